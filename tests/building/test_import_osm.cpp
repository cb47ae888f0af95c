#include "core/building/import/importer.h"
#include "tests/building/import_support.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace {

using namespace farol;
using namespace farol::building;
using namespace farol::building::testing;

RawMap house(const ImportOptions& options = {}) {
    auto importer = makeOsmImporter();
    auto listing = listingOf({fixture("sit_house.osm")});
    EXPECT_GT(importer->recognises(listing), 0);
    auto map = importer->read(listing, options);
    EXPECT_TRUE(map.ok()) << (map.ok() ? "" : map.error().text());
    return map.ok() ? std::move(*map) : RawMap();
}

TEST(ImportOsm, ReadsRoomsWithTheirNamesKindsAndLevels) {
    RawMap map = house();
    EXPECT_EQ(map.coordinates, RawCoordinates::Geographic);
    EXPECT_TRUE(map.openBoundaries);
    EXPECT_FALSE(map.explicitGraph);
    const Region* library = regionOf(map, "way/11");
    ASSERT_NE(library, nullptr);
    EXPECT_EQ(library->name, "Biblioteca");
    EXPECT_EQ(library->ref, "0.01");
    EXPECT_EQ(library->kind, RegionKind::Room);
    EXPECT_EQ(library->level, 0.0);
    EXPECT_EQ(library->polygon.outer.size(), 5U);
    EXPECT_NEAR(library->polygon.outer.front().x, -7.97, 0.001);
    EXPECT_EQ(regionOf(house({{}, "", "", "en"}), "way/11")->name, "Library");
    EXPECT_EQ(regionOf(map, "way/13")->kind, RegionKind::Toilet);
    EXPECT_EQ(regionOf(map, "way/10")->kind, RegionKind::Corridor);
}

TEST(ImportOsm, RepeatsARegionOnEachOfItsLevels) {
    RawMap map = house();
    ASSERT_NE(regionOf(map, "way/12@0"), nullptr);
    ASSERT_NE(regionOf(map, "way/12@1"), nullptr);
    EXPECT_EQ(regionOf(map, "way/12@1")->level, 1.0);
    EXPECT_TRUE(regionOf(map, "way/12@0")->restricted);
    EXPECT_EQ(regionOf(map, "way/12"), nullptr);
}

TEST(ImportOsm, NamesTheLevelsAsPeopleDo) {
    RawMap map = house();
    ASSERT_EQ(map.data.levels.size(), 3U);
    EXPECT_EQ(map.data.levels[0].ordinal, -1.0);
    EXPECT_EQ(map.data.levels[1].ref, "EG");
    EXPECT_EQ(map.data.levels[2].ref, "1.OG");
}

TEST(ImportOsm, DoorsJoinTheTwoOutlinesTheyStandOn) {
    RawMap map = house();
    std::set<std::set<std::string>> joined;
    for (const Access& access : map.data.accesses)
        if (access.kind == AccessKind::Door) joined.insert({access.regionA.value, access.regionB.value});
    EXPECT_TRUE(joined.count({"way/10", "way/11"}));
    EXPECT_TRUE(joined.count({"way/10", "way/13"}));
    EXPECT_TRUE(joined.count({"way/10", "way/12@0"})); // without a level of its own
    auto sliding = std::find_if(map.data.accesses.begin(), map.data.accesses.end(),
                                [](const Access& access) { return access.doorType == "sliding"; });
    ASSERT_NE(sliding, map.data.accesses.end());
    EXPECT_TRUE(sliding->automatic);
    EXPECT_EQ(sliding->line.size(), 2U);
}

TEST(ImportOsm, EmergencyExitsAreNoWay) {
    RawMap map = house();
    auto closed = std::count_if(map.data.accesses.begin(), map.data.accesses.end(),
                                [](const Access& a) { return a.closed; });
    EXPECT_EQ(closed, 1);
}

/// The region that the opening at this end of the steps leads to.
std::string endOf(const RawMap& map, const std::string& half) {
    const Access* opening = accessOf(map, half + "/end");
    return opening == nullptr ? "none" : opening->regionA.value;
}

TEST(ImportOsm, StepsLeadFromTheLowerToTheUpperLevel) {
    RawMap map = house();
    const Access* steps = accessOf(map, "way/21");
    ASSERT_NE(steps, nullptr);
    EXPECT_EQ(steps->kind, AccessKind::Stairs);
    EXPECT_EQ(steps->regionA.value, "way/21@0");
    EXPECT_EQ(steps->regionB.value, "way/21@1");
    EXPECT_EQ(steps->level, 0.0);
    EXPECT_EQ(steps->steps, 18);
    EXPECT_EQ(steps->oneWay, OneWay::No);
    EXPECT_EQ(regionOf(map, "way/21@0")->kind, RegionKind::Stairwell);
    EXPECT_EQ(endOf(map, "way/21@0"), "way/10");
    EXPECT_EQ(endOf(map, "way/21@1"), "way/20");
    for (const RegionId& half : {steps->regionA, steps->regionB})
        EXPECT_LT(distanceToPolygon(regionOf(map, half.value)->polygon, steps->midpoint()), 1e-7);
}

TEST(ImportOsm, AnEscalatorRunsOneWay) {
    RawMap map = house();
    const Access* escalator = accessOf(map, "way/22");
    ASSERT_NE(escalator, nullptr);
    EXPECT_EQ(escalator->kind, AccessKind::Escalator);
    EXPECT_EQ(escalator->oneWay, OneWay::BToA); // drawn upwards, runs down
    EXPECT_EQ(escalator->regionA.value, "way/22@0");
    const Access* drawnDownwards = accessOf(map, "way/24");
    ASSERT_NE(drawnDownwards, nullptr);
    EXPECT_EQ(drawnDownwards->regionA.value, "way/24@0");
    EXPECT_EQ(drawnDownwards->oneWay, OneWay::BToA); // forward along a way that falls: down
}

TEST(ImportOsm, ALiftIsAShaftThroughItsLevels) {
    RawMap map = house();
    std::vector<RawMap::VerticalLink> lifts;
    for (const auto& link : map.verticalLinks)
        if (link.kind == AccessKind::Elevator) lifts.push_back(link);
    ASSERT_EQ(lifts.size(), 2U);
    EXPECT_EQ(lifts[0].shaft, lifts[1].shaft);
    EXPECT_EQ(lifts[0].to, lifts[1].from);
    for (const auto& link : lifts) {
        ASSERT_NE(regionOf(map, link.from.value), nullptr);
        EXPECT_EQ(regionOf(map, link.from.value)->ref, "L1");
    }
    auto entered = std::count_if(map.data.accesses.begin(), map.data.accesses.end(),
                                 [](const Access& a) { return a.id.value.rfind("door/node/", 0) == 0; });
    EXPECT_EQ(entered, 3);
    EXPECT_NE(findingOf(map, "osm-lift-door"), nullptr);
}

TEST(ImportOsm, AWayOutsideTheAreasBecomesACorridorThatEntersRooms) {
    RawMap map = house();
    const Region* strip = regionOf(map, "corridor@0#1");
    ASSERT_NE(strip, nullptr);
    EXPECT_EQ(strip->kind, RegionKind::Corridor);
    auto opening = std::find_if(map.data.accesses.begin(), map.data.accesses.end(), [](const Access& access) {
        return access.regionA.value == "way/31" && access.regionB.value == "corridor@0#1";
    });
    ASSERT_NE(opening, map.data.accesses.end());
    EXPECT_EQ(opening->kind, AccessKind::Opening);
}

TEST(ImportOsm, LandmarksNeedALevel) {
    RawMap map = house();
    ASSERT_EQ(map.data.landmarks.size(), 2U);
    EXPECT_EQ(map.data.landmarks[0].region.value, "way/10");
    const Finding* left = findingOf(map, "osm-landmark-level");
    ASSERT_NE(left, nullptr);
    EXPECT_EQ(left->ids.size(), 1U);
}

TEST(ImportOsm, ThePackedFormSaysTheSame) {
    auto importer = makeOsmImporter();
    auto listing = listingOf({fixture("sit_house.osm.pbf")});
    EXPECT_GT(importer->recognises(listing), 0);
    auto packed = importer->read(listing, {});
    ASSERT_TRUE(packed.ok()) << packed.error().text();
    RawMap map = house();
    ASSERT_EQ(packed->data.regions.size(), map.data.regions.size());
    for (std::size_t i = 0; i < map.data.regions.size(); ++i) {
        EXPECT_EQ(packed->data.regions[i].id, map.data.regions[i].id);
        EXPECT_EQ(packed->data.regions[i].name, map.data.regions[i].name);
    }
    EXPECT_EQ(packed->data.accesses.size(), map.data.accesses.size());
    EXPECT_EQ(packed->data.landmarks.size(), map.data.landmarks.size());
}

std::string collection(const std::string& features) {
    return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

std::string room(const std::string& level,
                 const std::string& ring = "[[7,50],[7.001,50],[7.001,50.001],[7,50]]") {
    return R"({"type":"Feature","properties":{"@id":"way/1","indoor":"room","level":")" + level +
           R"("},"geometry":{"type":"Polygon","coordinates":[)" + ring + "]}}";
}

TEST(ImportOsm, ReadsTheGeoJsonMadeOfIt) {
    auto importer = makeOsmImporter();
    auto map = readBytes(*importer, "map.geojson", collection(room("0,5")));
    ASSERT_TRUE(map.ok()) << map.error().text();
    ASSERT_EQ(map->data.regions.size(), 1U);
    EXPECT_EQ(map->data.regions[0].level, 0.5);
    EXPECT_EQ(map->data.regions[0].id.value, "way/1");
}

TEST(ImportOsm, UnreadableLevelsAreTold) {
    auto importer = makeOsmImporter();
    for (const char* level : {"EG", "", "0-99999"}) {
        auto map = readBytes(*importer, "map.geojson", collection(room(level)));
        ASSERT_TRUE(map.ok());
        EXPECT_EQ(map->data.regions.size(), 1U);
        EXPECT_NE(findingOf(*map, "osm-level-missing"), nullptr) << level;
    }
}

TEST(ImportOsm, AGeometryWithoutATypeIsLeftOutAndTold) {
    std::string untyped =
        R"({"type":"Feature","properties":{"@id":"way/9","indoor":"room"},"geometry":{"coordinates":[]}})";
    auto map = readBytes(*makeOsmImporter(), "map.geojson", collection(room("0") + "," + untyped));
    ASSERT_TRUE(map.ok());
    ASSERT_NE(findingOf(*map, "source-geometry"), nullptr);
    EXPECT_EQ(findingOf(*map, "source-geometry")->ids, std::vector<std::string>{"way/9"});
}

TEST(ImportOsm, RefusesWhatIsNoMap) {
    auto importer = makeOsmImporter();
    std::string deep(100000, '[');
    std::string rooms = room("0-999");
    for (int i = 2; i < 30; ++i) {
        std::string next = room("0-999");
        rooms += "," + next.replace(next.find("way/1"), 5, "way/" + std::to_string(i));
    }
    for (const std::string& bytes :
         {std::string(), std::string("<osm version=\"0.6\"><node id="), std::string("{"), deep,
          "{\"features\":" + deep, collection(""), collection("1,null,[]"), collection(room("0", "[[7,50]]")),
          collection(room("0", "[[1e999,50],[7,50],[8,50]]")),
          collection(room("0", "[[700,50],[7,50],[8,50],[700,50]]")), std::string(5000, '\0'),
          collection(rooms)}) {
        auto map = readBytes(*importer, "broken.osm", bytes);
        EXPECT_FALSE(map.ok()) << bytes.substr(0, 60);
    }
}

TEST(ImportOsm, RefusesWaysThatCrossEverything) {
    std::string features;
    for (int i = 0; i < 3000; ++i) {
        std::string id = std::to_string(i);
        std::string
            one = room("0"),
            way =
                R"({"type":"Feature","properties":{"@id":"way/w)" + id +
                R"(","highway":"corridor","level":"0"},"geometry":{"type":"LineString","coordinates":[[7,50.0001],[7.001,50.0002]]}})";
        features += (i == 0 ? "" : ",") + one.replace(one.find("way/1"), 5, "way/" + id) + "," + way;
    }
    EXPECT_FALSE(readBytes(*makeOsmImporter(), "map.geojson", collection(features)).ok());
}

TEST(ImportOsm, RefusesABillionLaughs) {
    std::string bomb = "<?xml version=\"1.0\"?><!DOCTYPE osm [<!ENTITY a \"ha\">";
    for (char c = 'b'; c < 'k'; ++c) {
        bomb += std::string("<!ENTITY ") + c + " \"";
        for (int i = 0; i < 10; ++i) bomb += std::string("&") + static_cast<char>(c - 1) + ";";
        bomb += "\">";
    }
    bomb +=
        "]><osm version=\"0.6\"><node id=\"1\" lat=\"1\" lon=\"1\"><tag k=\"name\" v=\"&j;\"/></node></osm>";
    EXPECT_FALSE(readBytes(*makeOsmImporter(), "bomb.osm", bomb).ok());
}

class RealOsm : public ::testing::TestWithParam<const char*> {};

TEST_P(RealOsm, BerlinMainStation) {
    std::string folder = realMap("berlin_hbf_osm_sit");
    if (folder.empty()) GTEST_SKIP() << "FAROL_DATA has no maps/berlin_hbf_osm_sit";
    auto importer = makeOsmImporter();
    auto listing = listingOf({folder + "/" + GetParam()});
    EXPECT_GT(importer->recognises(listing), 0);
    auto map = importer->read(listing, {});
    ASSERT_TRUE(map.ok()) << map.error().text();
    std::set<std::string> rooms, flights, escalators, shafts;
    std::set<double> levels;
    auto source = [](const std::string& id) { return id.substr(0, id.find_first_of("@#")); };
    for (const Region& region : map->data.regions) {
        levels.insert(region.level);
        auto indoor = region.extra.find("indoor");
        if (indoor != region.extra.end() && indoor->second == AttributeValue("room"))
            rooms.insert(source(region.id.value));
    }
    for (const Access& access : map->data.accesses) {
        if (access.kind == AccessKind::Stairs) flights.insert(source(access.id.value));
        if (access.kind == AccessKind::Escalator) escalators.insert(source(access.id.value));
    }
    for (const auto& link : map->verticalLinks)
        if (link.kind == AccessKind::Elevator) shafts.insert(link.shaft.value);
    std::size_t joined = 0;
    for (const Access& access : map->data.accesses)
        joined += !access.regionA.empty() && !access.regionB.empty() ? 1U : 0U;
    RecordProperty("regions", static_cast<int>(map->data.regions.size()));
    RecordProperty("accesses", static_cast<int>(map->data.accesses.size()));
    RecordProperty("joined", static_cast<int>(joined));
    EXPECT_EQ(rooms.size(), 74U);
    EXPECT_EQ(escalators.size(), 53U); // 52 run one way, one is reversible
    EXPECT_EQ(flights.size() + escalators.size(), 80U);
    EXPECT_GE(shafts.size(), 15U);
    EXPECT_EQ(levels.count(-3) + levels.count(2), 2U);
}

INSTANTIATE_TEST_SUITE_P(Both, RealOsm, ::testing::Values("berlin_hbf.osm", "berlin_hbf.geojson"));

} // namespace
