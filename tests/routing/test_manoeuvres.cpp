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

} // namespace
} // namespace farol::routing
