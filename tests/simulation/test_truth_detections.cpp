#include "core/simulation/truth_detections.h"
#include "tests/support/ascii_map.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace farol::simulation {
namespace {

using test::AsciiMap;

class TruthDetectionsTest : public testing::Test {
protected:
    AsciiMap map = std::move(AsciiMap()
                                 .floor(R"(
        +-------+-----+
        |A      |B    |
        |  1    |  s  |
        |       |     |
        |   e   |     |
        +---/---+-----+
        |C            |
        +-------------+
    )")
                                 .landmark('e', {Kind::Extinguisher, "", "red", 90.0})
                                 .landmark('s', {Kind::Text, "2.14", "", std::nullopt}));
    std::shared_ptr<const WalkWorld> world = std::make_shared<const WalkWorld>(map.build());
    std::size_t a = *world->building().regionIndex(RegionId("A"));

    static TruthDetectionOptions exact() {
        TruthDetectionOptions options;
        options.wrongKind = options.misread = options.noRange = options.stale = 0.0;
        options.falsePerSecond = options.clutterPerM2 = 0.0;
        return options;
    }
    /// Of so many seconds of standing at `1` and looking that way.
    std::vector<recognition::Detection> seen(const TruthDetectionOptions& options, double headingDegrees,
                                             double seconds) {
        TruthDetections detections(world, options);
        std::vector<recognition::Detection> all;
        CameraPose pose;
        pose.position = *map.spot('1').position;
        pose.heading = fromDegrees(headingDegrees);
        for (pose.time = 0.0; pose.time < seconds; pose.time += 0.2)
            for (auto& each : detections.look(pose, a).detections) all.push_back(std::move(each));
        return all;
    }
};

TEST_F(TruthDetectionsTest, WhatIsAheadIsFoundAboutAsOftenAsTheStudySays) {
    auto found = seen(exact(), -60.0, 3000.0);
    EXPECT_GT(found.size(), 300U);
    EXPECT_LT(found.size(), 1500U);
    for (const recognition::Detection& each : found) {
        EXPECT_EQ(each.kind, Kind::Extinguisher);
        EXPECT_EQ(each.templateId.value, "red");
    }
}

TEST_F(TruthDetectionsTest, NothingIsSeenThroughAWallOrBehind) {
    EXPECT_TRUE(seen(exact(), 0.0, 500.0).empty()) << "the sign hangs in the next room";
    EXPECT_TRUE(seen(exact(), 120.0, 500.0).empty());
}

TEST_F(TruthDetectionsTest, FalseOnesComeAtTheirRate) {
    TruthDetectionOptions options = exact();
    options.detectionsPerSecond = 0.0;
    options.falsePerSecond = 0.02;
    auto found = seen(options, 120.0, 5000.0);
    EXPECT_NEAR(static_cast<double>(found.size()), 100.0, 40.0);
}

TEST_F(TruthDetectionsTest, MotionIsToldWithEachLookAndTellsTheTurn) {
    TruthDetectionOptions options = exact();
    options.lostFlow = 0.0;
    TruthDetections detections(world, options);
    CameraPose pose;
    pose.position = *map.spot('1').position;
    int told = 0;
    double turned = 0.0;
    for (pose.time = 0.0; pose.time < 20.05; pose.time += 0.1) {
        pose.heading = wrapped(fromDegrees(10.0 * pose.time));
        auto motion = detections.look(pose, a).motion;
        if (!motion.turn) continue;
        ++told;
        turned += toDegrees(*motion.turn);
    }
    EXPECT_NEAR(told, 200, 1);
    EXPECT_NEAR(turned, 200.0, 25.0);
}

TEST_F(TruthDetectionsTest, TheProgramsOwnEyesTellATrainedThingAgainAndAgainAsTheSame) {
    TruthDetectionOptions options = TruthDetectionOptions::ofCamera();
    options.wrongKind = options.misread = options.noRange = options.stale = 0.0;
    options.falsePerSecond = options.clutterPerM2 = 0.0;
    auto found = seen(options, -60.0, 30.0);
    // The door beside it is seen, too, without anybody having listed it.
    auto trained = std::stable_partition(found.begin(), found.end(), [](const recognition::Detection& each) {
        return each.kind != Kind::Door;
    });
    EXPECT_LT(trained, found.end());
    found.erase(trained, found.end());
    ASSERT_GT(found.size(), 10U);
    for (const recognition::Detection& each : found) {
        EXPECT_EQ(each.templateId.value, "red");
        EXPECT_EQ(each.track, found.front().track);
        EXPECT_GE(each.confirmations, 2);
        ASSERT_TRUE(each.rangeM);
        EXPECT_NEAR(*each.rangeM, *found.front().rangeM, 1.5);
    }
}

TEST_F(TruthDetectionsTest, TheSameSeedSeesTheSame) {
    auto first = seen(TruthDetectionOptions{}, -60.0, 200.0),
         second = seen(TruthDetectionOptions{}, -60.0, 200.0);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].quad, second[i].quad);
}

} // namespace
} // namespace farol::simulation
