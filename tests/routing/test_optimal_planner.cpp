#include "tests/routing/route_matchers.h"
#include "tests/support/ascii_map.h"

#include <gmock/gmock.h>
#include <limits>
#include <thread>

namespace farol::routing {
namespace {

using building::AccessKind;
using building::RegionKind;
using test::AsciiMap;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Route planned(std::shared_ptr<const Building> building, const Location& from, const Location& to,
              RouteOptions options = {}) {
    auto route = makeOptimalPlanner(building, options)->plan(from, to);
    if (!route.ok()) {
        ADD_FAILURE() << route.error().text();
        return {};
    }
    expectSound(*building, *route);
    return *route;
}

std::string refusal(std::shared_ptr<const Building> building, const Location& from, const Location& to,
                    RouteOptions options = {}) {
    auto route = makeOptimalPlanner(building, options)->plan(from, to);
    if (route.ok()) return "a route";
    EXPECT_EQ(route.error().code, ErrorCode::NotFound);
    return route.error().message;
}

TEST(OptimalPlanner, throughTheDoorThatCostsLess) {
    AsciiMap map;
    map.floor(R"(
        +---------+---+-----+
        |A   1    :B  :C   2|
        |         |   |     |
        |         +---+     |
        |         /D  /     |
        +---------+---+-----+
    )");
    // Over D it is about as far, but two doors cost a blind walker time.
    EXPECT_THAT(regionsOf(planned(map.build(), map.spot('1'), map.spot('2'))), ElementsAre("A", "B", "C"));
    RouteOptions indifferent;
    indifferent.doorSeconds = 0.0;
    EXPECT_THAT(regionsOf(planned(map.build(), map.spot('1'), map.spot('2'), indifferent)),
                ElementsAre("A", "B", "C"));
}

TEST(OptimalPlanner, roundTheColumnInTheRoom) {
    AsciiMap map;
    map.floor(R"(
        +---------+
        |A        |
        |   ###   |
        |1  ###  2|
        |   ###   |
        |         |
        +---------+
    )");
    Route route = planned(map.build(), map.spot('1'), map.spot('2'));
    EXPECT_THAT(regionsOf(route), ElementsAre("A"));
    EXPECT_NEAR(route.lengthM, 2.0 * std::hypot(3, 1) + 2.0, 1e-6);
    EXPECT_TRUE(route.accesses.empty());
}

TEST(OptimalPlanner, throughAnLShapedRegion) {
    AsciiMap map;
    map.floor(R"(
        +----+
        |A   |
        |1   |
        |    +----+----+
        |         /B   |
        |         |  2 |
        +---------+----+
    )");
    Route route = planned(map.build(), map.spot('1'), map.spot('2'));
    double legs = std::hypot(4, 1) + std::hypot(5, 1) + std::hypot(3, 1);
    EXPECT_NEAR(route.lengthM, legs, 1e-6);
    EXPECT_NEAR(route.seconds, legs / 0.8 + 4.0, 1e-6);
}

TEST(OptimalPlanner, sameRegionAndRegionsWithoutAPosition) {
    AsciiMap map;
    map.floor("+----+----+\n|A 1 /B   |\n|    |    |\n+----+----+");
    auto building = map.build();
    Route still = planned(building, map.spot('1'), map.spot('1'));
    EXPECT_EQ(still.lengthM, 0.0);
    EXPECT_THAT(spoken(still), ElementsAre("start", "arrive"));
    EXPECT_THAT(regionsOf(planned(building, in("A"), in("A"))), ElementsAre("A"));
    Route route = planned(building, in("A"), in("B"));
    EXPECT_EQ(route.path.back().position, pointInside(building->region(RegionId("B"))->polygon));
    EXPECT_THAT(accessesOf(route), ElementsAre("A-B"));
    Route fromTheWall = planned(building, {RegionId("A"), Point2{-2.0, 1.0}}, in("B"));
    EXPECT_EQ(fromTheWall.path.front().position, (Point2{0.0, 1.0})) << "a position outside its region";
}

TEST(OptimalPlanner, closedDoorsWindowsAndOneWay) {
    AsciiMap map;
    map.floor(R"(
        +---+---+---+---+
        |A  *B  >C  %D  |
        +/--+---+-/-+-/-+
        |E              |
        +---------------+
    )");
    auto building = map.build();
    EXPECT_THAT(regionsOf(planned(building, in("B"), in("C"))), ElementsAre("B", "C"));
    EXPECT_THAT(regionsOf(planned(building, in("C"), in("D"))), ElementsAre("C", "E", "D"));
    EXPECT_THAT(regionsOf(planned(building, in("A"), in("C"))), ElementsAre("A", "E", "C"));
    EXPECT_EQ(refusal(building, in("A"), in("B")), "B can be reached through a closed access only (A to B)");
    EXPECT_EQ(refusal(building, in("C"), in("B")), "B can be reached through a closed access only (A to B)");
}

TEST(OptimalPlanner, saysWhyThereIsNoWay) {
    AsciiMap map;
    map.floor("+---+---+ +---+\n|A  *B  | |C  |\n+---+---+ +---+");
    auto building = map.build();
    EXPECT_EQ(refusal(building, in("A"), in("B")), "B can be reached through a closed access only (A to B)");
    EXPECT_THAT(refusal(building, in("A"), in("C")), HasSubstr("no way at all"));
    auto oneWay = test::asciiMap("+---+---+---+\n|A  >B  *C  |\n+---+---+---+");
    EXPECT_EQ(refusal(oneWay, in("B"), in("A")), "A can be reached against a one-way access only (B to A)");
    EXPECT_EQ(refusal(oneWay, in("C"), in("A")),
              "A can be reached past a closed access (C to B) and a one-way access (B to A) only");
    auto unknown = makeOptimalPlanner(building)->plan(in("A"), in("Z"));
    ASSERT_FALSE(unknown.ok());
    EXPECT_THAT(unknown.error().text(), HasSubstr("destination: the map has no region \"Z\""));
    auto lost = makeOptimalPlanner(building)->plan({RegionId("A"), Point2{std::nan(""), 0.0}}, in("B"));
    EXPECT_EQ(lost.error().code, ErrorCode::InvalidArgument);
}

TEST(OptimalPlanner, refusesOptionsOutOfRange) {
    auto building = test::asciiMap("+---+\n|A  |\n+---+");
    RouteOptions options;
    options.walkingSpeed = 0.0;
    EXPECT_EQ(makeOptimalPlanner(building, options)->plan(in("A"), in("A")).error().code,
              ErrorCode::InvalidArgument);
    options.walkingSpeed = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(options.check().ok());
}

/// Levels -1, 0 and 1, joined by stairs at one end and a lift at the other.
AsciiMap tower() {
    AsciiMap map;
    map.floor(R"(
        +---+-------+---+
        |A  /D    1 /G  |
        |   |       |   |
        +---+-------+---+
    )",
              -1.0);
    map.floor(R"(
        +---+-------+---+
        |B  /E    2 /H  |
        |   |       |   |
        +---+-------+---+
    )",
              0.0);
    map.floor(R"(
        +---+-------+---+
        |C  /F    3 /I  |
        |   |       |   |
        +---+-------+---+
    )",
              1.0);
    for (char stairwell : {'A', 'B', 'C'}) map.region(stairwell, {"", RegionKind::Stairwell});
    for (char lift : {'G', 'H', 'I'}) map.region(lift, {"", RegionKind::Elevator});
    map.join(AccessKind::Stairs, 'A', 'B', "S", 18).join(AccessKind::Stairs, 'B', 'C', "S", 20);
    map.join(AccessKind::Elevator, 'G', 'H', "L").join(AccessKind::Elevator, 'H', 'I', "L");
    return map;
}

TEST(OptimalPlanner, overStairsAndLift) {
    AsciiMap map = tower();
    auto building = map.build();
    RouteOptions options;
    options.avoidElevator = true;
    Route stairs = planned(building, map.spot('1'), map.spot('3'), options);
    EXPECT_THAT(regionsOf(stairs), ElementsAre("D", "A", "B", "C", "F"));
    const Manoeuvre& first = stairs.manoeuvres[2];
    EXPECT_EQ(first.kind, ManoeuvreKind::Stairs);
    EXPECT_EQ(first.vertical, Vertical::Up);
    EXPECT_EQ(first.level, -1.0);
    EXPECT_EQ(first.targetLevel, 0.0);
    EXPECT_EQ(first.steps, 18);
    EXPECT_EQ(stairs.path.front().level, -1.0);
    EXPECT_EQ(stairs.path.back().level, 1.0);
    double flat = 0.0;
    for (std::size_t i = 1; i < stairs.path.size(); ++i)
        flat += distance(stairs.path[i - 1].position, stairs.path[i].position);
    EXPECT_NEAR(stairs.lengthM, flat + 2.0 * 3.0 * 2.0, 1e-6) << "a storey of 3 m is 6 m of stairs";
    EXPECT_NEAR(stairs.seconds, flat / 0.8 + 2 * 4.0 + 2 * 20.0, 1e-6);

    options = {};
    options.avoidStairs = true;
    Route lift = planned(building, map.spot('1'), map.spot('3'), options);
    EXPECT_THAT(regionsOf(lift), ElementsAre("D", "G", "H", "I", "F"));
    EXPECT_NEAR(lift.seconds, lift.lengthM / 0.8 + 2 * 4.0 + 45.0 + 5.0, 1e-6) << "one wait for one ride";

    Route down = planned(building, map.spot('2'), map.spot('1'), options);
    EXPECT_EQ(down.manoeuvres[2].vertical, Vertical::Down);
    options.avoidElevator = true;
    EXPECT_EQ(refusal(building, map.spot('1'), map.spot('3'), options),
              "F can be reached by stairs or lift only, which are to be avoided");
}

TEST(OptimalPlanner, levelsHaveTheElevationsOfTheMap) {
    AsciiMap map = tower();
    building::BuildingData data = map.data();
    for (building::Level& level : data.levels) level.elevationM = level.ordinal * 5.0;
    RouteOptions options;
    options.avoidElevator = true;
    auto plain = planned(map.build(), in("A"), in("B"), options);
    auto high = planned(std::make_shared<Building>(data), in("A"), in("B"), options);
    EXPECT_NEAR(high.lengthM - plain.lengthM, 2.0 * (5.0 - 3.0), 1e-9);
}

TEST(OptimalPlanner, saysThatOnlyStairsWouldDo) {
    AsciiMap map;
    map.floor("+---+\n|A  |\n|   |\n+---+").floor("+---+\n|B  |\n|   |\n+---+", 1.0);
    map.region('B', {"Room 2.14"}).join(AccessKind::Stairs, 'A', 'B');
    RouteOptions options;
    options.avoidStairs = true;
    EXPECT_EQ(refusal(map.build(), in("A"), in("B"), options),
              "Room 2.14 can be reached by stairs only, which are to be avoided");
}

TEST(OptimalPlanner, restrictedRegionsAreNoThoroughfare) {
    AsciiMap map;
    map.floor(R"(
        +---+---+---+
        |A  /B  /C  |
        +-/-+---+-/-+
        |D          |
        |           |
        |           |
        |           |
        |           |
        +-----------+
    )");
    map.region('B', {"Lab", RegionKind::Room, "", true});
    auto building = map.build();
    RouteOptions options;
    EXPECT_THAT(regionsOf(planned(building, in("A"), in("C"), options)), ElementsAre("A", "B", "C"));
    options.avoidRestricted = true;
    EXPECT_THAT(regionsOf(planned(building, in("A"), in("C"), options)), ElementsAre("A", "D", "C"));
    EXPECT_THAT(regionsOf(planned(building, in("A"), in("B"), options)), ElementsAre("A", "B"));
    EXPECT_THAT(regionsOf(planned(building, in("B"), in("C"), options)), ElementsAre("B", "C"));
}

TEST(OptimalPlanner, wideOpeningsAreCrossedWhereTheWayIsShort) {
    AsciiMap map;
    map.floor(R"(
        +------+------+
        |A     :B     |
        |      :      |
        |      :      |
        |      :      |
        |  1   :   2  |
        |      :      |
        +------+------+
    )");
    Route route = planned(map.build(), map.spot('1'), map.spot('2'));
    EXPECT_NEAR(route.lengthM, 8.0, 1e-3) << "straight, not over the middle of the opening";
    EXPECT_THAT(spoken(route), ElementsAre("start", "opening", "arrive"));
}

TEST(OptimalPlanner, anOpeningOfAPointIsAsWideAsItSays) {
    AsciiMap map;
    map.floor(R"(
        +------+------+
        |A     :B     |
        |      :      |
        |      :      |
        |      :      |
        |  1   :   2  |
        |      :      |
        +------+------+
    )");
    building::BuildingData data = map.data();
    data.accesses[0].line = {data.accesses[0].midpoint()};
    Route wide = planned(std::make_shared<Building>(data), map.spot('1'), map.spot('2'));
    EXPECT_NEAR(wide.lengthM, 8.0, 1e-3);
    data.accesses[0].widthM.reset();
    Route narrow = planned(std::make_shared<Building>(data), map.spot('1'), map.spot('2'));
    EXPECT_NEAR(narrow.lengthM, 2.0 * std::hypot(4.0, 1.5), 1e-3) << "nothing is known but the point";
}

/// A and C over B, by a way of each kind; the corridor D round about is longer.
std::shared_ptr<const Building> waysOf(AccessKind kind, std::optional<double> widthM = std::nullopt,
                                       std::optional<int> steps = std::nullopt) {
    AsciiMap map;
    map.floor(R"(
        +---+---+---+
        |A  /B  /C  |
        +-:-+---+-:-+
        |D          |
        |           |
        |           |
        |           |
        +-----------+
    )");
    building::BuildingData data = map.data();
    for (building::Access& access : data.accesses)
        if (access.id == AccessId("A-B")) {
            access.kind = kind;
            access.widthM = widthM;
            access.steps = steps;
        }
    return std::make_shared<Building>(std::move(data));
}

std::vector<std::string> overBOr(std::shared_ptr<const Building> building, RouteOptions options) {
    options.doorSeconds = 0.0;
    return regionsOf(planned(building, in("A"), in("C"), options));
}

TEST(OptimalPlanner, whatEachProfileAvoids) {
    struct Case {
        AccessKind kind;
        bool RouteOptions::*avoid;
    };
    for (const Case& each : {Case{AccessKind::Ramp, &RouteOptions::avoidRamp},
                             Case{AccessKind::Escalator, &RouteOptions::avoidWalkway},
                             Case{AccessKind::Stairs, &RouteOptions::avoidStairs}}) {
        RouteOptions options;
        options.stairsSecondsPerLevel = 1.0;
        auto building = waysOf(each.kind);
        EXPECT_THAT(overBOr(building, options), ElementsAre("A", "B", "C"));
        options.*each.avoid = true;
        EXPECT_THAT(overBOr(building, options), ElementsAre("A", "D", "C"));
    }
    RouteOptions options;
    options.avoidEscalator = true;
    EXPECT_THAT(overBOr(waysOf(AccessKind::Escalator), options), ElementsAre("A", "B", "C"))
        << "it stays on its level: a moving walkway";
}

TEST(OptimalPlanner, narrowDoors) {
    RouteOptions options;
    options.avoidNarrow = true;
    EXPECT_THAT(overBOr(waysOf(AccessKind::Door, 0.79), options), ElementsAre("A", "D", "C"));
    EXPECT_THAT(overBOr(waysOf(AccessKind::Door, 0.8), options), ElementsAre("A", "B", "C"));
    EXPECT_THAT(overBOr(waysOf(AccessKind::Door), options), ElementsAre("A", "B", "C")) << "drawn 0.9 m wide";
    options.narrowDoorM = 0.95;
    EXPECT_EQ(refusal(waysOf(AccessKind::Door), in("A"), in("C"), options),
              "C can be reached by a narrow door only, which is to be avoided")
        << "all are drawn 0.9 m wide";
    options.narrowDoorM = 0.8;
    options.avoidNarrow = false;
    options.narrowDoorSeconds = 100.0;
    EXPECT_THAT(overBOr(waysOf(AccessKind::Door, 0.7), options), ElementsAre("A", "D", "C"));
}

TEST(OptimalPlanner, stepsWithinALevelTakeTheirTime) {
    double none = planned(waysOf(AccessKind::Ramp), in("A"), in("B")).seconds;
    double nine = planned(waysOf(AccessKind::Stairs, {}, 9), in("A"), in("B")).seconds;
    double untold = planned(waysOf(AccessKind::Stairs), in("A"), in("B")).seconds;
    EXPECT_NEAR(nine - none, 10.0, 1e-9);
    EXPECT_NEAR(untold - none, 10.0, 1e-9);
}

TEST(OptimalPlanner, anEscalatorRunsOneWay) {
    AsciiMap map;
    map.floor("+---+\n|A  |\n|   |\n+---+").floor("+---+\n|B  |\n|   |\n+---+", 1.0);
    map.join(AccessKind::Escalator, 'A', 'B');
    building::BuildingData data = map.data();
    data.accesses[0].oneWay = building::OneWay::AToB;
    auto building = std::make_shared<const Building>(std::move(data));
    Route up = planned(building, in("A"), in("B"));
    EXPECT_EQ(up.manoeuvres[1].kind, ManoeuvreKind::Escalator);
    EXPECT_NEAR(up.seconds, 20.0, 1e-9);
    EXPECT_EQ(refusal(building, in("B"), in("A")), "A can be reached against a one-way access only (B to A)");
    RouteOptions options;
    options.avoidEscalator = true;
    EXPECT_EQ(refusal(building, in("A"), in("B"), options),
              "B can be reached by escalator only, which is to be avoided");
}

TEST(OptimalPlanner, leavesARegionWhereThatIsShorter) {
    AsciiMap map;
    map.floor(R"(
        +---+---+---+
        |A 1/B  /  2|
        |   |   |   |
        |   |   |   |
        |   |   |   |
        |   +---+   |
        |           |
        +-----------+
    )");
    RouteOptions options;
    options.doorSeconds = 1.0;
    EXPECT_THAT(regionsOf(planned(map.build(), map.spot('1'), map.spot('2'), options)),
                ElementsAre("A", "B", "A"));
    options.doorSeconds = 60.0;
    EXPECT_THAT(regionsOf(planned(map.build(), map.spot('1'), map.spot('2'), options)), ElementsAre("A"));
}

TEST(OptimalPlanner, manyThreadsPlanWithOnePlanner) {
    AsciiMap map = tower();
    auto planner = makeOptimalPlanner(map.build());
    auto expected = planner->plan(map.spot('1'), map.spot('3'));
    ASSERT_TRUE(expected.ok());
    auto fresh = makeOptimalPlanner(map.build());
    std::vector<std::thread> threads;
    std::vector<double> lengths(4);
    for (double& each : lengths)
        threads.emplace_back([&] { each = fresh->plan(map.spot('1'), map.spot('3'))->lengthM; });
    for (std::thread& thread : threads) thread.join();
    for (double each : lengths) EXPECT_EQ(each, expected->lengthM);
}

} // namespace
} // namespace farol::routing
