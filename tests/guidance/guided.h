#pragma once
// Fixes by hand, and a tracker with its scheduler.

#include "core/guidance/cue_scheduler.h"
#include "tests/guidance/straight_planner.h"
#include "tests/support/ascii_map.h"

#include <algorithm>
#include <string>
#include <vector>

namespace farol::test {

/// A corridor K with rooms along it, and a room on the next level that only stairs reach.
///   A ... E on level 0, S the stairwell, T above it, U behind T; X is cut off.
inline AsciiMap corridorMap() {
    return AsciiMap()
        .floor(R"(
            +---------+---------+---------+----+---+
            |A   a    |B   b    |C   c    |S   |X  |
            |         |         |         |    |   |
            +----/----+----/----+----/----+-:--+---+
            |K 1    2    3    4    5    6    7 |
            |                                  |
            +----/-----------------------------+
            |D       |
            |    d   |
            +--------+
        )")
        .floor(R"(
            +--------+----+
            |U       |T   |
            |        /    |
            +--------+----+
        )",
               1.0)
        .join(building::AccessKind::Stairs, 'S', 'T', "main", 18)
        .region('A', {"Library", building::RegionKind::Room})
        .region('B', {"Bar", building::RegionKind::Room})
        .region('K', {"Corridor", building::RegionKind::Corridor})
        .region('U', {"Office", building::RegionKind::Room});
}

inline building::Location at(const std::string& region) {
    return {RegionId(region), std::nullopt};
}

struct Guided {
    explicit Guided(AsciiMap drawing = corridorMap(), guidance::GuidanceOptions options = {},
                    guidance::TrackerOptions tracking = {}, bool optimal = false)
        : map(std::move(drawing)),
          building(map.build()),
          planner(std::make_shared<StraightPlanner>(building)),
          tracker(building,
                  optimal ? std::shared_ptr<const routing::Planner>(routing::makeOptimalPlanner(building))
                          : planner,
                  tracking),
          scheduler(building, options) {}

    /// A new observation says: this region, and perhaps this spot of the drawing.
    const std::vector<guidance::Cue>& seen(const std::string& region, char spot = 0,
                                           double confidence = 0.9) {
        fix = {};
        evidence = time + secondsBetween;
        fix.evidenceTime = evidence;
        if (!region.empty()) {
            fix.region = RegionId(region);
            fix.confidence = confidence;
            fix.level = building->region(RegionId(region)) != nullptr
                            ? building->region(RegionId(region))->level
                            : 0.0;
        }
        if (spot != 0) {
            fix.position = map.spot(spot).position;
            fix.sigmaM = 1.5;
        }
        return later(secondsBetween);
    }
    /// Time goes on with nothing new.
    const std::vector<guidance::Cue>& later(double seconds) {
        time += seconds;
        fix.time = time;
        progress = tracker.update(fix);
        cues = scheduler.update(++frame, fix, progress, fresh);
        fresh.clear();
        all.insert(all.end(), cues.begin(), cues.end());
        return cues;
    }
    /// In steps of a second; all cues on the way.
    std::vector<guidance::Cue> wait(int seconds) {
        std::vector<guidance::Cue> heard;
        for (int i = 0; i < seconds; ++i) {
            later(1.0);
            heard.insert(heard.end(), cues.begin(), cues.end());
        }
        return heard;
    }
    const guidance::Cue* find(guidance::CueKind kind) const {
        auto found =
            std::find_if(cues.begin(), cues.end(), [&](const auto& cue) { return cue.kind == kind; });
        return found == cues.end() ? nullptr : &*found;
    }
    std::size_t count(guidance::CueKind kind) const {
        return static_cast<std::size_t>(
            std::count_if(all.begin(), all.end(), [&](const auto& cue) { return cue.kind == kind; }));
    }

    AsciiMap map;
    std::shared_ptr<const building::Building> building;
    std::shared_ptr<StraightPlanner> planner;
    guidance::RouteTracker tracker;
    guidance::CueScheduler scheduler;
    localisation::Fix fix;
    guidance::Progress progress;
    std::vector<localisation::Observation> fresh;
    std::vector<guidance::Cue> cues, all;
    double time = 0.0, evidence = 0.0;
    double secondsBetween = 4.0;
    std::uint64_t frame = 0;
};

/// As the filter is asked: an arrival is told when it is that sure, or probable for so many observations (0:
/// never).
inline guidance::TrackerOptions sureArrivals(double confidence = 0.95, int patientObservations = 0) {
    guidance::TrackerOptions options;
    options.arrivalConfidence = confidence;
    options.patientSeconds = patientObservations * Guided().secondsBetween;
    return options;
}

} // namespace farol::test
