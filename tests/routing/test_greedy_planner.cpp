#include "tests/routing/route_matchers.h"
#include "tests/support/ascii_map.h"

#include <gmock/gmock.h>

namespace farol::routing {
namespace {

using building::AccessKind;
using test::AsciiMap;
using testing::ElementsAre;
using testing::HasSubstr;

Route planned(std::shared_ptr<const Building> building, const Location& from, const Location& to,
              RouteOptions options = {}) {
    auto route = makeGreedyPlanner(building, options)->plan(from, to);
    if (!route.ok()) {
        ADD_FAILURE() << route.error().text();
        return {};
    }
    EXPECT_EQ(route->planner, "greedy");
    expectSound(*building, *route);
    return *route;
}

TEST(GreedyPlanner, strikesOutADeadEndAndStartsAgain) {
    // B lies in the direction of the destination but has no second door.
    AsciiMap map;
    map.floor(R"(
        +---+----+---+
        |A  /B   |C  |
        |   |    |   |
        +-/-+----+-/-+
        |D           |
        +------------+
    )");
    auto building = map.build();
    EXPECT_THAT(regionsOf(planned(building, in("A"), in("C"))), ElementsAre("A", "D", "C"));
}

TEST(GreedyPlanner, leavesChainsOfDeadEnds) {
    AsciiMap map;
    map.floor(R"(
        +---+---+---+---+---+
        |A  /B  /C  /D  |Z  |
        |   |   |   |   |   |
        +-/-+-/-+---+---+-/-+
        |E  |F              |
        |   /               |
        +---+---------------+
    )");
    EXPECT_THAT(regionsOf(planned(map.build(), in("A"), in("Z"))), ElementsAre("A", "B", "F", "Z"));
}

TEST(GreedyPlanner, isNotAlwaysTheShortestWay) {
    // The nearer door to Z lies behind a detour.
    AsciiMap map;
    map.floor(R"(
        +-----------+--+
        |A          /B |
        |           |  |
        |  1        +-/+--+
        |           |C |Z |
        |           |  / 2|
        |           |  +--+
        |           |  |
        +--/--------+-/+
        |D             |
        +--------------+
    )");
    auto building = map.build();
    auto greedy = planned(building, map.spot('1'), map.spot('2'));
    auto best = makeOptimalPlanner(building)->plan(map.spot('1'), map.spot('2'));
    ASSERT_TRUE(best.ok());
    EXPECT_EQ(greedy.regions.back(), RegionId("Z"));
    EXPECT_GE(greedy.seconds, best->seconds - 1e-9);
}

TEST(GreedyPlanner, takesACommonShaftBetweenLevels) {
    AsciiMap map;
    map.floor("+---+---+---+\n|A  /B  /C  |\n|   |   |   |\n+---+---+---+", 0.0);
    map.floor("+---+---+---+\n|D  /E  /F  |\n|   |   |   |\n+---+---+---+", 1.0);
    map.floor("+---+---+---+\n|G  /H  /I  |\n|   |   |   |\n+---+---+---+", 2.0);
    map.join(AccessKind::Stairs, 'A', 'D', "S").join(AccessKind::Stairs, 'D', 'G', "S");
    map.join(AccessKind::Elevator, 'C', 'F', "L").join(AccessKind::Elevator, 'F', 'I', "L");
    auto building = map.build();
    EXPECT_THAT(regionsOf(planned(building, in("B"), in("H"))), ElementsAre("B", "A", "D", "G", "H"));
    RouteOptions options;
    options.avoidStairs = true;
    EXPECT_THAT(regionsOf(planned(building, in("B"), in("H"), options)),
                ElementsAre("B", "C", "F", "I", "H"));
    EXPECT_THAT(regionsOf(planned(building, in("H"), in("B"))), ElementsAre("H", "G", "D", "A", "B"));
    options.avoidElevator = true;
    auto none = makeGreedyPlanner(building, options)->plan(in("B"), in("H"));
    ASSERT_FALSE(none.ok());
    EXPECT_THAT(none.error().message, HasSubstr("to be avoided"));
}

TEST(GreedyPlanner, changesTheShaftOnALevelBetween) {
    AsciiMap map;
    map.floor("+---+---+\n|A  /B  |\n|   |   |\n+---+---+", -1.0);
    map.floor("+---+---+\n|C  /D  |\n|   |   |\n+---+---+", 0.0);
    map.floor("+---+---+\n|E  /F  |\n|   |   |\n+---+---+", 1.0);
    map.join(AccessKind::Stairs, 'A', 'C', "S").join(AccessKind::Elevator, 'D', 'F', "L");
    EXPECT_THAT(regionsOf(planned(map.build(), in("B"), in("E"))), ElementsAre("B", "A", "C", "D", "F", "E"));
}

TEST(GreedyPlanner, saysWhenOnlyTheOtherPlannerFindsAWay) {
    AsciiMap map;
    map.floor("+---+ +---+\n|A  | |B  |\n|   | |   |\n+---+ +---+", 0.0);
    map.floor("+---------+\n|C        |\n|         |\n+---------+", 1.0);
    map.join(AccessKind::Stairs, 'A', 'C').join(AccessKind::Stairs, 'B', 'C');
    auto building = map.build();
    auto greedy = makeGreedyPlanner(building)->plan(in("A"), in("B"));
    ASSERT_FALSE(greedy.ok());
    EXPECT_THAT(greedy.error().message, HasSubstr("optimal planner"));
    EXPECT_TRUE(makeOptimalPlanner(building)->plan(in("A"), in("B")).ok());
    auto apart = makeGreedyPlanner(test::asciiMap("+---+---+\n|A  |B  |\n+---+---+"))->plan(in("A"), in("B"));
    ASSERT_FALSE(apart.ok());
    EXPECT_THAT(apart.error().message, HasSubstr("no way at all"));
}

TEST(GreedyPlanner, sameRegion) {
    auto building = test::asciiMap("+---+\n|A  |\n|   |\n+---+");
    EXPECT_THAT(regionsOf(planned(building, in("A"), in("A"))), ElementsAre("A"));
}

} // namespace
} // namespace farol::routing
