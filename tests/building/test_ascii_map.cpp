// The helper itself: a wrong drawing must not make other tests pass by accident.
#include "tests/support/ascii_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

namespace farol::test {
namespace {

using building::AccessKind;
using building::OneWay;
using testing::HasSubstr;

std::string reasonOf(std::string_view drawing) {
    try {
        (void)asciiMap(drawing);
    } catch (const std::invalid_argument& wrong) {
        return wrong.what();
    }
    return "no exception";
}

TEST(AsciiMap, roomsShareTheWallBetweenThem) {
    auto building = asciiMap(R"(
        +-----+---+
        |A    |B  |
        |     /   |
        +-----+---+
    )");
    ASSERT_EQ(building->regions().size(), 2U);
    EXPECT_DOUBLE_EQ(area(building->region(RegionId("A"))->polygon), 6.0 * 3.0);
    EXPECT_DOUBLE_EQ(area(building->region(RegionId("B"))->polygon), 4.0 * 3.0);
    const building::Access* door = building->access(AccessId("A-B"));
    ASSERT_NE(door, nullptr);
    EXPECT_EQ(door->midpoint(), (Point2{6.0, 1.0}));
    EXPECT_NEAR(*door->widthM, 0.9, 1e-12);
    EXPECT_EQ(building->regionAt({5.9, 1.0}, 0.0), building->regionIndex(RegionId("A")));
    EXPECT_EQ(building->regionAt({6.1, 1.0}, 0.0), building->regionIndex(RegionId("B")));
}

TEST(AsciiMap, readsColumnsWindowsAndOneWayDoors) {
    auto map = AsciiMap(2.0)
                   .floor(R"(
        +--%--+------+
        |A  1 *  B   |
        |     < ##   |
        |  e  : ##   |
        |     :      |
        +-----+--v---+
        |C           |
        +------------+
    )")
                   .landmark('e', {Kind::Extinguisher, "", "T1", 90.0});
    auto building = map.build();
    EXPECT_DOUBLE_EQ(area(building->region(RegionId("B"))->polygon), 4.0 * (7.0 * 5.0 - 1.0));
    EXPECT_EQ(building->region(RegionId("B"))->polygon.holes.size(), 1U);
    EXPECT_TRUE(building->access(AccessId("A-B"))->closed);
    EXPECT_EQ(building->access(AccessId("A-B2"))->oneWay, OneWay::BToA);
    EXPECT_EQ(building->access(AccessId("A-B3"))->kind, AccessKind::Opening);
    EXPECT_NEAR(*building->access(AccessId("A-B3"))->widthM, 3.8, 1e-12);
    EXPECT_EQ(building->access(AccessId("B-C"))->oneWay, OneWay::AToB);
    EXPECT_EQ(building->accesses().size(), 4U) << "a window to the outside joins nothing";
    EXPECT_EQ(map.spot('1').region, RegionId("A"));
    const building::Landmark* landmark = building->landmark(LandmarkId("e"));
    ASSERT_NE(landmark, nullptr);
    EXPECT_EQ(landmark->region, RegionId("A"));
    EXPECT_EQ(landmark->position, (Point2{6.0, 8.0}));
}

TEST(AsciiMap, joinsLevels) {
    auto building = AsciiMap()
                        .floor("+--+\n|S |\n|  |\n+--+", 0.0)
                        .floor("+--+\n|T |\n|  |\n+--+", -1.0)
                        .join(AccessKind::Stairs, 'T', 'S', "main", 12)
                        .build();
    const building::Access* stairs = building->access(AccessId("S-T"));
    ASSERT_NE(stairs, nullptr);
    EXPECT_EQ(stairs->level, 0.0);
    EXPECT_EQ(building->levels().front().ordinal, -1.0);
    EXPECT_TRUE(building->areNeighbours(0, 1));
}

TEST(AsciiMap, refusesDrawingsThatMakeNoSense) {
    EXPECT_THAT(reasonOf("+--+\n|A  \n+--+"), HasSubstr("not closed"));
    EXPECT_THAT(reasonOf("+---+\n|A B|\n+---+"), HasSubstr("no wall between A and B"));
    EXPECT_THAT(reasonOf("+--+--+\n|A |A |\n+--+--+"), HasSubstr("two rooms are called A"));
    EXPECT_THAT(reasonOf("+--+\n|A?|\n+--+"), HasSubstr("unknown character"));
    EXPECT_THAT(reasonOf("  \n "), HasSubstr("empty"));
}

} // namespace
} // namespace farol::test
