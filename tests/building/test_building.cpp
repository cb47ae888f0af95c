#include "core/building/building.h"
#include "tests/support/ascii_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace farol::building {
namespace {

using test::AsciiMap;
using testing::ElementsAre;

std::vector<std::string> neighbours(const Building& building, const std::string& id) {
    std::vector<std::string> names;
    for (std::size_t each : building.neighboursOf(*building.regionIndex(RegionId(id))))
        names.push_back(building.regions()[each].id.value);
    return names;
}

TEST(Building, neighboursArePassableAccessesOnly) {
    auto building = test::asciiMap(R"(
        +---+---+---+---+
        |A  /B  %C  *D  |
        |   >   |   |   |
        +-:-+---+-/-+---+
        |E          |
        +-----------+
    )");
    EXPECT_THAT(neighbours(*building, "A"), ElementsAre("B", "E"));
    EXPECT_THAT(neighbours(*building, "B"), ElementsAre("A")); // B and C share a window only
    EXPECT_THAT(neighbours(*building, "D"), ElementsAre());    // behind a closed door
    EXPECT_EQ(building->accessesOf(*building->regionIndex(RegionId("C"))).size(), 3U);
    EXPECT_TRUE(building->areNeighbours(0, *building->regionIndex(RegionId("E"))));
}

TEST(Building, theSmallerOfTwoRegionsHoldsThePoint) {
    BuildingData data;
    for (double size : {10.0, 4.0}) {
        Region region;
        region.id = RegionId("R" + std::to_string(data.regions.size()));
        region.polygon.outer = {{0, 0}, {size, 0}, {size, size}, {0, size}};
        data.regions.push_back(region);
    }
    Building building(data);
    EXPECT_EQ(building.regionAt({1, 1}, 0.0), 1U);
    EXPECT_EQ(building.regionAt({6, 6}, 0.0), 0U);
    EXPECT_EQ(building.regionAt({1, 1}, 1.0), std::nullopt);
    EXPECT_EQ(building.regionAt({-1, 1}, 0.0), std::nullopt);
}

TEST(Building, nearALevelChange) {
    auto building = AsciiMap()
                        .floor("+---+---+---+\n|A  /B  /S  |\n+---+---+---+")
                        .floor("+---+\n|T  |\n+---+", 1.0)
                        .join(AccessKind::Stairs, 'S', 'T')
                        .build();
    EXPECT_FALSE(building->nearLevelChange(0));
    EXPECT_TRUE(building->nearLevelChange(1));
    EXPECT_TRUE(building->nearLevelChange(2));
    EXPECT_TRUE(building->nearLevelChange(3));
    EXPECT_FALSE(building->nearLevelChange(99));
}

TEST(Building, oddDataJoinsNothing) {
    BuildingData data;
    data.regions.resize(2);
    data.regions[0].id = RegionId("A");
    data.regions[1].id = RegionId("A"); // the same id twice: the first is found
    Access toItself;
    toItself.id = AccessId("x");
    toItself.regionA = toItself.regionB = RegionId("A");
    Access toNowhere;
    toNowhere.id = AccessId("y");
    toNowhere.regionA = RegionId("A");
    toNowhere.regionB = RegionId("gone");
    data.accesses = {toItself, toNowhere};
    Landmark lost;
    lost.id = LandmarkId("l");
    lost.region = RegionId("gone");
    data.landmarks = {lost};
    Building building(data);
    EXPECT_EQ(building.regionIndex(RegionId("A")), 0U);
    EXPECT_EQ(building.otherSide(building.accesses()[0], 0), std::nullopt);
    EXPECT_EQ(building.otherSide(building.accesses()[1], 0), std::nullopt);
    EXPECT_TRUE(building.neighboursOf(0).empty());
    EXPECT_EQ(building.accessesOf(0).size(), 2U);
    EXPECT_TRUE(building.landmarksOf(0).empty());
    EXPECT_EQ(building.regionAt({0, 0}, 0.0), std::nullopt);
    EXPECT_EQ(Building(BuildingData{}).regionAt({0, 0}, 0.0), std::nullopt);
}

TEST(Building, midpointIsHalfWayAlongTheLine) {
    Access access;
    EXPECT_EQ(access.midpoint(), Point2{});
    access.line = {{3, 4}};
    EXPECT_EQ(access.midpoint(), (Point2{3, 4}));
    access.line = {{0, 0}, {4, 0}, {4, 2}};
    EXPECT_EQ(access.midpoint(), (Point2{3, 0}));
    access.line = {{1, 1}, {1, 1}};
    EXPECT_EQ(access.midpoint(), (Point2{1, 1}));
}

TEST(Building, spokenNameIsNeverEmpty) {
    Region region;
    region.id = RegionId("R7");
    EXPECT_EQ(spokenName(region), "R7");
    region.ref = "2.14";
    EXPECT_EQ(spokenName(region), "2.14");
    region.name = "Bar";
    EXPECT_EQ(spokenName(region), "Bar");
}

TEST(Building, kindNamesReadBack) {
    for (const char* name :
         {"room", "corridor", "hall", "stairwell", "elevator", "toilet", "outside", "other"})
        EXPECT_EQ(regionKindName(*regionKindFromName(name)), name);
    for (const char* name : {"door", "opening", "stairs", "elevator", "escalator", "ramp", "window", "other"})
        EXPECT_EQ(accessKindName(*accessKindFromName(name)), name);
    EXPECT_EQ(regionKindFromName("kitchen"), std::nullopt);
    EXPECT_EQ(accessKindFromName(""), std::nullopt);
}

} // namespace
} // namespace farol::building
