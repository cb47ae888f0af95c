#pragma once
// Short forms for what tests of routes ask again and again.

#include "core/routing/route.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace farol::routing {

inline std::vector<std::string> regionsOf(const Route& route) {
    std::vector<std::string> names;
    for (const RegionId& id : route.regions) names.push_back(id.value);
    return names;
}

inline std::vector<std::string> accessesOf(const Route& route) {
    std::vector<std::string> names;
    for (const AccessId& id : route.accesses) names.push_back(id.value);
    return names;
}

/// "door +90" and the like: kind and turn, rounded to 5 degrees.
inline std::vector<std::string> spoken(const Route& route) {
    std::vector<std::string> words;
    for (const Manoeuvre& each : route.manoeuvres) {
        int degrees = 5 * static_cast<int>(std::lround(toDegrees(each.turn) / 5.0));
        words.push_back(manoeuvreKindName(each.kind) +
                        (degrees == 0 ? "" : (degrees > 0 ? " +" : " ") + std::to_string(degrees)));
    }
    return words;
}

inline Location in(const std::string& region) {
    return {RegionId(region), std::nullopt};
}

/// What every route must fulfil, whatever the planner.
inline void expectSound(const Building& building, const Route& route) {
    ASSERT_EQ(route.regions.size(), route.accesses.size() + 1);
    for (std::size_t i = 0; i < route.accesses.size(); ++i) {
        const building::Access* access = building.access(route.accesses[i]);
        ASSERT_NE(access, nullptr);
        EXPECT_TRUE(access->passable());
        EXPECT_EQ(building.otherSide(*access, *building.regionIndex(route.regions[i])),
                  building.regionIndex(route.regions[i + 1]));
    }
    ASSERT_GE(route.manoeuvres.size(), 2U);
    EXPECT_EQ(route.manoeuvres.front().kind, ManoeuvreKind::Start);
    EXPECT_EQ(route.manoeuvres.back().kind, ManoeuvreKind::Arrive);
    EXPECT_NEAR(route.manoeuvres.back().atM, route.lengthM, 1e-6);
    for (std::size_t i = 1; i < route.manoeuvres.size(); ++i)
        EXPECT_GE(route.manoeuvres[i].atM, route.manoeuvres[i - 1].atM - 1e-9);
}

} // namespace farol::routing
