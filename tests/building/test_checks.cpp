// Every fault a map can have, alone in an otherwise sound map: the rule, the feature and what to do are told.
#include "core/building/checks.h"
#include "core/building/import/importer.h"
#include "tests/support/ascii_map.h"

#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <vector>

namespace farol::building {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

BuildingData soundMap() {
    test::AsciiMap map;
    map.floor("+---+---+---+\n|A  /B  /C  |\n|e  |   |   |\n+---+---+---+");
    map.landmark('e', {Kind::Extinguisher});
    return map.data();
}

Ring box(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Region regionOf(const std::string& id, Ring outer, double level = 0.0) {
    Region region;
    region.id = RegionId(id);
    region.name = id;
    region.level = level;
    region.kind = RegionKind::Room;
    region.polygon.outer = std::move(outer);
    return region;
}

Access doorOf(const std::string& id, const std::string& a, const std::string& b, Polyline line) {
    Access access;
    access.id = AccessId(id);
    access.regionA = RegionId(a);
    access.regionB = RegionId(b);
    access.line = std::move(line);
    return access;
}

struct Fault {
    const char* rule;
    const char* id;  ///< one of the features that must be named
    const char* fix; ///< a piece of the advice
    std::function<void(BuildingData&)> make;
};

std::vector<Fault> faultsOfRegions() {
    return {
        {"region-polygon-valid", "B", "draw it again",
         [](BuildingData& d) {
             d.regions[1].polygon.outer = {{4, 0}, {8, 3}, {8, 0}, {4, 3.5}};
         }},
        {"region-polygon-valid", "B", "draw it again",
         [](BuildingData& d) { d.regions[1].polygon.holes = {box(50, 50, 51, 51)}; }},
        {"region-sliver", "thin", "join it",
         [](BuildingData& d) { d.regions.push_back(regionOf("thin", box(20, 0, 30, 0.1))); }},
        {"region-overlap", "D", "draw the border",
         [](BuildingData& d) { d.regions.push_back(regionOf("D", box(10, 0, 18, 3))); }},
        {"region-inside", "D", "cut it out",
         [](BuildingData& d) { d.regions.push_back(regionOf("D", box(1, 1, 2, 2))); }},
        {"region-duplicate", "D", "remove one",
         [](BuildingData& d) { d.regions.push_back(regionOf("D", d.regions[0].polygon.outer)); }},
        {"region-id-unique", "A", "give each its own",
         [](BuildingData& d) { d.regions[1].id = RegionId("A"); }},
        {"region-ref-unique", "B", "correct it",
         [](BuildingData& d) { d.regions[0].ref = d.regions[1].ref = "0.01"; }},
        {"region-named", "C", "", [](BuildingData& d) { d.regions[2].name = d.regions[2].ref = ""; }},
        {"region-name-sayable", "C", "give it the name",
         [](BuildingData& d) { d.regions[2].name = "Input name here"; }},
        {"level-listed", "A", "add it", [](BuildingData& d) { d.levels.clear(); }},
        {"kind-known", "A", "known are",
         [](BuildingData& d) {
             d.regions[0].kind = RegionKind::Other;
             d.regions[0].kindText = "dungeon";
         }},
        {"crs-degrees-for-metres", "", "reproject",
         [](BuildingData& d) {
             for (Region& region : d.regions)
                 for (Point2& p : region.polygon.outer) p = p * 1e-5;
         }},
        {"region-has-access", "D", "add it",
         [](BuildingData& d) { d.regions.push_back(regionOf("D", box(20, 0, 24, 3))); }},
        {"regions-connected", "D", "missing or closed",
         [](BuildingData& d) { d.regions.push_back(regionOf("D", box(20, 0, 24, 3))); }},
        {"region-door-joins-others", "D", "correct region_a",
         [](BuildingData& d) {
             // The door between A and B ends at the corner of D.
             d.regions.push_back(regionOf("D", box(2, 3.0, 6, 6)));
             d.accesses[0].line = {{4, 1}, {4, 3.0}};
         }},
    };
}

std::vector<Fault> faultsOfTheRest() {
    return {
        {"access-joins-two-regions", "A-B", "set region_a",
         [](BuildingData& d) { d.accesses[0].regionB = {}; }},
        {"access-joins-two-regions", "A-B", "set region_a",
         [](BuildingData& d) { d.accesses[0].regionB = d.accesses[0].regionA; }},
        {"access-regions-exist", "A-B", "correct it",
         [](BuildingData& d) { d.accesses[0].regionB = RegionId("gone"); }},
        {"access-touches-regions", "far", "move it",
         [](BuildingData& d) {
             d.accesses.push_back(doorOf("far", "A", "C", {{1, 1}, {1, 2}}));
         }},
        {"access-touches-two-regions", "three", "see that",
         [](BuildingData& d) {
             d.regions.push_back(regionOf("D", box(2, 3.0, 6, 6)));
             d.accesses.push_back(doorOf("three", "A", "B", {{4, 2.5}, {4, 3.0}}));
         }},
        {"access-level-change", "up", "correct its kind",
         [](BuildingData& d) {
             d.levels.push_back({1.0, "", "1", {}, {}, {}});
             d.regions.push_back(regionOf("U", box(0, 0, 4, 3), 1.0));
             d.accesses.push_back(doorOf("up", "A", "U", {{1, 1}}));
         }},
        {"escalator-direction", "up", "set oneway",
         [](BuildingData& d) {
             d.regions.push_back(regionOf("U", box(0, 0, 4, 3), 1.0));
             d.accesses.push_back(doorOf("up", "A", "U", {{1, 1}}));
             d.accesses.back().kind = AccessKind::Escalator;
         }},
        {"shaft-misses-level", "lift", "add it",
         [](BuildingData& d) {
             d.levels.push_back({1.0, "", "1", {}, {}, {}});
             d.levels.push_back({2.0, "", "2", {}, {}, {}});
             d.regions.push_back(regionOf("U", box(0, 0, 4, 3), 2.0));
             d.accesses.push_back(doorOf("up", "A", "U", {{1, 1}}));
             d.accesses.back().kind = AccessKind::Elevator;
             d.accesses.back().shaft = ShaftId("lift");
         }},
        {"access-id-unique", "A-B", "give each its own",
         [](BuildingData& d) { d.accesses[1].id = AccessId("A-B"); }},
        {"landmark-id-unique", "e", "give each its own",
         [](BuildingData& d) { d.landmarks.push_back(d.landmarks[0]); }},
        {"landmark-region-exists", "e", "set region_id", [](BuildingData& d) { d.landmarks[0].region = {}; }},
        {"landmark-inside-region", "e", "move it",
         [](BuildingData& d) {
             d.landmarks[0].position = {11, 1};
         }},
        {"landmark-inside-region", "e", "level", [](BuildingData& d) { d.landmarks[0].level = 3.0; }},
    };
}

TEST(Checks, ASoundMapIsToldNothing) {
    std::vector<std::string> rules;
    for (const Finding& finding : checkBuilding(Building(soundMap()))) rules.push_back(finding.rule);
    EXPECT_THAT(rules, IsEmpty());
}

TEST(Checks, EachFaultIsToldWithItsFeatureAndAFix) {
    std::vector<Fault> faults = faultsOfRegions();
    for (Fault& fault : faultsOfTheRest()) faults.push_back(std::move(fault));
    for (const Fault& fault : faults) {
        BuildingData data = soundMap();
        fault.make(data);
        bool told = false;
        for (const Finding& finding : checkBuilding(Building(data))) {
            if (finding.rule != fault.rule) continue;
            bool named = *fault.id == 0 ||
                         std::find(finding.ids.begin(), finding.ids.end(), fault.id) != finding.ids.end();
            told = told || (named && finding.message.find(fault.fix) != std::string::npos);
        }
        EXPECT_TRUE(told) << fault.rule << " of " << fault.id << ", with \"" << fault.fix << "\"";
    }
}

/// Rules that only an import can tell: what was odd in the source and was mended.
std::vector<Finding> importOf(std::vector<Region> regions, const std::string& crs = "",
                              bool geographic = false, std::vector<Access> accesses = {}) {
    RawMap raw;
    raw.data.regions = std::move(regions);
    raw.data.accesses = std::move(accesses);
    raw.data.crs = crs;
    raw.coordinates = geographic ? RawCoordinates::Geographic : RawCoordinates::Unknown;
    auto imported = finishImport(std::move(raw), MapFormat::GeoJson);
    EXPECT_TRUE(imported.ok()) << (imported.ok() ? "" : imported.error().text());
    return imported.ok() ? imported->findings : std::vector<Finding>();
}

std::vector<std::string> rulesOf(const std::vector<Finding>& findings) {
    std::vector<std::string> rules;
    for (const Finding& finding : findings) rules.push_back(finding.rule);
    return rules;
}

TEST(Checks, ImportsTellWhatTheyMended) {
    Region plain = regionOf("A", box(0, 0, 5, 5));
    EXPECT_THAT(rulesOf(importOf({plain})), Contains("crs-missing"));
    Region bow = regionOf("bow", {{0, 0}, {4, 4}, {4, 0}, {0, 4}});
    auto mended = rulesOf(importOf({bow}, "EPSG:32629"));
    EXPECT_THAT(mended, Contains("region-polygon-valid"));
    EXPECT_THAT(mended, Contains("region-split"));
    EXPECT_THAT(rulesOf(importOf({plain, regionOf("B", box(0, 0, 5, 5))}, "EPSG:32629")),
                Contains("region-duplicate"));
    // North first: only the other way round does it lie on earth.
    Region flipped = regionOf("F", {{37.0, -118.0}, {37.0, -118.1}, {37.1, -118.1}});
    EXPECT_THAT(rulesOf(importOf({flipped}, "EPSG:4326", true)), Contains("axes-flipped"));
    // Degrees that call themselves metres.
    Region degrees = regionOf("D", {{-8.0, 37.0}, {-7.999, 37.0}, {-7.999, 37.001}});
    EXPECT_THAT(rulesOf(importOf({degrees}, "EPSG:32629")), Contains("crs-degrees-for-metres"));
    auto half = importOf({plain}, "EPSG:32629", false, {doorOf("out", "", "", {{5, 1}, {5, 2}})});
    EXPECT_THAT(rulesOf(half), Contains("access-touches-two-regions"));
    for (const Finding& finding : half) EXPECT_FALSE(finding.message.empty()) << finding.rule;
}

} // namespace
} // namespace farol::building
