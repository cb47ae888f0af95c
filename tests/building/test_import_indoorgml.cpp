#include "core/building/import/importer.h"
#include "tests/building/import_support.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace {

using namespace farol;
using namespace farol::building;
using namespace farol::building::testing;

std::string houseText() {
    std::ifstream file(fixture("indoor_house.gml"));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

RawMap mapOf(const std::string& text, const ImportOptions& options = {}) {
    auto map = readBytes(*makeIndoorGmlImporter(), "house.gml", text, options);
    EXPECT_TRUE(map.ok()) << (map.ok() ? "" : map.error().text());
    return map.ok() ? std::move(*map) : RawMap();
}

TEST(ImportIndoorGml, ReadsCellsWithKindsNamesAndStoreys) {
    auto importer = makeIndoorGmlImporter();
    EXPECT_GT(importer->recognises(listingOf({fixture("indoor_house.gml")})), 0);
    RawMap map = mapOf(houseText());
    EXPECT_TRUE(map.explicitGraph);
    EXPECT_EQ(map.coordinates, RawCoordinates::Metric);
    ASSERT_EQ(map.data.regions.size(), 6U); // the door is no region
    EXPECT_EQ(regionOf(map, "C1")->name, "Library");
    EXPECT_EQ(regionOf(map, "C1")->kind, RegionKind::Room);
    EXPECT_EQ(regionOf(map, "C2")->kind, RegionKind::Corridor);
    EXPECT_EQ(regionOf(map, "C3")->kind, RegionKind::Stairwell);
    EXPECT_EQ(regionOf(map, "C6")->kind, RegionKind::Elevator);
    EXPECT_EQ(regionOf(map, "C5")->ref, "1.01");
    EXPECT_EQ(regionOf(map, "C5")->level, 1.0);
    ASSERT_EQ(map.data.levels.size(), 2U);
    EXPECT_EQ(map.data.levels[1].ref, "1");
}

TEST(ImportIndoorGml, TheFootprintIsTheFloorAndNotAThresholdBelowIt) {
    RawMap map = mapOf(houseText());
    EXPECT_NEAR(area(regionOf(map, "C1")->polygon), 30.2, 0.01); // floor 6 x 5 with the threshold of the door
    EXPECT_NEAR(area(regionOf(map, "C2")->polygon), 29.0, 0.01);
}

TEST(ImportIndoorGml, ADoorCellBecomesTheDoorBetweenItsTwoRooms) {
    RawMap map = mapOf(houseText());
    const Access* door = accessOf(map, "D1");
    ASSERT_NE(door, nullptr);
    EXPECT_EQ(door->kind, AccessKind::Door);
    EXPECT_EQ(std::set<std::string>({door->regionA.value, door->regionB.value}),
              (std::set<std::string>{"C1", "C2"}));
    EXPECT_NEAR(door->midpoint().x, 6.1, 0.01);
    EXPECT_EQ(accessOf(map, "T1"), nullptr);
}

TEST(ImportIndoorGml, TransitionsAreReadOnceWithTheirReverses) {
    RawMap map = mapOf(houseText());
    EXPECT_EQ(map.data.accesses.size(), 5U);
    const Access* wide = accessOf(map, "T4");
    ASSERT_NE(wide, nullptr);
    ASSERT_EQ(wide->line.size(), 2U); // from its ConnectionBoundary
    EXPECT_NEAR(length(wide->line), 1.2, 1e-9);
    EXPECT_NEAR(accessOf(map, "T3")->midpoint().x, 12.0, 1e-6);
    EXPECT_EQ(accessOf(map, "T5")->kind, AccessKind::Stairs);
    const Finding* loose = findingOf(map, "indoorgml-transition");
    ASSERT_NE(loose, nullptr);
    EXPECT_EQ(loose->ids, std::vector<std::string>{"T7"});
}

TEST(ImportIndoorGml, LevelsComeFromHeightsWhereAskedOrWhereNothingElseTells) {
    RawMap asked = mapOf(houseText(), {{}, "", "z", ""});
    EXPECT_EQ(regionOf(asked, "C5")->level, 1.0);
    RawMap untold = mapOf(replaced(houseText(), "storey=", "storex="));
    EXPECT_EQ(regionOf(untold, "C5")->level, 1.0);
    EXPECT_EQ(regionOf(untold, "C1")->level, 0.0);
    ASSERT_EQ(untold.data.levels.size(), 2U);
    EXPECT_TRUE(untold.data.levels[1].elevationM.has_value());
    RawMap named = mapOf(replaced(houseText(), "storey=", "etage="), {{}, "", "etage", ""});
    EXPECT_EQ(named.data.levels[1].ref, "1");
}

TEST(ImportIndoorGml, CaseOfElementsDoesNotMatter) {
    std::string text =
        replaced(replaced(houseText(), "Geometry3D", "geometry3d"), "core:State ", "core:STATE ");
    text = replaced(text, "core:State>", "core:STATE>");
    EXPECT_EQ(mapOf(text).data.accesses.size(), 5U);
}

TEST(ImportIndoorGml, GeographicCoordinatesMayHaveLatitudeFirst) {
    std::string named =
        replaced(houseText(), "<gml:Solid>", "<gml:Solid srsName=\"urn:ogc:def:crs:EPSG::4326\">");
    RawMap map = mapOf(named);
    EXPECT_EQ(map.coordinates, RawCoordinates::Geographic);
    EXPECT_NEAR(boundingBox(regionOf(map, "C2")->polygon.outer)->high.y, 12.0, 1e-9);
    EXPECT_FALSE(map.data.crs.empty());
}

TEST(ImportIndoorGml, RefusesWhatIsNoMap) {
    std::string bomb = "<!DOCTYPE x [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;&a;\">]>";
    std::string deep = "<core:IndoorFeatures xmlns:core=\"x\">";
    for (int i = 0; i < 100000; ++i) deep += "<a>";
    std::string house = houseText();
    std::string declared = house;
    declared.insert(declared.find("<core:IndoorFeatures"), bomb);
    auto importer = makeIndoorGmlImporter();
    for (const std::string& text :
         {std::string(), std::string("<x/>"), house.substr(0, house.size() / 2), declared, deep,
          std::string(1000, '\0'), replaced(house, "pos", "pox"), std::string("<IndoorFeatures/>")}) {
        auto map = readBytes(*importer, "broken.gml", text);
        ASSERT_FALSE(map.ok()) << text.substr(0, 80);
        EXPECT_FALSE(map.error().message.empty());
    }
}

TEST(ImportIndoorGml, ACellWithoutNumbersIsLeftOutAndTold) {
    RawMap map = mapOf(replaced(houseText(), "<gml:pos>15 0<", "<gml:pos>nan 0<"));
    EXPECT_EQ(regionOf(map, "C3"), nullptr);
    ASSERT_NE(findingOf(map, "indoorgml-cell"), nullptr);
    for (const Region& region : map.data.regions)
        for (Point2 point : region.polygon.outer) EXPECT_TRUE(isFinite(point));
}

TEST(ImportIndoorGml, ReferencesInACircleDoNotHang) {
    std::string ring = replaced(houseText(), "<gml:Shell>",
                                "<gml:Shell gml:id=\"sh\"><gml:surfaceMember "
                                "xlink:href=\"#sh\"/><gml:surfaceMember xlink:href=\"#house\"/>");
    EXPECT_FALSE(mapOf(ring).data.regions.empty());
}

TEST(ImportIndoorGml, FjkHouse) {
    std::string folder = realMap("indoorgml_fjk");
    if (folder.empty()) GTEST_SKIP() << "FAROL_DATA has no maps/indoorgml_fjk";
    auto listing = listingOf({folder + "/FJK-Haus_IndoorGML_withEXR-corrected_1_0_3.gml"});
    auto map = makeIndoorGmlImporter()->read(listing, {});
    ASSERT_TRUE(map.ok()) << map.error().text();
    EXPECT_EQ(map->data.regions.size(), 14U);
    EXPECT_EQ(map->data.levels.size(), 3U);
    EXPECT_EQ(map->data.levels.front().ordinal, -1.0);
    EXPECT_EQ(map->data.accesses.size(), 15U); // 30 transitions, each written both ways
    std::set<std::string> reached;
    int stairs = 0;
    for (const Access& access : map->data.accesses) {
        reached.insert({access.regionA.value, access.regionB.value});
        stairs += access.kind == AccessKind::Stairs ? 1 : 0;
    }
    EXPECT_EQ(reached.size(), 14U);
    EXPECT_EQ(stairs, 2);
    EXPECT_GT(area(regionOf(*map, "C12")->polygon), 5.0); // its lowest face is only the notch of the stairs
}

} // namespace
