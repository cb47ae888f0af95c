#include "core/simulation/spoken_instruction.h"

#include <gtest/gtest.h>

namespace farol::simulation {
namespace {

using guidance::SweepStep;
using routing::Side;
using routing::Vertical;

TEST(SpokenInstruction, ADoorWithItsSideItsNumberAndWhatFollows) {
    auto heard = instructionFrom("In about 6 metres, go through the second door on your right.");
    EXPECT_EQ(heard.order, Order::Go);
    EXPECT_FALSE(heard.now);
    EXPECT_EQ(heard.task.feature, Feature::Door);
    EXPECT_EQ(heard.task.side, Side::Right);
    EXPECT_EQ(heard.task.number, 2);
    EXPECT_EQ(heard.distanceM, 6.0);
    heard = instructionFrom("Go through the door on your left, then turn right. Next: Office 2.07, your "
                            "destination.");
    EXPECT_TRUE(heard.now);
    EXPECT_EQ(heard.task.side, Side::Left);
    EXPECT_EQ(heard.task.into, "Office 2.07");
    ASSERT_TRUE(heard.task.behind.has_value());
    EXPECT_NEAR(toDegrees(*heard.task.behind), -90.0, 1e-9);
}

TEST(SpokenInstruction, TwoOpeningsInARowAreTwoTasks) {
    for (const char* words : {"Go straight on through two openings in a row.",
                              "In about 6 metres, go straight on through two openings in a row."}) {
        auto heard = instructionFrom(words);
        EXPECT_EQ(heard.order, Order::Go);
        EXPECT_EQ(heard.task.feature, Feature::Opening);
        EXPECT_EQ(heard.then.feature, Feature::Opening);
        ASSERT_TRUE(heard.then.turn.has_value());
        EXPECT_NEAR(toDegrees(*heard.then.turn), 0.0, 1e-9);
    }
    auto last = instructionFrom("Go through the door on your right. Next: your destination.");
    EXPECT_EQ(last.task.side, Side::Right);
    EXPECT_TRUE(last.task.into.empty());
    auto doors =
        instructionFrom("Go through the door ahead, then turn left. Then, straight away, go straight on "
                        "through the next door.");
    EXPECT_EQ(doors.then.feature, Feature::Door);
}

TEST(SpokenInstruction, ATurnIsMadeNowOrFirstByWhatFollows) {
    auto now = instructionFrom("Turn left.");
    EXPECT_TRUE(now.now);
    EXPECT_EQ(now.task.feature, Feature::Turn);
    EXPECT_FALSE(now.turnFirst);
    auto first = instructionFrom(
        "You are walking the wrong way. Turn around. Then, go through the opening ahead. Next: Atrium.");
    EXPECT_TRUE(first.astray);
    EXPECT_FALSE(first.now);
    ASSERT_TRUE(first.turnFirst.has_value());
    EXPECT_NEAR(toDegrees(*first.turnFirst), 180.0, 1e-9);
    EXPECT_EQ(first.task.feature, Feature::Opening);
    auto atOnce = instructionFrom("Turn slightly right. Then, straight away, go through the door ahead.");
    EXPECT_TRUE(atOnce.now);
    EXPECT_FALSE(atOnce.turnFirst);
    EXPECT_EQ(atOnce.then.feature, Feature::Door);
}

TEST(SpokenInstruction, StairsAndLifts) {
    auto stairs = instructionFrom("Careful: you are probably near the stairs. Take the stairs down. It is a "
                                  "long flight. At the bottom: Ground floor.");
    EXPECT_TRUE(stairs.now);
    EXPECT_EQ(stairs.task.feature, Feature::Stairs);
    EXPECT_EQ(stairs.task.vertical, Vertical::Down);
    auto lift =
        instructionFrom("Take the lift up. Inside, choose: level minus 1. When you get out: Gallery.");
    EXPECT_EQ(lift.task.feature, Feature::Elevator);
    EXPECT_EQ(lift.task.level, "-1");
    auto door = instructionFrom("In about 6 metres, go into the lift ahead.");
    EXPECT_EQ(door.task.feature, Feature::Door);
    EXPECT_TRUE(door.task.lift);
    EXPECT_FALSE(instructionFrom("Go through the door ahead.").task.lift);
    auto soon = instructionFrom("Soon, probably: stairs up.");
    EXPECT_FALSE(soon.now);
    EXPECT_EQ(soon.task.vertical, Vertical::Up);
}

TEST(SpokenInstruction, WhatIsNoOrderIsNotObeyed) {
    for (const char* words :
         {"", "Stairs, left, down.", "You are here: Atrium.", "I read: turn left. Centre.", "Door, centre.",
          "The camera works again.", "…", ". . .", "Next: .", "In about 6", "In about metres, go", "Then, "})
        EXPECT_NE(instructionFrom(words).task.feature, Feature::Door) << words;
    EXPECT_EQ(instructionFrom("Door, centre.").order, Order::Inform);
    EXPECT_EQ(instructionFrom("I read: turn left. Centre.").order, Order::Inform);
    EXPECT_EQ(instructionFrom("Stop. I cannot see. Please uncover the camera.").order, Order::Halt);
    EXPECT_EQ(instructionFrom("Keep moving forward for about 20 metres.").order, Order::GoOn);
    EXPECT_EQ(instructionFrom("You have probably arrived: Bar.").order, Order::Arrived);
    EXPECT_FALSE(instructionFrom("You have probably arrived: Bar.").stop);
    EXPECT_EQ(instructionFrom("Stop. You have arrived: Bar.").order, Order::Arrived);
    EXPECT_TRUE(instructionFrom("Stop. You have arrived: Bar.").stop);
    EXPECT_TRUE(instructionFrom("I am not sure where you are. Stop, and turn slowly to the right.").stop);
    EXPECT_EQ(instructionFrom("Now turn slowly to the left, past where you began.").sweep, SweepStep::Left);
}

} // namespace
} // namespace farol::simulation
