#include "core/building/geopackage.h"
#include "core/building/import/importer.h"
#include "tests/building/import_support.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace farol;
using namespace farol::building;
using namespace farol::building::testing;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::SizeIs;

const Finding* findingOf(const ImportedBuilding& imported, const std::string& rule) {
    for (const Finding& finding : imported.findings)
        if (finding.rule == rule) return &finding;
    return nullptr;
}

std::size_t countOf(const ImportedBuilding& imported, const std::string& rule) {
    std::size_t count = 0;
    for (const Finding& finding : imported.findings) count += finding.rule == rule ? 1U : 0U;
    return count;
}

std::string collection(const std::string& features) {
    return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

std::string square(double x, const std::string& properties, double size = 0.0001) {
    auto corner = [](double a, double b) { return "[" + std::to_string(a) + "," + std::to_string(b) + "]"; };
    std::string first = corner(x, 37.0);
    return R"({"type":"Feature","properties":{)" + properties +
           R"(},"geometry":{"type":"Polygon","coordinates":[[)" + first + "," + corner(x + size, 37.0) + "," +
           corner(x + size, 37.0001) + "," + corner(x, 37.0001) + "," + first + "]]}}";
}

std::string line(double x, double from, double to, const std::string& properties) {
    return R"({"type":"Feature","properties":{)" + properties +
           R"(},"geometry":{"type":"LineString","coordinates":[[)" + std::to_string(x) + "," +
           std::to_string(from) + "],[" + std::to_string(x) + "," + std::to_string(to) + "]]}}";
}

std::string point(double x, double y, const std::string& properties) {
    return R"({"type":"Feature","properties":{)" + properties +
           R"(},"geometry":{"type":"Point","coordinates":[)" + std::to_string(x) + "," + std::to_string(y) +
           "]}}";
}

Result<ImportedBuilding> floorsOfThePaper(const test::TemporaryFolder& folder,
                                          const ImportOptions& options = {}) {
    folder.write("MapA.geojson",
                 collection(square(-8.0, R"("EspacoID":"1","Nome":"Secretaria","Tipo":"sala")") + "," +
                            square(-7.9999, R"("EspacoID":"2","Nome":"","Tipo":"corredor")") + "," +
                            line(-7.9999, 37.00002, 37.00003, R"("Tipo":"porta")") + "," +
                            line(-7.9999, 37.00006, 37.00007, R"("Tipo":"janela")") + "," +
                            line(-7.9998, 37.0, 37.0001, R"("Tipo":"parede")") + "," +
                            point(-7.99985, 37.00005, R"("EspacoID":"2","Tipo":"extintor")")));
    folder.write("MapB.geojson",
                 collection(square(-8.0, R"("EspacoID":"1","Nome":"Sala 2.1","Tipo":"sala")")));
    return importBuilding(folder.string(), options);
}

TEST(ImportTables, FloorsAsInThePaper) {
    test::TemporaryFolder folder;
    auto imported = floorsOfThePaper(folder);
    ASSERT_TRUE(imported.ok()) << imported.error().text();
    const Building& building = *imported->building;
    EXPECT_THAT(building.levels(), SizeIs(2)) << "MapA is the first floor of the building, MapB the next";
    ASSERT_THAT(building.regions(), SizeIs(3));
    ASSERT_NE(building.region(RegionId("1@0")), nullptr) << "room 1 of each floor is a room of its own";
    EXPECT_EQ(building.region(RegionId("1@1"))->name, "Sala 2.1");
    EXPECT_EQ(building.region(RegionId("2"))->kind, RegionKind::Corridor);
    EXPECT_EQ(building.region(RegionId("2"))->name, "Corridor 1");
    ASSERT_THAT(building.accesses(), SizeIs(2));
    for (const Access& access : building.accesses()) {
        EXPECT_FALSE(access.regionA.empty() || access.regionB.empty()) << access.id.value;
        EXPECT_EQ(access.passable(), access.kind == AccessKind::Door) << "a window is seen through";
    }
    ASSERT_THAT(building.landmarks(), SizeIs(1));
    EXPECT_EQ(building.landmarks()[0].kind, Kind::Extinguisher);
    EXPECT_EQ(building.landmarks()[0].region, RegionId("2")) << "by EspacoID";
    EXPECT_THAT(building.data().walls, SizeIs(1));
    EXPECT_EQ(std::get<std::string>(building.region(RegionId("2"))->extra.at("Tipo")), "corredor")
        << "nothing is lost";
}

TEST(ImportTables, AProfileNamesOtherColumns) {
    test::TemporaryFolder folder, profile;
    folder.write("plan.geojson",
                 collection(square(-8.0, R"("NR":"17","BEZ":"Labor","ART":"X1","COTA":"CAVE")") + "," +
                            square(-7.9999, R"("NR":"18","BEZ":"Gang","ART":"X2","COTA":"CAVE")")));
    profile.write("p.json", R"({"columns":{"id":["NR"],"name":["BEZ"],"kind":["ART"],"level":["COTA"]},
                                "codes":{"X1":"room","X2":"corridor"},"levels":{"CAVE":-1}})");
    ImportOptions options;
    options.profile = (profile / "p.json").string();
    auto imported = importBuilding(folder.string(), options);
    ASSERT_TRUE(imported.ok()) << imported.error().text();
    ASSERT_THAT(imported->building->regions(), SizeIs(2));
    EXPECT_EQ(imported->building->regions()[1].name, "Gang");
    EXPECT_EQ(imported->building->regions()[1].kind, RegionKind::Corridor);
    EXPECT_EQ(imported->building->regions()[1].level, -1.0);
    profile.write("p.json", R"({"columns":{"colour":["ROT"]}})");
    EXPECT_THAT(importBuilding(folder.string(), options).error().text(), HasSubstr("colour"));
    profile.write("p.json", "[1, 2");
    EXPECT_FALSE(importBuilding(folder.string(), options).ok());
}

TEST(ImportTables, DamagedFilesAreErrorsAndNeverHalves) {
    test::TemporaryFolder whole, folder;
    ASSERT_TRUE(floorsOfThePaper(whole).ok());
    SourceListing listing = *listSource((whole / "MapA.geojson").string());
    std::string bytes = *listing.content(listing.members[0]);
    for (std::size_t size = 0; size < bytes.size(); size += 37) {
        folder.write("MapA.geojson", bytes.substr(0, size));
        auto imported = importBuilding((folder / "MapA.geojson").string());
        ASSERT_FALSE(imported.ok()) << "cut at " << size;
        EXPECT_FALSE(imported.error().message.empty());
    }
    for (const char* bad :
         {"", "\xff\xfe", "{}", R"({"type":"FeatureCollection","features":[]})", R"({"type":"Feature"})"}) {
        folder.write("MapA.geojson", bad);
        EXPECT_FALSE(importBuilding((folder / "MapA.geojson").string()).ok()) << bad;
    }
}

TEST(ImportTables, AnImportSurvivesTheBuildingFile) {
    test::TemporaryFolder folder, out;
    auto imported = floorsOfThePaper(folder);
    ASSERT_TRUE(imported.ok());
    ASSERT_TRUE(saveBuilding(*imported->building, (out / "b.gpkg").string()).ok());
    auto again = loadBuilding((out / "b.gpkg").string());
    ASSERT_TRUE(again.ok()) << again.error().text();
    ASSERT_EQ(again->building->regions().size(), imported->building->regions().size());
    for (std::size_t i = 0; i < again->building->regions().size(); ++i) {
        const Region &before = imported->building->regions()[i], &after = again->building->regions()[i];
        EXPECT_EQ(after.id, before.id);
        EXPECT_EQ(after.name, before.name);
        EXPECT_EQ(after.extra.count("Tipo"), 1U);
        EXPECT_NEAR(area(after.polygon), area(before.polygon), 1e-6);
    }
    EXPECT_EQ(again->building->accesses().size(), imported->building->accesses().size());
}

TEST(ImportTables, EdgeCasesOfShapefiles) {
    std::string root = realMap("shp_edge_cases_synthetic");
    if (root.empty()) GTEST_SKIP() << "FAROL_DATA has no folder maps/shp_edge_cases_synthetic";
    for (const auto& [name, rule] :
         std::vector<std::pair<std::string, std::string>>{{"duplicate_geometry", "region-duplicate"},
                                                          {"flipped_coordinates", "axes-flipped"},
                                                          {"invalid_geometry", "region-polygon-valid"},
                                                          {"multipolygon_units", "region-split"},
                                                          {"no_prj_file", "crs-missing"},
                                                          {"overlapping_units", "region-overlap"},
                                                          {"sliver_polygons", "region-sliver"}}) {
        auto imported = importBuilding(root + "/edge_cases/" + name + ".shp");
        ASSERT_TRUE(imported.ok()) << name << ": " << imported.error().text();
        EXPECT_NE(findingOf(*imported, rule), nullptr) << name;
    }
    for (const auto& [name, rule] :
         std::vector<std::pair<std::string, std::string>>{{"detached_opening", "access-joins-two-regions"},
                                                          {"empty_file", "layer-empty"},
                                                          {"mixed_geometry", "layer-role"}}) {
        auto imported = importBuilding(root + "/edge_cases/" + name + ".shp");
        ASSERT_FALSE(imported.ok()) << name;
        EXPECT_THAT(imported.error().text(), HasSubstr(rule));
    }
    auto station = importBuilding(root + "/tokyo_station");
    ASSERT_TRUE(station.ok()) << station.error().text();
    EXPECT_THAT(station->building->regions(), SizeIs(3));
    EXPECT_THAT(station->building->levels(), SizeIs(2)) << "B1 and GF in the names of the files";
    EXPECT_NE(findingOf(*station, "access-drawn-across"), nullptr);
}

TEST(ImportImdf, LabelsDoorsAndWalls) {
    test::TemporaryFolder folder;
    std::string door =
        R"({"type":"Feature","id":"d","feature_type":"opening","properties":{"category":"pedestrian","level_id":"l",)"
        R"("door":{"type":"sliding","automatic":true}},"geometry":{"type":"LineString","coordinates":)"
        R"([[-7.9999,37.00002],[-7.9999,37.00003]]}})";
    auto unit = [](const char* id, double x, const char* category, const char* name) {
        std::string text =
            square(x, std::string(R"("level_id":"l","category":")") + category + R"(","name":)" + name);
        return R"({"id":")" + std::string(id) + R"(","feature_type":"unit",)" + text.substr(1);
    };
    folder.write(
        "level.geojson",
        collection(R"({"type":"Feature","id":"l","feature_type":"level","geometry":null,"properties":)"
                   R"({"ordinal":2,"name":{"en":"Second"},"short_name":{"en":"2"}}})"));
    folder.write("unit.geojson", collection(unit("a", -8.0, "office", R"({"en":"Office","pt":"Gabinete"})") +
                                            "," + unit("b", -7.9999, "walkway", "null") + "," +
                                            unit("c", -7.9998, "column", "null") + "," +
                                            unit("e", -7.9997, "nonpublic", "null")));
    folder.write("opening.geojson", collection(door));
    ImportOptions options;
    options.language = "pt";
    auto imported = importBuilding(folder.string(), options);
    ASSERT_TRUE(imported.ok()) << imported.error().text();
    EXPECT_EQ(imported->format, MapFormat::Imdf);
    const Building& building = *imported->building;
    ASSERT_THAT(building.regions(), SizeIs(3)) << "a column is no region";
    EXPECT_THAT(building.data().walls, SizeIs(1));
    EXPECT_EQ(building.region(RegionId("a"))->name, "Gabinete");
    EXPECT_EQ(building.region(RegionId("b"))->name, "Corridor 1");
    EXPECT_TRUE(building.region(RegionId("e"))->restricted);
    EXPECT_EQ(building.levels()[0].ref, "2");
    const Access* access = building.access(AccessId("d"));
    ASSERT_NE(access, nullptr);
    EXPECT_TRUE(access->automatic);
    EXPECT_EQ(access->doorType, "sliding");
    EXPECT_FALSE(access->regionA.empty() || access->regionB.empty());
}

TEST(ImportImdf, Addenbrookes) {
    std::string root = realMap("cambridge_imdf");
    if (root.empty()) GTEST_SKIP() << "FAROL_DATA has no folder maps/cambridge_imdf";
    auto imported = importBuilding(root + "/Addenbrookes_Final_IMDF");
    ASSERT_TRUE(imported.ok()) << imported.error().text();
    EXPECT_THAT(imported->building->regions(), SizeIs(72));
    EXPECT_THAT(imported->building->accesses(), SizeIs(75));
    std::size_t odd = 0;
    for (const Finding& finding : imported->findings)
        if (finding.rule == "access-touches-two-regions") odd += finding.ids.size();
    EXPECT_EQ(odd, 19U) << "openings not on two units";
    EXPECT_EQ(countOf(*imported, "access-joins-two-regions"), 17U)
        << "two of the 19 touch three or four units and are joined";
    const Finding* without = findingOf(*imported, "region-has-access");
    ASSERT_NE(without, nullptr);
    EXPECT_THAT(without->ids, SizeIs(14)) << "ten that no opening touches, four with one that leads outside";
    const Finding* besides = findingOf(*imported, "region-door-joins-others");
    ASSERT_NE(besides, nullptr);
    EXPECT_THAT(besides->ids, ::testing::ElementsAre("28ef1c92-952b-4eaa-9279-44d71acb3f60"))
        << "a door that joins two others ends at its corner";
    std::set<std::string> named; // by map check alone, when nobody remembers the import
    for (const Finding& finding : checkBuilding(*imported->building))
        if (finding.rule == "access-touches-two-regions" || finding.rule == "access-joins-two-regions")
            named.insert(finding.ids.begin(), finding.ids.end());
    EXPECT_THAT(named, SizeIs(19));
    auto several = importBuilding(root);
    ASSERT_FALSE(several.ok());
    EXPECT_THAT(several.error().text(), HasSubstr("name the folder of one"));
    auto two = importBuilding(root + "/Combined_IMDF_CPC4");
    ASSERT_TRUE(two.ok());
    EXPECT_THAT(two->building->levels(), SizeIs(2));
    EXPECT_THAT(two->building->regions(), SizeIs(33));
}

} // namespace
