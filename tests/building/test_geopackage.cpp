#include "core/base/ogr.h"
#include "core/building/geopackage.h"
#include "core/building/info.h"
#include "tests/support/ascii_map.h"
#include "tests/support/same_building.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <limits>
#include <set>
#include <sys/resource.h>
#include <tuple>
#include <unistd.h>

namespace farol::building {
namespace {

namespace fs = std::filesystem;
using test::AsciiMap;
using test::expectSame;
using testing::Contains;
using testing::HasSubstr;

class GeoPackage : public testing::Test {
protected:
    void SetUp() override {
        std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
        m_folder =
            fs::temp_directory_path() / ("farol-geopackage-" + name + "-" + std::to_string(::getpid()));
        fs::create_directories(m_folder);
        m_path = (m_folder / "map.gpkg").string();
    }
    void TearDown() override { fs::remove_all(m_folder); }

    /// Runs SQL on the file as an outsider (QGIS, a script) would.
    void sql(const std::vector<std::string>& statements) {
        auto dataset = openVector(m_path, OpenMode::Update);
        ASSERT_TRUE(dataset.ok()) << dataset.error().text();
        GdalMessages messages;
        for (const std::string& statement : statements)
            (*dataset)->ExecuteSQL(statement.c_str(), nullptr, nullptr);
        EXPECT_EQ(messages.text(), "");
        EXPECT_TRUE(closeVector(std::move(*dataset), m_path).ok());
    }
    /// Edits each feature of a layer.
    void edit(const std::string& layerName, const std::function<void(OGRFeature&)>& change) {
        auto dataset = openVector(m_path, OpenMode::Update);
        ASSERT_TRUE(dataset.ok());
        GdalMessages quiet;
        OGRLayer* layer = (*dataset)->GetLayerByName(layerName.c_str());
        std::vector<OGRFeatureUniquePtr> features;
        while (OGRFeature* feature = layer->GetNextFeature()) features.emplace_back(feature);
        for (auto& feature : features) {
            change(*feature);
            EXPECT_EQ(layer->SetFeature(feature.get()), OGRERR_NONE);
        }
        (void)closeVector(std::move(*dataset), m_path);
    }
    Error loadError() {
        auto loaded = loadBuilding(m_path);
        if (!loaded.ok()) return loaded.error();
        ADD_FAILURE() << "the map was read";
        return {};
    }
    std::string bytes() {
        std::ifstream in(m_path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    }
    std::vector<std::string> filesBeside() {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(m_folder))
            names.push_back(entry.path().filename().string());
        return names;
    }

    fs::path m_folder;
    std::string m_path;
};

BuildingData sample() {
    AsciiMap map;
    map.floor(R"(
        +------+------+
        |A  e  /B     |
        |      |  ##  |
        |      :  ##  |
        |      :      |
        +-->---+------+
        |S     |
        +------+
    )");
    map.floor("+--+\n|T |\n|  |\n+--+", -1.0);
    map.region('A', {"Átrio “Sul” – Ω", RegionKind::Hall, "0.01", true});
    map.landmark('e', {Kind::Extinguisher, "ação", "ext-1", 123.456});
    map.join(AccessKind::Stairs, 'S', 'T', "shaft-1", 12);
    BuildingData data = map.data();
    data.title = "Exemplo";
    data.languages = {"pt", "en"};
    data.properties["note"] = "by hand";
    data.levels[1].elevationM = -3.5;
    data.accesses[0].automatic = true;
    data.accesses[0].doorType = "swing";
    data.walls.push_back({0.0, {{0, 0}, {3, 4}, {5, 5}}, {}});
    data.landmarks[0].kind = Kind::Other;
    data.landmarks[0].kindText = "sculpture";
    data.landmarks[0].tallM = 0.55;
    data.regions[1].extra = {{"seats", std::int64_t{24}}, {"rent", 12.5}, {"owner", std::string("DEEI")}};
    data.regions[0].extra = {{"seats", {}}, {"rent", {}}, {"owner", {}}};
    data.regions[2].extra = data.regions[3].extra = data.regions[0].extra;
    return data;
}

TEST_F(GeoPackage, readsBackWhatItWrote) {
    Building building(sample());
    auto saved = saveBuilding(building, m_path);
    ASSERT_TRUE(saved.ok()) << saved.error().text();
    auto loaded = loadBuilding(m_path);
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    expectSame(building.data(), loaded->building->data());
    ASSERT_TRUE(saveBuilding(*loaded->building, m_path).ok()); // onto itself
    auto again = loadBuilding(m_path);
    ASSERT_TRUE(again.ok());
    expectSame(building.data(), again->building->data());
    EXPECT_EQ(again->building->landmarks()[0].heading, loaded->building->landmarks()[0].heading);
    EXPECT_EQ(filesBeside().size(), 1U);
}

TEST_F(GeoPackage, keepsTheCoordinateSystem) {
    BuildingData data = sample();
    data.crs = "EPSG:32629";
    ASSERT_TRUE(saveBuilding(Building(data), m_path).ok());
    auto loaded = loadBuilding(m_path);
    ASSERT_TRUE(loaded.ok());
    EXPECT_EQ(describe(*loaded->building).crs, "EPSG:32629");
    ASSERT_TRUE(saveBuilding(*loaded->building, m_path).ok());
    auto again = loadBuilding(m_path);
    ASSERT_TRUE(again.ok());
    expectSame(loaded->building->data(), again->building->data());
}

TEST_F(GeoPackage, keepsUnknownLayersAndFields) {
    ASSERT_TRUE(saveBuilding(Building(sample()), m_path).ok());
    sql({"CREATE TABLE notes (fid INTEGER PRIMARY KEY, words TEXT)", "INSERT INTO notes VALUES (7, 'olá')",
         "INSERT INTO gpkg_contents (table_name, data_type, identifier) VALUES ('notes', 'attributes', "
         "'notes')",
         "ALTER TABLE regions ADD COLUMN photo BLOB", "ALTER TABLE regions ADD COLUMN cleaned DATE",
         "UPDATE regions SET photo = x'00ff10', cleaned = '2026-05-04' WHERE region_id = 'B'",
         "UPDATE regions SET fid = fid + 100"});
    auto loaded = loadBuilding(m_path);
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    BuildingData data = loaded->building->data();
    EXPECT_EQ(data.regions[1].extra.at("seats"), AttributeValue(std::int64_t{24}));
    EXPECT_EQ(data.regions[1].extra.at("cleaned"), AttributeValue(std::string("2026/05/04")));
    data.regions[1].name = "Renamed";
    std::erase_if(data.regions, [](const Region& region) { return region.id.value == "S"; });
    ASSERT_TRUE(saveBuilding(Building(data), m_path).ok());
    auto dataset = openVector(m_path);
    ASSERT_TRUE(dataset.ok());
    OGRLayer* notes = (*dataset)->GetLayerByName("notes");
    ASSERT_NE(notes, nullptr);
    EXPECT_STREQ(OGRFeatureUniquePtr(notes->GetNextFeature())->GetFieldAsString("words"), "olá");
    OGRLayer* regions = (*dataset)->GetLayerByName("regions");
    EXPECT_EQ(regions->GetFeatureCount(), 3);
    regions->SetAttributeFilter("region_id = 'B'");
    OGRFeatureUniquePtr feature(regions->GetNextFeature());
    ASSERT_NE(feature, nullptr);
    EXPECT_STREQ(feature->GetFieldAsString("name"), "Renamed");
    EXPECT_EQ(feature->GetFieldAsInteger("seats"), 24);
    EXPECT_STREQ(feature->GetFieldAsString("cleaned"), "2026/05/04");
    int size = 0;
    const GByte* photo = feature->GetFieldAsBinary(feature->GetFieldIndex("photo"), &size);
    ASSERT_EQ(size, 3);
    EXPECT_EQ(photo[1], 0xff);
}

TEST_F(GeoPackage, aFailedSaveLeavesTheOldFile) {
    ASSERT_TRUE(saveBuilding(Building(sample()), m_path).ok());
    std::string before = bytes();
    BuildingData larger = sample();
    for (int i = 0; i < 3000; ++i) {
        larger.landmarks.push_back(larger.landmarks[0]);
        larger.landmarks.back().id = LandmarkId("x" + std::to_string(i));
    }
    // The disk "fills up" shortly after the copy of the old file.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    rlimit small{before.size() + 40000, old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    auto saved = saveBuilding(Building(larger), m_path);
    setrlimit(RLIMIT_FSIZE, &old);
    ASSERT_FALSE(saved.ok());
    EXPECT_THAT(saved.error().context, HasSubstr("map.gpkg"));
    EXPECT_EQ(bytes(), before);
    EXPECT_EQ(filesBeside().size(), 1U) << "nothing half-written is left behind";
    EXPECT_TRUE(loadBuilding(m_path).ok());
}

TEST_F(GeoPackage, refusesToWriteWhatIsNoMap) {
    BuildingData data = sample();
    data.regions[0].polygon.outer.clear();
    auto saved = saveBuilding(Building(data), m_path);
    ASSERT_FALSE(saved.ok());
    EXPECT_EQ(saved.error().code, ErrorCode::InvalidArgument);
    EXPECT_TRUE(filesBeside().empty());
    std::ofstream(m_path) << "my notes, not a map";
    EXPECT_FALSE(saveBuilding(Building(sample()), m_path).ok());
    EXPECT_EQ(bytes(), "my notes, not a map");
    EXPECT_EQ(saveBuilding(Building(sample()), (m_folder / "no" / "such.gpkg").string()).ok(), false);
}

TEST_F(GeoPackage, neverOverwritesAFileOfALaterFarol) {
    ASSERT_TRUE(saveBuilding(Building(sample()), m_path).ok());
    sql({"UPDATE farol SET value = '2' WHERE key = 'schema'"});
    EXPECT_EQ(saveBuilding(Building(sample()), m_path).error().code, ErrorCode::UnsupportedFormat);
    Error error = loadError();
    EXPECT_EQ(error.code, ErrorCode::UnsupportedFormat);
    EXPECT_THAT(error.message, HasSubstr("schema version 2"));
}

TEST_F(GeoPackage, tellsWhatIsNotAMap) {
    EXPECT_EQ(loadError().code, ErrorCode::NotFound);
    std::ofstream(m_path) << "hello";
    EXPECT_EQ(loadError().code, ErrorCode::UnsupportedFormat);
    std::ofstream(m_path).close();
    EXPECT_EQ(loadError().code, ErrorCode::UnsupportedFormat);
    fs::remove(m_path);
    auto dataset = createGeoPackage(m_path);
    ASSERT_TRUE(dataset.ok());
    ASSERT_NE((*dataset)->CreateLayer("templates", nullptr, wkbNone, nullptr), nullptr);
    ASSERT_TRUE(closeVector(std::move(*dataset), m_path).ok());
    Error library = loadError();
    EXPECT_EQ(library.code, ErrorCode::UnsupportedFormat);
    EXPECT_THAT(library.message, HasSubstr("library"));
}

TEST_F(GeoPackage, aTornFileIsCorrupt) {
    ASSERT_TRUE(saveBuilding(Building(sample()), m_path).ok());
    fs::resize_file(m_path, fs::file_size(m_path) / 2);
    EXPECT_FALSE(loadBuilding(m_path).ok());
}

TEST_F(GeoPackage, namesTheFeatureThatIsWrong) {
    struct Case {
        std::vector<std::string> statements;
        std::string expected;
    };
    for (const Case& each : std::vector<Case>{
             {{"UPDATE regions SET region_id = 'A' WHERE region_id = 'B'"},
              "layer regions, feature A: two features"},
             {{"UPDATE accesses SET access_id = NULL WHERE access_id = 'A-B'"},
              "layer accesses, feature number 1"},
             {{"UPDATE landmarks SET landmark_id = ''"}, "has no landmark_id"},
             {{"ALTER TABLE regions RENAME COLUMN region_id TO code"},
              "layer regions: the field region_id is missing"},
             {{"UPDATE regions SET level = NULL WHERE region_id = 'A'"}, "feature A: has no level"},
             {{"UPDATE regions SET level = 1e300 WHERE region_id = 'A'"}, "no floor"},
             {{"UPDATE accesses SET steps = 2000000 WHERE access_id = 'S-T'"},
              "feature S-T: steps is no whole number"},
             {{"UPDATE accesses SET oneway = 'up' WHERE access_id = 'A-B'"}, "oneway is \"up\""},
             {{"INSERT INTO levels (level) VALUES (0)"}, "feature 0: this level is listed twice"},
             {{"UPDATE regions SET geom = NULL WHERE region_id = 'B'"}, "feature B: has no geometry"},
             {{"UPDATE farol SET value = 'one' WHERE key = 'schema'"}, "is no version"},
             {{"DELETE FROM regions"}, "no regions"}}) {
        fs::remove(m_path);
        ASSERT_TRUE(saveBuilding(Building(sample()), m_path).ok());
        sql(each.statements);
        auto loaded = loadBuilding(m_path);
        ASSERT_FALSE(loaded.ok()) << each.expected;
        EXPECT_THAT(loaded.error().text(), HasSubstr(each.expected));
        EXPECT_THAT(loaded.error().text(), HasSubstr("map.gpkg"));
        EXPECT_EQ(loaded.error().code, ErrorCode::Corrupt);
    }
}

TEST_F(GeoPackage, refusesGeometriesThatAreNone) {
    struct Case {
        std::string wkt;
        std::string expected;
    };
    for (const Case& each : std::vector<Case>{
             {"MULTIPOLYGON (((0 0,4 0,4 4,0 0)),((9 9,12 9,12 12,9 9)))", "feature A: consists of 2 parts"},
             {"LINESTRING (0 0,4 4)", "feature A: is a LINESTRING; a Polygon is wanted"},
             {"POLYGON ((0 0,1e30 0,4 4,0 0))", "beyond any metric map"},
             {"POLYGON ((0 0,4 4,8 8,0 0))", "without an area"},
             {"POLYGON EMPTY", "has no geometry"}}) {
        fs::remove(m_path);
        ASSERT_TRUE(saveBuilding(Building(sample()), m_path).ok());
        edit("regions", [&](OGRFeature& feature) {
            if (std::string(feature.GetFieldAsString("region_id")) != "A") return;
            OGRGeometry* geometry = nullptr;
            ASSERT_EQ(OGRGeometryFactory::createFromWkt(each.wkt.c_str(), nullptr, &geometry), OGRERR_NONE)
                << each.wkt;
            feature.SetGeometryDirectly(geometry);
        });
        Error error = loadError();
        EXPECT_EQ(error.code, ErrorCode::Corrupt);
        EXPECT_THAT(error.text(), HasSubstr(each.expected));
    }
}

TEST_F(GeoPackage, refusesCoordinatesThatAreNoNumbers) {
    for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        fs::remove(m_path);
        ASSERT_TRUE(saveBuilding(Building(sample()), m_path).ok());
        edit("accesses", [&](OGRFeature& feature) {
            if (std::string(feature.GetFieldAsString("access_id")) != "A-B") return;
            feature.GetGeometryRef()->toLineString()->setPoint(1, bad, 1.0);
        });
        Error error = loadError();
        EXPECT_EQ(error.code, ErrorCode::Corrupt);
        EXPECT_THAT(error.text(),
                    HasSubstr("layer accesses, feature A-B: has a coordinate that is no number"));
    }
}

TEST_F(GeoPackage, acceptsMultiPolygonsOfOnePart) {
    ASSERT_TRUE(saveBuilding(Building(sample()), m_path).ok());
    edit("regions", [](OGRFeature& feature) {
        feature.SetGeometryDirectly(OGRGeometryFactory::forceToMultiPolygon(feature.StealGeometry()));
    });
    auto loaded = loadBuilding(m_path);
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    expectSame(sample(), [&] {
        BuildingData data = loaded->building->data();
        std::reverse(data.levels.begin(), data.levels.end());
        return data;
    }());
}

TEST_F(GeoPackage, refusesDegrees) {
    BuildingData data = sample();
    data.crs = "EPSG:4326";
    ASSERT_TRUE(saveBuilding(Building(data), m_path).ok());
    Error error = loadError();
    EXPECT_EQ(error.code, ErrorCode::UnsupportedFormat);
    EXPECT_THAT(error.message, HasSubstr("degrees"));
}

TEST_F(GeoPackage, livesWithOddThingsAndSaysSo) {
    ASSERT_TRUE(saveBuilding(Building(sample()), m_path).ok());
    sql({"DROP TABLE levels", "DROP TABLE landmarks", "DROP TABLE walls",
         "UPDATE accesses SET kind = 'portcullis', region_b = 'nowhere' WHERE access_id = 'A-B'"});
    auto loaded = loadBuilding(m_path);
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    EXPECT_EQ(loaded->building->access(AccessId("A-B"))->kind, AccessKind::Other);
    EXPECT_EQ(loaded->building->access(AccessId("A-B"))->kindText, "portcullis");
    EXPECT_THAT(loaded->warnings, Contains(HasSubstr("no layer levels")));
    EXPECT_THAT(loaded->warnings, Contains(HasSubstr("no layer landmarks")));
    EXPECT_THAT(loaded->warnings, Contains(HasSubstr("\"portcullis\", treated as other: A-B")));
    EXPECT_THAT(loaded->warnings, Contains(HasSubstr("do not join two regions")));
}

TEST_F(GeoPackage, derivesTheRegionsOfAnAccess) {
    BuildingData data = sample();
    for (Access& access : data.accesses) access.regionA = access.regionB = RegionId();
    data.accesses[1].regionA = RegionId("A");              // one side given
    data.accesses[2].line = {data.accesses[2].midpoint()}; // a point instead of a line
    ASSERT_TRUE(saveBuilding(Building(data), m_path).ok());
    auto loaded = loadBuilding(m_path);
    ASSERT_TRUE(loaded.ok());
    EXPECT_EQ(describe(*loaded->building).accessesJoined, 3U)
        << "all but the stairs, whose other level is not told";
    const Access* door = loaded->building->access(AccessId("A-B"));
    EXPECT_EQ(std::set<RegionId>({door->regionA, door->regionB}),
              std::set<RegionId>({RegionId("A"), RegionId("B")}));
    EXPECT_EQ(loaded->building->access(AccessId("A-B2"))->regionB, RegionId("B"));
}

TEST(RealMaps, allWalksLoadAndAreJoined) {
    const char* data = std::getenv("FAROL_DATA");
    fs::path walks = fs::path(data == nullptr ? "" : data) / "walks";
    if (!fs::exists(walks)) GTEST_SKIP() << "FAROL_DATA has no folder walks";
    std::size_t maps = 0;
    for (const auto& entry : fs::directory_iterator(walks)) {
        fs::path map = entry.path() / "map.gpkg";
        if (!fs::exists(map)) continue;
        ++maps;
        auto loaded = loadBuilding(map.string());
        ASSERT_TRUE(loaded.ok()) << loaded.error().text();
        BuildingInfo info = describe(*loaded->building);
        EXPECT_EQ(info.accessesJoined, info.accesses) << map;
        EXPECT_EQ(info.components, 1U) << map;
        EXPECT_TRUE(loaded->warnings.empty()) << map << ": " << loaded->warnings.front();
    }
    EXPECT_GE(maps, 1U);
}

} // namespace
} // namespace farol::building
