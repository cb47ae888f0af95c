#pragma once
// Two buildings compared in all that a map may hold, feature by feature.

#include "core/building/building.h"

#include <gtest/gtest.h>
#include <tuple>

namespace farol::test {

inline void expectSame(const building::BuildingData& a, const building::BuildingData& b) {
    EXPECT_EQ(a.title, b.title);
    EXPECT_EQ(a.languages, b.languages);
    EXPECT_EQ(a.crs, b.crs);
    EXPECT_EQ(a.properties, b.properties);
    ASSERT_EQ(a.levels.size(), b.levels.size());
    for (std::size_t i = 0; i < a.levels.size(); ++i) {
        EXPECT_EQ(a.levels[i].ordinal, b.levels[i].ordinal);
        EXPECT_EQ(a.levels[i].name, b.levels[i].name);
        EXPECT_EQ(a.levels[i].elevationM, b.levels[i].elevationM);
    }
    ASSERT_EQ(a.regions.size(), b.regions.size());
    for (std::size_t i = 0; i < a.regions.size(); ++i) {
        const building::Region& x = a.regions[i];
        const building::Region& y = b.regions[i];
        EXPECT_EQ(std::tie(x.id, x.level, x.name, x.ref, x.kind, x.kindText, x.restricted, x.polygon.outer,
                           x.polygon.holes, x.extra),
                  std::tie(y.id, y.level, y.name, y.ref, y.kind, y.kindText, y.restricted, y.polygon.outer,
                           y.polygon.holes, y.extra))
            << x.id.value;
    }
    ASSERT_EQ(a.accesses.size(), b.accesses.size());
    for (std::size_t i = 0; i < a.accesses.size(); ++i) {
        const building::Access& x = a.accesses[i];
        const building::Access& y = b.accesses[i];
        EXPECT_EQ(std::tie(x.id, x.kind, x.kindText, x.level, x.regionA, x.regionB, x.shaft, x.oneWay,
                           x.doorType, x.automatic, x.widthM, x.steps, x.closed, x.line, x.extra),
                  std::tie(y.id, y.kind, y.kindText, y.level, y.regionA, y.regionB, y.shaft, y.oneWay,
                           y.doorType, y.automatic, y.widthM, y.steps, y.closed, y.line, y.extra))
            << x.id.value;
    }
    ASSERT_EQ(a.landmarks.size(), b.landmarks.size());
    for (std::size_t i = 0; i < a.landmarks.size(); ++i) {
        const building::Landmark& x = a.landmarks[i];
        const building::Landmark& y = b.landmarks[i];
        EXPECT_EQ(std::tie(x.id, x.kind, x.kindText, x.templateId, x.text, x.region, x.level, x.heightM,
                           x.widthM, x.tallM, x.position, x.extra),
                  std::tie(y.id, y.kind, y.kindText, y.templateId, y.text, y.region, y.level, y.heightM,
                           y.widthM, y.tallM, y.position, y.extra))
            << x.id.value;
        ASSERT_EQ(x.heading.has_value(), y.heading.has_value());
        EXPECT_NEAR(x.heading.value_or(Radians{}).value, y.heading.value_or(Radians{}).value, 1e-12);
    }
    ASSERT_EQ(a.walls.size(), b.walls.size());
    for (std::size_t i = 0; i < a.walls.size(); ++i) EXPECT_EQ(a.walls[i].line, b.walls[i].line);
}

} // namespace farol::test
