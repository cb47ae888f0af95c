// What a map goes through between import and later edits: nothing may change that nobody changed.
#include "core/base/ogr.h"
#include "core/building/geopackage.h"
#include "core/building/import/importer.h"
#include "tests/building/import_support.h"
#include "tests/support/ascii_map.h"
#include "tests/support/temporary_folder.h"

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <sys/resource.h>

namespace farol::building {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string bytesOf(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// GeoPackage notes when a layer was last changed; a fixed date lets files be compared byte by byte.
class FixedDate {
public:
    FixedDate() { CPLSetConfigOption("OGR_CURRENT_DATE", "2026-01-01T00:00:00.000Z"); }
    ~FixedDate() { CPLSetConfigOption("OGR_CURRENT_DATE", nullptr); }
    FixedDate(const FixedDate&) = delete;
    FixedDate& operator=(const FixedDate&) = delete;
};

class RoundTrip : public ::testing::Test {
protected:
    std::string at(const std::string& name) { return (m_folder / name).string(); }

    void expectStays(const std::string& source) {
        FixedDate date;
        auto imported = importBuilding(source);
        ASSERT_TRUE(imported.ok()) << imported.error().text();
        ASSERT_TRUE(saveBuilding(*imported->building, at("a.gpkg")).ok());
        std::string first = bytesOf(at("a.gpkg"));
        auto loaded = loadBuilding(at("a.gpkg"));
        ASSERT_TRUE(loaded.ok()) << loaded.error().text();
        ASSERT_TRUE(saveBuilding(*loaded->building, at("b.gpkg")).ok());
        EXPECT_TRUE(bytesOf(at("b.gpkg")) == first) << "written anew: " << source;
        ASSERT_TRUE(saveBuilding(*loaded->building, at("a.gpkg")).ok());
        EXPECT_TRUE(bytesOf(at("a.gpkg")) == first) << "written over itself: " << source;
        auto again = importBuilding(at("a.gpkg"));
        ASSERT_TRUE(again.ok()) << again.error().text();
        EXPECT_EQ(again->building->accesses().size(), loaded->building->accesses().size());
        ASSERT_TRUE(saveBuilding(*again->building, at("c.gpkg"), again->origin).ok());
        EXPECT_TRUE(bytesOf(at("c.gpkg")) == first) << "imported as a map: " << source;
        for (const char* name : {"a.gpkg", "b.gpkg", "c.gpkg"}) fs::remove(at(name));
    }

    test::TemporaryFolder m_folder;
};

TEST_F(RoundTrip, ImportsOfEveryFormatStayToTheByte) {
    for (const char* name : {"indoor_house.gml", "sit_house.osm", "sit_house.osm.pbf", "wrld_house"})
        expectStays(testing::fixture(name));
}

TEST_F(RoundTrip, RealMapsStayToTheByte) {
    if (testing::realMap("").empty()) GTEST_SKIP() << "FAROL_DATA has no folder maps";
    for (const char* name :
         {"cambridge_imdf/Addenbrookes_Final_IMDF", "cambridge_imdf/CPC4_Final_IMDF",
          "cambridge_imdf/Combined_IMDF_CPC4", "cambridge_imdf/Addenbrookes_QGIS_Geojsons",
          "westport_house_wrld", "berlin_hbf_osm_sit/berlin_hbf.osm", "berlin_hbf_osm_sit/berlin_hbf.geojson",
          "indoorgml_fjk", "hulop_sample", "shp_edge_cases_synthetic/tokyo_station"}) {
        ASSERT_NE(testing::realMap(name), "") << name;
        expectStays(testing::realMap(name));
    }
}

BuildingData house() {
    test::AsciiMap map;
    map.floor("+---+---+\n|A  /B  |\n|  e|   |\n+---+---+");
    map.landmark('e', {Kind::Extinguisher});
    BuildingData data = map.data();
    data.walls = {{0.0, {{0, 0}, {8, 0}}, {}}, {0.0, {{0, 3}, {8, 3}}, {}}};
    return data;
}

void sql(const std::string& path, const std::vector<std::string>& statements) {
    auto dataset = openVector(path, OpenMode::Update);
    ASSERT_TRUE(dataset.ok()) << dataset.error().text();
    GdalMessages messages;
    for (const std::string& statement : statements)
        (*dataset)->ExecuteSQL(statement.c_str(), nullptr, nullptr);
    EXPECT_EQ(messages.text(), "");
    EXPECT_TRUE(closeVector(std::move(*dataset), path).ok());
}

/// All rows of a layer as text, geometry with heights, bytes as hexadecimal digits.
std::vector<std::string> rowsOf(const std::string& path, const std::string& query) {
    std::vector<std::string> rows;
    auto dataset = openVector(path);
    if (!dataset.ok()) return rows;
    OGRLayer* found = (*dataset)->ExecuteSQL(query.c_str(), nullptr, "SQLite");
    if (found == nullptr) return rows;
    while (OGRFeatureUniquePtr feature{found->GetNextFeature()}) {
        std::string row;
        for (int i = 0; i < feature->GetFieldCount(); ++i)
            row += std::string(feature->GetFieldAsString(i)) + "|";
        if (const OGRGeometry* shape = feature->GetGeometryRef()) row += shape->exportToWkt();
        rows.push_back(row);
    }
    (*dataset)->ReleaseResultSet(found);
    return rows;
}

/// A layer of its own, columns of every type and heights, as a curator adds them in QGIS.
void editByHand(const std::string& path) {
    sql(path,
        {"ALTER TABLE regions ADD COLUMN painted DATETIME", "ALTER TABLE regions ADD COLUMN cleaned DATE",
         "ALTER TABLE regions ADD COLUMN plan BLOB", "ALTER TABLE regions ADD COLUMN warm BOOLEAN",
         "ALTER TABLE regions ADD COLUMN rent FLOAT", "ALTER TABLE walls ADD COLUMN photo BLOB",
         "ALTER TABLE accesses ADD COLUMN notes TEXT",
         "UPDATE regions SET painted = '2026-05-04T10:20:30.125Z', cleaned = '2026-05-04', plan = x'00ff', "
         "warm = 1, rent = 0.1 WHERE region_id = 'B'",
         "UPDATE walls SET photo = x'0102' WHERE fid = 2", "UPDATE accesses SET notes = ''",
         "UPDATE regions SET restricted = NULL, name = '' WHERE region_id = 'B'"});
    auto dataset = openVector(path, OpenMode::Update);
    ASSERT_TRUE(dataset.ok());
    OGRLayer* layer = (*dataset)->CreateLayer("lamps", nullptr, wkbPoint25D, nullptr);
    ASSERT_NE(layer, nullptr);
    OGRFieldDefn watts("watts", OFTReal);
    ASSERT_EQ(layer->CreateField(&watts), OGRERR_NONE);
    OGRFeature lamp(layer->GetLayerDefn());
    lamp.SetField("watts", 11.5);
    OGRPoint place(1.5, 2.5, 2.25);
    lamp.SetGeometry(&place);
    ASSERT_EQ(layer->CreateFeature(&lamp), OGRERR_NONE);
    EXPECT_TRUE(closeVector(std::move(*dataset), path).ok());
}

const std::vector<std::string> kUnknownParts{"SELECT region_id, painted, cleaned, hex(plan), warm, rent, "
                                             "restricted, name FROM regions WHERE region_id = 'B'",
                                             "SELECT fid, hex(photo), ST_AsText(geom) FROM walls",
                                             "SELECT notes IS NULL, notes FROM accesses",
                                             "SELECT watts, ST_AsText(geom), ST_Z(geom) FROM lamps"};

TEST_F(RoundTrip, AHandEditedFileKeepsWhatFarolDoesNotKnow) {
    ASSERT_TRUE(saveBuilding(Building(house()), at("map.gpkg")).ok());
    editByHand(at("map.gpkg"));
    std::vector<std::vector<std::string>> before;
    for (const std::string& query : kUnknownParts) before.push_back(rowsOf(at("map.gpkg"), query));
    auto loaded = loadBuilding(at("map.gpkg"));
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    ASSERT_TRUE(saveBuilding(*loaded->building, at("map.gpkg")).ok());
    BuildingData data = loaded->building->data();
    data.regions[0].name = "Renamed";
    data.landmarks[0].position.x += 0.25;
    data.walls.push_back({0.0, {{0, 0}, {0, 3}}, {}});
    ASSERT_TRUE(saveBuilding(Building(data), at("map.gpkg")).ok());
    ASSERT_TRUE(saveBuilding(Building(data), at("copy.gpkg"), at("map.gpkg")).ok()) << "saved as";
    for (const char* name : {"map.gpkg", "copy.gpkg"})
        for (std::size_t i = 0; i < kUnknownParts.size(); ++i) {
            std::vector<std::string> now = rowsOf(at(name), kUnknownParts[i]);
            ASSERT_GE(now.size(), before[i].size()) << kUnknownParts[i];
            ASSERT_FALSE(before[i].empty()) << kUnknownParts[i];
            now.resize(before[i].size());
            EXPECT_EQ(now, before[i]) << name << ": " << kUnknownParts[i];
        }
    auto again = loadBuilding(at("copy.gpkg"));
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->building->regions()[0].name, "Renamed");
    EXPECT_EQ(again->building->data().walls.size(), 3U);
}

TEST_F(RoundTrip, HeightsOfOutlinesStayWhereNothingMoved) {
    ASSERT_TRUE(saveBuilding(Building(house()), at("map.gpkg")).ok());
    {
        auto dataset = openVector(at("map.gpkg"), OpenMode::Update);
        ASSERT_TRUE(dataset.ok());
        OGRLayer* regions = (*dataset)->GetLayerByName("regions");
        OGRFeatureUniquePtr feature(regions->GetFeature(1));
        auto* shape = feature->GetGeometryRef();
        shape->set3D(TRUE);
        feature->GetGeometryRef()->toPolygon()->getExteriorRing()->setZ(0, 7.5);
        GdalMessages quiet;
        ASSERT_EQ(regions->SetFeature(feature.get()), OGRERR_NONE);
    }
    auto loaded = loadBuilding(at("map.gpkg"));
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    BuildingData data = loaded->building->data();
    data.regions[0].ref = "0.01";
    ASSERT_TRUE(saveBuilding(Building(data), at("map.gpkg")).ok());
    auto rows = rowsOf(at("map.gpkg"), "SELECT ref, ST_AsText(geom) FROM regions WHERE fid = 1");
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_THAT(rows[0], HasSubstr("0.01"));
    EXPECT_THAT(rows[0], HasSubstr("7.5"));
}

TEST_F(RoundTrip, ColumnsGrowWithWhatIsWrittenIntoThem) {
    BuildingData data = house();
    data.regions[0].extra["seats"] = std::int64_t{4};
    ASSERT_TRUE(saveBuilding(Building(data), at("map.gpkg")).ok());
    data.regions[1].extra["seats"] = 2.5;
    ASSERT_TRUE(saveBuilding(Building(data), at("map.gpkg")).ok());
    auto rows = rowsOf(at("map.gpkg"), "SELECT seats FROM regions ORDER BY region_id");
    EXPECT_EQ(rows, (std::vector<std::string>{"4|", "2.5|"}));
    data.regions[0].extra["seats"] = std::string("a few");
    ASSERT_TRUE(saveBuilding(Building(data), at("map.gpkg")).ok());
    rows = rowsOf(at("map.gpkg"), "SELECT seats FROM regions ORDER BY region_id");
    EXPECT_EQ(rows.at(0), "a few|");
    EXPECT_TRUE(loadBuilding(at("map.gpkg")).ok());
}

TEST_F(RoundTrip, WhatAnotherProgramStillWritesIsNeitherLostNorSpoilt) {
    ASSERT_TRUE(saveBuilding(Building(house()), at("map.gpkg")).ok());
    CPLSetConfigOption("OGR_SQLITE_JOURNAL", "WAL"); // as QGIS opens its files
    auto other = openVector(at("map.gpkg"), OpenMode::Update);
    CPLSetConfigOption("OGR_SQLITE_JOURNAL", nullptr);
    ASSERT_TRUE(other.ok());
    (*other)->ExecuteSQL("UPDATE regions SET name = 'from elsewhere' WHERE region_id = 'A'", nullptr,
                         nullptr);
    ASSERT_GT(fs::file_size(at("map.gpkg-wal")), 0U);
    auto saved = saveBuilding(Building(house()), at("map.gpkg"));
    ASSERT_FALSE(saved.ok());
    EXPECT_EQ(saved.error().code, ErrorCode::Conflict);
    EXPECT_THAT(saved.error().text(), HasSubstr("another program"));
    ASSERT_TRUE(closeVector(std::move(*other), "").ok());
    auto loaded = loadBuilding(at("map.gpkg"));
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    EXPECT_EQ(loaded->building->regions()[0].name, "from elsewhere");
    EXPECT_TRUE(saveBuilding(*loaded->building, at("map.gpkg")).ok());
}

TEST_F(RoundTrip, AFullDiskIsCalledByItsName) {
    ASSERT_TRUE(saveBuilding(Building(house()), at("map.gpkg")).ok());
    std::string before = bytesOf(at("map.gpkg"));
    BuildingData larger = house();
    for (int i = 0; i < 3000; ++i) {
        larger.landmarks.push_back(larger.landmarks[0]);
        larger.landmarks.back().id = LandmarkId("x" + std::to_string(i));
    }
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    getrlimit(RLIMIT_FSIZE, &old);
    // Full at once, in the copy of the old file, and at different points of the writing.
    for (std::size_t room : {std::size_t{0}, std::size_t{5000}, before.size() - 4096, before.size(),
                             before.size() + 4096, before.size() + 40000, before.size() + 200000}) {
        rlimit small{room, old.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
        auto saved = saveBuilding(Building(larger), at("map.gpkg"));
        auto fresh = saveBuilding(Building(larger), at("new.gpkg"));
        setrlimit(RLIMIT_FSIZE, &old);
        ASSERT_FALSE(saved.ok()) << room;
        EXPECT_EQ(saved.error().code, ErrorCode::NoSpace) << room << ": " << saved.error().text();
        EXPECT_THAT(saved.error().text(), HasSubstr("disk is full"));
        EXPECT_THAT(saved.error().context, HasSubstr("map.gpkg"));
        EXPECT_TRUE(bytesOf(at("map.gpkg")) == before);
        ASSERT_FALSE(fresh.ok()) << room;
        EXPECT_EQ(fresh.error().code, ErrorCode::NoSpace) << room << ": " << fresh.error().text();
        EXPECT_EQ(std::distance(fs::directory_iterator(m_folder.string()), fs::directory_iterator()), 1);
    }
}

TEST_F(RoundTrip, OnlyOrdinaryFilesAreWrittenAndLinksStayLinks) {
    EXPECT_EQ(saveBuilding(Building(house()), "/dev/full").error().code, ErrorCode::InvalidArgument);
    EXPECT_FALSE(fs::is_regular_file("/dev/full"));
    EXPECT_FALSE(saveBuilding(Building(house()), m_folder.string()).ok());
    ASSERT_TRUE(saveBuilding(Building(house()), at("real.gpkg")).ok());
    fs::create_symlink("real.gpkg", at("link.gpkg"));
    BuildingData data = house();
    data.title = "through the link";
    ASSERT_TRUE(saveBuilding(Building(data), at("link.gpkg")).ok());
    EXPECT_TRUE(fs::is_symlink(at("link.gpkg")));
    EXPECT_EQ(loadBuilding(at("real.gpkg"))->building->data().title, "through the link");
}

} // namespace
} // namespace farol::building
