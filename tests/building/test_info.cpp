#include "core/building/checks.h"
#include "core/building/info.h"
#include "tests/support/ascii_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

namespace farol::building {
namespace {

using test::AsciiMap;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

AsciiMap twoRoomsAndABar() {
    AsciiMap map;
    map.floor(R"(
        +----+----+----+
        |A   |B   |C   |
        |    /    *    |
        +----+----+----+
    )");
    map.region('A', {"Café Müller", RegionKind::Room, "0.01"})
        .region('B', {"Office", RegionKind::Room, "0.02"});
    map.region('C', {"office", RegionKind::Room, "0.03"});
    return map;
}

std::vector<std::string> rulesOf(const BuildingData& data, Severity severity) {
    std::vector<std::string> rules;
    for (const Finding& finding : checkBuilding(Building(data)))
        if (finding.severity == severity) rules.push_back(finding.rule);
    return rules;
}

TEST(ResolveWhere, takesIdsNamesRefsAndPoints) {
    auto building = twoRoomsAndABar().build();
    EXPECT_EQ(resolveWhere(*building, "A")->region, RegionId("A"));
    EXPECT_EQ(resolveWhere(*building, "a")->region, RegionId("A"));
    EXPECT_EQ(resolveWhere(*building, "  cafe   MULLER ")->region, RegionId("A"));
    EXPECT_EQ(resolveWhere(*building, "0.02")->region, RegionId("B"));
    auto point = resolveWhere(*building, "7.5, 1, 0");
    ASSERT_TRUE(point.ok());
    EXPECT_EQ(point->region, RegionId("B"));
    EXPECT_EQ(point->position, (Point2{7.5, 1.0}));
    EXPECT_EQ(resolveWhere(*building, "-0.3,1,0")->region, RegionId("A")) << "a point in the wall";
}

TEST(ResolveWhere, saysWhyAPlaceIsNotFound) {
    auto building = twoRoomsAndABar().build();
    auto shared = resolveWhere(*building, "Office");
    ASSERT_FALSE(shared.ok());
    EXPECT_EQ(shared.error().code, ErrorCode::Conflict);
    EXPECT_THAT(shared.error().message, HasSubstr("B (level 0), C (level 0)"));
    auto misspelt = resolveWhere(*building, "Cafe Muler");
    ASSERT_FALSE(misspelt.ok());
    EXPECT_EQ(misspelt.error().code, ErrorCode::NotFound);
    EXPECT_THAT(misspelt.error().message, HasSubstr("Café Müller"));
    EXPECT_EQ(resolveWhere(*building, "7,1,3").error().code, ErrorCode::NotFound);
    EXPECT_EQ(resolveWhere(*building, "99,1,0").error().code, ErrorCode::NotFound);
    EXPECT_EQ(resolveWhere(*building, "nan,1,0").error().code, ErrorCode::NotFound);
    EXPECT_EQ(resolveWhere(*building, "1,1").error().code, ErrorCode::NotFound);
    EXPECT_EQ(resolveWhere(*building, " ").error().code, ErrorCode::InvalidArgument);
}

TEST(Describe, countsWhatIsThere) {
    AsciiMap map = twoRoomsAndABar();
    map.floor("+--+\n|D |\n|e |\n+--+", -1.0).landmark('e', {Kind::Extinguisher});
    BuildingData data = map.data();
    data.accesses.push_back({});
    data.accesses.back().id = AccessId("half");
    data.accesses.back().regionA = RegionId("A");
    data.landmarks.push_back(data.landmarks.front());
    data.landmarks.back().id = LandmarkId("e2");
    data.landmarks.back().kind = Kind::Other;
    data.landmarks.back().kindText = "sculpture";
    data.regions[3].name.clear();
    BuildingInfo info = describe(Building(data));
    EXPECT_EQ(info.regions, 4U);
    EXPECT_EQ(info.accesses, 3U);
    EXPECT_EQ(info.accessesJoined, 2U) << "a closed door joins, a half access does not";
    EXPECT_EQ(info.components, 3U);
    EXPECT_EQ(info.largestComponent, 2U);
    EXPECT_EQ(info.unnamedRegions, 1U);
    EXPECT_THAT(info.landmarkKinds,
                ElementsAre(testing::Pair("extinguisher", 1U), testing::Pair("sculpture", 1U)));
    ASSERT_EQ(info.levels.size(), 2U);
    EXPECT_EQ(info.levels[0].level, -1.0);
    EXPECT_EQ(info.levels[0].landmarks, 2U);
    EXPECT_EQ(info.levels[1].regions, 3U);
    EXPECT_DOUBLE_EQ(info.widthM, 15.0);
    EXPECT_DOUBLE_EQ(info.heightM, 3.0);
    EXPECT_EQ(describe(Building(BuildingData{})).components, 0U);
}

TEST(Checks, aSoundMapHasNoErrors) {
    BuildingData data = twoRoomsAndABar().data();
    EXPECT_THAT(rulesOf(data, Severity::Error), IsEmpty());
    EXPECT_THAT(rulesOf(data, Severity::Warning), ElementsAre("region-has-access", "regions-connected"));
}

TEST(Checks, nameEveryFault) {
    BuildingData data = twoRoomsAndABar().data();
    data.levels.clear();
    data.regions[1].id = RegionId("A");
    data.regions[2].polygon.outer = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
    data.accesses[0].regionB = RegionId("nowhere");
    data.accesses[1].regionA = RegionId("C");
    Landmark landmark;
    landmark.id = LandmarkId("l");
    landmark.region = RegionId("gone");
    data.landmarks = {landmark};
    auto errors = rulesOf(data, Severity::Error);
    EXPECT_THAT(errors, Contains("region-id-unique"));
    EXPECT_THAT(errors, Contains("region-polygon-valid"));
    EXPECT_THAT(errors, Contains("access-regions-exist"));
    EXPECT_THAT(errors, Contains("landmark-region-exists"));
    auto warnings = rulesOf(data, Severity::Warning);
    EXPECT_THAT(warnings, Contains("level-listed"));
    EXPECT_THAT(warnings, Contains("access-joins-two-regions"));
}

TEST(Checks, landmarksStandInTheirRegion) {
    BuildingData data = twoRoomsAndABar().data();
    Landmark landmark;
    landmark.id = LandmarkId("l");
    landmark.region = RegionId("A");
    landmark.position = {5.3, 1.0}; // on the far side of the wall, within what a wall is thick
    data.landmarks = {landmark};
    EXPECT_THAT(rulesOf(data, Severity::Warning), Not(Contains("landmark-inside-region")));
    data.landmarks[0].position = {6.0, 1.0};
    EXPECT_THAT(rulesOf(data, Severity::Warning), Contains("landmark-inside-region"));
}

TEST(Checks, aDoorDoesNotChangeTheLevel) {
    AsciiMap map = twoRoomsAndABar();
    map.floor("+--+\n|D |\n|  |\n+--+", 1.0).join(AccessKind::Door, 'A', 'D');
    EXPECT_THAT(rulesOf(map.data(), Severity::Error), Contains("access-level-change"));
}

TEST(Checks, unknownKindsAreNamed) {
    BuildingData data = twoRoomsAndABar().data();
    data.accesses[0].kind = AccessKind::Other;
    data.accesses[0].kindText = "portcullis";
    EXPECT_THAT(rulesOf(data, Severity::Warning), Contains("kind-known"));
}

TEST(Checks, brokenOutlinesAreToldApart) {
    auto faultOf = [](Ring ring) {
        BuildingData data;
        data.regions.emplace_back();
        data.regions[0].id = RegionId("R");
        data.regions[0].polygon.outer = std::move(ring);
        for (const Finding& finding : checkBuilding(Building(data)))
            if (finding.rule == "region-polygon-valid") return finding.message;
        return std::string();
    };
    EXPECT_THAT(faultOf({}), HasSubstr("fewer than three"));
    EXPECT_THAT(faultOf({{0, 0}, {1, 1}, {2, 2}}), HasSubstr("no area"));
    EXPECT_THAT(faultOf({{0, 0}, {4, 4}, {4, 0}, {0, 3}}), HasSubstr("crosses itself"));
    EXPECT_THAT(faultOf({{0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0}, {1, 1}}),
                HasSubstr("no number"));
    EXPECT_EQ(faultOf({{0, 0}, {1, 0}, {1, 1}}), "");
}

} // namespace
} // namespace farol::building
