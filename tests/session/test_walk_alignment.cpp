#include "core/session/walk_alignment.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace farol;
using namespace farol::session;

namespace {

routing::PathPoint at(double x, double y, double level = 0.0) {
    return {{x, y}, level};
}

/// Straight, a left turn, straight.
WalkedPath bend() {
    return WalkedPath({at(0, 0), at(10, 0), at(10, 10)});
}

std::vector<WalkedFrame> evenly(int count, double seconds) {
    std::vector<WalkedFrame> frames;
    for (int i = 0; i < count; ++i) frames.push_back({seconds * i / (count - 1), {}, {}});
    return frames;
}

} // namespace

TEST(WalkedPath, TellsSpotHeadingAndBends) {
    WalkedPath path = bend();
    EXPECT_DOUBLE_EQ(path.lengthM(), 20.0);
    EXPECT_DOUBLE_EQ(path.at(4.0).position.x, 4.0);
    EXPECT_DOUBLE_EQ(path.at(14.0).position.y, 4.0);
    EXPECT_DOUBLE_EQ(path.at(99.0).position.y, 10.0);
    EXPECT_NEAR(toDegrees(*path.heading(3.0)), 0.0, 1e-9);
    EXPECT_NEAR(toDegrees(*path.heading(10.0)), 45.0, 1e-6);
    EXPECT_NEAR(toDegrees(*path.heading(19.0)), 90.0, 1e-9);
    EXPECT_TRUE(path.bends(9.6, fromDegrees(25)));
    EXPECT_FALSE(path.bends(5.0, fromDegrees(25)));
}

TEST(WalkAlignment, WithoutMotionThePaceIsEven) {
    auto metres = alignWalk(bend(), evenly(21, 25.0));
    ASSERT_TRUE(metres) << metres.error().text();
    for (std::size_t i = 0; i < metres->size(); ++i)
        EXPECT_NEAR((*metres)[i], static_cast<double>(i), 0.6) << "frame " << i;
    EXPECT_EQ(metres->front(), 0.0);
    EXPECT_EQ(metres->back(), 20.0);
}

TEST(WalkAlignment, AnEvenPaceStaysEvenBetweenTwoCells) {
    // 1.9 m a step: neither seven cells nor eight.
    WalkedPath path({at(0, 0), at(74.1, 0)});
    auto metres = alignWalk(path, evenly(40, 78.0));
    ASSERT_TRUE(metres) << metres.error().text();
    for (std::size_t i = 0; i < metres->size(); ++i)
        EXPECT_NEAR((*metres)[i], 1.9 * static_cast<double>(i), 0.2) << "frame " << i;
}

TEST(WalkAlignment, AThingSeenFromFarAwayDoesNotDrawTheWalkToIt) {
    auto frames = evenly(21, 25.0);
    Anchor door{{10.0, 0.0}, 0.0, 8.0, 1.0, true};
    frames[2].anchors = {door};
    auto metres = alignWalk(bend(), frames);
    ASSERT_TRUE(metres) << metres.error().text();
    EXPECT_NEAR((*metres)[2], 2.0, 0.6);
    // The same distance beyond the door is no fit: one does not see what lies behind.
    frames = evenly(21, 25.0);
    frames[9].anchors = {Anchor{{10.0, 0.0}, 0.0, 1.0, 0.2, true}};
    metres = alignWalk(bend(), frames);
    ASSERT_TRUE(metres) << metres.error().text();
    EXPECT_NEAR((*metres)[9], 9.0, 0.6);
}

TEST(WalkAlignment, WhoStandsStillIsNotMoved) {
    auto frames = evenly(61, 60.0);
    for (std::size_t i = 1; i < frames.size(); ++i) frames[i].motion.speed = i > 20 && i <= 40 ? 0.0 : 0.7;
    auto metres = alignWalk(bend(), frames);
    ASSERT_TRUE(metres) << metres.error().text();
    EXPECT_NEAR((*metres)[20], 10.0, 0.8);
    EXPECT_NEAR((*metres)[40], 10.0, 0.8);
    EXPECT_NEAR((*metres)[50], 15.0, 0.8);
}

TEST(WalkAlignment, TheTurnIsWhereTheWayBends) {
    // Slow before the corner, quick behind it, and the picture tells no speed: only the turn says so.
    auto frames = evenly(41, 40.0);
    for (std::size_t i = 1; i < frames.size(); ++i)
        frames[i].motion.turn = i >= 27 && i <= 29 ? fromDegrees(30) : fromDegrees(0);
    auto metres = alignWalk(bend(), frames);
    ASSERT_TRUE(metres) << metres.error().text();
    EXPECT_NEAR((*metres)[28], 10.0, 1.2);
    EXPECT_LT((*metres)[20], 9.0);
}

TEST(WalkAlignment, AKnownLandmarkHoldsTheWalk) {
    auto frames = evenly(41, 40.0);
    frames[10].anchors.push_back({{9.5, 0.5}, 0.0, 1.0});
    auto metres = alignWalk(bend(), frames);
    ASSERT_TRUE(metres) << metres.error().text();
    EXPECT_GT((*metres)[10], 7.0) << "an even pace would be at 5 m";
    frames[10].anchors.push_back({{500.0, 0.5}, 0.0, 1.0});
    auto wrong = alignWalk(bend(), frames);
    ASSERT_TRUE(wrong);
    EXPECT_NEAR((*wrong)[10], (*metres)[10], 0.6) << "a wrong recognition does not bend the walk";
}

TEST(WalkAlignment, WhatDoesNotFitIsRefusedInWords) {
    auto fast = alignWalk(bend(), evenly(10, 3.0));
    ASSERT_FALSE(fast);
    EXPECT_NE(fast.error().text().find("20 m"), std::string::npos) << fast.error().text();
    EXPECT_FALSE(alignWalk(bend(), {}));
    EXPECT_FALSE(alignWalk(bend(), evenly(2, 0.0)));
    EXPECT_FALSE(alignWalk(WalkedPath({at(1, 1), at(1, 1)}), evenly(10, 10.0)));
    EXPECT_FALSE(alignWalk(WalkedPath({}), evenly(10, 10.0)));
    AlignmentOptions options;
    options.cellM = 0.0;
    EXPECT_FALSE(alignWalk(bend(), evenly(41, 40.0), options));
}
