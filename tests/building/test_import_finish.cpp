#include "core/building/import/importer.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace farol;
using namespace farol::building;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Ring box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Region room(const std::string& id, Ring outer, double level = 0.0, RegionKind kind = RegionKind::Room) {
    Region region;
    region.id = RegionId(id);
    region.level = level;
    region.kind = kind;
    region.polygon.outer = std::move(outer);
    return region;
}

Access door(const std::string& id, Polyline line, double level = 0.0) {
    Access access;
    access.id = AccessId(id);
    access.level = level;
    access.line = std::move(line);
    return access;
}

RawMap metric(std::vector<Region> regions, std::vector<Access> accesses = {}) {
    RawMap raw;
    raw.coordinates = RawCoordinates::Metric;
    raw.data.regions = std::move(regions);
    raw.data.accesses = std::move(accesses);
    return raw;
}

ImportedBuilding finished(RawMap raw) {
    auto done = finishImport(std::move(raw), MapFormat::GeoJson);
    EXPECT_TRUE(done.ok()) << (done.ok() ? "" : done.error().text());
    return done.ok()
               ? std::move(*done)
               : ImportedBuilding{std::make_shared<const Building>(BuildingData{}), MapFormat::GeoJson, {}};
}

std::vector<std::string> rulesOf(const ImportedBuilding& imported) {
    std::vector<std::string> rules;
    for (const Finding& finding : imported.findings) rules.push_back(finding.rule);
    return rules;
}

std::pair<std::string, std::string> sides(const ImportedBuilding& imported, const std::string& id) {
    const Access* access = imported.building->access(AccessId(id));
    return access == nullptr ? std::pair<std::string, std::string>("gone", "gone")
                             : std::pair(access->regionA.value, access->regionB.value);
}

using Pair = std::pair<std::string, std::string>;

TEST(FinishImport, DoorsOnABorderBesideItAndInAThickWall) {
    auto imported = finished(
        metric({room("A", box(0, 0, 5, 5)), room("B", box(5, 0, 10, 5)), room("C", box(10.6, 0, 15, 5))},
               {door("on", {{5, 1}, {5, 2}}), door("beside", {{5.2, 3}, {5.2, 4}}),
                door("thick", {{10.3, 1}, {10.3, 2}}), door("point", {{5, 2.5}})}));
    EXPECT_EQ(sides(imported, "on"), Pair("A", "B"));
    EXPECT_EQ(sides(imported, "beside"), Pair("A", "B"));
    EXPECT_EQ(sides(imported, "thick"), Pair("B", "C"));
    auto [a, b] = sides(imported, "point");
    EXPECT_TRUE((a == "A" && b == "B") || (a == "B" && b == "A")) << a << " " << b;
}

TEST(FinishImport, ADoorToTheOutsideJoinsNoNeighbourOfItsOwnSide) {
    auto imported =
        finished(metric({room("A", box(0, 0, 5, 5)), room("B", box(5, 0, 10, 5))},
                        {door("corner", {{4.2, 5}, {5.0, 5}}), door("across", {{4.6, 5}, {5.4, 5}})}));
    EXPECT_EQ(sides(imported, "corner"), Pair("A", ""));
    EXPECT_EQ(sides(imported, "across").second, "");
    EXPECT_THAT(rulesOf(imported), Contains("access-joins-two-regions"));
}

TEST(FinishImport, AGateBetweenTwoHousesIsNotTheWayBetweenThem) {
    auto imported = finished(
        metric({room("A", box(0, 0, 5, 5)), room("B", box(9, 0, 14, 5))}, {door("gate", {{5, 2}, {9, 2}})}));
    EXPECT_EQ(imported.building->neighboursOf(0).size(), 0U);
    EXPECT_THAT(rulesOf(imported), Contains("access-drawn-across"));
}

TEST(FinishImport, SeveralCandidatesAreTold) {
    auto imported = finished(
        metric({room("A", box(0, 0, 5, 5)), room("B", box(5, 0, 10, 5)), room("hall", box(0, 5, 10, 9))},
               {door("wide", {{4, 5}, {6, 5}})}));
    EXPECT_THAT(rulesOf(imported), Contains("access-ambiguous"));
    EXPECT_THAT(rulesOf(imported), Contains("access-touches-two-regions"));
}

TEST(FinishImport, DegreesBecomeMetresOfTheirZone) {
    RawMap raw;
    raw.coordinates = RawCoordinates::Geographic;
    raw.data.regions = {room("A", box(-7.9700, 37.0430, -7.9699, 37.0431))};
    auto imported = finished(std::move(raw));
    EXPECT_THAT(imported.building->data().crs, HasSubstr("UTM zone 29N"));
    EXPECT_NEAR(area(imported.building->regions()[0].polygon), 8.9 * 11.1, 1.0) << "metres, not degrees";
}

TEST(FinishImport, DegreesWithoutACrsAndFlippedAxesAreFound) {
    RawMap silent;
    silent.data.regions = {room("A", box(-7.9700, 37.0430, -7.9699, 37.0431))};
    EXPECT_THAT(rulesOf(finished(silent)), Contains("crs-missing"));
    RawMap claimed = silent;
    claimed.data.crs = "EPSG:3763";
    EXPECT_THAT(rulesOf(finished(claimed)), Contains("crs-degrees-for-metres"));
    RawMap flipped;
    flipped.coordinates = RawCoordinates::Geographic;
    flipped.data.regions = {room("A", box(35.6800, 139.7600, 35.6801, 139.7601))};
    auto imported = finished(flipped);
    EXPECT_THAT(rulesOf(imported), Contains("axes-flipped"));
    EXPECT_THAT(imported.building->data().crs, HasSubstr("UTM zone 54N"));
}

TEST(FinishImport, WebMercatorIsNeverMetres) {
    RawMap raw;
    raw.data.crs = "EPSG:3857";
    raw.data.regions = {room("A", box(-887000, 4443000, -886990, 4443010))};
    auto imported = finished(std::move(raw));
    EXPECT_THAT(imported.building->data().crs, HasSubstr("UTM zone 29N"));
    EXPECT_LT(area(imported.building->regions()[0].polygon), 70.0)
        << "10 m of Web Mercator are 8 m at 37 degrees";
    RawMap national;
    national.data.crs = "EPSG:3763";
    national.data.regions = {room("A", box(20000, -290000, 20010, -289990))};
    imported = finished(std::move(national));
    EXPECT_THAT(imported.building->data().crs, HasSubstr("Portugal TM06"));
    EXPECT_DOUBLE_EQ(imported.building->regions()[0].polygon.outer[0].x, 20000.0) << "a metric CRS stays";
}

TEST(FinishImport, BadOutlinesAreMendedOrLeftOut) {
    double nan = std::numeric_limits<double>::quiet_NaN();
    auto imported = finished(metric({room("bow", {{0, 0}, {5, 5}, {5, 0}, {0, 5}}), room("dot", {{20, 0}}),
                                     room("nan", {{30, 0}, {35, 0}, {nan, 2}, {35, 5}, {30, 5}}),
                                     room("twice", box(40, 0, 45, 5)), room("again", box(40, 0, 45, 5)),
                                     room("", box(50, 0, 55, 5)), room("bow", box(60, 0, 65, 5))},
                                    {door("d", {{nan, nan}})}));
    std::vector<std::string> ids;
    for (const Region& region : imported.building->regions()) {
        ids.push_back(region.id.value);
        EXPECT_GT(area(region.polygon), 1.0) << region.id.value;
    }
    EXPECT_THAT(ids, ElementsAre("bow", "bow-2", "bow/2", "nan", "region-1", "twice"));
    for (const char* rule : {"region-polygon-valid", "region-split", "coordinates-finite", "region-duplicate",
                             "region-id-unique", "access-geometry"})
        EXPECT_THAT(rulesOf(imported), Contains(rule));
}

TEST(FinishImport, NothingLeftIsAnError) {
    for (const RawMap& raw :
         {metric({}), metric({room("dot", {{1, 1}})}), metric({room("line", {{0, 0}, {1, 1}, {2, 2}})})}) {
        auto done = finishImport(raw, MapFormat::GeoJson);
        ASSERT_FALSE(done.ok());
        EXPECT_EQ(done.error().code, ErrorCode::Corrupt);
    }
    std::vector<Region> tower;
    for (int i = 0; i < 600; ++i) tower.push_back(room("r" + std::to_string(i), box(0, 0, 5, 5), i));
    auto done = finishImport(metric(tower), MapFormat::GeoJson);
    ASSERT_FALSE(done.ok());
    EXPECT_THAT(done.error().text(), HasSubstr("600 levels"));
}

TEST(FinishImport, StairsAndLiftsAboveEachOtherAreJoined) {
    auto imported =
        finished(metric({room("s0", box(0, 0, 3, 5), 0, RegionKind::Stairwell),
                         room("s1", box(0, 0.2, 3, 5.2), 1, RegionKind::Stairwell),
                         room("l0", box(5, 0, 7, 2), 0, RegionKind::Elevator),
                         room("l2", box(5, 0, 7, 2), 2, RegionKind::Elevator), room("x1", box(5, 0, 7, 2), 1),
                         room("far", box(20, 0, 23, 5), 1, RegionKind::Stairwell)}));
    const Building& building = *imported.building;
    auto joined = [&](const char* a, const char* b) {
        return building.areNeighbours(*building.regionIndex(RegionId(a)), *building.regionIndex(RegionId(b)));
    };
    EXPECT_TRUE(joined("s0", "s1"));
    EXPECT_TRUE(joined("l0", "l2")) << "a lift may pass a floor";
    EXPECT_FALSE(joined("l0", "x1")) << "a room above a lift is no lift";
    EXPECT_TRUE(building.neighboursOf(*building.regionIndex(RegionId("far"))).empty());
    EXPECT_THAT(rulesOf(imported), Contains("shaft-misses-level"));
}

TEST(FinishImport, OpenBordersOnlyWhereNoWallStands) {
    RawMap raw = metric({room("A", box(0, 0, 5, 5), 0, RegionKind::Corridor),
                         room("B", box(5, 0, 10, 5), 0, RegionKind::Hall),
                         room("C", box(10, 0, 15, 5), 0, RegionKind::Hall)});
    raw.openBoundaries = true;
    raw.data.walls = {{0.0, {{10, -1}, {10, 4.6}}, {}}, {0.0, {{5, 0}, {5, 2}}, {}}};
    auto imported = finished(std::move(raw));
    ASSERT_EQ(imported.building->accesses().size(), 1U) << "0.4 m beside a wall is no way";
    const Access& open = imported.building->accesses()[0];
    EXPECT_EQ(open.kind, AccessKind::Opening);
    EXPECT_NEAR(*open.widthM, 3.0, 1e-6);
    EXPECT_EQ(sides(imported, open.id.value), Pair("A", "B"));
}

TEST(FinishImport, TheUnnamedAreNamedAndAttributesKept) {
    RawMap raw = metric({room("c1", box(0, 0, 5, 5), 0, RegionKind::Corridor),
                         room("c2", box(5, 0, 10, 5), 0, RegionKind::Corridor),
                         room("c3", box(0, 0, 5, 5), 1, RegionKind::Corridor), room("r", box(10, 0, 15, 5))});
    raw.data.regions[0].name = "Corridor 1";
    raw.data.regions[3].ref = "2.14";
    raw.data.regions[3].extra = {{"name", std::string("as the source has it")},
                                 {"Farbe", std::string("rot")},
                                 {"farbe", std::int64_t{3}}};
    auto imported = finished(std::move(raw));
    EXPECT_EQ(imported.building->region(RegionId("c2"))->name, "Corridor 2")
        << "a name that is taken is not given again";
    EXPECT_EQ(imported.building->region(RegionId("c3"))->name, "Corridor 1");
    EXPECT_EQ(imported.building->region(RegionId("r"))->name, "") << "a ref is enough";
    const Attributes& extra = imported.building->region(RegionId("r"))->extra;
    EXPECT_EQ(extra.count("source_name"), 1U);
    EXPECT_EQ(extra.size(), 3U) << "columns that differ in case only would be one in a table";
}

TEST(FinishImport, LandmarksFindTheirRegion) {
    RawMap raw = metric({room("A", box(0, 0, 5, 5)), room("B", box(5, 0, 10, 5))});
    Landmark inside, lost;
    inside.id = LandmarkId("in");
    inside.position = {7, 1};
    lost.id = LandmarkId("lost");
    lost.position = {50, 50};
    raw.data.landmarks = {inside, lost};
    auto imported = finished(std::move(raw));
    EXPECT_EQ(imported.building->landmark(LandmarkId("in"))->region, RegionId("B"));
    EXPECT_EQ(imported.building->landmark(LandmarkId("lost"))->region, RegionId());
    EXPECT_THAT(rulesOf(imported), Contains("landmark-region-exists"));
}

} // namespace
