#include "core/simulation/visits.h"
#include "core/simulation/walk_source.h"
#include "tests/support/ascii_map.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "simulated_places.h"

namespace farol::simulation {
namespace {

guidance::Cue cue(guidance::CueKind kind, double time) {
    guidance::Cue cue;
    cue.kind = kind;
    cue.time = time;
    return cue;
}

class WalkSourceTest : public testing::Test {
protected:
    World world = test::worldOf(test::corridorMap());
    WalkSourceOptions options;

    void SetUp() override {
        options.camera.size = {64, 48};
        options.framesPerSecond = 5.0;
    }
    std::unique_ptr<WalkSource> source() {
        auto made = WalkSource::create(world, {RegionId("corridor"), {}}, options);
        EXPECT_TRUE(made.ok());
        return made ? std::move(made).value() : nullptr;
    }
};

TEST_F(WalkSourceTest, AnswersThatComeLateGiveTheSameWalk) {
    auto walk = [&](std::uint64_t late) {
        auto walker = source();
        std::vector<Point2> way;
        std::vector<std::uint64_t> unanswered;
        for (int i = 0; i < 40; ++i) {
            auto frame = walker->next();
            EXPECT_TRUE(frame.has_value());
            if (!frame) break;
            EXPECT_EQ(frame->index, static_cast<std::uint64_t>(i));
            way.push_back(walker->truth(frame->index).pose.position);
            unanswered.push_back(frame->index);
            while (unanswered.size() > late) {
                std::vector<guidance::Cue> cues;
                double time = static_cast<double>(unanswered.front()) / options.framesPerSecond;
                if (unanswered.front() % 6 == 0) cues.push_back(cue(guidance::CueKind::Reassure, time));
                walker->answer(unanswered.front(), cues);
                unanswered.erase(unanswered.begin());
            }
        }
        return way;
    };
    auto atOnce = walk(0), late = walk(4);
    ASSERT_EQ(atOnce.size(), late.size());
    for (std::size_t i = 0; i < atOnce.size(); ++i) {
        EXPECT_EQ(atOnce[i].x, late[i].x) << i;
        EXPECT_EQ(atOnce[i].y, late[i].y) << i;
    }
    EXPECT_GT(distance(atOnce.front(), atOnce.back()), 0.5);
}

TEST_F(WalkSourceTest, WhoIsToStopWaitsForNoAnswer) {
    auto walker = source();
    for (int i = 0; i < 5; ++i) ASSERT_TRUE(walker->next().has_value());
    walker->requestStop();
    EXPECT_FALSE(walker->next().has_value());
}

TEST_F(WalkSourceTest, AHandOnTheLensAndDarkness) {
    options.camera.adaptExposure = false;
    auto walker = source();
    auto next = [&] {
        auto frame = walker->next();
        EXPECT_TRUE(frame.has_value());
        walker->answer(frame->index, {});
        return test::brightness(frame->image, {0, 0, 64, 48});
    };
    double lit = next();
    walker->setLightsOut(true);
    double dark = next();
    EXPECT_LT(dark, 0.6 * lit);
    walker->setLightsOut(false);
    EXPECT_GT(next(), 1.2 * dark);
    walker->setCovered(true);
    EXPECT_LT(next(), 60.0);
    walker->setCovered(false);
    EXPECT_GT(next(), 1.2 * dark);
}

TEST_F(WalkSourceTest, ArrivesAndIsSentOffAgain) {
    options.afterArrivalS = 1.0;
    auto walker = source();
    auto step = [&](const std::vector<guidance::CueKind>& kinds) {
        auto frame = walker->next();
        if (!frame) return false;
        std::vector<guidance::Cue> cues;
        for (auto kind : kinds) cues.push_back(cue(kind, frame->capturedAt));
        walker->answer(frame->index, cues);
        return true;
    };
    ASSERT_TRUE(step({guidance::CueKind::Arrived}));
    for (int i = 0; i < 6; ++i) ASSERT_TRUE(step({}));
    EXPECT_TRUE(walker->arrived());
    walker->sendOff();
    EXPECT_FALSE(walker->arrived());
    for (int i = 0; i < 20; ++i) ASSERT_TRUE(step({}));
    ASSERT_TRUE(step({guidance::CueKind::Arrived}));
    int more = 0;
    while (more < 100 && step({})) ++more;
    EXPECT_TRUE(walker->arrived());
    EXPECT_GE(more, 5);
    EXPECT_LE(more, 12);
}

TEST_F(WalkSourceTest, AnArrivalHeardLateDoesNotEndTheNextWay) {
    auto walker = source();
    auto frame = walker->next();
    ASSERT_TRUE(frame);
    walker->answer(frame->index, {cue(guidance::CueKind::Arrived, frame->capturedAt)});
    walker->sendOff(); // the next place is chosen before the sentence has sunk in
    for (int i = 0; i < 20; ++i) {
        frame = walker->next();
        ASSERT_TRUE(frame);
        walker->answer(frame->index, {});
    }
    EXPECT_FALSE(walker->arrived());
}

TEST_F(WalkSourceTest, AWrongTurnIsNotTalkedOutOf) {
    auto heading = [](WalkSource& walker, std::uint64_t frame) { return walker.truth(frame).pose.heading; };
    auto walker = source();
    double least = 1e9;
    Radians before;
    for (std::uint64_t i = 0; i < 40; ++i) {
        auto frame = walker->next();
        ASSERT_TRUE(frame.has_value());
        if (i == 15) {
            before = heading(*walker, i);
            walker->takeWrongTurn();
        }
        if (i == 39) least = std::abs(wrapped(heading(*walker, i) - before).value);
        walker->answer(i, {cue(guidance::CueKind::NoRoute, frame->capturedAt)}); // "stop"
    }
    EXPECT_GT(least, 0.6);
}

TEST(Visits, AreTheSameByNumberAndCanBeWalked) {
    test::AsciiMap map;
    map.floor(R"(
        +-----+-----+-----+     +---+
        |A    |B    |D    |     |E  |
        |     |     |     |     |   |
        +--/--+--/--+--/--+     +---+
        |C                |
        |                 |
        +-----------------+
    )");
    Visits visits(map.build());
    for (std::uint64_t number = 1; number <= 30; ++number) {
        auto visit = visits.visit(number), again = visits.visit(number);
        ASSERT_TRUE(visit.has_value());
        EXPECT_EQ(visit->from, again->from);
        EXPECT_EQ(visit->to, again->to);
        EXPECT_NE(visit->from, visit->to);
        EXPECT_GT(visit->metres, 0.0);
        EXPECT_NE(visit->from, RegionId("E"));
        auto mine = visits.visit(number, RegionId("B"));
        ASSERT_TRUE(mine.has_value());
        EXPECT_EQ(mine->from, RegionId("B"));
    }
    EXPECT_FALSE(visits.visit(1, RegionId("E")).has_value());
    EXPECT_FALSE(visits.between(RegionId("A"), RegionId("E")).has_value());
}

} // namespace
} // namespace farol::simulation
