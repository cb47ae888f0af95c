#include "tests/ui/representative_cues.h"

namespace farol::test {

using guidance::Cue;
using guidance::CueKind;
using guidance::CueReason;
using guidance::SweepStep;
using routing::Manoeuvre;
using routing::ManoeuvreKind;
using routing::Vertical;

namespace {

Manoeuvre at(ManoeuvreKind kind, double turnDegrees = 0.0, Vertical vertical = Vertical::None,
             std::optional<int> steps = std::nullopt) {
    Manoeuvre manoeuvre;
    manoeuvre.kind = kind;
    manoeuvre.turn = fromDegrees(turnDegrees);
    manoeuvre.vertical = vertical;
    manoeuvre.steps = steps;
    return manoeuvre;
}

Cue cueOf(CueKind kind, std::optional<Manoeuvre> manoeuvre = std::nullopt, const char* into = "") {
    Cue cue;
    cue.kind = kind;
    cue.manoeuvre = manoeuvre;
    cue.intoName = into;
    return cue;
}

Cue with(Cue cue, std::optional<int> hour, std::optional<double> metres = std::nullopt) {
    cue.hour = hour;
    cue.distanceM = metres;
    return cue;
}

Cue then(Cue cue, const Manoeuvre& next) {
    cue.next = next;
    return cue;
}

/// Round a small room, as the how-manyeth door along that wall.
Manoeuvre alongWall(ManoeuvreKind kind, routing::Side side, int number, double behindDegrees = 0.0) {
    Manoeuvre manoeuvre = at(kind);
    manoeuvre.side = side;
    manoeuvre.number = number;
    manoeuvre.alongWall = true;
    manoeuvre.behind = fromDegrees(behindDegrees);
    return manoeuvre;
}

Cue unsure(Cue cue) {
    cue.sure = false;
    return cue;
}

Cue toLevel(Cue cue, const char* level) {
    cue.levelName = level;
    return cue;
}

Cue about(CueKind kind, const char* region, CueReason reason = CueReason::None) {
    Cue cue = cueOf(kind);
    cue.regionName = region;
    cue.reason = reason;
    return cue;
}

Cue seen(Kind kind, Zone zone, const char* text = "") {
    Cue cue = cueOf(CueKind::Detection);
    cue.objectKind = kind;
    cue.zone = zone;
    cue.text = text;
    return cue;
}

void addStarts(std::vector<NamedCue>& list) {
    Cue door = with(cueOf(CueKind::RouteStart, at(ManoeuvreKind::Door, 90), "Corridor B"), 9, 42.0);
    door.regionName = "Library";
    list.push_back({"start, door", door, true});
    Cue behind = with(door, std::nullopt, 42.0);
    behind.turnFirst = fromDegrees(178);
    list.push_back({"start, behind", behind, true});
    behind.turnFirst = fromDegrees(-90);
    list.push_back({"start, to the right, unsure", unsure(behind), true});
    Cue blind = with(door, std::nullopt);
    list.push_back({"start, door, no direction, no length", blind, false});
    list.push_back({"start, door, unsure", unsure(door), false});
    Cue begin = then(cueOf(CueKind::RouteStart, at(ManoeuvreKind::Start), "Stairwell"),
                     at(ManoeuvreKind::Stairs, 0, Vertical::Up, 9));
    begin.regionName = "Library";
    list.push_back({"start, then stairs", toLevel(begin, "1"), false});
    Cue turn = with(cueOf(CueKind::RouteStart, at(ManoeuvreKind::Turn, -90)), std::nullopt, 1.2);
    turn.regionName = "Room 2.14";
    list.push_back({"start, turn", turn, true});
    list.push_back({"start, turn, unsure", unsure(turn), false});
    list.push_back({"start, nothing known", cueOf(CueKind::RouteStart), false});
    Cue far = with(cueOf(CueKind::RouteStart, at(ManoeuvreKind::Door, 90), "Corridor B"), std::nullopt, 42.0);
    far.regionName = "Library";
    far.firstM = 14.0;
    far.facingWay = false;
    far.manoeuvre->atM = 14.0;
    list.push_back({"start, door far off, facing unknown", far, false});
    far.turnFirst = fromDegrees(150);
    far.facingWay = true;
    far.distanceM = 15.0; // the length of the way says no more than the first distance
    list.push_back({"start, door far off, behind", far, true});
}

void addManoeuvres(std::vector<NamedCue>& list, CueKind kind, const QString& word) {
    auto add = [&](const char* label, const Cue& cue, bool styled = false) {
        list.push_back({word + QLatin1String(label), cue, styled});
    };
    const Cue door = cueOf(kind, at(ManoeuvreKind::Door, 90), "Corridor B");
    add("door left", door, true);
    add("door left, unsure", unsure(door));
    add("door on the left", with(door, 9, 6.2), true);
    add("door on the left, unsure", unsure(with(door, 9, 6.2)), true);
    add("door left, then right", then(door, at(ManoeuvreKind::Turn, -90)), true);
    add("door ahead, straight", with(cueOf(kind, at(ManoeuvreKind::Door, 5), "Library"), 12, 3.0), true);
    add("door without a name", cueOf(kind, at(ManoeuvreKind::Door, -90)));
    add("door, then arrive",
        then(cueOf(kind, at(ManoeuvreKind::Door, 0), "Library"), at(ManoeuvreKind::Arrive)));
    add("turn, then arrive", then(cueOf(kind, at(ManoeuvreKind::Turn, 90)), at(ManoeuvreKind::Arrive)));
    add("stairs up, then arrive",
        then(toLevel(cueOf(kind, at(ManoeuvreKind::Stairs, 0, Vertical::Up, 9), "Library"), "2"),
             at(ManoeuvreKind::Arrive)));
    add("opening", cueOf(kind, at(ManoeuvreKind::Opening, 0), "Hall"));
    add("opening slightly right, unsure", unsure(cueOf(kind, at(ManoeuvreKind::Opening, -35), "Hall")), true);
    add("opening, then door",
        then(cueOf(kind, at(ManoeuvreKind::Opening, 90), "Hall"), at(ManoeuvreKind::Door, -90)));
    add("stairs up",
        toLevel(cueOf(kind, at(ManoeuvreKind::Stairs, 170, Vertical::Up, 9), "Corridor 2"), "2"));
    add("stairs down, long",
        toLevel(cueOf(kind, at(ManoeuvreKind::Stairs, 0, Vertical::Down, 13)), "Floor 0"));
    add("stairs down, one step", with(cueOf(kind, at(ManoeuvreKind::Stairs, 0, Vertical::Down, 1)), 12));
    add("stairs up, unsure", unsure(cueOf(kind, at(ManoeuvreKind::Stairs, 0, Vertical::Up))));
    add("stairs, direction unknown", cueOf(kind, at(ManoeuvreKind::Stairs)));
    add("lift up", toLevel(cueOf(kind, at(ManoeuvreKind::Elevator, 0, Vertical::Up), "Hall 3"), "3"));
    add("lift down to the basement",
        with(toLevel(cueOf(kind, at(ManoeuvreKind::Elevator, 0, Vertical::Down)), "-1"), 4));
    add("lift, unsure", unsure(cueOf(kind, at(ManoeuvreKind::Elevator))));
    add("escalator up", toLevel(cueOf(kind, at(ManoeuvreKind::Escalator, 0, Vertical::Up), "Shops"), "1"));
    add("escalator down, unsure",
        unsure(with(cueOf(kind, at(ManoeuvreKind::Escalator, 0, Vertical::Down)), 6)), true);
    add("escalator, direction unknown", cueOf(kind, at(ManoeuvreKind::Escalator)));
    add("ramp up", cueOf(kind, at(ManoeuvreKind::Ramp, 0, Vertical::Up), "Gallery"));
    add("ramp down", with(cueOf(kind, at(ManoeuvreKind::Ramp, 90, Vertical::Down), "Gallery"), 1, 12.0),
        true);
    add("ramp, level", cueOf(kind, at(ManoeuvreKind::Ramp, 90), "Gallery"));
    add("turn slightly left", cueOf(kind, at(ManoeuvreKind::Turn, 40)), true);
    add("turn left", cueOf(kind, at(ManoeuvreKind::Turn, 90)), true);
    add("turn sharply left", cueOf(kind, at(ManoeuvreKind::Turn, 135)), true);
    add("turn around", cueOf(kind, at(ManoeuvreKind::Turn, 180)), true);
    add("turn sharply right", cueOf(kind, at(ManoeuvreKind::Turn, -135)), true);
    add("turn right", with(cueOf(kind, at(ManoeuvreKind::Turn, -90)), std::nullopt, 23.0), true);
    add("turn slightly right", cueOf(kind, at(ManoeuvreKind::Turn, -40)), true);
    add("straight on", cueOf(kind, at(ManoeuvreKind::Turn, 3)), true);
    add("turn left, then stairs",
        then(cueOf(kind, at(ManoeuvreKind::Turn, 90)), at(ManoeuvreKind::Stairs, 0, Vertical::Down)));
    add("turn right, unsure", unsure(cueOf(kind, at(ManoeuvreKind::Turn, -90))));
    add("start", cueOf(kind, at(ManoeuvreKind::Start)));
    add("arrive", cueOf(kind, at(ManoeuvreKind::Arrive), "Library"));
    add("arrive, unsure", unsure(cueOf(kind, at(ManoeuvreKind::Arrive), "Library")));
    add("arrive, no name", cueOf(kind, at(ManoeuvreKind::Arrive)));
}

void addDirections(std::vector<NamedCue>& list) {
    for (int hour = 1; hour <= 12; ++hour) {
        Cue cue = with(cueOf(CueKind::Act, at(ManoeuvreKind::Door, 4.0 - 30.0 * hour)), hour);
        list.push_back({QStringLiteral("door and turn at %1").arg(hour), cue, true});
    }
    Cue behind =
        then(cueOf(CueKind::Act, at(ManoeuvreKind::Door, -90), "Corridor B"), at(ManoeuvreKind::Door, 0));
    behind.turnFirst = fromDegrees(-175);
    list.push_back({"door behind, and another", behind, true});
    list.push_back({"door behind, and another, unsure", unsure(behind), true});
}

void addWalls(std::vector<NamedCue>& list) {
    Cue right =
        cueOf(CueKind::Prepare, alongWall(ManoeuvreKind::Door, routing::Side::Right, 2, -90), "Corridor B");
    right.soon = false;
    list.push_back({"second door along the wall", right, true});
    list.push_back({"second door along the wall, unsure", unsure(right), false});
    Cue left = cueOf(CueKind::Prepare, alongWall(ManoeuvreKind::Door, routing::Side::Left, 1), "Hall");
    left.soon = false;
    list.push_back({"first door along the wall", left, true});
    for (routing::Side side : {routing::Side::Left, routing::Side::Right}) {
        Cue opening = cueOf(CueKind::Prepare, alongWall(ManoeuvreKind::Opening, side, 1), "Hall");
        opening.soon = false;
        list.push_back({"opening along the wall", opening, false});
    }
    Cue far = then(with(cueOf(CueKind::Prepare, at(ManoeuvreKind::Door, 0)), std::nullopt, 6.0),
                   alongWall(ManoeuvreKind::Door, routing::Side::Left, 3, 90));
    list.push_back({"door, then another along the wall", far, true});
    Cue now = far;
    now.kind = CueKind::Act;
    now.distanceM.reset();
    list.push_back({"now a door, then another along the wall", now, false});
}

void addState(std::vector<NamedCue>& list) {
    list.push_back({"reassure", cueOf(CueKind::Reassure), false});
    list.push_back({"reassure, metres", with(cueOf(CueKind::Reassure), std::nullopt, 11.6), false});
    list.push_back({"reassure, unsure", unsure(cueOf(CueKind::Reassure)), false});
    list.push_back({"arrived", about(CueKind::Arrived, "Library"), false});
    list.push_back({"arrived, unsure", unsure(about(CueKind::Arrived, "Library")), false});
    list.push_back({"arrived, no name", cueOf(CueKind::Arrived), false});
    Cue stop = about(CueKind::Arrived, "Library");
    stop.stop = true;
    list.push_back({"arrived, at a door", stop, false});
    list.push_back({"arrived, at a door, unsure", unsure(stop), false});
    stop.kind = CueKind::AlreadyThere;
    list.push_back({"already there, at a door", stop, false});
    list.push_back({"off route", cueOf(CueKind::OffRoute), false});
    list.push_back({"off route, unsure", unsure(cueOf(CueKind::OffRoute)), false});
    list.push_back({"off route, new way",
                    with(cueOf(CueKind::OffRoute, at(ManoeuvreKind::Door, -90), "Hall"), 5), true});
    Cue back = cueOf(CueKind::OffRoute, at(ManoeuvreKind::Opening, -90), "Hall");
    back.turnFirst = fromDegrees(-175);
    list.push_back({"off route, new way behind", back, false});
    back.firstM = 8.0;
    back.turnFirst = fromDegrees(-90);
    list.push_back({"off route, new way far off", back, false});
    Cue waits = cueOf(CueKind::Prepare, at(ManoeuvreKind::Door, 90), "Hall");
    waits.soon = false;
    list.push_back({"told again, perhaps far off", waits, false});
    list.push_back({"told again, perhaps far off, unsure", unsure(waits), false});
    waits.turnFirst = fromDegrees(180);
    list.push_back({"told again, behind", waits, false});
    Cue asked = cueOf(CueKind::Unsure);
    asked.sweep = SweepStep::Up;
    asked.asked = true;
    list.push_back({"asked while looking around", asked, false});
    list.push_back(
        {"off route, new way, turn", cueOf(CueKind::OffRoute, at(ManoeuvreKind::Turn, 180)), false});
    list.push_back(
        {"off route, no way", about(CueKind::OffRoute, "Library", CueReason::DestinationUnreachable), false});
    for (SweepStep step : {SweepStep::None, SweepStep::Right, SweepStep::Left, SweepStep::Up, SweepStep::Down,
                           SweepStep::AskForHelp, SweepStep::Done}) {
        Cue look = cueOf(CueKind::Unsure);
        look.sweep = step;
        list.push_back(
            {QStringLiteral("unsure, look: ") + QString::fromStdString(sweepStepName(step)), look, false});
    }
    list.push_back({"located", about(CueKind::Located, "Corridor B"), false});
    list.push_back({"located, level", toLevel(about(CueKind::Located, "Corridor B"), "-1"), false});
    list.push_back({"located, unsure", unsure(about(CueKind::Located, "Corridor B")), false});
    list.push_back({"located, nowhere", cueOf(CueKind::Located), false});
    list.push_back(
        {"no route, unknown", about(CueKind::NoRoute, "Bar", CueReason::DestinationUnknown), false});
    list.push_back(
        {"no route, unknown, no name", about(CueKind::NoRoute, "", CueReason::DestinationUnknown), false});
    list.push_back({"no route", about(CueKind::NoRoute, "Bar", CueReason::DestinationUnreachable), false});
    list.push_back({"no route, no name", cueOf(CueKind::NoRoute), false});
    list.push_back({"already there", about(CueKind::AlreadyThere, "Library"), false});
    list.push_back({"already there, unsure", unsure(about(CueKind::AlreadyThere, "Library")), false});
    list.push_back({"already there, no name", cueOf(CueKind::AlreadyThere), false});
    for (CueReason reason : {CueReason::CameraLost, CueReason::CameraBack, CueReason::RecordingStopped,
                             CueReason::PictureCovered, CueReason::FrameSkipped, CueReason::None}) {
        list.push_back({QStringLiteral("warning %1").arg(static_cast<int>(reason)),
                        about(CueKind::Warning, "", reason), false});
    }
}

void addDetections(std::vector<NamedCue>& list) {
    list.push_back({"detection, paper", seen(Kind::Extinguisher, {Column::Left, Row::Down}), false});
    list.push_back({"detection, hour", with(seen(Kind::Stairs, {Column::Right, Row::Up}), 3), true});
    list.push_back({"detection, centre", seen(Kind::ExitSign, {Column::Centre, Row::Centre}), false});
    list.push_back({"detection, with text", seen(Kind::Sign, {Column::Left, Row::Centre}, "2.14"), false});
    list.push_back({"detection, unsure", unsure(seen(Kind::Door, {Column::Right, Row::Centre})), false});
    for (Kind kind : allKinds()) {
        list.push_back({QStringLiteral("kind %1").arg(QLatin1String(kindName(kind).data())),
                        seen(kind, {Column::Centre, Row::Up}), false});
    }
    Cue text = seen(Kind::Text, {Column::Left, Row::Up}, "Library.");
    text.kind = CueKind::Text;
    list.push_back({"text", text, false});
    text.text =
        "Please close the fire door behind you at all times and keep the escape route clear of furniture";
    list.push_back({"text, a notice", text, false});
}

Manoeuvre doorOn(routing::Side side, int number, double behindDegrees) {
    Manoeuvre door = at(ManoeuvreKind::Door, (side == routing::Side::Left ? 90.0 : -90.0) + behindDegrees);
    door.side = side;
    door.number = number;
    door.behind = fromDegrees(behindDegrees);
    return door;
}

void addCountedDoors(std::vector<NamedCue>& list) {
    Cue cue =
        with(cueOf(CueKind::Prepare, doorOn(routing::Side::Left, 3, 0.0), "Library"), std::nullopt, 6.0);
    cue.routeVersion = 1;
    list.push_back({"third door on the left", cue, true});
    cue.mark = guidance::Mark{Kind::Extinguisher, routing::Side::Right};
    list.push_back({"door after the extinguisher", cue, true});
    cue.mark.reset();
    cue.facingWay = false;
    list.push_back({"door, facing unknown", cue, false});
    cue = cueOf(CueKind::Act, doorOn(routing::Side::Right, 1, -90.0), "Corridor B");
    cue.routeVersion = 1;
    list.push_back({"door on the right, then right", cue, true});
    cue.manoeuvre->side = routing::Side::None;
    cue.manoeuvre->turn = cue.manoeuvre->behind.value();
    list.push_back({"door ahead, then right", cue, true});
    cue = toLevel(cueOf(CueKind::Act, at(ManoeuvreKind::Elevator, 0, Vertical::Up)), "3");
    cue.staying = true;
    list.push_back({"in the lift already", cue, false});
    cue = cueOf(CueKind::OffRoute, doorOn(routing::Side::Right, 1, 0.0), "Library");
    cue.turnFirst = fromDegrees(175.0);
    cue.deviation = guidance::Deviation::WrongWay;
    list.push_back({"the wrong way", cue, true});
    cue.deviation = guidance::Deviation::Missed;
    list.push_back({"too far", cue, false});
    list.push_back({"too far, unsure", unsure(cue), false});
    cue.deviation = guidance::Deviation::WrongWay;
    list.push_back({"the wrong way, unsure", unsure(cue), false});
}

void addAnswers(std::vector<NamedCue>& list) {
    Cue around = about(CueKind::Around, "Corridor B");
    guidance::Surrounding door, other, thing;
    door.access = other.access = ManoeuvreKind::Door;
    door.name = "Library";
    door.direction = fromDegrees(90.0);
    other.behind = building::RegionKind::Toilet;
    other.direction = fromDegrees(-90.0);
    thing.kind = Kind::Extinguisher;
    thing.direction = fromDegrees(95.0);
    around.around = {door, other, thing};
    for (auto bearing : {guidance::Bearing::Facing, guidance::Bearing::AlongWay, guidance::Bearing::Map}) {
        around.bearing = bearing;
        list.push_back({QStringLiteral("around, ") + QString::fromStdString(bearingName(bearing)), around,
                        bearing == guidance::Bearing::Facing});
    }
    around.around.clear();
    list.push_back({"around, nothing", around, false});
    Cue route = with(about(CueKind::Itinerary, "Library"), std::nullopt, 31.0);
    route.steps = {
        cueOf(CueKind::Act, at(ManoeuvreKind::Turn, 90)),
        toLevel(cueOf(CueKind::Act, at(ManoeuvreKind::Stairs, 0, Vertical::Up, 9)), "2"),
        then(cueOf(CueKind::Act, doorOn(routing::Side::Left, 2, 0.0), "Library"), at(ManoeuvreKind::Arrive))};
    list.push_back({"itinerary", route, true});
    route.steps.insert(route.steps.end(), 8, route.steps.front());
    list.push_back({"itinerary, long", route, false});
    list.push_back({"no destination", about(CueKind::NoRoute, "", CueReason::NoDestination), false});
    Cue unnamed = toLevel(about(CueKind::Located, ""), "2");
    unnamed.regionKind = building::RegionKind::Corridor;
    list.push_back({"located, no name", unnamed, false});
}

/// Words that nothing above needs: every thing, side of the map, number, mark and hedged place.
void addEveryWord(std::vector<NamedCue>& list) {
    for (int number = 4; number <= 8; ++number) {
        Cue cue =
            with(cueOf(CueKind::Prepare, doorOn(routing::Side::Right, number, 0.0)), std::nullopt, 20.0);
        cue.routeVersion = 1;
        list.push_back({QStringLiteral("door number %1").arg(number), cue, false});
    }
    for (Kind kind :
         {Kind::Fountain, Kind::Hydrant, Kind::VendingMachine, Kind::Bin, Kind::Plant, Kind::Locker}) {
        Cue cue = cueOf(CueKind::Prepare, doorOn(routing::Side::Left, 1, 0.0));
        cue.mark = guidance::Mark{kind, routing::Side::None};
        list.push_back({QStringLiteral("mark %1").arg(QLatin1String(kindName(kind).data())), cue, false});
    }
    Cue around = about(CueKind::Around, "Corridor B");
    around.bearing = guidance::Bearing::Map;
    int eighth = 0;
    for (Kind kind : allKinds()) {
        guidance::Surrounding thing;
        thing.kind = kind;
        thing.direction = fromDegrees(-45.0 * (eighth++ % 8));
        around.around = {thing};
        list.push_back(
            {QStringLiteral("around, %1").arg(QLatin1String(kindName(kind).data())), around, false});
    }
    for (auto behind : {building::RegionKind::Room, building::RegionKind::Hall,
                        building::RegionKind::Stairwell, building::RegionKind::Outside}) {
        guidance::Surrounding door;
        door.access = ManoeuvreKind::Door;
        door.behind = behind;
        around.around = {door};
        list.push_back({QStringLiteral("around, door to %1").arg(static_cast<int>(behind)), around, false});
        Cue unnamed = about(CueKind::Located, "");
        unnamed.regionKind = behind;
        list.push_back({QStringLiteral("located in %1").arg(static_cast<int>(behind)), unnamed, false});
    }
    for (auto kind :
         {ManoeuvreKind::Stairs, ManoeuvreKind::Elevator, ManoeuvreKind::Ramp, ManoeuvreKind::Escalator}) {
        const QString name = QString::fromStdString(routing::manoeuvreKindName(kind));
        const Cue cue = unsure(cueOf(CueKind::Act, at(kind, 0, Vertical::Up)));
        list.push_back({name + QStringLiteral(", unsure, somewhere"), cue, false});
        list.push_back({name + QStringLiteral(", unsure, on the right"), with(cue, 3), false});
    }
    for (double turn : {180.0, 135.0, -135.0, 45.0, 0.0})
        list.push_back({QStringLiteral("through a door, turning %1").arg(turn),
                        cueOf(CueKind::Act, at(ManoeuvreKind::Door, turn)), false});
    for (double turn : {45.0, 90.0, 135.0, -45.0, -135.0, 150.0}) {
        Cue cue = cueOf(CueKind::Prepare, at(ManoeuvreKind::Door));
        cue.turnFirst = fromDegrees(turn);
        list.push_back({QStringLiteral("turn %1 on the spot").arg(turn), cue, true});
    }
    for (auto kind : {ManoeuvreKind::Door, ManoeuvreKind::Opening}) {
        Manoeuvre straight = at(kind);
        straight.behind = fromDegrees(0.0);
        const QString name = QString::fromStdString(routing::manoeuvreKindName(kind));
        const Cue two = then(cueOf(CueKind::Act, straight), straight);
        list.push_back({name + QStringLiteral(", and another straight behind"), two, false});
        Cue bend = two;
        bend.manoeuvre->behind = fromDegrees(90.0);
        list.push_back({name + QStringLiteral(", a turn, and another straight on"), bend, false});
    }
    list.push_back({"arrived, unsure, no name", unsure(cueOf(CueKind::Arrived)), false});
    list.push_back({"already there, unsure, no name", unsure(cueOf(CueKind::AlreadyThere)), false});
    list.push_back(
        {"act, arrive, unsure, no name", unsure(cueOf(CueKind::Act, at(ManoeuvreKind::Arrive))), false});
}

} // namespace

std::vector<NamedCue> representativeCues() {
    std::vector<NamedCue> list;
    addStarts(list);
    addManoeuvres(list, CueKind::Prepare, QStringLiteral("prepare, "));
    addManoeuvres(list, CueKind::Act, QStringLiteral("act, "));
    addDirections(list);
    addWalls(list);
    addState(list);
    addDetections(list);
    addCountedDoors(list);
    addAnswers(list);
    addEveryWord(list);
    return list;
}

} // namespace farol::test
