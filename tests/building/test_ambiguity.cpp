#include "core/building/ambiguity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

namespace {

using namespace farol;
using namespace farol::building;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Rooms in a row, each joined to the next; landmarks by a letter a room, '.' for none.
BuildingData row(const std::string& looks) {
    BuildingData data;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        double x = static_cast<double>(i) * 5.0;
        Region region;
        region.id = RegionId("r" + std::to_string(i));
        region.polygon.outer = {{x, 0}, {x + 5, 0}, {x + 5, 5}, {x, 5}};
        data.regions.push_back(region);
        if (looks[i] != '.') {
            Landmark landmark;
            landmark.id = LandmarkId("l" + std::to_string(i));
            landmark.region = region.id;
            landmark.templateId = TemplateId(std::string(1, looks[i]));
            landmark.position = {x + 2, 2};
            data.landmarks.push_back(landmark);
        }
        if (i == 0) continue;
        Access access;
        access.id = AccessId("d" + std::to_string(i));
        access.regionA = data.regions[i - 1].id;
        access.regionB = region.id;
        access.line = {{x, 2}, {x, 3}};
        data.accesses.push_back(access);
    }
    return data;
}

TEST(Ambiguity, DifferentLandmarksTellAllApart) {
    Ambiguity ambiguity = findAmbiguity(Building(row("abcd")));
    EXPECT_THAT(ambiguity.groups, IsEmpty());
    EXPECT_THAT(ambiguity.withoutLandmarks, IsEmpty());
    EXPECT_THAT(ambiguity.suggestions, IsEmpty());
}

TEST(Ambiguity, WhatLeadsThereTellsLikeRoomsApart) {
    EXPECT_THAT(findAmbiguity(Building(row("abacad"))).groups, IsEmpty());
    Ambiguity mirrored = findAmbiguity(Building(row("abba")));
    EXPECT_EQ(mirrored.confusedPairs, 2U) << "from either end the same is seen";
    EXPECT_THAT(mirrored.groups, ElementsAre(ElementsAre(RegionId("r0"), RegionId("r3")),
                                             ElementsAre(RegionId("r1"), RegionId("r2"))));
    ASSERT_FALSE(mirrored.suggestions.empty());
    EXPECT_EQ(mirrored.suggestions[0].pairs, 2U) << "one landmark breaks the symmetry";
}

TEST(Ambiguity, FurtherBackThanFourLandmarksIsForgotten) {
    EXPECT_THAT(findAmbiguity(Building(row("aaaaaaaab"))).groups.front(), SizeIs(5U))
        << "r1 to r5: b, or the end, is too far away";
}

TEST(Ambiguity, RegionsWithoutLandmarksAreListed) {
    Ambiguity ambiguity = findAmbiguity(Building(row("a..b")));
    EXPECT_THAT(ambiguity.withoutLandmarks, ElementsAre(RegionId("r1"), RegionId("r2")));
    EXPECT_THAT(ambiguity.groups, IsEmpty()) << "they are known by what lies beside them";
    EXPECT_EQ(findAmbiguity(Building(BuildingData{})).confusedPairs, 0U);
}

} // namespace
