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

} // namespace
} // namespace farol::building
