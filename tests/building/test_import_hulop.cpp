#include "core/building/import/hulop_records.h"
#include "core/building/import/importer.h"
#include "tests/building/import_support.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {

using namespace farol;
using namespace farol::building;
using namespace farol::building::testing;

/// A place in metres east and north of one in Lisbon.
std::string at(double x, double y) {
    double lon = -9.2 + x / (111319.49 * std::cos(38.7 * 3.14159265358979 / 180.0)),
           lat = 38.7 + y / 111319.49;
    return "[" + std::to_string(lon) + "," + std::to_string(lat) + "]";
}

std::string feature(const std::string& geometry, const std::string& properties) {
    return R"({"type":"Feature","geometry":)" + geometry + R"(,"properties":{)" + properties + "}}";
}

std::string point(double x, double y) {
    return R"({"type":"Point","coordinates":)" + at(x, y) + "}";
}

std::string node(const std::string& id, double x, double y, int floor) {
    return feature(point(x, y),
                   R"("node_id":")" + id + R"(","floor":)" + std::to_string(floor) + R"(,"link1_id":"x")");
}

std::string link(const std::string& id, const std::string& from, const std::string& to,
                 const std::string& type, const std::string& direction = "1") {
    return feature("null", R"("link_id":")" + id + R"(","start_id":")" + from + R"(","end_id":")" + to +
                               R"(","route_type":")" + type + R"(","direction":")" + direction + "\"");
}

/// Two floors: A - B - C below, D above; a lift from C to D, an escalator from B to E above; a shop at A.
std::string network() {
    return R"({"type":"FeatureCollection","features":[)" + node("A", 0, 0, 1) + "," + node("B", 10, 0, 1) +
           "," + node("C", 20, 0, 1) + "," + node("D", 20, 0, 2) + "," + node("E", 10, 8, 2) + "," +
           link("AB", "A", "B", "1") + "," + link("BC", "B", "C", "1") + "," + link("CD", "C", "D", "4") +
           "," + link("BE", "B", "E", "5", "2") + "," + link("ED", "E", "D", "1") + "," +
           link("lost", "E", "Z", "1") + "," +
           feature(
               point(0, 6),
               R"("facil_id":"F","name_en":"Shop","name_ja":"店","ent1_node":"A","ent1_n":"Front","ent1_d":"1")") +
           "," +
           feature(
               point(5, 1),
               R"("facil_id":"P","hulop_major_category":"_nav_poi_","hulop_sub_category":"_nav_info_","hulop_heading":"90","hulop_angle":"45","hulop_content":"Map on the wall","hulop_height":"1")") +
           "," + feature(point(900, 900), R"("facil_id":"Q","name_en":"Far")") + "," +
           feature(point(3, 3), R"("what":"else")") + "]}";
}

RawMap mapOf(const std::string& text, const ImportOptions& options = {}) {
    auto map = readBytes(*makeHulopImporter(), "map.geojson", text, options);
    EXPECT_TRUE(map.ok()) << (map.ok() ? "" : map.error().text());
    return map.ok() ? std::move(*map) : RawMap();
}

TEST(ImportHulop, NodesBecomeRegionsAndLinksTheWaysBetween) {
    RawMap map = mapOf(network());
    EXPECT_TRUE(map.explicitGraph);
    EXPECT_EQ(map.coordinates, RawCoordinates::Geographic);
    EXPECT_EQ(map.data.regions.size(), 6U);
    EXPECT_EQ(map.data.accesses.size(), 6U);
    const Access* way = accessOf(map, "AB");
    ASSERT_NE(way, nullptr);
    EXPECT_EQ(way->kind, AccessKind::Opening);
    EXPECT_EQ(way->regionA.value, "A");
    EXPECT_EQ(way->regionB.value, "B");
    Point2 middle = way->midpoint();
    for (const char* id : {"A", "B"})
        EXPECT_LT(distanceToPolygon(regionOf(map, id)->polygon, middle), 1e-7)
            << id; // half-way, where both end
    ASSERT_NE(findingOf(map, "hulop-link"), nullptr);
    EXPECT_EQ(findingOf(map, "hulop-link")->ids, std::vector<std::string>{"lost"});
    ASSERT_NE(findingOf(map, "hulop-unknown"), nullptr);
}

TEST(ImportHulop, LiftsAndEscalatorsLeadToOtherFloors) {
    RawMap map = mapOf(network());
    EXPECT_EQ(accessOf(map, "CD")->kind, AccessKind::Elevator);
    EXPECT_FALSE(accessOf(map, "CD")->shaft.empty());
    EXPECT_EQ(regionOf(map, "C")->kind, RegionKind::Elevator);
    EXPECT_EQ(accessOf(map, "BE")->kind, AccessKind::Escalator);
    EXPECT_EQ(accessOf(map, "BE")->oneWay, OneWay::AToB);
}

TEST(ImportHulop, FloorOneIsTheGroundUnlessToldOtherwise) {
    RawMap map = mapOf(network());
    EXPECT_EQ(regionOf(map, "A")->level, 0.0);
    EXPECT_EQ(regionOf(map, "D")->level, 1.0);
    ASSERT_EQ(map.data.levels.size(), 2U);
    EXPECT_EQ(map.data.levels[0].ref, "1");
    EXPECT_NE(findingOf(map, "hulop-floors"), nullptr);
    RawMap told = mapOf(network(), {{}, "", "0", ""});
    EXPECT_EQ(regionOf(told, "A")->level, 1.0);
    EXPECT_EQ(findingOf(told, "hulop-floors"), nullptr);
}

TEST(ImportHulop, AFacilityLiesBehindItsEntrance) {
    RawMap map = mapOf(network());
    const Region* shop = regionOf(map, "F");
    ASSERT_NE(shop, nullptr);
    EXPECT_EQ(shop->name, "Shop");
    EXPECT_EQ(regionOf(mapOf(network(), {{}, "", "", "ja"}), "F")->name, "店");
    const Access* door = accessOf(map, "F/1");
    ASSERT_NE(door, nullptr);
    EXPECT_EQ(door->kind, AccessKind::Door);
    EXPECT_TRUE(door->automatic);
    EXPECT_GT(door->midpoint().y,
              regionOf(map, "A")->polygon.outer.empty() ? 0.0 : 38.7); // north of the node
}

TEST(ImportHulop, PointsOfInterestBecomeLandmarksThatFaceWhoIsTold) {
    RawMap map = mapOf(network());
    ASSERT_EQ(map.data.landmarks.size(), 1U);
    const Landmark& sign = map.data.landmarks.front();
    EXPECT_EQ(sign.kind, Kind::Sign);
    EXPECT_EQ(sign.text, "Map on the wall");
    ASSERT_TRUE(sign.heading.has_value());
    EXPECT_NEAR(std::abs(sign.heading->value), 3.14159, 1e-4); // told to who walks east, so it faces west
    EXPECT_NE(findingOf(map, "hulop-landmark-far"), nullptr);
}

TEST(ImportHulop, ReadsTheBareListOfTheServer) {
    std::string text = network();
    std::size_t start = text.find('[');
    EXPECT_EQ(mapOf(text.substr(start, text.size() - start - 1)).data.regions.size(), 6U);
}

TEST(ImportHulop, ReadsDegreesMinutesSeconds) {
    EXPECT_NEAR(sexagesimalDegrees("35.41.02.450").value_or(0), 35.6840139, 1e-6);
    EXPECT_NEAR(sexagesimalDegrees("-0.00.00.418").value_or(0), -0.000116, 1e-6);
    EXPECT_NEAR(sexagesimalDegrees("139.5").value_or(0), 139.5, 1e-9);
    for (const char* junk : {"", "a.b.c", "1.99.00", "1.-2.00", "1..2", "nan"})
        EXPECT_FALSE(sexagesimalDegrees(junk)) << junk;
}

TEST(ImportHulop, RefusesWhatIsNoNetwork) {
    for (const std::string& text :
         {std::string(), std::string("{}"), std::string("[1,2"), std::string("[]"),
          std::string("[null,{\"properties\":{\"node_id\":\"A\"}}]"), std::string(100000, '['),
          R"({"features":[)" + link("AB", "A", "B", "1") + "]}", network().substr(0, 900)})
        EXPECT_FALSE(readBytes(*makeHulopImporter(), "map.geojson", text).ok()) << text.substr(0, 50);
}

TEST(ImportHulop, ALinkToItselfOrTwiceIsNoWay) {
    std::string text = R"({"features":[)" + node("A", 0, 0, 1) + "," + node("B", 0, 0, 1) + "," +
                       link("AA", "A", "A", "1") + "," + link("AB", "A", "B", "1") + "," +
                       link("AB", "A", "B", "1") + "]}";
    RawMap map = mapOf(text);
    EXPECT_EQ(map.data.accesses.size(), 1U);
    EXPECT_FALSE(map.data.accesses.front().line.empty());
}

TEST(ImportHulop, Sample) {
    std::string folder = realMap("hulop_sample");
    if (folder.empty()) GTEST_SKIP() << "FAROL_DATA has no maps/hulop_sample";
    auto importer = makeHulopImporter();
    auto listing = listingOf({folder + "/MapData-sample.geojson"});
    EXPECT_GT(importer->recognises(listing), 0);
    auto map = importer->read(listing, {{}, "", "", "en"});
    ASSERT_TRUE(map.ok()) << map.error().text();
    // 19 features: 7 nodes, 6 links, 3 facilities, 3 entrances
    EXPECT_EQ(map->data.regions.size(), 10U);
    EXPECT_EQ(map->data.accesses.size(), 9U);
    EXPECT_EQ(map->data.levels.size(), 1U);
    auto named = [&](const std::string& name) {
        return std::any_of(map->data.regions.begin(), map->data.regions.end(),
                           [&](const Region& region) { return region.name == name; });
    };
    EXPECT_TRUE(named("Auditorium"));
    EXPECT_TRUE(named("Sample building"));
    auto toilets = std::count_if(map->data.regions.begin(), map->data.regions.end(),
                                 [](const Region& region) { return region.kind == RegionKind::Toilet; });
    EXPECT_EQ(toilets, 1);
}

} // namespace
