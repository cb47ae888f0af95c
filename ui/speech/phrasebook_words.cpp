// The small words: things, zones, turns, directions.

#include "core/guidance/clock.h"
#include "ui/speech/phrasebook.h"

#include <algorithm>
#include <cmath>

namespace farol::ui {

using guidance::TurnWord;

namespace {

/// Nobody turns more finely than this by feel (field.md 4.3: 45 and 60 degrees are already confused).
constexpr int kDegreeStep = 15;

int roundedDegrees(Radians turn) {
    const double degrees = std::abs(toDegrees(wrapped(turn)));
    return std::clamp(static_cast<int>(std::lround(degrees / kDegreeStep)) * kDegreeStep, kDegreeStep, 180);
}

/// A corner that is nearly square is one: people turn square there, and the walls see to the rest.
Radians squared(Radians turn) {
    constexpr double kNearlyDegrees = 22.5;
    const double degrees = toDegrees(wrapped(turn));
    if (std::abs(std::abs(degrees) - 90.0) > kNearlyDegrees) return turn;
    return fromDegrees(degrees > 0.0 ? 90.0 : -90.0);
}

bool toTheLeft(Radians turn) {
    return wrapped(turn).value > 0.0;
}

} // namespace

QString Phrasebook::kindWord(Kind kind) {
    switch (kind) {
    case Kind::Place:
        return tr("known place");
    case Kind::Door:
        return tr("door");
    case Kind::Stairs:
        return tr("stairs");
    case Kind::Elevator:
        return tr("lift");
    case Kind::Extinguisher:
        return tr("extinguisher");
    case Kind::ExitSign:
        return tr("exit sign");
    case Kind::Sign:
        return tr("sign");
    case Kind::Text:
        return tr("text");
    case Kind::Rectangle:
        return tr("rectangular shape");
    case Kind::Window:
        return tr("window");
    case Kind::Locker:
        return tr("locker");
    case Kind::Poster:
        return tr("poster");
    case Kind::Fountain:
        return tr("drinking fountain");
    case Kind::Hydrant:
        return tr("hydrant");
    case Kind::VendingMachine:
        return tr("vending machine");
    case Kind::Bin:
        return tr("waste bin");
    case Kind::Plant:
        return tr("plant");
    case Kind::Furniture:
        return tr("piece of furniture");
    case Kind::Picture:
        return tr("picture");
    case Kind::Other:
        break;
    }
    return tr("object");
}

/// As in "On your left: an extinguisher."
QString Phrasebook::thingWords(Kind kind) {
    switch (kind) {
    case Kind::Door:
        return tr("a door");
    case Kind::Elevator:
        return tr("a lift");
    case Kind::Extinguisher:
        return tr("an extinguisher");
    case Kind::ExitSign:
        return tr("an exit sign");
    case Kind::Sign:
        return tr("a sign");
    case Kind::Text:
        return tr("a text");
    case Kind::Window:
        return tr("a window");
    case Kind::Locker:
        return tr("a locker");
    case Kind::Poster:
        return tr("a poster");
    case Kind::Fountain:
        return tr("a drinking fountain");
    case Kind::Hydrant:
        return tr("a hydrant");
    case Kind::VendingMachine:
        return tr("a vending machine");
    case Kind::Bin:
        return tr("a waste bin");
    case Kind::Plant:
        return tr("a plant");
    case Kind::Furniture:
        return tr("a piece of furniture");
    case Kind::Picture:
        return tr("a picture");
    case Kind::Stairs:
    case Kind::Place:
    case Kind::Rectangle:
    case Kind::Other:
        break;
    }
    return kindWord(kind);
}

QString Phrasebook::zoneWords(Zone zone) {
    QStringList words;
    if (zone.column == Column::Left) words << tr("left");
    if (zone.column == Column::Right) words << tr("right");
    if (zone.row == Row::Up) words << tr("up");
    if (zone.row == Row::Down) words << tr("down");
    return words.isEmpty() ? tr("centre") : words.join(QStringLiteral(", "));
}

QString Phrasebook::hourWord(int hour) {
    switch (hour) {
    case 1:
        return tr("1 o'clock");
    case 2:
        return tr("2 o'clock");
    case 3:
        return tr("3 o'clock");
    case 4:
        return tr("4 o'clock");
    case 5:
        return tr("5 o'clock");
    case 6:
        return tr("6 o'clock");
    case 7:
        return tr("7 o'clock");
    case 8:
        return tr("8 o'clock");
    case 9:
        return tr("9 o'clock");
    case 10:
        return tr("10 o'clock");
    case 11:
        return tr("11 o'clock");
    default:
        return tr("12 o'clock");
    }
}

QString Phrasebook::turnWords(Radians turn) const {
    if (!std::isfinite(turn.value)) return tr("go straight on");
    if (m_style == DirectionStyle::Clock) {
        const int hour = guidance::clockHour(squared(turn));
        if (hour == 12) return tr("go straight on");
        //: %1 is an hour, such as "9 o'clock"
        return hour == 1 ? tr("turn to %1", "one o'clock").arg(hourWord(hour))
                         : tr("turn to %1").arg(hourWord(hour));
    }
    const TurnWord word = guidance::turnWord(turn);
    if (word == TurnWord::Straight) return tr("go straight on");
    if (m_style == DirectionStyle::Degrees) {
        const int degrees = roundedDegrees(squared(turn));
        if (degrees == 180) return tr("turn around");
        return toTheLeft(turn) ? tr("turn %1 degrees to the left").arg(degrees)
                               : tr("turn %1 degrees to the right").arg(degrees);
    }
    switch (word) {
    case TurnWord::SlightLeft:
        return tr("turn slightly left");
    case TurnWord::Left:
        return tr("turn left");
    case TurnWord::SharpLeft:
        return tr("turn sharply left");
    case TurnWord::SlightRight:
        return tr("turn slightly right");
    case TurnWord::Right:
        return tr("turn right");
    case TurnWord::SharpRight:
        return tr("turn sharply right");
    case TurnWord::Back:
        return tr("turn around");
    case TurnWord::Straight:
        break;
    }
    return tr("go straight on");
}

/// For somebody who stands: a corner is walked round, this is not.
QString Phrasebook::turnOnTheSpot(Radians turn) const {
    if (!std::isfinite(turn.value)) return turnWords(turn);
    turn = guidance::turnOnTheSpot(turn);
    if (m_style != DirectionStyle::LeftRight) return turnWords(turn);
    switch (guidance::turnWord(turn)) {
    case TurnWord::SlightLeft:
        return tr("turn slightly left", "on the spot");
    case TurnWord::Left:
        return tr("turn left", "on the spot");
    case TurnWord::SharpLeft:
        return tr("turn sharply left", "on the spot");
    case TurnWord::SlightRight:
        return tr("turn slightly right", "on the spot");
    case TurnWord::Right:
        return tr("turn right", "on the spot");
    case TurnWord::SharpRight:
        return tr("turn sharply right", "on the spot");
    case TurnWord::Back:
    case TurnWord::Straight:
        break;
    }
    return turnWords(turn);
}

/// The same as a part of "go through the door, ..."; empty for straight on, which has a sentence of its own.
QString Phrasebook::turningWords(Radians turn) const {
    if (!std::isfinite(turn.value)) return {};
    if (m_style == DirectionStyle::Clock) {
        const int hour = guidance::clockHour(squared(turn));
        if (hour == 12) return {};
        //: %1 is an hour, such as "9 o'clock"
        return hour == 1 ? tr("turning to %1", "one o'clock").arg(hourWord(hour))
                         : tr("turning to %1").arg(hourWord(hour));
    }
    const TurnWord word = guidance::turnWord(turn);
    if (word == TurnWord::Straight) return {};
    if (m_style == DirectionStyle::Degrees) {
        const int degrees = roundedDegrees(squared(turn));
        if (degrees == 180) return tr("turning around");
        return toTheLeft(turn) ? tr("turning %1 degrees to the left").arg(degrees)
                               : tr("turning %1 degrees to the right").arg(degrees);
    }
    switch (word) {
    case TurnWord::SlightLeft:
        return tr("turning slightly left");
    case TurnWord::Left:
        return tr("turning left");
    case TurnWord::SharpLeft:
        return tr("turning sharply left");
    case TurnWord::SlightRight:
        return tr("turning slightly right");
    case TurnWord::Right:
        return tr("turning right");
    case TurnWord::SharpRight:
        return tr("turning sharply right");
    case TurnWord::Back:
        return tr("turning around");
    case TurnWord::Straight:
        break;
    }
    return {};
}

/// Where something is, seen from the way the user faces: "on your left", "at 9 o'clock", "90 degrees to your
/// left".
QString Phrasebook::whereWords(int hour, routing::Side side) const {
    // Who counts in degrees still has a left and a right hand at the wall.
    if (m_style == DirectionStyle::Degrees && side != routing::Side::None)
        return side == routing::Side::Left ? tr("on your left") : tr("on your right");
    const int h = ((hour % 12) + 12) % 12; // 0 is straight ahead
    if (m_style == DirectionStyle::Clock) {
        //: %1 is an hour, such as "9 o'clock"
        return h == 1 ? tr("at %1", "one o'clock").arg(hourWord(h)) : tr("at %1").arg(hourWord(h));
    }
    if (h == 0) return tr("straight ahead");
    if (h == 6) return tr("behind you");
    if (m_style == DirectionStyle::Degrees) {
        return h < 6 ? tr("%1 degrees to your right").arg(h * 30)
                     : tr("%1 degrees to your left").arg((12 - h) * 30);
    }
    switch (h) {
    case 1:
        return tr("ahead, slightly to your right");
    case 5:
        return tr("behind you, on the right");
    case 7:
        return tr("behind you, on the left");
    case 11:
        return tr("ahead, slightly to your left");
    default:
        return h < 6 ? tr("on your right") : tr("on your left");
    }
}

/// Of a door or an opening; beyond the last one nobody counts.
QString Phrasebook::ordinal(int number) {
    switch (number) {
    case 1:
        return tr("first", "door or opening");
    case 2:
        return tr("second", "door or opening");
    case 3:
        return tr("third", "door or opening");
    case 4:
        return tr("fourth", "door or opening");
    case 5:
        return tr("fifth", "door or opening");
    case 6:
        return tr("sixth", "door or opening");
    case 7:
        return tr("seventh", "door or opening");
    case 8:
        return tr("eighth", "door or opening");
    default:
        return {};
    }
}

/// Things that hand or cane finds.
QString Phrasebook::markWords(Kind kind) {
    switch (kind) {
    case Kind::Extinguisher:
        return tr("after the extinguisher");
    case Kind::Fountain:
        return tr("after the drinking fountain");
    case Kind::Hydrant:
        return tr("after the hydrant");
    case Kind::VendingMachine:
        return tr("after the vending machine");
    case Kind::Bin:
        return tr("after the waste bin");
    case Kind::Plant:
        return tr("after the plant");
    case Kind::Locker:
        return tr("after the locker");
    default:
        return {};
    }
}

/// What a place without a name is; empty where that is not known either.
QString Phrasebook::regionWord(building::RegionKind kind) {
    switch (kind) {
    case building::RegionKind::Room:
        return tr("a room");
    case building::RegionKind::Corridor:
        return tr("a corridor");
    case building::RegionKind::Hall:
        return tr("a hall");
    case building::RegionKind::Stairwell:
        return tr("a stairwell");
    case building::RegionKind::Elevator:
        return tr("a lift");
    case building::RegionKind::Toilet:
        return tr("a toilet");
    case building::RegionKind::Outside:
        return tr("outside the building");
    case building::RegionKind::Other:
        break;
    }
    return {};
}

/// Counter-clockwise from north, as maps are drawn.
QString Phrasebook::compassWords(Radians fromNorth) {
    const int eighth = static_cast<int>(std::lround(-toDegrees(wrapped(fromNorth)) / 45.0) + 8) % 8;
    switch (eighth) {
    case 1:
        return tr("to the north-east");
    case 2:
        return tr("to the east");
    case 3:
        return tr("to the south-east");
    case 4:
        return tr("to the south");
    case 5:
        return tr("to the south-west");
    case 6:
        return tr("to the west");
    case 7:
        return tr("to the north-west");
    default:
        return tr("to the north");
    }
}

} // namespace farol::ui
