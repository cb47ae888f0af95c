// The planner on synthetic campuses beside A* of Boost over all doors, with the straight line for a bound:
// neither landmarks nor what the planner leaves out of its search.

#include "core/routing/route.h"
#include "tests/bench/boost_planner.h"
#include "tests/bench/door_graph.h"
#include "tests/support/campus.h"

#include <gtest/gtest.h>

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

} // namespace
} // namespace farol::routing
