// A campus in PostgreSQL with PostGIS: imported, read, routed over, edited from several processes at once.
// Runs beside the server of with_cluster.sh; the first argument is farol-cli.

#include "core/base/ogr.h"
#include "core/building/checks.h"
#include "core/building/database_map.h"
#include "core/building/geopackage.h"
#include "core/routing/route.h"
#include "tests/support/campus.h"
#include "tests/support/same_building.h"
#include "tests/support/temporary_folder.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace farol::building {
namespace {

using test::expectSame;
using testing::HasSubstr;
using testing::Not;

std::string farolCli;

struct Said {
    int code = -1;
    std::string text; ///< of both streams
};

Said shell(const std::string& command) {
    Said said;
    FILE* pipe = ::popen(("{ " + command + "; } 2>&1").c_str(), "r");
    if (pipe == nullptr) return said;
    std::array<char, 4096> buffer{};
    while (std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
        said.text.append(buffer.data(), count);
    said.code = WEXITSTATUS(::pclose(pipe));
    return said;
}

/// A fresh database for each test.
class Postgis : public testing::Test {
protected:
    static void SetUpTestSuite() {
        ASSERT_NE(std::getenv("PGHOST"), nullptr) << "start this test by tests/postgis/with_cluster.sh";
        Said made = shell("createdb with_postgis && psql -q -d with_postgis -c 'CREATE EXTENSION postgis'");
        ASSERT_EQ(made.code, 0) << made.text;
    }
    void SetUp() override {
        m_database = testing::UnitTest::GetInstance()->current_test_info()->name();
        std::transform(m_database.begin(), m_database.end(), m_database.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        Said made = shell("createdb -T with_postgis " + m_database);
        ASSERT_EQ(made.code, 0) << made.text;
        m_source = "PG:dbname=" + m_database;
    }

    std::string sql(const std::string& statement) {
        Said said = shell("psql -qAt -v ON_ERROR_STOP=1 -d " + m_database + " -c \"" + statement + "\"");
        EXPECT_EQ(said.code, 0) << statement << "\n" << said.text;
        while (!said.text.empty() && said.text.back() == '\n') said.text.pop_back();
        return said.text;
    }
    BuildingData read() {
        auto loaded = loadBuilding(m_source);
        EXPECT_TRUE(loaded.ok()) << loaded.error().text();
        return loaded ? loaded->building->data() : BuildingData();
    }
    Result<std::string> save(const BuildingData& data) { return saveToDatabase(Building(data), m_source); }
    /// A campus of 100 regions in the database.
    void fill() {
        auto saved = saveBuilding(*test::makeCampus({100}), m_source);
        ASSERT_TRUE(saved.ok()) << saved.error().text();
    }

    /// The exit code of what a process of its own does.
    static pid_t inProcess(const std::function<int()>& work) {
        pid_t child = ::fork();
        if (child == 0) ::_exit(work());
        return child;
    }
    static int codeOf(pid_t child) {
        int status = 0;
        ::waitpid(child, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    std::string m_database, m_source;
};

TEST_F(Postgis, TheCommandLineImportsReadsChecksAndRoutes) {
    test::TemporaryFolder folder;
    std::string file = (folder / "campus.gpkg").string();
    test::CampusOptions options{300};
    options.crs = "EPSG:32629";
    options.origin = {595000.0, 4099000.0};
    ASSERT_TRUE(saveBuilding(*test::makeCampus(options), file).ok());
    Said imported = shell(farolCli + " map import " + file + " '" + m_source + "'");
    ASSERT_EQ(imported.code, 0) << imported.text;
    for (const char* words : {"map info --json", "map check --json"}) {
        Said fromFile = shell(farolCli + " " + words + " " + file);
        Said fromDatabase = shell(farolCli + " " + words + " '" + m_source + "'");
        EXPECT_EQ(fromDatabase.code, 0) << words;
        EXPECT_EQ(fromDatabase.text, fromFile.text) << words;
    }
    std::string copy = (folder / "copy.gpkg").string();
    EXPECT_EQ(shell(farolCli + " map import '" + m_source + "' " + copy).code, 0);
    EXPECT_EQ(shell(farolCli + " map info --json " + copy).text,
              shell(farolCli + " map info --json " + file).text);
    auto campus = test::makeCampus(options);
    for (const auto& [from, to] : test::campusPairs(*campus, 3)) {
        std::string ends = " --json --from " + from.region.value + " --to " + to.region.value;
        Said fromFile = shell(farolCli + " route " + file + ends);
        Said fromDatabase = shell(farolCli + " route '" + m_source + "'" + ends);
        EXPECT_EQ(fromDatabase.code, 0) << fromDatabase.text;
        EXPECT_EQ(fromDatabase.text, fromFile.text);
    }
}

TEST_F(Postgis, AWalkReadsItsMapFromTheDatabase) {
    fill();
    test::TemporaryFolder folder;
    std::string frames = (folder / "frames").string();
    Said copied = shell("mkdir " + frames +
                        " && cp " FAROL_SOURCE_DIR "/resources/examples/drawn/frames/1.jpg " + frames);
    ASSERT_EQ(copied.code, 0) << copied.text;
    Said walked = shell(farolCli + " run --map '" + m_source + " password=hunter2' --source " +
                        (folder / "frames").string() + " --from b1.0.2 --to b2.0.3 --record " +
                        (folder / "walk").string());
    EXPECT_EQ(walked.code, 0) << walked.text;
    Said found = shell("grep -r hunter2 " + (folder / "walk").string());
    EXPECT_EQ(found.code, 1) << "the password stands in the recording: " << found.text;
}

TEST_F(Postgis, EverythingComesBackAsItWas) {
    BuildingData data = test::campusData({100});
    data.title = "Campus “Gambelas” – Ω";
    data.languages = {"pt", "en"};
    data.properties["note"] = "it's \\ by hand; DROP TABLE regions";
    data.regions[0].name = "Átrio 'Sul'\tund\n\"mehr\" \\N";
    data.regions[0].extra = {
        {"Seats: total", std::int64_t{24}}, {"rent", 12.5}, {"owner", std::string("DEEI")}};
    data.landmarks[0].heading = fromDegrees(123.456);
    data.landmarks[0].text = "ação";
    data.walls.push_back({0.0, {{0.1, 0.2}, {1.0 / 3.0, 4}, {5, 5}}, {}});
    auto saved = save(data);
    ASSERT_TRUE(saved.ok()) << saved.error().text();
    BuildingData first = read();
    EXPECT_EQ(first.revision, *saved);
    EXPECT_EQ(first.regions.size(), data.regions.size());
    Building map(first);
    const Region* hall = map.region(data.regions[0].id);
    ASSERT_NE(hall, nullptr);
    EXPECT_EQ(hall->name, data.regions[0].name);
    EXPECT_EQ(std::get<std::int64_t>(hall->extra.at("Seats: total")), 24);
    EXPECT_EQ(first.properties.at("note"), data.properties["note"]);
    auto again = save(first);
    ASSERT_TRUE(again.ok()) << again.error().text();
    EXPECT_EQ(*again, first.revision) << "saving what was read changes nothing";
    expectSame(first, read());
    test::TemporaryFolder folder;
    std::string file = (folder / "copy.gpkg").string();
    ASSERT_TRUE(saveBuilding(Building(first), file).ok());
    auto copy = loadBuilding(file);
    ASSERT_TRUE(copy.ok());
    expectSame(first, copy->building->data());
}

TEST_F(Postgis, AChangeIsSavedAndAStaleOneIsRefused) {
    fill();
    BuildingData mine = read(), theirs = mine;
    mine.regions[0].name = "Bar";
    auto saved = save(mine);
    ASSERT_TRUE(saved.ok()) << saved.error().text();
    theirs.regions[1].name = "Library";
    auto refused = save(theirs);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::Conflict);
    EXPECT_THAT(refused.error().text(), HasSubstr("someone else"));
    EXPECT_EQ(read().revision, *saved) << "nothing was written";
    EXPECT_EQ(read().regions[0].name, "Bar");
    mine.revision = *saved;
    mine.regions[0].name = "Canteen";
    EXPECT_TRUE(save(mine).ok()) << "one's own saves are no conflict";
    theirs = read();
    theirs.regions[1].name = "Library";
    EXPECT_TRUE(save(theirs).ok());
    EXPECT_EQ(read().regions[0].name, "Canteen");
    EXPECT_EQ(read().regions[1].name, "Library");
}

TEST_F(Postgis, WhatOthersEditByHandIsKeptAndNoticed) {
    fill();
    sql("ALTER TABLE regions ADD cleaned date; UPDATE regions SET cleaned = '2026-11-01'; CREATE TABLE notes "
        "(t text)");
    BuildingData data = read();
    sql("UPDATE accesses SET closed = true WHERE access_id = '" + data.accesses[3].id.value + "'");
    data.regions[0].name = "Bar";
    auto refused = save(data);
    ASSERT_FALSE(refused.ok()) << "a door was closed in between";
    EXPECT_EQ(refused.error().code, ErrorCode::Conflict);
    data = read();
    EXPECT_TRUE(data.accesses[3].closed);
    data.regions[0].name = "Bar";
    auto rows = sql("SELECT sum(xmin::text::bigint) FROM regions WHERE region_id <> '" +
                    data.regions[0].id.value + "'");
    ASSERT_TRUE(save(data).ok());
    EXPECT_EQ(sql("SELECT name FROM regions WHERE region_id = '" + data.regions[0].id.value + "'"), "Bar");
    EXPECT_EQ(sql("SELECT count(*) FROM regions WHERE cleaned = '2026-11-01'"),
              std::to_string(data.regions.size()));
    EXPECT_EQ(sql("SELECT count(*) FROM notes"), "0");
    EXPECT_EQ(sql("SELECT sum(xmin::text::bigint) FROM regions WHERE region_id <> '" +
                  data.regions[0].id.value + "'"),
              rows)
        << "rows in which nothing changed are not written again";
}

TEST_F(Postgis, TwoProcessesEditAtOnceAndNothingIsLost) {
    constexpr int kEdits = 8;
    fill();
    auto edit = [&](int who) {
        for (int number = 0; number < kEdits;) {
            auto loaded = loadBuilding(m_source);
            if (!loaded) return 2;
            BuildingData data = loaded->building->data();
            // The title and a region tell of one save: never of two.
            data.title = data.regions[0].name = std::to_string(who) + "-" + std::to_string(number);
            Landmark sign = data.landmarks[0];
            sign.id = LandmarkId("sign-" + data.title);
            data.landmarks.push_back(sign);
            auto saved = saveToDatabase(Building(data), m_source);
            if (saved) ++number;
            if (!saved && saved.error().code != ErrorCode::Conflict) return 3;
        }
        return 0;
    };
    std::size_t before = read().landmarks.size();
    pid_t first = inProcess([&] { return edit(1); }), second = inProcess([&] { return edit(2); });
    pid_t reader = inProcess([&] {
        for (int i = 0; i < 40; ++i) {
            auto loaded = loadBuilding(m_source);
            if (!loaded) return 2;
            const BuildingData& data = loaded->building->data();
            bool untouched = data.landmarks.size() == before;
            if (!untouched && data.title != data.regions[0].name) return 3;
        }
        return 0;
    });
    EXPECT_EQ(codeOf(first), 0);
    EXPECT_EQ(codeOf(second), 0);
    EXPECT_EQ(codeOf(reader), 0) << "every reading is of one moment";
    BuildingData data = read();
    EXPECT_EQ(data.landmarks.size(), before + 2 * kEdits);
    for (const Finding& finding : checkBuilding(Building(data))) EXPECT_EQ(finding.severity, Severity::Note);
}

TEST_F(Postgis, TwoImportsAtOnceLeaveOneWholeMap) {
    auto import = [&](std::uint32_t seed) {
        return inProcess([&, seed] {
            return saveBuilding(*test::makeCampus({300, seed}), m_source).ok() ? 0 : 1;
        });
    };
    pid_t first = import(1), second = import(2);
    EXPECT_EQ(codeOf(first), 0);
    EXPECT_EQ(codeOf(second), 0);
    BuildingData data = read();
    std::size_t one = test::campusData({300, 1}).accesses.size(),
                other = test::campusData({300, 2}).accesses.size();
    EXPECT_TRUE(data.accesses.size() == one || data.accesses.size() == other) << data.accesses.size();
    for (const Finding& finding : checkBuilding(Building(data)))
        EXPECT_EQ(finding.severity, Severity::Note) << finding.message;
}

TEST_F(Postgis, AKilledWriterLeavesTheMapAsItWas) {
    fill();
    std::string before = read().revision;
    pid_t writer = inProcess([&] {
        return saveBuilding(*test::makeCampus({1000, 5}), m_source).ok() ? 0 : 1;
    });
    // In the middle: it has its turn, and has written.
    std::string busy = "SELECT count(*) FROM pg_locks WHERE locktype = 'advisory' AND granted";
    std::string said;
    do said = sql(busy);
    while (said == "0" && ::waitpid(writer, nullptr, WNOHANG) == 0);
    EXPECT_EQ(said, "1") << "the writer was not seen at work";
    ::kill(writer, SIGKILL);
    codeOf(writer);
    auto saved = saveBuilding(*test::makeCampus({100}), m_source); // waits until the server has noticed
    ASSERT_TRUE(saved.ok()) << saved.error().text();
    EXPECT_EQ(read().regions.size(), test::campusData({100}).regions.size());
    EXPECT_EQ(before.substr(0, before.find(':')), read().revision.substr(0, before.find(':')));
}

TEST_F(Postgis, WhoCannotHaveTheirTurnAreTold) {
    fill();
    auto other = openVector(m_source, OpenMode::Update);
    ASSERT_TRUE(other.ok());
    (*other)->StartTransaction();
    (*other)->ExecuteSQL("UPDATE regions SET name = 'x'", nullptr, nullptr);
    std::string revision = read().revision; // readers never wait
    auto refused = saveBuilding(*test::makeCampus({100, 9}), m_source + " options='-c lock_timeout=50'");
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::Conflict);
    EXPECT_THAT(refused.error().text(), HasSubstr("someone else is changing it"));
    (*other)->RollbackTransaction();
    EXPECT_EQ(read().revision, revision);
    EXPECT_TRUE(saveBuilding(*test::makeCampus({100, 9}), m_source).ok());
}

TEST_F(Postgis, WhoMayOnlyReadIsToldWhenSaving) {
    fill();
    sql("GRANT SELECT ON ALL TABLES IN SCHEMA public TO guarded");
    std::string source = m_source + " user=guarded password=hunter2";
    auto loaded = loadBuilding(source);
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    auto refused = saveBuilding(*loaded->building, source);
    ASSERT_FALSE(refused.ok());
    EXPECT_THAT(refused.error().text(), HasSubstr("right"));
    EXPECT_THAT(refused.error().text(), Not(HasSubstr("hunter2")));
    Said wrong = shell(farolCli + " map info 'PG:dbname=" + m_database + " user=guarded password=hunter3'");
    EXPECT_EQ(wrong.code, 1);
    EXPECT_THAT(wrong.text, HasSubstr("cannot be opened"));
    EXPECT_THAT(wrong.text, Not(HasSubstr("hunter3")));
}

TEST_F(Postgis, DatabasesThatHoldNoMapAreSaidSo) {
    auto empty = loadBuilding(m_source);
    ASSERT_FALSE(empty.ok());
    EXPECT_EQ(empty.error().code, ErrorCode::UnsupportedFormat) << empty.error().text();
    EXPECT_FALSE(loadBuilding("PG:dbname=nobody_made_this").ok());
    ASSERT_EQ(shell("createdb plain_" + m_database).code, 0);
    auto plain = saveBuilding(*test::makeCampus({100}), "PG:dbname=plain_" + m_database);
    ASSERT_FALSE(plain.ok());
    EXPECT_THAT(plain.error().text(), HasSubstr("PostGIS"));
    fill();
    sql("UPDATE regions SET level = 'NaN' WHERE region_id = 'w1'");
    auto damaged = loadBuilding(m_source);
    ASSERT_FALSE(damaged.ok());
    EXPECT_THAT(damaged.error().text(), HasSubstr("layer regions, feature w1"));
    sql("UPDATE regions SET level = 0; UPDATE farol SET value = '99' WHERE key = 'schema'");
    EXPECT_EQ(loadBuilding(m_source).error().code, ErrorCode::UnsupportedFormat);
    EXPECT_FALSE(saveBuilding(*test::makeCampus({100}), m_source).ok())
        << "a later Farol's map is not overwritten";
}

TEST_F(Postgis, SeveralCampusesLiveInSchemasOfOneDatabase) {
    sql("CREATE SCHEMA gambelas; CREATE SCHEMA penha");
    std::string gambelas = m_source + " active_schema=gambelas", penha = m_source + " active_schema=penha";
    ASSERT_TRUE(saveBuilding(*test::makeCampus({100}), gambelas).ok());
    auto saved = saveBuilding(*test::makeCampus({300}), penha);
    ASSERT_TRUE(saved.ok()) << saved.error().text();
    auto first = loadBuilding(gambelas), second = loadBuilding(penha);
    ASSERT_TRUE(first.ok()) << first.error().text();
    ASSERT_TRUE(second.ok()) << second.error().text();
    EXPECT_EQ(first->building->regions().size(), test::campusData({100}).regions.size());
    EXPECT_EQ(second->building->regions().size(), test::campusData({300}).regions.size());
    BuildingData data = first->building->data();
    data.regions[0].name = "Bar";
    EXPECT_TRUE(saveToDatabase(Building(data), gambelas).ok());
    EXPECT_FALSE(loadBuilding(m_source).ok()) << "the other schemas hold no map";
}

} // namespace
} // namespace farol::building

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (argc > 1) farol::building::farolCli = argv[1];
    return RUN_ALL_TESTS();
}
