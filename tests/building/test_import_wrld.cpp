#include "core/building/import/importer.h"
#include "tests/building/import_support.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>

namespace {

using namespace farol;
using namespace farol::building;
using namespace farol::building::testing;

SourceListing houseListing() {
    return listingOf({fixture("wrld_house/ground.geojson"), fixture("wrld_house/low.geojson"),
                      fixture("wrld_house/main.json")});
}

RawMap house() {
    auto map = makeWrldImporter()->read(houseListing(), {});
    EXPECT_TRUE(map.ok()) << (map.ok() ? "" : map.error().text());
    return map.ok() ? std::move(*map) : RawMap();
}

std::vector<std::string> spacesOf(const RawMap& map, double level) {
    std::vector<std::string> ids;
    for (const Region& region : map.data.regions)
        if (region.level == level && region.id.value.find("space-") != std::string::npos)
            ids.push_back(region.id.value);
    return ids;
}

TEST(ImportWrld, IsKnownByItsMainFile) {
    EXPECT_GT(makeWrldImporter()->recognises(houseListing()), 0);
    EXPECT_EQ(makeWrldImporter()->recognises(listingOf({fixture("wrld_house/low.geojson")})), 0);
}

TEST(ImportWrld, LevelsCountFromTheGroundFloor) {
    RawMap map = house();
    ASSERT_EQ(map.data.levels.size(), 2U);
    EXPECT_EQ(map.data.levels[0].ordinal, -1.0);
    EXPECT_EQ(map.data.levels[0].ref, "B");
    EXPECT_EQ(map.data.levels[1].ordinal, 0.0);
    EXPECT_EQ(map.data.levels[1].name, "Ground Floor");
    EXPECT_EQ(map.data.title, "House");
}

TEST(ImportWrld, RoomsAreClosedFromWallsAndDoorsOverSmallGaps) {
    RawMap map = house();
    EXPECT_EQ(spacesOf(map, -1.0).size(), 3U);
    EXPECT_EQ(spacesOf(map, 0.0).size(), 2U); // the third is drawn: "Archive"
    EXPECT_EQ(regionOf(map, "G/220")->name, "Archive");
    EXPECT_EQ(regionOf(map, "G/220")->kind, RegionKind::Room);
}

TEST(ImportWrld, DoorsJoinTheSpacesOnTheirSides) {
    RawMap map = house();
    const Access* door = accessOf(map, "G/203");
    ASSERT_NE(door, nullptr);
    EXPECT_TRUE(door->regionA.value == "G/220" || door->regionB.value == "G/220");
    EXPECT_FALSE(door->regionA.empty() || door->regionB.empty());
    EXPECT_NEAR(door->widthM.value_or(0.0), 1.0, 0.02);
    const Access* outer = accessOf(map, "B/121");
    ASSERT_NE(outer, nullptr);
    EXPECT_NE(outer->regionA.empty(), outer->regionB.empty());
    const Finding* half = findingOf(map, "wrld-door-one-side");
    ASSERT_NE(half, nullptr);
    EXPECT_EQ(half->ids, std::vector<std::string>{"B/121"});
    EXPECT_EQ(accessOf(map, "B/120")->kind, AccessKind::Window);
}

TEST(ImportWrld, StairsAndLiftsStandAboveEachOther) {
    RawMap map = house();
    std::set<std::pair<std::string, std::string>> links;
    for (const auto& link : map.verticalLinks) links.insert({link.from.value, link.to.value});
    EXPECT_EQ(links, (std::set<std::pair<std::string, std::string>>{{"B/108", "G/208"}, {"B/109", "G/209"}}));
}

std::string fileText(const std::string& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(ImportWrld, AMissingOrBrokenFloorIsAnError) {
    auto missing = makeWrldImporter()->read(
        listingOf({fixture("wrld_house/main.json"), fixture("wrld_house/low.geojson")}), {});
    ASSERT_FALSE(missing.ok());
    EXPECT_NE(missing.error().message.find("ground.geojson"), std::string::npos);
    std::string main = fileText(fixture("wrld_house/main.json"));
    for (const std::string& bytes :
         {std::string(), main.substr(0, 200), std::string("[]"), std::string("{\"levels\":[]}"),
          std::string("{\"levels\":[1]}"), std::string("{\"levels\":[{\"z_order\":1e99}]}"),
          std::string(200000, '[')})
        EXPECT_FALSE(readBytes(*makeWrldImporter(), "main.json", bytes).ok()) << bytes.substr(0, 40);
}

TEST(ImportWrld, WestportHouse) {
    std::string folder = realMap("westport_house_wrld/westport-house");
    if (folder.empty()) GTEST_SKIP() << "FAROL_DATA has no maps/westport_house_wrld";
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    auto map = makeWrldImporter()->read(listingOf(paths), {});
    ASSERT_TRUE(map.ok()) << map.error().text();
    std::map<RegionKind, int> kinds;
    for (const Region& region : map->data.regions) ++kinds[region.kind];
    int doors = 0, joined = 0;
    for (const Access& access : map->data.accesses) {
        if (access.kind != AccessKind::Door) continue;
        ++doors;
        joined += !access.regionA.empty() && !access.regionB.empty() ? 1 : 0;
    }
    EXPECT_EQ(map->data.levels.size(), 7U);
    EXPECT_EQ(map->data.levels.front().ref, "G");
    EXPECT_EQ(map->data.levels.front().ordinal, 0.0);
    EXPECT_EQ(doors, 333);
    EXPECT_EQ(joined, 325); // the other 8 lead outside, all on the ground floor
    EXPECT_EQ(map->data.regions.size(), 373U);
    EXPECT_EQ(kinds[RegionKind::Elevator], 18);
    EXPECT_EQ(kinds[RegionKind::Stairwell], 28);
    EXPECT_EQ(map->verticalLinks.size(), 29U);
}

} // namespace
