// The planner on synthetic campuses beside A* of Boost over all doors, with the straight line for a bound:
// neither landmarks nor what the planner leaves out of its search.

#include "core/routing/route.h"
#include "tests/bench/boost_planner.h"
#include "tests/bench/door_graph.h"
#include "tests/support/campus.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

namespace farol::routing {
namespace {

constexpr double kMillimetre = 0.001;

class OnCampus : public testing::TestWithParam<test::CampusOptions> {};

TEST_P(OnCampus, TheLeastTimeIsWhatOthersFind) {
    auto campus = test::makeCampus(GetParam());
    auto pairs = test::campusPairs(*campus, 300);
    RouteOptions profile;
    auto planner = makeOptimalPlanner(campus, profile);
    RouteGraph rules(campus, profile);
    bench::DoorGraph doors(rules, pairs);
    bench::BoostPlanner boost(doors, profile.walkingSpeed);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        auto route = planner->plan(pairs[i].first, pairs[i].second);
        ASSERT_TRUE(route.ok()) << route.error().text();
        EXPECT_NEAR(route->seconds * profile.walkingSpeed,
                    boost.seconds(doors.start(i), doors.goal(i)) * profile.walkingSpeed, kMillimetre)
            << pairs[i].first.region.value << " to " << pairs[i].second.region.value;
    }
}

INSTANTIATE_TEST_SUITE_P(Campuses, OnCampus,
                         testing::Values(test::CampusOptions{100, 1}, test::CampusOptions{100, 2, 31.0},
                                         test::CampusOptions{300, 3, 0.0, {595000.0, 4099000.0}},
                                         test::CampusOptions{1000, 1}, test::CampusOptions{1000, 4, 12.0},
                                         test::CampusOptions{3000, 5, 45.0, {595000.0, 4099000.0}}));

/// Areas of a railway station lie over each other, and every two of them are joined.
TEST(OverlappingAreas, JoinedEachToEachAreStillPlannedThrough) {
    building::BuildingData data;
    data.levels.push_back({0.0, "Ground floor", "0", std::nullopt, std::nullopt, {}});
    constexpr int kAreas = 12;
    for (int i = 0; i < kAreas; ++i) {
        building::Region area;
        area.id = RegionId("area-" + std::to_string(i));
        area.kind = building::RegionKind::Hall;
        double at = 0.7 * i;
        area.polygon.outer = {{at, at}, {at + 12.0, at}, {at + 12.0, at + 12.0}, {at, at + 12.0}};
        data.regions.push_back(area);
    }
    for (int i = 0; i < kAreas; ++i)
        for (int j = i + 1; j < kAreas; ++j) {
            building::Access opening;
            opening.id = AccessId("opening-" + std::to_string(i) + "-" + std::to_string(j));
            opening.kind = building::AccessKind::Opening;
            opening.regionA = RegionId("area-" + std::to_string(i));
            opening.regionB = RegionId("area-" + std::to_string(j));
            double x = 8.0 + 0.3 * i, y = 8.0 + 0.3 * j;
            opening.line = {{x, y}, {x + 1.5, y - 1.5}};
            data.accesses.push_back(opening);
        }
    auto building = std::make_shared<const building::Building>(std::move(data));
    auto planner = makeOptimalPlanner(building);
    auto route =
        planner->plan({RegionId("area-0"), Point2{1.0, 1.0}}, {RegionId("area-11"), Point2{19.0, 19.0}});
    ASSERT_TRUE(route) << route.error().text();
    EXPECT_EQ(route->regions.front(), RegionId("area-0"));
    EXPECT_EQ(route->regions.back(), RegionId("area-11"));
    EXPECT_GE(route->lengthM, std::hypot(18.0, 18.0) - 1e-6);
    EXPECT_LT(route->lengthM, 27.0);
}

} // namespace
} // namespace farol::routing
