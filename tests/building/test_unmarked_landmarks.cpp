#include "core/building/unmarked_landmarks.h"
#include "tests/support/ascii_map.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace farol::building {
namespace {

using test::AsciiMap;

const char* const kDrawing = R"(
    +-----+-----+-----+
    |A    |B    |C    |
    |    a|     |     |
    +--/--+--/--+--:--+
    |K d              |
    +-----------------+
)";

std::vector<Landmark> doorsIn(const std::vector<Landmark>& doors, const std::string& region) {
    std::vector<Landmark> found;
    for (const Landmark& door : doors)
        if (door.region.value == region) found.push_back(door);
    return found;
}

TEST(UnmarkedDoors, OneOnEachSideFacesIntoItsRegion) {
    auto doors = unmarkedDoors(*AsciiMap().floor(kDrawing).build());
    ASSERT_EQ(doorsIn(doors, "B").size(), 1U);
    EXPECT_EQ(doorsIn(doors, "K").size(), 2U);
    EXPECT_TRUE(doorsIn(doors, "C").empty()) << "an opening is no door";
    const Landmark door = doorsIn(doors, "B").front();
    EXPECT_EQ(door.kind, Kind::Door);
    ASSERT_TRUE(door.heading);
    EXPECT_NEAR(std::sin(door.heading->value), 1.0, 1e-9) << "north, into the room";
    for (const Landmark& side : doorsIn(doors, "K"))
        EXPECT_NEAR(std::sin(side.heading->value), -1.0, 1e-9) << "south, into the corridor";
}

TEST(UnmarkedDoors, WhatTheMapListsIsNotListedAgain) {
    AsciiMap map;
    map.floor(kDrawing).landmark('d', {.kind = Kind::Door}).landmark('a', {.kind = Kind::Poster});
    auto building = map.build();
    auto doors = unmarkedDoors(*building);
    EXPECT_EQ(doorsIn(doors, "K").size(), 1U) << "only the one of B is left";
    EXPECT_EQ(doorsIn(doors, "A").size(), 1U) << "its other side is another landmark";
}

TEST(UnmarkedDoors, AMapWithoutDoorsHasNone) {
    EXPECT_TRUE(unmarkedDoors(*AsciiMap().floor("+--+\n|A |\n+--+").build()).empty());
}

AsciiMap twoLevels() {
    AsciiMap map;
    map.floor("+---+\n|A s|\n|   |\n+---+").floor("+---+\n|B  |\n|   |\n+---+", 1.0);
    map.join(AccessKind::Stairs, 'A', 'B');
    return map;
}

TEST(UnmarkedStairs, AreSeenFromBothEndsUnlessTheMapListsThem) {
    auto both = unmarkedStairs(*twoLevels().build());
    ASSERT_EQ(both.size(), 2U);
    for (const Landmark& end : both) EXPECT_EQ(end.kind, Kind::Stairs);
    EXPECT_EQ(doorsIn(both, "B").front().level, 1.0);
    AsciiMap map = twoLevels();
    map.landmark('s', {.kind = Kind::Stairs});
    auto listed = unmarkedStairs(*map.build());
    ASSERT_EQ(listed.size(), 1U);
    EXPECT_EQ(listed.front().region.value, "B") << "its head is not listed";
}

TEST(UnmarkedStairs, LiftsAndClosedFlightsAreNone) {
    AsciiMap lift;
    lift.floor("+--+\n|A |\n+--+").floor("+--+\n|B |\n+--+", 1.0);
    lift.join(AccessKind::Elevator, 'A', 'B');
    EXPECT_TRUE(unmarkedStairs(*lift.build()).empty());
    BuildingData closed = twoLevels().data();
    for (Access& access : closed.accesses) access.closed = true;
    EXPECT_TRUE(unmarkedStairs(Building(std::move(closed))).empty());
}

} // namespace
} // namespace farol::building
