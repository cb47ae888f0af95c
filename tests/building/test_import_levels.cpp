// Ways from level to level, and ways that run in one direction only: a wrong one leads against a wall.
#include "core/building/import/importer.h"
#include "tests/building/import_support.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace farol;
using namespace farol::building;
using namespace farol::building::testing;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using Pair = std::pair<std::string, std::string>;

Ring box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Region area(const std::string& id, Ring outer, double level, RegionKind kind = RegionKind::Corridor) {
    Region region;
    region.id = RegionId(id);
    region.level = level;
    region.kind = kind;
    region.polygon.outer = std::move(outer);
    return region;
}

Access way(const std::string& id, AccessKind kind, double level, Point2 at, const std::string& a = "",
           const std::string& shaft = "") {
    Access access;
    access.id = AccessId(id);
    access.kind = kind;
    access.level = level;
    access.regionA = RegionId(a);
    access.shaft = ShaftId(shaft);
    access.line = {at};
    return access;
}

/// Two corridors beside each other on each of three floors.
RawMap floors(std::vector<Access> accesses) {
    RawMap raw;
    raw.coordinates = RawCoordinates::Metric;
    for (int level = 0; level < 3; ++level) {
        raw.data.regions.push_back(area("W" + std::to_string(level), box(0, 0, 10, 4), level));
        raw.data.regions.push_back(area("E" + std::to_string(level), box(10, 0, 20, 4), level));
    }
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

Pair sides(const ImportedBuilding& imported, const std::string& id) {
    const Access* access = imported.building->access(AccessId(id));
    return access == nullptr ? Pair("gone", "gone") : Pair(access->regionA.value, access->regionB.value);
}

std::vector<std::string> idsOf(const ImportedBuilding& imported, const std::string& rule) {
    for (const Finding& finding : imported.findings)
        if (finding.rule == rule) return finding.ids;
    return {};
}

TEST(LevelChanges, StairsThatNameOneSideNeverLeadToTheRegionBesideThem) {
    auto imported = finished(floors({way("s", AccessKind::Stairs, 0, {10, 2}, "W0")}));
    EXPECT_EQ(sides(imported, "s"), Pair("W0", ""));
    EXPECT_THAT(idsOf(imported, "access-far-level"), Contains("s"));
    EXPECT_THAT(idsOf(imported, "access-joins-two-regions"), Contains("s"));
}

TEST(LevelChanges, TheSameShaftJoinsItsFloorsInTurn) {
    auto imported = finished(floors({way("l0", AccessKind::Elevator, 0, {5, 2}, "", "L"),
                                     way("l1", AccessKind::Elevator, 1, {5, 2}, "", "L"),
                                     way("l2", AccessKind::Elevator, 2, {15, 2}, "", "L")}));
    EXPECT_EQ(sides(imported, "l0"), Pair("W0", "W1"));
    EXPECT_EQ(sides(imported, "l1"), Pair("W1", "E2"));
    EXPECT_EQ(sides(imported, "l2"), Pair("gone", "gone")) << "the one below leads there";
    EXPECT_THAT(idsOf(imported, "access-merged"), Contains("l2"));
    EXPECT_THAT(idsOf(imported, "shaft-misses-level"), IsEmpty());
}

TEST(LevelChanges, StairsAboveEachOtherAreOneFlight) {
    auto imported =
        finished(floors({way("a", AccessKind::Stairs, 0, {5, 2}), way("b", AccessKind::Stairs, 1, {6, 3}),
                         way("other", AccessKind::Stairs, 1, {18, 2})}));
    EXPECT_EQ(sides(imported, "a"), Pair("W0", "W1"));
    EXPECT_EQ(sides(imported, "b"), Pair("gone", "gone"));
    EXPECT_EQ(sides(imported, "other"), Pair("E1", "")) << "12 m away is another staircase";
}

TEST(LevelChanges, AStaircaseIsNotTakenForOneTwoFloorsUp) {
    auto imported =
        finished(floors({way("a", AccessKind::Stairs, 0, {5, 2}), way("b", AccessKind::Stairs, 2, {5, 2})}));
    EXPECT_EQ(sides(imported, "a"), Pair("W0", ""));
    auto lift = finished(
        floors({way("a", AccessKind::Elevator, 0, {5, 2}), way("b", AccessKind::Elevator, 2, {5, 2})}));
    EXPECT_EQ(sides(lift, "a"), Pair("W0", "W2")) << "a lift may pass a floor";
}

TEST(LevelChanges, ANamedLevelIsBelieved) {
    RawMap raw = floors(
        {way("s", AccessKind::Stairs, 0, {5, 2}, "W0"), way("back", AccessKind::Stairs, 2, {15, 2}, "E0")});
    raw.levelChanges = {{AccessId("s"), 2.0, std::nullopt}};
    auto imported = finished(std::move(raw));
    EXPECT_EQ(sides(imported, "s"), Pair("W0", "W2"));
    EXPECT_EQ(sides(imported, "back"), Pair("E0", "E2"))
        << "it stands on level 2 and names a region of level 0";
}

TEST(LevelChanges, TheWayIntoAStairwellStaysOnItsLevel) {
    RawMap raw = floors({way("door", AccessKind::Stairs, 0, {20, 2})});
    raw.data.regions.push_back(area("S0", box(20, 0, 23, 4), 0, RegionKind::Stairwell));
    raw.data.regions.push_back(area("S1", box(20, 0, 23, 4), 1, RegionKind::Stairwell));
    auto imported = finished(std::move(raw));
    auto [a, b] = sides(imported, "door");
    EXPECT_THAT((std::vector<std::string>{a, b}), ::testing::UnorderedElementsAre("E0", "S0"));
    const Building& building = *imported.building;
    EXPECT_TRUE(
        building.areNeighbours(*building.regionIndex(RegionId("S0")), *building.regionIndex(RegionId("S1"))));
}

TEST(LevelChanges, EscalatorsRunTheWayTheSourceTells) {
    RawMap raw =
        floors({way("up", AccessKind::Escalator, 0, {3, 2}), way("up2", AccessKind::Escalator, 1, {3, 2}),
                way("dn", AccessKind::Escalator, 0, {13, 2}), way("dn2", AccessKind::Escalator, 1, {13, 2}),
                way("who", AccessKind::Escalator, 1, {8, 2}), way("who2", AccessKind::Escalator, 2, {8, 2})});
    raw.levelChanges = {{AccessId("up"), std::nullopt, true}, {AccessId("dn2"), std::nullopt, false}};
    auto imported = finished(std::move(raw));
    EXPECT_EQ(imported.building->access(AccessId("up"))->oneWay, OneWay::AToB);
    EXPECT_EQ(imported.building->access(AccessId("dn"))->oneWay, OneWay::BToA) << "its upper end tells";
    EXPECT_EQ(sides(imported, "dn"), Pair("E0", "E1"));
    EXPECT_THAT(idsOf(imported, "escalator-direction"), ::testing::ElementsAre("who"));
}

TEST(LevelChanges, TwoEscalatorsBetweenTheSameRegionsRunBothWays) {
    RawMap raw = floors({});
    RawMap::VerticalLink link;
    link.from = RegionId("W0");
    link.to = RegionId("W1");
    link.kind = AccessKind::Escalator;
    link.oneWay = OneWay::AToB;
    raw.verticalLinks = {link, link};
    std::swap(link.from, link.to);
    raw.verticalLinks.push_back(link);
    auto imported = finished(std::move(raw));
    std::vector<Pair> ways;
    for (const Access& access : imported.building->accesses())
        if (access.oneWay == OneWay::AToB) ways.emplace_back(access.regionA.value, access.regionB.value);
    EXPECT_THAT(ways, ::testing::UnorderedElementsAre(Pair("W0", "W1"), Pair("W1", "W0")))
        << "and none twice";
}

TEST(OpenAreas, AreasThatReachIntoEachOtherAreOpenUnlessWallsOrStairsStandThere) {
    auto openings = [](RegionKind kind, std::vector<Wall> walls) {
        RawMap raw;
        raw.coordinates = RawCoordinates::Metric;
        raw.openBoundaries = true;
        raw.data.regions = {area("hall", box(0, 0, 20, 20), 0, RegionKind::Hall),
                            area("arm", box(15, 5, 40, 8), 0, kind)};
        raw.data.walls = std::move(walls);
        auto imported = finished(std::move(raw));
        std::vector<double> widths;
        for (const Access& access : imported.building->accesses()) {
            EXPECT_EQ(access.kind, AccessKind::Opening);
            widths.push_back(std::round(access.widthM.value_or(0.0) * 10) / 10);
        }
        return widths;
    };
    EXPECT_THAT(openings(RegionKind::Corridor, {}), ::testing::UnorderedElementsAre(3.0, 5.0, 5.0));
    Wall across{0.0, {{15, 5}, {15, 8}, {20, 8}}, {}};
    EXPECT_THAT(openings(RegionKind::Corridor, {across}), ::testing::ElementsAre(5.0));
    EXPECT_THAT(openings(RegionKind::Stairwell, {}), IsEmpty()) << "nobody steps onto stairs from the side";
    Wall around{0.0, {{15, 5}, {40, 5}, {40, 8}, {15, 8}, {15, 5}}, {}};
    EXPECT_THAT(openings(RegionKind::Room, {around}), IsEmpty());
}

TEST(OpenAreas, AMovingWalkwayIsEnteredAtOneEndOnly) {
    auto node = [](int id, double x, double y) {
        return "<node id='" + std::to_string(id) + "' lat='" + std::to_string(37.0 + y / 111000) + "' lon='" +
               std::to_string(-8.0 + x / 89000) + "'/>";
    };
    std::string osm =
        "<osm version='0.6'>" + node(1, 0, 0) + node(2, 10, 0) + node(3, 10, 10) + node(4, 0, 10) +
        node(5, 40, 0) + node(6, 50, 0) + node(7, 50, 10) + node(8, 40, 10) + node(9, 9, 5) +
        node(10, 41, 5) +
        "<way id='1'><nd ref='1'/><nd ref='2'/><nd ref='3'/><nd ref='4'/><nd ref='1'/><tag k='indoor' "
        "v='area'/><tag k='level' v='0'/></way>"
        "<way id='2'><nd ref='5'/><nd ref='6'/><nd ref='7'/><nd ref='8'/><nd ref='5'/><tag k='indoor' "
        "v='area'/><tag k='level' v='0'/></way>"
        "<way id='3'><nd ref='9'/><nd ref='10'/><tag k='highway' v='footway'/><tag k='indoor' v='yes'/>"
        "<tag k='level' v='0'/><tag k='conveying' v='CONVEYING'/></way></osm>";
    for (auto [word, there, back] : {std::tuple("forward", OneWay::AToB, OneWay::BToA),
                                     std::tuple("backward", OneWay::BToA, OneWay::AToB),
                                     std::tuple("reversible", OneWay::No, OneWay::No)}) {
        std::string text = osm;
        text.replace(text.find("CONVEYING"), 9, word);
        MemoryFile file("walkway.osm", text);
        auto imported = importBuilding(file.path());
        ASSERT_TRUE(imported.ok()) << imported.error().text();
        const Access* entry = imported->building->access(AccessId("way/3@0/end"));
        const Access* exit = imported->building->access(AccessId("way/3@0/end#2"));
        ASSERT_NE(entry, nullptr) << word;
        ASSERT_NE(exit, nullptr) << word;
        EXPECT_EQ(entry->regionA.value, "way/1");
        EXPECT_EQ(exit->regionA.value, "way/2");
        EXPECT_EQ(entry->regionB, exit->regionB);
        EXPECT_EQ(entry->oneWay, there) << word;
        EXPECT_EQ(exit->oneWay, back) << word;
        EXPECT_EQ(imported->building->accesses().size(), 2U) << word;
    }
}

std::string roomAt(const std::string& id, double x, double z, const std::string& more = "") {
    auto corner = [&](double a, double b) {
        return "[" + std::to_string(500000 + a) + "," + std::to_string(4100000 + b) + "," +
               std::to_string(z) + "]";
    };
    return R"({"type":"Feature","properties":{"id":")" + id + "\"" + more +
           R"(},"geometry":{"type":"Polygon","coordinates":[[)" + corner(x, 0) + "," + corner(x + 5, 0) +
           "," + corner(x + 5, 5) + "," + corner(x, 5) + "," + corner(x, 0) + "]]}}";
}

Result<ImportedBuilding> tables(const std::string& features, const ImportOptions& options = {}) {
    test::TemporaryFolder folder;
    folder.write("plan.geojson",
                 R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:32629"}},)"
                 R"("features":[)" +
                     features + "]}");
    return importBuilding((folder / "plan.geojson").string(), options);
}

double levelOf(const Result<ImportedBuilding>& imported, const std::string& id) {
    const Region* region = imported.ok() ? imported->building->region(RegionId(id)) : nullptr;
    return region == nullptr ? -99.0 : region->level;
}

TEST(TableLevels, HeightsTellTheFloors) {
    std::string rooms = roomAt("cellar", 0, -3.1) + "," + roomAt("hall", 0, 0.2) + "," +
                        roomAt("step", 10, 0.6) + "," + roomAt("attic", 0, 3.4);
    auto imported = tables(rooms);
    ASSERT_TRUE(imported.ok()) << imported.error().text();
    EXPECT_EQ(levelOf(imported, "cellar"), -1.0);
    EXPECT_EQ(levelOf(imported, "hall"), 0.0);
    EXPECT_EQ(levelOf(imported, "step"), 0.0) << "a step is no floor";
    EXPECT_EQ(levelOf(imported, "attic"), 1.0);
    ASSERT_EQ(imported->building->levels().size(), 3U);
    EXPECT_NEAR(*imported->building->levels()[2].elevationM, 3.4, 1e-9);
    EXPECT_FALSE(idsOf(*imported, "level-by-height").empty());
}

TEST(TableLevels, AColumnComesBeforeHeightsUnlessHeightsAreAskedFor) {
    std::string rooms = roomAt("a", 0, 0.0, R"(,"level":4)") + "," + roomAt("b", 10, 3.5, R"(,"level":4)");
    auto imported = tables(rooms);
    EXPECT_EQ(levelOf(imported, "a"), 4.0);
    EXPECT_EQ(levelOf(imported, "b"), 4.0);
    ImportOptions byHeight;
    byHeight.levelFrom = "z";
    auto asked = tables(rooms, byHeight);
    EXPECT_EQ(levelOf(asked, "a"), 0.0);
    EXPECT_EQ(levelOf(asked, "b"), 1.0);
    std::string flat =
        R"({"type":"Feature","properties":{"id":"a"},"geometry":{"type":"Polygon","coordinates":)"
        R"([[[500000,4100000],[500005,4100000],[500005,4100005],[500000,4100000]]]}})";
    auto none = tables(flat, byHeight);
    ASSERT_FALSE(none.ok());
    EXPECT_THAT(none.error().text(), HasSubstr("no heights"));
}

TEST(TableLevels, PlacesBeyondTheEarthAreNotTransformed) {
    // Web Mercator with such coordinates would be wrapped round the earth turn by turn.
    auto far = [](const std::string& id, const std::string& x) {
        return R"({"type":"Feature","properties":{"id":")" + id +
               R"(","level":0},"geometry":{"type":"Polygon",)" + R"("coordinates":[[[)" + x + ",0],[" + x +
               ",9],[9,9],[" + x + R"(,0]]]}})";
    };
    test::TemporaryFolder folder;
    folder.write(
        "plan.geojson",
        R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:3857"}},"features":[)" +
            far("far", "1e26") + "," + far("near", "1") + "]}");
    auto imported = importBuilding((folder / "plan.geojson").string());
    ASSERT_TRUE(imported.ok()) << imported.error().text();
    EXPECT_EQ(imported->building->regions().size(), 1U);
    EXPECT_THAT(idsOf(*imported, "coordinates-finite"), Contains("far"));
}

TEST(TableLevels, DirectionsComeInManyWords) {
    auto door = [](const std::string& id, const std::string& word) {
        return R"({"type":"Feature","properties":{"id":")" + id +
               R"(","kind":"door","level":0,"region_a":"a","region_b":"b",)" + R"("oneway":")" + word +
               R"("},"geometry":{"type":"Point","coordinates":[500005,4100002]}})";
    };
    auto imported = tables(roomAt("a", 0, 0, R"(,"level":0)") + "," + roomAt("b", 5, 0, R"(,"level":0)") +
                           "," + door("d1", "yes") + "," + door("d2", "-1") + "," + door("d3", "no") + "," +
                           door("d4", "left"));
    ASSERT_TRUE(imported.ok()) << imported.error().text();
    auto way = [&](const char* id) { return imported->building->access(AccessId(id))->oneWay; };
    EXPECT_EQ(way("d1"), OneWay::AToB);
    EXPECT_EQ(way("d2"), OneWay::BToA);
    EXPECT_EQ(way("d3"), OneWay::No);
    EXPECT_EQ(way("d4"), OneWay::No);
    EXPECT_THAT(idsOf(*imported, "access-direction-unknown"), ::testing::ElementsAre("d4"));
}

} // namespace
