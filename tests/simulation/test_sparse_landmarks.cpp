#include "core/simulation/sparse_landmarks.h"
#include "tests/support/ascii_map.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace farol::simulation {
namespace {

test::AsciiMap office() {
    return test::AsciiMap()
        .floor(R"(
            +---------+---------+---------+---------+
            |A        |B        |D        |S        |
            |         |         |         |         |
            +----/----+----/----+----/----+----/----+
            |C                                      |
            |                                       |
            +---------------------------------------+
        )")
        .region('A', {"Library", building::RegionKind::Room})
        .region('B', {"Bar", building::RegionKind::Room})
        .region('D', {"Court", building::RegionKind::Room})
        .region('S', {"Stairs", building::RegionKind::Stairwell})
        .region('C', {"Corridor", building::RegionKind::Corridor});
}

int countOf(const building::Building& building, Kind kind) {
    return static_cast<int>(
        std::count_if(building.landmarks().begin(), building.landmarks().end(),
                      [&](const building::Landmark& landmark) { return landmark.kind == kind; }));
}

TEST(SparseLandmarks, HangInTheCorridorAndFaceIt) {
    auto plain = office().build();
    auto furnished = withSparseLandmarks(*plain);
    EXPECT_EQ(countOf(*furnished, Kind::Text), 2) << "beside every other door";
    EXPECT_EQ(countOf(*furnished, Kind::ExitSign), 1);
    EXPECT_GE(countOf(*furnished, Kind::Extinguisher), 1);
    for (const building::Landmark& landmark : furnished->landmarks()) {
        EXPECT_EQ(landmark.region, RegionId("C"));
        ASSERT_TRUE(landmark.heading.has_value());
        Point2 before = landmark.position +
                        Point2{std::cos(landmark.heading->value), std::sin(landmark.heading->value)} * 0.3;
        EXPECT_TRUE(contains(furnished->region(RegionId("C"))->polygon, before)) << landmark.id.value;
    }
    EXPECT_EQ(withSparseLandmarks(*plain)->landmarks().size(), furnished->landmarks().size());
}

TEST(SparseLandmarks, WhatTheMapHasIsLeftAlone) {
    auto furnished = withSparseLandmarks(*withSparseLandmarks(*office().build()));
    EXPECT_EQ(furnished->landmarks().size(), withSparseLandmarks(*office().build())->landmarks().size());
}

} // namespace
} // namespace farol::simulation
