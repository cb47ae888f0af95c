// Which of several doors around a small room: counted along the wall from the door one has come through.

#include "core/routing/route.h"
#include "core/routing/wall_walk.h"
#include "tests/support/lobby_map.h"

#include <gtest/gtest.h>

namespace farol::routing {
namespace {

using test::AsciiMap;
using test::lobbyMap;

Route planned(const AsciiMap& map, char from, char to) {
    auto route = makeOptimalPlanner(map.build())->plan(map.spot(from), map.spot(to));
    if (!route.ok()) {
        ADD_FAILURE() << route.error().text();
        return {};
    }
    return *route;
}

/// The door after the first one.
Manoeuvre second(const AsciiMap& map, char from, char to) {
    Route route = planned(map, from, to);
    int doors = 0;
    for (const Manoeuvre& each : route.manoeuvres)
        if (each.kind == ManoeuvreKind::Door && ++doors == 2) return each;
    ADD_FAILURE() << "no second door";
    return {};
}

TEST(WallWalk, ADoorBesideTheOneAheadIsCountedAlongTheNearerWall) {
    Manoeuvre right = second(lobbyMap(), '1', '2');
    EXPECT_TRUE(right.alongWall);
    EXPECT_EQ(right.side, Side::Right);
    EXPECT_EQ(right.number, 2) << "the first is that of S";
    Manoeuvre left = second(lobbyMap(), '1', '4');
    EXPECT_TRUE(left.alongWall);
    EXPECT_EQ(left.side, Side::Left);
    EXPECT_EQ(left.number, 2) << "the first is that of N";
}

TEST(WallWalk, WhoFollowsAWallIsToldOfNoTurnBehindTheDoorBefore) {
    Route route = planned(lobbyMap(), '1', '2');
    ASSERT_GE(route.manoeuvres.size(), 4U);
    for (const Manoeuvre& each : route.manoeuvres) EXPECT_NE(each.kind, ManoeuvreKind::Turn);
    ASSERT_TRUE(route.manoeuvres[1].behind);
    EXPECT_EQ(route.manoeuvres[1].behind->value, 0.0);
}

TEST(WallWalk, TheWayBackIsCountedFromItsOwnDoor) {
    Manoeuvre back = second(lobbyMap(), '2', '1');
    EXPECT_TRUE(back.alongWall || back.side != Side::None);
    Manoeuvre across = second(lobbyMap(), '5', '2');
    EXPECT_EQ(across.side, Side::Left) << "past the door of E, in one wall with it";
    EXPECT_EQ(across.number, 2);
}

TEST(WallWalk, WithNothingToTakeItForTheDoorAheadIsAhead) {
    AsciiMap map;
    map.floor(R"(
        +----+----+------+
        |W   |L   |F     |
        |1   /    /    2 |
        |    |    |      |
        +----+----+------+
    )");
    Manoeuvre ahead = second(map, '1', '2');
    EXPECT_FALSE(ahead.alongWall);
    EXPECT_EQ(ahead.side, Side::None);
}

TEST(WallWalk, AnOpeningEndsTheWall) {
    AsciiMap map;
    map.floor(R"(
        +----+----+------+
        |W   |N   |E     |
        |    |    |      |
        |    +-/--+      |
        |    |L   /      |
        |1   /    +------+
        |    |    |F     |
        |    |    /    2 |
        |    +-::-+      |
        |    |S   |      |
        +----+----+------+
    )");
    Manoeuvre door = second(map, '1', '2');
    ASSERT_TRUE(door.alongWall);
    EXPECT_EQ(door.side, Side::Left) << "round the other way";
    EXPECT_EQ(door.number, 3);
}

TEST(WallWalk, BesideAnOpeningThereIsNoWallToBeginWith) {
    AsciiMap map;
    map.floor(R"(
        +----+----+------+
        |W   |N   |E     |
        |    |    |      |
        |    +-/--+      |
        |    |L   /      |
        |1   :    +------+
        |    |    |F     |
        |    |    /    2 |
        |    +--/-+      |
        |    |S   |      |
        +----+----+------+
    )");
    for (const Manoeuvre& each : planned(map, '1', '2').manoeuvres) EXPECT_FALSE(each.alongWall);
}

TEST(WallWalk, ALargeHallIsNotWalkedRound) {
    AsciiMap map(4.0);
    map.floor(R"(
        +----+----+------+
        |W   |N   |E     |
        |    +-/--+      |
        |    |L   /      |
        |1   /    +------+
        |    |    /F   2 |
        +----+----+------+
    )");
    for (const Manoeuvre& each : planned(map, '1', '2').manoeuvres) EXPECT_FALSE(each.alongWall);
}

TEST(WallWalk, OnTheWayTheDoorsThatAreLeftCount) {
    AsciiMap map = lobbyMap();
    auto building = map.build();
    std::size_t region = *building->regionIndex(RegionId("L"));
    const building::Access& door = *building->access(AccessId("F-L"));
    // Beside the wall between W and L, south of the door one came through.
    Point2 entry = building->access(AccessId("L-W"))->midpoint();
    auto begun = wallSpot(*building, region, door, false, entry + Point2{0.5, -1.2}, 0.2);
    ASSERT_TRUE(begun);
    EXPECT_EQ(begun->number, 2);
    EXPECT_NEAR(toDegrees(begun->along), -90.0, 1.0) << "with the wall on the right one goes south there";
    Point2 passed = building->access(AccessId("L-S"))->midpoint() + Point2{1.2, 0.5};
    auto last = wallSpot(*building, region, door, false, passed, 0.2);
    ASSERT_TRUE(last);
    EXPECT_EQ(last->number, 1);
    EXPECT_FALSE(wallSpot(*building, region, door, false, passed, 3.0)) << "nobody knows what was passed";
    EXPECT_FALSE(wallSpot(*building, region, door, false, *map.spot('8').position, 0.2))
        << "in the middle of a room no wall is at hand";
}

} // namespace
} // namespace farol::routing
