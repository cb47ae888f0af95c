#include "core/simulation/walk_instruction.h"

#include "core/guidance/clock.h"

#include <cmath>

namespace farol::simulation {

using guidance::Cue;
using guidance::CueKind;
using guidance::SweepStep;
using guidance::TurnWord;
using routing::Manoeuvre;
using routing::ManoeuvreKind;

namespace {

/// From so much on a turn behind a door is told.
constexpr double kTurnTold = 30.0 * kPi / 180.0;

/// A turn as people hear it: in the middle of its word's range.
Radians heard(Radians turn) {
    switch (guidance::turnWord(turn)) {
    case TurnWord::Straight:
        return fromDegrees(0.0);
    case TurnWord::SlightLeft:
        return fromDegrees(45.0);
    case TurnWord::Left:
        return fromDegrees(90.0);
    case TurnWord::SharpLeft:
        return fromDegrees(135.0);
    case TurnWord::Back:
        return fromDegrees(180.0);
    case TurnWord::SharpRight:
        return fromDegrees(-135.0);
    case TurnWord::Right:
        return fromDegrees(-90.0);
    case TurnWord::SlightRight:
        return fromDegrees(-45.0);
    }
    return {};
}

Feature featureOf(ManoeuvreKind kind) {
    switch (kind) {
    case ManoeuvreKind::Door:
        return Feature::Door;
    case ManoeuvreKind::Opening:
        return Feature::Opening;
    case ManoeuvreKind::Stairs:
        return Feature::Stairs;
    case ManoeuvreKind::Elevator:
        return Feature::Elevator;
    case ManoeuvreKind::Escalator:
        return Feature::Escalator;
    case ManoeuvreKind::Ramp:
        return Feature::Ramp;
    case ManoeuvreKind::Turn:
        return Feature::Turn;
    case ManoeuvreKind::Start:
    case ManoeuvreKind::Arrive:
        break;
    }
    return Feature::None;
}

WalkTask taskOf(const std::optional<Manoeuvre>& manoeuvre) {
    WalkTask task;
    if (!manoeuvre) return task;
    task.feature = featureOf(manoeuvre->kind);
    task.vertical = manoeuvre->vertical;
    bool gap = task.feature == Feature::Door || task.feature == Feature::Opening;
    bool turns = (gap && !manoeuvre->behind) || task.feature == Feature::Turn;
    if (turns && std::isfinite(manoeuvre->turn.value)) task.turn = heard(manoeuvre->turn);
    // Where the map tells how a door stands, the turn behind it is said apart, if it is one.
    if (gap && manoeuvre->behind && std::abs(manoeuvre->behind->value) >= kTurnTold)
        task.behind = heard(*manoeuvre->behind);
    task.side = manoeuvre->side;
    task.number = manoeuvre->number;
    task.alongWall = manoeuvre->alongWall;
    return task;
}

void takeTasks(const Cue& cue, WalkInstruction& instruction) {
    std::optional<Manoeuvre> first = cue.manoeuvre, second = cue.next;
    if (first && first->kind == ManoeuvreKind::Start && second) {
        first = second;
        second.reset();
    }
    instruction.task = taskOf(first);
    instruction.then = taskOf(second);
    if (!cue.facingWay) { // then no side is spoken
        instruction.task.side = routing::Side::None;
        instruction.task.number = 0;
        instruction.task.alongWall = false;
    }
    bool gap = instruction.task.feature == Feature::Door || instruction.task.feature == Feature::Opening;
    instruction.task.ahead = gap && first && cue.facingWay && instruction.task.side == routing::Side::None &&
                             (cue.hour ? *cue.hour % 12 == 0 : first->behind.has_value());
    instruction.task.lift = gap && (cue.intoKind == building::RegionKind::Elevator ||
                                    cue.fromKind == building::RegionKind::Elevator);
    if (instruction.task.lift) instruction.task.alongWall = false; // it is told by what it is
    instruction.task.into = cue.intoName;
    // "Next: your destination"; of two things told at once it is behind the second.
    instruction.task.last = second && second->kind == ManoeuvreKind::Arrive;
    if (instruction.task.feature == Feature::Elevator) instruction.task.level = cue.levelName;
    instruction.turnFirst = cue.turnFirst;
    if (instruction.turnFirst) instruction.turnFirst = heard(guidance::turnOnTheSpot(*instruction.turnFirst));
    // Of a door or an opening no hour is spoken either to one who does not face the way.
    if (cue.facingWay || !gap) instruction.hour = cue.hour;
    if (cue.distanceM && cue.sure) instruction.distanceM = std::round(*cue.distanceM);
    bool begins = cue.kind == CueKind::RouteStart || cue.kind == CueKind::OffRoute;
    // The distance of a beginning is that of the whole way.
    if (begins) instruction.distanceM.reset();
    if (begins && cue.firstM && cue.sure) instruction.distanceM = std::round(*cue.firstM);
}

} // namespace

bool sameTask(const WalkTask& a, const WalkTask& b) {
    auto same = [](const std::string& x, const std::string& y) { return x.empty() || y.empty() || x == y; };
    return a.feature == b.feature && a.vertical == b.vertical && same(a.into, b.into) &&
           same(a.level, b.level);
}

WalkInstruction instructionOf(const Cue& cue) {
    WalkInstruction instruction;
    switch (cue.kind) {
    case CueKind::RouteStart:
        takeTasks(cue, instruction);
        instruction.order = Order::Go;
        break;
    case CueKind::Prepare:
    case CueKind::Act:
        takeTasks(cue, instruction);
        instruction.now = cue.kind == CueKind::Act && !cue.turnFirst;
        instruction.order = Order::Go;
        break;
    case CueKind::OffRoute:
        takeTasks(cue, instruction);
        instruction.astray = true;
        instruction.order = instruction.task.feature == Feature::None ? Order::Halt : Order::Go;
        break;
    case CueKind::Reassure:
        instruction.order = Order::GoOn;
        break;
    case CueKind::Arrived:
    case CueKind::AlreadyThere:
        instruction.order = Order::Arrived;
        instruction.stop = cue.stop;
        break;
    case CueKind::Unsure:
        instruction.order = Order::Sweep;
        instruction.sweep = cue.sweep == SweepStep::None ? SweepStep::Right : cue.sweep;
        instruction.stop = instruction.sweep == SweepStep::Right;
        break;
    case CueKind::NoRoute:
        instruction.order = Order::Halt;
        break;
    case CueKind::Warning:
        if (cue.reason == guidance::CueReason::CameraLost ||
            cue.reason == guidance::CueReason::PictureCovered) {
            instruction.order = Order::Halt;
            instruction.stop = true;
        }
        break;
    case CueKind::Located:
    case CueKind::Detection:
    case CueKind::Text:
    case CueKind::Around:
    case CueKind::Itinerary:
    case CueKind::Chime:
        break;
    }
    return instruction;
}

} // namespace farol::simulation
