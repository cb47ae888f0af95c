#include "core/session/closed_loop.h"
#include "tests/support/ascii_map.h"

#include <gtest/gtest.h>

namespace farol::session {
namespace {

using test::AsciiMap;

std::shared_ptr<const building::Building> house() {
    AsciiMap map;
    map.floor(R"(
        +-----+-----+-----+
        |A    |B    |D    |
        |     |     |     |
        | a   | b   | d   |
        +--/--+--/--+--/--+
        |C                |
        | c               |
        |       e         |
        +-----------------+
    )");
    for (char each : std::string("abcde"))
        map.landmark(each, {Kind::Poster, "", std::string("poster-") + each, std::nullopt});
    return map.build();
}

class ClosedLoopTest : public testing::Test {
protected:
    std::shared_ptr<const simulation::WalkWorld> world =
        std::make_shared<const simulation::WalkWorld>(house());
    ClosedLoopOptions options;

    std::unique_ptr<ClosedLoop> loop(const char* from, const char* to) {
        simulation::TruthDetectionOptions detections;
        detections.detectionsPerSecond = 2.0;
        detections.wrongKind = detections.falsePerSecond = detections.clutterPerM2 = detections.stale = 0.0;
        auto made = ClosedLoop::create(world, {RegionId(from), {}}, {RegionId(to), {}}, options,
                                       truthEye(world, detections));
        EXPECT_TRUE(made.ok());
        return made ? std::move(made).value() : nullptr;
    }
};

TEST_F(ClosedLoopTest, ArrivesByNothingButCues) {
    auto result = loop("A", "C")->run();
    ASSERT_TRUE(result.ok());
    EXPECT_EQ(result->end, WalkEnd::Arrived) << result->reason;
    EXPECT_TRUE(result->arrived);
    EXPECT_TRUE(result->announcedArrival);
    EXPECT_GT(result->cues, 1);
    EXPECT_GT(result->metres, 0.5);
    EXPECT_GT(result->shortestM, 0.5);
}

TEST_F(ClosedLoopTest, WhoHearsNothingStaysAndIsNotCountedAsArrived) {
    options.patience = 1.0;
    options.patienceSeconds = 30.0;
    auto deaf = loop("A", "D");
    deaf->setEar([](const guidance::Cue&) { return std::nullopt; });
    auto result = deaf->run();
    ASSERT_TRUE(result.ok());
    EXPECT_NE(result->end, WalkEnd::Arrived);
    EXPECT_FALSE(result->arrived);
    EXPECT_EQ(result->metres, 0.0);
    EXPECT_FALSE(result->reason.empty());
}

TEST_F(ClosedLoopTest, StandingStillIsNoSignOfTheArrival) {
    options.patience = 1.0;
    options.patienceSeconds = 120.0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        options.walker.seed = seed;
        auto deaf = loop("A", "D");
        deaf->setEar([](const guidance::Cue&) { return std::nullopt; });
        auto result = deaf->run();
        ASSERT_TRUE(result.ok());
        EXPECT_FALSE(result->announcedArrival) << seed;
    }
}

TEST_F(ClosedLoopTest, TheSameSeedIsTheSameWalk) {
    auto first = loop("B", "D")->run(), second = loop("B", "D")->run();
    ASSERT_TRUE(first.ok() && second.ok());
    EXPECT_EQ(first->seconds, second->seconds);
    EXPECT_EQ(first->metres, second->metres);
    EXPECT_EQ(first->cues, second->cues);
}

TEST_F(ClosedLoopTest, WatchersSeeThePoseOfEachFrameInTheOrderOfTime) {
    auto watched = loop("A", "C");
    double before = -1.0;
    int moments = 0;
    watched->onMoment([&](const ClosedLoopMoment& moment) {
        EXPECT_GT(moment.pose.time, before);
        EXPECT_NEAR(moment.pose.time, moment.step.percept.time, 1e-9);
        before = moment.pose.time;
        ++moments;
    });
    ASSERT_TRUE(watched->run().ok());
    EXPECT_GT(moments, 10);
}

TEST_F(ClosedLoopTest, WhatCannotBeWalkedIsRefusedInWords) {
    auto eye = truthEye(world, {});
    auto nowhere = ClosedLoop::create(world, {RegionId("A"), {}}, {RegionId("X"), {}}, options, eye);
    ASSERT_FALSE(nowhere.ok());
    EXPECT_FALSE(nowhere.error().message.empty());
    options.framesPerSecond = 0.0;
    EXPECT_FALSE(ClosedLoop::create(world, {RegionId("A"), {}}, {RegionId("B"), {}}, options, eye).ok());
}

TEST_F(ClosedLoopTest, AnEyeThatFailsEndsTheWalkWithItsWords) {
    auto made =
        ClosedLoop::create(world, {RegionId("A"), {}}, {RegionId("B"), {}}, options,
                           [](const simulation::CameraPose&, std::size_t, std::uint64_t) -> Result<Percept> {
                               return Error{ErrorCode::Io, "the camera broke", ""};
                           });
    ASSERT_TRUE(made.ok());
    auto result = (*made)->run();
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().message, "the camera broke");
}

} // namespace
} // namespace farol::session
