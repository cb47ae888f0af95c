#pragma once
// Detections and a little walk for the tests of this folder.

#include "core/localisation/navigation_history.h"
#include "core/localisation/voting_localiser.h"

#include <string>
#include <vector>

namespace farol::test {

inline recognition::Detection seen(Kind kind, const std::string& templateId = {},
                                   const std::string& text = {}, ImageBox box = {100, 100, 80, 120}) {
    recognition::Detection detection;
    detection.kind = kind;
    detection.templateId = TemplateId(templateId);
    detection.text = text;
    detection.quad = quadOf(box);
    detection.image = {640, 480};
    detection.score = 0.8;
    return detection;
}

/// A localiser with its history; every sight is a frame and a scene of its own unless said otherwise.
struct Walk {
    explicit Walk(std::shared_ptr<const building::Building> building,
                  localisation::VotingOptions options = localisation::VotingOptions::repaired())
        : localiser(localisation::makeVotingLocaliser(std::move(building), options)) {}

    localisation::Fix start(const std::string& region = {}) {
        localiser->start(time, region.empty() ? std::nullopt : std::optional(RegionId(region)));
        return localiser->update(time, {}, history.items());
    }
    localisation::Fix see(const std::vector<recognition::Detection>& detections, bool newScene = true) {
        ++frame;
        time += secondsBetween;
        if (newScene) ++scene;
        std::vector<localisation::Observation> observations;
        for (const auto& each : detections) observations.push_back({each, time, frame, scene});
        std::vector<localisation::Observation> fresh = history.add(observations);
        return localiser->update(time, fresh, history.items());
    }
    localisation::Fix see(const recognition::Detection& detection) { return see(std::vector{detection}); }
    localisation::Fix wait(double seconds) {
        time += seconds;
        return localiser->update(time, {}, history.items());
    }

    std::unique_ptr<localisation::Localiser> localiser;
    localisation::NavigationHistory history;
    double time = 0.0;
    double secondsBetween = 4.0;
    std::uint64_t frame = 0;
    int scene = 0;
};

inline std::string regionOf(const localisation::Fix& fix) {
    return fix.region ? fix.region->value : "none";
}

} // namespace farol::test
