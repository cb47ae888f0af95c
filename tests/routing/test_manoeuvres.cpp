#include "tests/routing/route_matchers.h"
#include "tests/support/ascii_map.h"

#include <gmock/gmock.h>

namespace farol::routing {
namespace {

using test::AsciiMap;
using testing::ElementsAre;

Route planned(const AsciiMap& map) {
    auto route = makeOptimalPlanner(map.build())->plan(map.spot('1'), map.spot('2'));
    if (!route.ok()) {
        ADD_FAILURE() << route.error().text();
        return {};
    }
    return *route;
}

TEST(Manoeuvres, leftIsPositive) {
    AsciiMap left;
    left.floor(R"(
        +----------+--+
        |          |B |
        |          |2 |
        |          |  |
        |          |  |
        |          +/-+
        |A         |C |
        |1         /  |
        +----------+--+
    )");
    // East through the first door, north through the second.
    Route route = planned(left);
    EXPECT_THAT(regionsOf(route), ElementsAre("A", "C", "B"));
    EXPECT_GT(route.manoeuvres[1].turn.value + route.manoeuvres[2].turn.value, 1.2);
    EXPECT_GE(route.manoeuvres[2].turn.value, 0.0);

    AsciiMap right;
    right.floor(R"(
        +----------+--+
        |A         |C |
        |1         /  |
        |          +/-+
        |          |B |
        |          |  |
        |          |2 |
        +----------+--+
    )");
    Route other = planned(right);
    EXPECT_LT(other.manoeuvres[1].turn.value + other.manoeuvres[2].turn.value, -1.2);
}

TEST(Manoeuvres, aTurnInACorridorIsTold) {
    AsciiMap bend;
    bend.floor(R"(
        +--+
        |2 |
        |  |
        |  |
        |  |
        |  |
        |  +---------+
        |A          1|
        +------------+
    )");
    Route route = planned(bend);
    ASSERT_EQ(route.manoeuvres.size(), 3U);
    const Manoeuvre& turn = route.manoeuvres[1];
    EXPECT_EQ(turn.kind, ManoeuvreKind::Turn);
    EXPECT_LT(turn.turn.value, -kPi / 3.0) << "walking west, then north: to the right";
    EXPECT_EQ(turn.from, RegionId("A"));
    EXPECT_EQ(turn.into, RegionId("A"));
    EXPECT_TRUE(turn.access.empty());
    EXPECT_EQ(turn.position, (Point2{3.0, 2.0}));
    EXPECT_GT(turn.atM, 5.0);
    EXPECT_LT(turn.atM, route.lengthM);
}

TEST(Manoeuvres, straightThroughADoorIsNoTurn) {
    AsciiMap map;
    map.floor("+------+------+\n|A     |B     |\n|1     /     2|\n|      |      |\n+------+------+");
    Route route = planned(map);
    EXPECT_THAT(spoken(route), ElementsAre("start", "door", "arrive"));
    const Manoeuvre& door = route.manoeuvres[1];
    EXPECT_EQ(door.from, RegionId("A"));
    EXPECT_EQ(door.into, RegionId("B"));
    EXPECT_EQ(door.access, AccessId("A-B"));
    EXPECT_DOUBLE_EQ(door.atM, 6.0);
    EXPECT_EQ(door.vertical, Vertical::None);
}

/// A route along given points of one region, or of two with an access at `portal`.
Route along(const Polyline& points, std::optional<std::size_t> portal = std::nullopt) {
    Route route;
    for (Point2 p : points) route.path.push_back({p, 0.0});
    route.regions = {RegionId("A")};
    if (portal) {
        route.regions.push_back(RegionId("B"));
        route.accesses = {AccessId("A-B")};
    }
    route.lengthM = length(points);
    auto building = test::asciiMap("+---+---+\n|A  /B  |\n+---+---+");
    route.manoeuvres = manoeuvresAlong(
        *building, route, portal ? std::vector<std::size_t>{*portal} : std::vector<std::size_t>{});
    return route;
}

TEST(Manoeuvres, theTurnAtADoorIsTheChangeOfDirection) {
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {5, 5}}, 1)), ElementsAre("start", "door +90", "arrive"));
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {5, -5}}, 1)), ElementsAre("start", "door -90", "arrive"));
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {10, 0}}, 1)), ElementsAre("start", "door", "arrive"));
}

TEST(Manoeuvres, theCornerOfTwoCorridorsIsAWholeTurn) {
    // The shortest way cuts the corner and leaves by a door near it; the walls still turn by 90 degrees.
    auto map = test::AsciiMap().floor(R"(
            +--+
            |B |
            |  +-----+
            |  /C  1 |
            |  +-----+
            |  |
            |  |
            |  |
    +-------+  |
    |A 2    :  |
    |       :  |
    +-------+--+
        )");
    auto planner = makeOptimalPlanner(map.build());
    auto route = planner->plan(map.spot('2'), map.spot('1'));
    ASSERT_TRUE(route.ok());
    std::vector<double> turns;
    for (const Manoeuvre& each : route->manoeuvres)
        if (each.kind == ManoeuvreKind::Opening || each.kind == ManoeuvreKind::Door)
            turns.push_back(toDegrees(each.turn));
    ASSERT_EQ(turns.size(), 2U);
    EXPECT_NEAR(turns[0], 90.0, 1.0);
    EXPECT_NEAR(turns[1], -90.0, 1.0);
}

TEST(Manoeuvres, whoCrossesACorridorDoesNotTurnAlongIt) {
    auto map = test::AsciiMap().floor(R"(
        +---+
        |B2 |
        +-/-+---------+
        |C            |
        |             |
        +-/-+---------+
        |A1 |
        +---+
        )");
    auto planner = makeOptimalPlanner(map.build());
    auto route = planner->plan(map.spot('1'), map.spot('2'));
    ASSERT_TRUE(route.ok());
    for (const Manoeuvre& each : route->manoeuvres) EXPECT_LT(std::abs(toDegrees(each.turn)), 45.0);
}

TEST(Manoeuvres, aBendBesideADoorBelongsToIt) {
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {5.4, 0}, {5.4, 5}}, 1)),
                ElementsAre("start", "door +90", "arrive"));
    EXPECT_THAT(spoken(along({{0, 0}, {4.4, 0}, {5, 0.3}, {5, 5}}, 2)),
                ElementsAre("start", "door +90", "arrive"));
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {8, 0}, {8, 5}}, 1)),
                ElementsAre("start", "door", "turn +90", "arrive"));
}

TEST(Manoeuvres, huggingACornerDoesNotMakeATurn) {
    // A jog of 30 cm at the opening: the direction before and after is the same.
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {5.2, 0.3}, {10, 0.3}}, 1)),
                ElementsAre("start", "door", "arrive"));
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {5.3, 0.3}, {10, 0.3}})), ElementsAre("start", "arrive"));
}

TEST(Manoeuvres, bendsTogetherAreOneTurn) {
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {5.6, 0.2}, {6, 0.7}, {6, 6}})),
                ElementsAre("start", "turn +90", "arrive"));
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {5, 0.2}, {0, 0.2}})),
                ElementsAre("start", "turn +180", "arrive"));
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {5, -0.2}, {0, -0.2}})),
                ElementsAre("start", "turn -180", "arrive"));
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {9, 2}})), ElementsAre("start", "arrive")) << "27 degrees";
    EXPECT_THAT(spoken(along({{0, 0}, {5, 0}, {9, 2.6}})), ElementsAre("start", "turn +35", "arrive"));
}

TEST(Manoeuvres, degenerateRoutes) {
    EXPECT_THAT(spoken(along({{3, 3}})), ElementsAre("start", "arrive"));
    EXPECT_THAT(spoken(along({{3, 3}, {3, 3}, {3, 3}}, 1)), ElementsAre("start", "door", "arrive"));
    auto building = test::asciiMap("+---+\n|A  |\n+---+");
    EXPECT_TRUE(manoeuvresAlong(*building, Route{}, {}).empty());
}

/// What is said of the doors on the way: number, side and the region behind.
std::vector<std::string> counted(const Route& route) {
    std::vector<std::string> words;
    for (const Manoeuvre& each : route.manoeuvres) {
        if (each.access.empty()) continue;
        std::string side = each.side == Side::Left ? "left" : each.side == Side::Right ? "right" : "ahead";
        words.push_back((each.side == Side::None ? "" : std::to_string(each.number) + " ") + side + " " +
                        each.into.value);
    }
    return words;
}

TEST(Manoeuvres, doorsInTheWallAreCounted) {
    AsciiMap map;
    map.floor(R"(
        +---+---+---+---+---+
        |B  |C  |D  |E  |F  |
        |   |   |   | 2 |   |
        +-/-+-*-+-%-+-/-+-/-+
        |A                  |
        |1                  |
        +-/-----/---+-/-+-/-+
        |G          |H  |I  |
        +-----------+---+---+
    )");
    auto building = map.build();
    auto planner = makeOptimalPlanner(building);
    // B, the closed door of C, then E; a window is no door.
    EXPECT_THAT(counted(*planner->plan(map.spot('1'), map.spot('2'))), ElementsAre("3 left E"));
    EXPECT_THAT(counted(*planner->plan(in("F"), in("E"))), ElementsAre("ahead A", "1 right E"));
    EXPECT_THAT(counted(*planner->plan(map.spot('1'), in("I"))), ElementsAre("4 right I"));
    EXPECT_THAT(counted(*planner->plan(in("I"), in("G"))), ElementsAre("ahead A", "2 left G"));
    EXPECT_THAT(counted(*planner->plan(map.spot('2'), in("H"))), ElementsAre("ahead A", "ahead H"))
        << "the door on the other side is no door in a wall one follows";
}

/// Degrees that the way turns behind each door; 999 where that is not told.
std::vector<int> behindDoors(const Route& route) {
    std::vector<int> degrees;
    for (const Manoeuvre& each : route.manoeuvres)
        if (!each.access.empty())
            degrees.push_back(each.behind ? static_cast<int>(std::lround(toDegrees(*each.behind))) : 999);
    return degrees;
}

TEST(Manoeuvres, theTurnBehindADoorIsToldApartFromTheOneTowardsIt) {
    AsciiMap map;
    map.floor(R"(
        +---------+---------+
        |A        |B        |
        |    1    |    2    |
        +----/----+----/----+
        |K                  |
        |                   |
        +-/-----------------+
        |C                  |
        |                  3|
        +-------------------+
    )");
    auto building = map.build();
    auto planner = makeOptimalPlanner(building);
    Route route = *planner->plan(map.spot('1'), map.spot('2'));
    EXPECT_THAT(behindDoors(route), ElementsAre(90, 0)) << "out of A to the left, and straight into B";
    EXPECT_EQ(route.manoeuvres[2].side, Side::Left);
    route = *planner->plan(map.spot('2'), map.spot('1'));
    EXPECT_THAT(behindDoors(route), ElementsAre(-90, 0));
    // Towards the door of C one turns left, behind it left again along its corridor-like floor.
    route = *planner->plan(map.spot('1'), map.spot('3'));
    ASSERT_EQ(behindDoors(route).size(), 2U);
    EXPECT_EQ(behindDoors(route).back(), 90);
}

TEST(Manoeuvres, aDoorWithoutAWallTellsNoTurnBehind) {
    AsciiMap map;
    map.floor("+---+---+\n|A 1/B 2|\n|   |   |\n+---+---+");
    building::BuildingData data = map.data();
    data.accesses[0].line = {Point2{2.0, 1.5}}; // a point in the middle of the room
    auto building = std::make_shared<const Building>(std::move(data));
    auto planner = makeOptimalPlanner(building);
    auto route = planner->plan(map.spot('1'), map.spot('2'));
    if (route) {
        EXPECT_THAT(behindDoors(*route), ElementsAre(999));
    }
}

TEST(Manoeuvres, countingBeginsAgainAfterATurn) {
    AsciiMap map;
    map.floor(R"(
        +--+-----+
        |A /B    |
        |  +-----+
        |  /C   2|
        |  +-----+
        |  /D    |
        |  +-----+-----------+
        |                   1|
        +-/----/-------/-----+
        |E                   |
        +--------------------+
    )");
    Route route = planned(map);
    EXPECT_THAT(spoken(route).size(), 4U);
    EXPECT_THAT(counted(route), ElementsAre("2 right C"));
}

TEST(Manoeuvres, aLiftIsToldTheLevelToChoose) {
    AsciiMap map;
    map.floor("+---+---+\n|A 1/L  |\n|   |   |\n+---+---+", 0.0);
    map.floor("+---+---+\n|B  /M  |\n|   |   |\n+---+---+", 1.0);
    map.floor("+---+---+\n|C 2/N  |\n|   |   |\n+---+---+", 2.0);
    for (char car : {'L', 'M', 'N'}) map.region(car, {"", building::RegionKind::Elevator});
    map.join(building::AccessKind::Elevator, 'L', 'M', "X")
        .join(building::AccessKind::Elevator, 'M', 'N', "X");
    Route route = planned(map);
    EXPECT_THAT(spoken(route),
                ElementsAre("start", "door -15", "elevator", "elevator", "door +15", "arrive"));
    const Manoeuvre& lift = route.manoeuvres[2];
    EXPECT_EQ(lift.kind, ManoeuvreKind::Elevator);
    EXPECT_EQ(lift.level, 0.0);
    EXPECT_EQ(lift.targetLevel, 2.0) << "not the floor it passes";
    EXPECT_EQ(lift.into, RegionId("N"));
    EXPECT_EQ(lift.turn.value, 0.0);
}

TEST(Manoeuvres, stairsComeOutWhereTheUpperRegionIs) {
    AsciiMap map;
    map.floor("+---+---+\n|A 1/L  |\n|   |   |\n+---+---+", 0.0);
    map.floor("+---+---+---+\n|Z  |M  |B 2|\n|   |   /   |\n+---+---+---+", 1.0);
    map.join(building::AccessKind::Stairs, 'L', 'M', "X", 18);
    building::BuildingData data = map.data();
    // The flight begins two metres before the landing.
    data.accesses.back().line = {{3.0, 1.5}};
    data.regions[1].polygon.outer = {{2.0, 0.0}, {8.0, 0.0}, {8.0, 3.0}, {2.0, 3.0}};
    data.regions[0].polygon.outer = {{0.0, 0.0}, {2.0, 0.0}, {2.0, 3.0}, {0.0, 3.0}};
    data.accesses[0].line = {{2.0, 1.0}, {2.0, 2.0}};
    auto route = makeOptimalPlanner(std::make_shared<Building>(data))
                     ->plan({RegionId("A"), Point2{1.0, 1.5}}, map.spot('2'));
    ASSERT_TRUE(route.ok());
    double walked = 0.0;
    for (std::size_t i = 1; i < route->path.size(); ++i) {
        const PathPoint &a = route->path[i - 1], &b = route->path[i];
        if (a.level != b.level) {
            EXPECT_EQ(a.position, (Point2{3.0, 1.5}));
            EXPECT_EQ(b.position, (Point2{4.0, 1.5})) << "in the upper region";
        } else {
            walked += distance(a.position, b.position);
        }
    }
    EXPECT_NEAR(route->lengthM, walked + 6.0, 1e-9) << "between them only the stairs are walked";
    EXPECT_NEAR(route->manoeuvres.back().atM, route->lengthM, 1e-9);
}

} // namespace
} // namespace farol::routing
