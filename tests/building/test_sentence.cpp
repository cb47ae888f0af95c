// What is said of a map: the table of sentences is sound, and the English of it is what scripts have always
// read.
#include "core/building/checks.h"
#include "tests/support/ascii_map.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

namespace farol::building {
namespace {

using ::testing::Contains;

/// The places of a text as they follow each other, and the count behind them.
std::vector<std::string> placesOf(const std::string& text) {
    std::vector<std::string> places;
    for (std::size_t i = 0; i + 1 < text.size(); ++i)
        if (text[i] == '%' && (text[i + 1] == 'n' || (text[i + 1] >= '1' && text[i + 1] <= '9')))
            places.push_back(text.substr(i, 2));
    std::stable_partition(places.begin(), places.end(),
                          [](const std::string& place) { return place != "%n"; });
    return places;
}

TEST(Sentences, TheTableIsSound) {
    std::set<std::string> texts;
    std::size_t number = 0;
    for (const SentenceText& row : allSentences()) {
        EXPECT_EQ(&textOf(row.sentence), &row) << row.text;
        EXPECT_TRUE(texts.insert(row.text).second) << "twice: " << row.text;
        if (number++ == 0) continue; // nothing is said there
        std::vector<std::string> places = placesOf(row.text);
        for (std::size_t i = 0; i < places.size(); ++i)
            EXPECT_EQ(places[i], i + 1 == places.size() && row.counts() ? "%n" : "%" + std::to_string(i + 1))
                << row.text;
        if (row.one == nullptr) continue;
        EXPECT_TRUE(row.counts()) << row.text;
        EXPECT_EQ(placesOf(row.one), places) << row.one;
    }
    EXPECT_GT(number, 100U);
}

TEST(Sentences, WhatIsPutInIsNotReadAgain) {
    EXPECT_EQ(withPlaces("%1 and %2", {"%2", "b"}), "%2 and b");
    EXPECT_EQ(withPlaces("12 % of %1, %3", {"all"}), "12 % of all, %3");
    EXPECT_EQ(said(Sentence::AccessFarFromRegion, "%2", "100 %").english(),
              "access \"%2\" lies more than 1 m from region \"100 %\"; move it to the border");
    EXPECT_EQ(counted(Sentence::IdShared, 3, "%n").english(),
              "3 features share the id \"%n\"; give each its own");
}

TEST(Sentences, NumbersAndListsAreWrittenOut) {
    EXPECT_EQ(
        said(Sentence::ShaftMissesLevel, "lift", std::vector<double>{-1.0, 0.5}).english(),
        "shaft \"lift\" passes level -1, 0.5 without an access there; add it, unless it does not stop there");
    EXPECT_EQ(said(Sentence::RegionSliver, "s", 0.12).english(),
              "region \"s\" is a sliver, about 0.12 m wide: nobody stands there; join it to its neighbour");
    EXPECT_EQ(counted(Sentence::AccessKindUnknown, 1, "gate", Argument::Is::AccessKinds).english(),
              "1 feature has the unknown kind \"gate\"; known are door, opening, stairs, elevator, "
              "escalator, ramp, "
              "window, other (nobody is led through other)");
    EXPECT_EQ(counted(Sentence::KindUnknown, 2, "cave", Argument::Is::RegionKinds).english(),
              "2 features have the unknown kind \"cave\"; known are room, corridor, hall, stairwell, "
              "elevator, toilet, "
              "outside, other");
}

TEST(Sentences, TheEnglishOfTheMapCheckStaysAsItWas) {
    test::AsciiMap map;
    map.floor("+---+---+---+---+\n|A  /B  /C  |D  |\n|e  |   |   |   |\n+---+---+---+---+");
    map.landmark('e', {Kind::Extinguisher});
    BuildingData data = map.data();
    data.levels.clear();
    data.regions[1].name.clear();
    data.regions[1].ref.clear();
    data.regions[2].polygon.holes.push_back({{0.0, 0.0}, {1.0, 0.0}});
    data.landmarks[0].region = RegionId("nowhere");
    std::vector<std::string> messages;
    for (const Finding& finding : checkBuilding(Building(data))) {
        EXPECT_EQ(finding.message, finding.said.english());
        messages.push_back(finding.message);
    }
    for (const char* message :
         {"the outline of region \"C\" has a hole that has fewer than three corners; draw it again",
          "landmark \"e\" names the region \"nowhere\", which does not exist; correct it",
          "1 region has neither name nor ref: only its kind is spoken",
          "level 0 is used by 4 regions but is not in the layer levels: its name cannot be spoken; add it",
          "the building falls into 2 parts; 1 region cannot be reached from the largest (3 regions): "
          "accesses are "
          "missing or closed",
          "1 region has no door or other access that joins another region: nobody can be led there; add it"})
        EXPECT_THAT(messages, Contains(message));
}

} // namespace
} // namespace farol::building
