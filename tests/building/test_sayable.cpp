#include "core/building/sayable.h"

#include <gtest/gtest.h>

namespace farol::building {
namespace {

TEST(Sayable, WhatStandsForANameIsNoName) {
    for (const char* name :
         {"input name here", "Input Name Here", "unnamed", "UNNAMED ROOM", "<unnamed>", "tbd", "TBD.", "???",
          "", "  ", "-", "n/a", "null", "Untitled", "Region 12", "polygon7", "sem nome"})
        EXPECT_TRUE(isPlaceholderName(name)) << name;
}

TEST(Sayable, NamesOfPeopleAndPlacesAreNames) {
    for (const char* name :
         {"Library", "2.14", "C0.01", "001", "Room 12", "A", "Café", "Sala do Conselho", "会議室", "B-12",
          "Dr. Silva", "Name of the Rose", "F0hall00", "WC", "Testing room"}) {
        EXPECT_FALSE(isPlaceholderName(name)) << name;
        EXPECT_TRUE(isSayable(name)) << name;
    }
}

TEST(Sayable, NumbersOfProgramsAreNotSaid) {
    for (const char* name :
         {"3d2f9a0b-77c1-4e4e-9d5a-0a1b2c3d4e5f", "1234567", "way/123456789", "{12}", "https://x.org/a"})
        EXPECT_FALSE(isSayable(name)) << name;
    EXPECT_FALSE(isSayable(std::string(200, 'x')));
}

TEST(Sayable, TheRefStandsInForAPlaceholder) {
    Region region;
    region.id = RegionId("r_00017");
    EXPECT_EQ(sayableName(region), "") << "never the id";
    region.ref = "2.14";
    region.name = "TBD";
    EXPECT_EQ(sayableName(region), "2.14");
    region.ref = "null";
    EXPECT_EQ(sayableName(region), "");
}

TEST(Sayable, NamesInALanguageFallBackToTheMapsOwn) {
    Region region;
    region.id = RegionId("r1");
    region.name = "Library";
    region.extra["name_pt"] = std::string("Biblioteca");
    region.extra["name:de"] = std::string("Bibliothek");
    region.extra["name_fr"] = std::string();
    region.extra["name_es"] = std::string("TBD");
    EXPECT_EQ(nameIn(region, "pt"), "Biblioteca");
    EXPECT_EQ(sayableName(region, "pt"), "Biblioteca");
    EXPECT_EQ(sayableName(region, "de"), "Bibliothek");
    EXPECT_EQ(sayableName(region, "fr"), "Library") << "an empty name is none";
    EXPECT_EQ(sayableName(region, "es"), "Library") << "a placeholder is none";
    EXPECT_EQ(sayableName(region, "fi"), "Library");
    EXPECT_EQ(sayableName(region), "Library");
    EXPECT_EQ(spokenName(region, "pt"), "Biblioteca");
    EXPECT_EQ(spokenName(region, ""), "Library");
    region.extra["name_pt"] = std::int64_t{7};
    EXPECT_EQ(nameIn(region, "pt"), "Library") << "a number is no name";
}

} // namespace
} // namespace farol::building
