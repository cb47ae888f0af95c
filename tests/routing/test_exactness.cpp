// Every way that the optimal planner finds costs what an independent search over the free space of whole
// floors says it has to: to a millimetre.
#include "core/routing/portal_search.h"
#include "tests/routing/free_space_graph.h"
#include "tests/routing/random_floors.h"
#include "tests/routing/route_matchers.h"
#include "tests/support/campus.h"

#include <gtest/gtest.h>
#include <random>

namespace farol::routing {
namespace {

constexpr double kMillimetre = 1e-3;

/// The price that the route itself adds up to has to be the least there is.
void expectLeast(const Planner& planner, const test::FreeSpaceGraph& truth, const Building& building,
                 const Location& from, const Location& to, const std::string& what) {
    auto route = planner.plan(from, to);
    auto least = truth.seconds(from, to);
    ASSERT_EQ(route.ok(), least.has_value()) << what << " " << from.region.value << " to " << to.region.value
                                             << (route.ok() ? "" : ": " + route.error().text());
    if (!least) return;
    expectSound(building, *route);
    EXPECT_NEAR(route->seconds * 0.8, *least * 0.8, kMillimetre)
        << what << " " << from.region.value << " to " << to.region.value;
}

void expectExact(std::shared_ptr<const Building> building, int pairs, std::uint32_t seed,
                 const RouteOptions& options, const std::string& what) {
    auto planner = makeOptimalPlanner(building, options);
    test::FreeSpaceGraph truth(building, options);
    std::mt19937 random(seed);
    for (int i = 0; i < pairs; ++i) {
        Location from = test::randomSpot(*building, random);
        Location to = test::randomSpot(*building, random);
        expectLeast(*planner, truth, *building, from, to, what);
    }
}

TEST(Exactness, randomFloors) {
    for (std::uint32_t seed = 1; seed <= 24; ++seed) {
        test::RandomFloors floors;
        floors.openness = seed % 3 == 0 ? 0.9 : 0.5;
        expectExact(test::randomFloors(seed, floors), 16, seed, {}, "floors " + std::to_string(seed));
    }
}

TEST(Exactness, whereStairsOrLiftsAreAvoidedAndDoorsCostNothing) {
    for (std::uint32_t seed = 101; seed <= 105; ++seed) {
        auto building = test::randomFloors(seed);
        RouteOptions options;
        options.avoidStairs = true;
        expectExact(building, 10, seed, options, "no stairs " + std::to_string(seed));
        options = {};
        options.avoidElevator = true;
        options.doorSeconds = 0.0;
        expectExact(building, 10, seed, options, "no lift " + std::to_string(seed));
    }
}

TEST(Exactness, threeLevelsAndALiftRiddenOn) {
    for (std::uint32_t seed = 201; seed <= 208; ++seed) {
        test::RandomFloors floors;
        floors.levels = 3;
        floors.columns = 3;
        floors.rows = 2;
        RouteOptions options;
        options.stairsSecondsPerLevel = 60.0;
        expectExact(test::randomFloors(seed, floors), 20, seed, options, "lift " + std::to_string(seed));
    }
}

TEST(Exactness, oneOpenFloor) {
    for (std::uint32_t seed = 301; seed <= 303; ++seed) {
        test::RandomFloors floors;
        floors.levels = 1;
        floors.columns = 6;
        floors.rows = 4;
        floors.openness = 1.0;
        expectExact(test::randomFloors(seed, floors), 20, seed, {}, "open " + std::to_string(seed));
    }
}

TEST(Exactness, aCampus) {
    test::CampusOptions options;
    options.regions = 100;
    options.turnDegrees = 17.0;
    options.origin = {592000.0, 4098000.0};
    auto building = test::makeCampus(options);
    auto planner = makeOptimalPlanner(building);
    test::FreeSpaceGraph truth(building, {});
    for (const auto& [from, to] : test::campusPairs(*building, 150))
        expectLeast(*planner, truth, *building, from, to, "campus");
}

TEST(Exactness, boundsChangeNothingButTheTime) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        test::CampusOptions options;
        options.regions = 1500;
        options.seed = seed;
        auto building = test::makeCampus(options);
        RouteGraph graph(building, {});
        PortalGraph portals(graph);
        LandmarkBounds bounds(portals), none(portals, 0);
        PortalSearch quick(portals, bounds), plain(portals, none);
        for (const auto& [from, to] : test::campusPairs(*building, 500, seed)) {
            auto start = graph.endpoint(from, "start"), goal = graph.endpoint(to, "goal");
            auto found = quick.run(*start, *goal), truth = plain.run(*start, *goal);
            ASSERT_TRUE(found && truth);
            EXPECT_NEAR(found->seconds * 0.8, truth->seconds * 0.8, kMillimetre)
                << seed << ": " << from.region.value << " to " << to.region.value;
        }
    }
}

} // namespace
} // namespace farol::routing
