#include "core/building/unmarked_doors.h"
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

} // namespace
} // namespace farol::building
