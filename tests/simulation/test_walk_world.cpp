#include "core/simulation/walk_world.h"
#include "tests/support/ascii_map.h"

#include <gtest/gtest.h>

namespace farol::simulation {
namespace {

using test::AsciiMap;

class WalkWorldTest : public testing::Test {
protected:
    AsciiMap map = std::move(AsciiMap().floor(R"(
        +-----+-----+
        |A    :B    |
        |  1  :  2  |
        |     :     |
        +--/--+-----+
        |C 3        |
        +-----------+
    )"));
    std::shared_ptr<const building::Building> building = map.build();
    WalkWorld world{building};
    std::size_t a = *building->regionIndex(RegionId("A")), b = *building->regionIndex(RegionId("B"));
    Point2 one = *map.spot('1').position, two = *map.spot('2').position;
};

TEST_F(WalkWorldTest, ADoorIsSolidAndAnOpeningIsNot) {
    EXPECT_NEAR(world.free(a, one, fromDegrees(270.0), 10.0), 2.0, 1e-6);
    EXPECT_NEAR(world.free(a, one, fromDegrees(0.0), 10.0), 10.0, 1e-6);
    EXPECT_NEAR(world.free(a, one, fromDegrees(180.0), 10.0), 3.0, 1e-6);
}

TEST_F(WalkWorldTest, NobodyIsMovedThroughAWall) {
    Point2 stopped = world.moved(a, one, one + Point2{0.0, -5.0});
    EXPECT_TRUE(world.inside(a, stopped));
    Point2 near = world.moved(a, one, one + Point2{0.0, -1.95});
    EXPECT_GE(near.y, one.y - 2.0 + WalkWorld::kBodyM - 0.01);
}

TEST_F(WalkWorldTest, AStepThroughAnOpeningIsNoticed) {
    const Passage* gap = world.crossed(a, {one.x + 2.9, one.y}, {one.x + 3.1, one.y});
    ASSERT_NE(gap, nullptr);
    EXPECT_EQ(gap->into, b);
    EXPECT_NEAR(gap->outward.x, 1.0, 1e-9);
    EXPECT_EQ(world.crossed(a, one, one + Point2{0.1, 0.0}), nullptr);
    EXPECT_EQ(world.crossed(a, one, one + Point2{-3.5, 0.0}), nullptr) << "that is a wall";
}

TEST_F(WalkWorldTest, BehindADoorOneStandsInTheNextRoom) {
    for (const Passage& passage : world.passagesOf(a)) {
        Point2 behind = world.landing(passage, (passage.gap.a + passage.gap.b) * 0.5);
        EXPECT_TRUE(world.inside(passage.into, behind));
        EXPECT_FALSE(world.inside(a, behind));
    }
}

TEST(WalkWorld, ClosedDoorsWindowsAndTheWrongWayAreNoPassages) {
    auto building = test::asciiMap(R"(
        +---+---+---+
        |A  *B  %C  |
        |   |   >   |
        +---+---+---+
    )");
    WalkWorld world(building);
    auto passages = [&](const char* id) {
        return world.passagesOf(*building->regionIndex(RegionId(id))).size();
    };
    EXPECT_EQ(passages("A"), 0U);
    EXPECT_EQ(passages("B"), 1U);
    EXPECT_EQ(passages("C"), 0U);
}

} // namespace
} // namespace farol::simulation
