#include "core/building/import/importer.h"
#include "tests/support/temporary_folder.h"

#include <cstdint>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace {

using namespace farol;
using namespace farol::building;
using ::testing::HasSubstr;

struct Entry {
    std::string name, bytes;
    std::uint32_t claimedSize = 0; ///< 0: the true one
    bool encrypted = false;
};

std::string little(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text.push_back(static_cast<char>(value >> (8 * i) & 0xFFU));
    return text;
}

/// A zip of stored (unpacked) members; its check sums are zero, which listing does not look at.
std::string zipOf(const std::vector<Entry>& entries) {
    std::string body, directory;
    for (const Entry& entry : entries) {
        std::uint64_t size = entry.claimedSize != 0 ? entry.claimedSize : entry.bytes.size();
        std::string common = little(20, 2) + little(entry.encrypted ? 1 : 0, 2) + little(0, 2) +
                             little(0, 4) + little(0, 4) + little(entry.bytes.size(), 4) + little(size, 4) +
                             little(entry.name.size(), 2) + little(0, 2);
        directory += "PK\x01\x02" + little(20, 2) + common + little(0, 2) + little(0, 2) + little(0, 2) +
                     little(0, 4) + little(body.size(), 4) + entry.name;
        body += "PK\x03\x04" + common + entry.name + entry.bytes;
    }
    return body + directory + "PK\x05\x06" + little(0, 4) + little(entries.size(), 2) +
           little(entries.size(), 2) + little(directory.size(), 4) + little(body.size(), 4) + little(0, 2);
}

std::string messageFor(const std::vector<Entry>& entries) {
    test::TemporaryFolder folder;
    folder.write("map.zip", zipOf(entries));
    auto listing = listSource((folder / "map.zip").string());
    return listing.ok() ? "" : listing.error().text();
}

TEST(ImportListing, OneFileAFolderAndAZip) {
    test::TemporaryFolder folder;
    folder.write("unit10.geojson", "ten");
    folder.write("unit2.geojson", "two");
    auto one = listSource((folder / "unit2.geojson").string());
    ASSERT_TRUE(one.ok());
    ASSERT_EQ(one->members.size(), 1U);
    EXPECT_EQ(one->head(one->members[0]), "two");
    auto all = listSource(folder.string());
    ASSERT_TRUE(all.ok());
    EXPECT_TRUE(all->folder);
    ASSERT_EQ(all->members.size(), 2U);
    EXPECT_EQ(all->members[0].name, "unit2.geojson") << "natural order";
    folder.write("map.imdf", zipOf({{"venue/unit.geojson", "packed"}, {"__MACOSX/unit.geojson", "litter"}}));
    auto zip = listSource((folder / "map.imdf").string());
    ASSERT_TRUE(zip.ok()) << zip.error().text();
    EXPECT_TRUE(zip->zip);
    ASSERT_EQ(zip->members.size(), 1U);
    ASSERT_NE(zip->find("UNIT.geojson"), nullptr);
    EXPECT_EQ(zip->find("unit.geojson")->name, "venue/unit.geojson");
}

TEST(ImportListing, NamesThatLeadOutAreRefused) {
    for (const char* name : {"../evil.geojson", "a/../../evil", "/etc/map", "C:\\map", "a\\..\\b"})
        EXPECT_THAT(messageFor({{name, "x"}}), HasSubstr("leads out")) << name;
    EXPECT_EQ(messageFor({{"a..b/..c/d", "x"}}), "") << "dots in a name are no way out";
}

TEST(ImportListing, BombsAndLockedZipsAreRefused) {
    EXPECT_THAT(messageFor({{"unit.geojson", "x", 800U << 20U}}), HasSubstr("too much"));
    EXPECT_THAT(messageFor({{"unit.geojson", "x", 0, true}}), HasSubstr("password"));
    std::vector<Entry> many;
    for (int i = 0; i < 10001; ++i) many.push_back({std::to_string(i), ""});
    EXPECT_THAT(messageFor(many), HasSubstr("more than 10000 files"));
}

TEST(ImportListing, DamagedZipsAreErrors) {
    test::TemporaryFolder folder;
    std::string whole = zipOf({{"unit.geojson", "content"}, {"level.geojson", "content"}});
    for (std::size_t size = 4; size < whole.size(); ++size) {
        folder.write("map.zip", whole.substr(0, size));
        auto listing = listSource((folder / "map.zip").string());
        EXPECT_FALSE(listing.ok()) << "cut at " << size;
    }
    for (std::size_t at = 4; at < whole.size(); ++at) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ 0x55);
        folder.write("map.zip", flipped);
        auto listing = listSource((folder / "map.zip").string());
        EXPECT_TRUE(listing.ok() || !listing.error().message.empty());
    }
}

TEST(ImportListing, WhatIsNotThereOrNoMapIsSaid) {
    EXPECT_EQ(listSource("/there/is/no/such.file").error().code, ErrorCode::NotFound);
    EXPECT_FALSE(listSource("").ok());
    EXPECT_FALSE(listSource("/vsicurl/http://localhost/map.zip").ok()) << "nothing is fetched";
    test::TemporaryFolder folder;
    EXPECT_FALSE(listSource(folder.string()).ok()) << "an empty folder";
    folder.write("letter.txt", "Dear Sir");
    auto imported = importBuilding((folder / "letter.txt").string());
    ASSERT_FALSE(imported.ok());
    EXPECT_EQ(imported.error().code, ErrorCode::UnsupportedFormat);
    EXPECT_THAT(imported.error().text(), HasSubstr("imdf, "));
}

TEST(ImportListing, FormatNamesReadBack) {
    for (const char* name :
         {"shapefile", "geopackage", "geojson", "imdf", "osm", "indoorgml", "hulop", "wrld"}) {
        auto format = mapFormatFromName(name);
        ASSERT_TRUE(format.has_value()) << name;
        EXPECT_EQ(mapFormatName(*format), name);
    }
    EXPECT_FALSE(mapFormatFromName("dwg").has_value());
}

} // namespace
