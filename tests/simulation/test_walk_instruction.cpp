#include "core/simulation/walk_instruction.h"

#include <gtest/gtest.h>

namespace farol::simulation {
namespace {

using guidance::Cue;
using guidance::CueKind;
using routing::Manoeuvre;
using routing::ManoeuvreKind;

Manoeuvre door(double turnDegrees) {
    Manoeuvre manoeuvre;
    manoeuvre.kind = ManoeuvreKind::Door;
    manoeuvre.turn = fromDegrees(turnDegrees);
    return manoeuvre;
}

Cue cueOf(CueKind kind, const Manoeuvre& manoeuvre) {
    Cue cue;
    cue.kind = kind;
    cue.manoeuvre = manoeuvre;
    return cue;
}

TEST(WalkInstruction, ATurnIsHeardAsItsWord) {
    EXPECT_NEAR(toDegrees(*instructionOf(cueOf(CueKind::Prepare, door(78.0))).task.turn), 90.0, 1e-9);
    EXPECT_NEAR(toDegrees(*instructionOf(cueOf(CueKind::Prepare, door(-40.0))).task.turn), -45.0, 1e-9);
    EXPECT_NEAR(toDegrees(*instructionOf(cueOf(CueKind::Prepare, door(12.0))).task.turn), 0.0, 1e-9);
}

TEST(WalkInstruction, WhatIsDoneAfterTheStartIsTheFirstTask) {
    Manoeuvre start;
    start.kind = ManoeuvreKind::Start;
    Cue cue = cueOf(CueKind::RouteStart, start);
    cue.next = door(90.0);
    cue.distanceM = 80.0;
    WalkInstruction heard = instructionOf(cue);
    EXPECT_EQ(heard.order, Order::Go);
    EXPECT_EQ(heard.task.feature, Feature::Door);
    EXPECT_EQ(heard.then.feature, Feature::None);
    EXPECT_FALSE(heard.distanceM) << "the length of the whole way is not how far the door is";
}

TEST(WalkInstruction, ADistanceThatIsNotSaidIsNotHeard) {
    Cue cue = cueOf(CueKind::Prepare, door(90.0));
    cue.distanceM = 5.2;
    EXPECT_EQ(instructionOf(cue).distanceM, 5.0);
    cue.sure = false;
    EXPECT_FALSE(instructionOf(cue).distanceM);
}

TEST(WalkInstruction, OnlySomeWordsAreOrders) {
    EXPECT_EQ(instructionOf(cueOf(CueKind::Located, {})).order, Order::Inform);
    EXPECT_EQ(instructionOf(cueOf(CueKind::Detection, {})).order, Order::Inform);
    EXPECT_EQ(instructionOf(cueOf(CueKind::Arrived, {})).order, Order::Arrived);
    EXPECT_EQ(instructionOf(cueOf(CueKind::AlreadyThere, {})).order, Order::Arrived);
    Cue left;
    left.kind = CueKind::OffRoute;
    EXPECT_EQ(instructionOf(left).order, Order::Halt) << "stop for a moment";
    Cue lost;
    lost.kind = CueKind::Warning;
    lost.reason = guidance::CueReason::CameraLost;
    EXPECT_EQ(instructionOf(lost).order, Order::Halt);
    lost.reason = guidance::CueReason::RecordingStopped;
    EXPECT_EQ(instructionOf(lost).order, Order::Inform);
}

} // namespace
} // namespace farol::simulation
