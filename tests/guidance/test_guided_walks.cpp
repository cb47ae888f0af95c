// Whole walks: what other people's navigation programs got wrong (field.md 6.2).

#include "tests/guidance/guided.h"

#include <gtest/gtest.h>

using namespace farol;
using namespace farol::guidance;
using farol::test::AsciiMap;
using farol::test::at;
using farol::test::Guided;

namespace {

/// The spot that lies `walked` metres along the flat path, and the level there.
routing::PathPoint pointAlong(const routing::Route& route, double walked) {
    for (std::size_t i = 1; i < route.path.size(); ++i) {
        Point2 a = route.path[i - 1].position, b = route.path[i].position;
        double step = distance(a, b);
        if (walked <= step && step > 0.0) return {a + (b - a) * (walked / step), route.path[i - 1].level};
        walked -= step;
    }
    return route.path.back();
}

std::vector<CueKind> kindsOf(const std::vector<Cue>& cues) {
    std::vector<CueKind> kinds;
    for (const Cue& cue : cues) kinds.push_back(cue.kind);
    return kinds;
}

/// "You have arrived" may mean the room behind the door that one was sent to.
TEST(GuidedWalk, WhoWasSentOnByAGuessIsToldToStop) {
    struct Case {
        double confidence;
        int seconds;
        bool stop;
    };
    for (const Case& one : {Case{0.7, 2, true}, Case{0.9, 2, false}, Case{0.7, 25, false}}) {
        Guided walk;
        walk.tracker.setDestination(at("D"));
        walk.seen("A");
        walk.seen("K", '2', one.confidence);
        walk.wait(3);
        walk.seen("K", '1', one.confidence);
        walk.wait(one.seconds);
        walk.seen("D");
        ASSERT_EQ(walk.count(CueKind::Arrived), 1U);
        EXPECT_EQ(walk.find(CueKind::Arrived)->stop, one.stop) << one.confidence << " " << one.seconds;
    }
}

/// An arrival that waits behind a sentence expires when the user seems to be out again for a moment.
TEST(GuidedWalk, AnArrivalThatMayNotHaveBeenHeardIsToldAgain) {
    Guided walk;
    walk.secondsBetween = 2.0;
    walk.tracker.setDestination(at("B"));
    for (const char* region : {"A", "K", "B"}) walk.seen(region);
    EXPECT_EQ(walk.count(CueKind::Arrived), 1U);
    walk.seen("K");
    for (int i = 0; i < 3; ++i) walk.seen("B");
    EXPECT_EQ(walk.count(CueKind::Arrived), 1U) << "not twice in a breath";
    for (int i = 0; i < 12; ++i) walk.seen("B");
    EXPECT_EQ(walk.count(CueKind::Arrived), 2U);
}

TEST(GuidedWalk, EveryDoorOnTheWayIsToldBeforeItAndArrivalAtTheEnd) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    std::vector<std::string> told;
    for (const char* region : {"A", "K", "S", "T", "U"}) {
        for (const Cue& cue : walk.seen(region)) {
            if (cue.manoeuvre) told.push_back(cue.manoeuvre->access.value);
            if (cue.next && !cue.next->access.empty()) told.push_back(cue.next->access.value);
        }
    }
    for (const char* access : {"A-K", "K-S", "T-U"}) {
        EXPECT_EQ(std::count(told.begin(), told.end(), access), 1) << access;
    }
    EXPECT_EQ(std::count(told.begin(), told.end(), "S-T"), 2)
        << "ahead of the stairs, and at them with their steps";
    EXPECT_EQ(walk.all.back().kind, CueKind::Arrived);
}

// A guess that lasts leads to another way in the end. The look around that went on until then is over with
// it.
TEST(GuidedWalk, NobodyHearsAWayAndThatNobodyKnowsWhereTheyAre) {
    guidance::GuidanceOptions cautious;
    cautious.usableConfidence = 0.5;
    guidance::TrackerOptions patient;
    patient.guessConfidence = 0.5;
    patient.guessSeconds = 30.0;
    Guided walk(test::corridorMap(), cautious, patient);
    walk.secondsBetween = 1.0;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    bool led = false;
    for (int second = 0; second < 60; ++second) {
        walk.seen("B", 0, 0.35);
        if (walk.find(CueKind::OffRoute) != nullptr) {
            led = true;
            EXPECT_EQ(walk.find(CueKind::Unsure), nullptr) << "at " << walk.time;
            walk.all.clear();
        }
    }
    ASSERT_TRUE(led);
    auto asked = std::find_if(walk.all.begin(), walk.all.end(),
                              [](const Cue& cue) { return cue.kind == CueKind::Unsure; });
    ASSERT_NE(asked, walk.all.end()) << "still a guess";
    EXPECT_EQ(asked->sweep, guidance::SweepStep::Right) << "from the beginning";
}

TEST(GuidedWalk, ASecondRouteStartsClean) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    for (const char* region : {"A", "K", "D"}) walk.seen(region);
    ASSERT_EQ(walk.count(CueKind::Arrived), 1U);
    const std::uint64_t first = walk.all.front().routeVersion;
    walk.all.clear();
    walk.tracker.setDestination(at("A"));
    walk.seen("D");
    EXPECT_EQ(kindsOf(walk.cues), (std::vector<CueKind>{CueKind::RouteStart}));
    EXPECT_EQ(walk.cues.front().region.value, "A");
    EXPECT_EQ(walk.cues.front().manoeuvre->access.value, "D-K");
    walk.seen("K");
    walk.seen("A");
    EXPECT_EQ(walk.count(CueKind::Arrived), 1U);
    const std::uint64_t second = walk.progress.routeVersion;
    EXPECT_GT(second, first);
    for (const Cue& cue : walk.all) {
        EXPECT_TRUE(cue.routeVersion == 0 || cue.routeVersion == second);
    }
}

TEST(GuidedWalk, ChangingTheDestinationOnTheWayMakesOldCuesVoid) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    walk.seen("A");
    std::uint64_t old = walk.cues.front().routeVersion;
    walk.tracker.setDestination(at("B"));
    walk.seen("K");
    ASSERT_NE(walk.find(CueKind::RouteStart), nullptr);
    EXPECT_GT(walk.find(CueKind::RouteStart)->routeVersion, old);
    EXPECT_EQ(walk.find(CueKind::RouteStart)->manoeuvre->access.value, "B-K");
}

TEST(GuidedWalk, GuidanceGoesOnAfterStairs) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    for (const char* region : {"K", "S", "T"}) walk.seen(region);
    bool told = false;
    for (const Cue& cue : walk.cues) told = told || (cue.manoeuvre && cue.manoeuvre->access.value == "T-U");
    EXPECT_TRUE(told);
}

TEST(GuidedWalk, LevelsBelowGroundAndTheGroundItselfAreLevels) {
    auto map = AsciiMap()
                   .floor("+---+---+\n|B  /S  |\n|   |   |\n+---+---+", -1.0)
                   .floor("+---+---+\n|A  /T  |\n|   |   |\n+---+---+", 0.0)
                   .join(building::AccessKind::Stairs, 'S', 'T', "main", 9);
    Guided down(map);
    down.tracker.setDestination(at("B"));
    for (const char* region : {"A", "T"}) down.seen(region);
    const Cue* cue = nullptr;
    for (const Cue& each : down.all) {
        if (each.manoeuvre && each.manoeuvre->kind == routing::ManoeuvreKind::Stairs) cue = &each;
        if (each.next && each.next->kind == routing::ManoeuvreKind::Stairs) cue = &each;
    }
    ASSERT_NE(cue, nullptr);
    Guided up(map);
    up.tracker.setDestination(at("A"));
    up.seen("S", 0, 0.9);
    ASSERT_NE(up.find(CueKind::RouteStart), nullptr);
    EXPECT_EQ(up.find(CueKind::RouteStart)->manoeuvre->vertical, routing::Vertical::Up);
    EXPECT_EQ(up.find(CueKind::RouteStart)->manoeuvre->targetLevel, 0.0);
    EXPECT_EQ(up.find(CueKind::RouteStart)->levelName, "Level 0");
}

TEST(GuidedWalk, AFlickeringFixDoesNotChatter) {
    Guided walk;
    walk.secondsBetween = 1.0;
    walk.tracker.setDestination(at("U"));
    walk.seen("A");
    walk.all.clear();
    for (int i = 0; i < 30; ++i) walk.seen(i % 2 == 0 ? "A" : "K", 0, 0.3);
    EXPECT_LE(walk.all.size(), 5U) << "in half a minute";
    EXPECT_EQ(walk.count(CueKind::OffRoute), 0U);
}

TEST(GuidedWalk, OneWrongSightDoesNotSendAnyoneAnywhere) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    walk.seen("A");
    walk.seen("K");
    walk.all.clear();
    walk.seen("B", 0, 0.3); // a false door
    walk.wait(3);
    EXPECT_TRUE(walk.all.empty());
    walk.seen("K");
    EXPECT_EQ(walk.count(CueKind::OffRoute), 0U);
}

TEST(GuidedWalk, WhatIsToldIsNeverStaleByDesign) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    for (const char* region : {"A", "K", "K", "C", "K", "S", "T", "U"}) walk.seen(region);
    for (const Cue& cue : walk.all) {
        EXPECT_GT(cue.validUntil, cue.time) << cueKindName(cue.kind);
        EXPECT_LE(cue.validUntil - cue.time, 20.0);
        bool order = cue.kind == CueKind::Act || cue.kind == CueKind::Prepare;
        if (order) {
            EXPECT_FALSE(cue.validIn.empty());
            EXPECT_NE(cue.routeVersion, 0U);
            ASSERT_TRUE(cue.manoeuvre);
            EXPECT_EQ(cue.validIn.front(), cue.manoeuvre->from);
        }
    }
}

/// Somebody walks the planned path exactly, seen every two seconds.
TEST(GuidedWalk, OnAPlannedRouteEveryDoorIsActedOnAndDistancesFit) {
    Guided walk;
    auto planner = std::shared_ptr<const routing::Planner>(routing::makeOptimalPlanner(walk.building));
    RouteTracker tracker(walk.building, planner);
    CueScheduler scheduler(walk.building);
    tracker.setDestination(at("C"));
    auto planned = planner->plan({RegionId("D"), walk.map.spot('d').position}, at("C"));
    ASSERT_TRUE(planned.ok());
    std::vector<std::string> acted;
    std::vector<Cue> all;
    double last = planned->lengthM + 1.0;
    std::size_t region = 0;
    for (double walked = 0.0; walked < planned->lengthM + 1.5; walked += 1.5) {
        for (const routing::Manoeuvre& each : planned->manoeuvres) {
            if (!each.access.empty() && each.into == planned->regions[region + 1] && walked > each.atM)
                ++region;
            if (region + 1 == planned->regions.size()) break;
        }
        routing::PathPoint here = pointAlong(*planned, walked);
        localisation::Fix fix;
        fix.time = fix.evidenceTime = walked / 0.75;
        fix.region = planned->regions[region];
        fix.confidence = 0.9;
        fix.level = here.level;
        fix.position = here.position;
        fix.sigmaM = 1.0;
        Progress progress = tracker.update(fix);
        ASSERT_TRUE(progress.route);
        if (progress.travel == Travel::OnRoute) {
            ASSERT_TRUE(progress.distanceM && progress.remainingM && progress.next);
            EXPECT_NEAR(*progress.remainingM, planned->lengthM - walked, 0.3);
            EXPECT_LT(*progress.remainingM, last);
            last = *progress.remainingM;
        }
        for (Cue& cue : scheduler.update(1, fix, progress, {})) {
            if (cue.kind == CueKind::Act) acted.push_back(cue.manoeuvre->access.value);
            if (cue.kind == CueKind::Act && cue.next) acted.push_back(cue.next->access.value);
            all.push_back(std::move(cue));
        }
    }
    EXPECT_EQ(std::count(acted.begin(), acted.end(), "C-K"), 1);
    EXPECT_EQ(all.front().kind, CueKind::RouteStart);
    EXPECT_EQ(all.front().manoeuvre->access.value, "D-K") << "so near that the start is all there is to tell";
    EXPECT_EQ(all.back().kind, CueKind::Arrived);
}

TEST(GuidedWalk, TheSameWalkIsToldTheSame) {
    std::vector<std::string> runs[2];
    for (auto& lines : runs) {
        Guided walk;
        walk.tracker.setDestination(at("U"));
        for (const char* region : {"A", "B", "K", "S", "T", "U"}) {
            for (const Cue& cue : walk.seen(region, 0, 0.7)) {
                lines.push_back(std::to_string(cue.id) + cueKindName(cue.kind) + cue.regionName +
                                cue.intoName);
            }
        }
    }
    EXPECT_EQ(runs[0], runs[1]);
    EXPECT_FALSE(runs[0].empty());
}

} // namespace
