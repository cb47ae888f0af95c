#include "core/building/import/level_parser.h"

#include <clocale>
#include <gtest/gtest.h>
#include <string>

namespace {

using farol::building::parseLevels;
using Levels = std::vector<double>;

Levels levelsOf(const std::string& text) {
    auto parsed = parseLevels(text);
    EXPECT_TRUE(parsed.understood) << text;
    return parsed.levels;
}

TEST(LevelParser, ReadsListsAndRanges) {
    EXPECT_EQ(levelsOf(""), Levels{});
    EXPECT_EQ(levelsOf("0"), Levels{0});
    EXPECT_EQ(levelsOf("-1"), Levels{-1});
    EXPECT_EQ(levelsOf("-1;0"), (Levels{-1, 0}));
    EXPECT_EQ(levelsOf("0.5;0.7"), (Levels{0.5, 0.7}));
    EXPECT_EQ(levelsOf("1-3"), (Levels{1, 2, 3}));
    EXPECT_EQ(levelsOf("-1-5"), (Levels{-1, 0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(levelsOf("-4--2"), (Levels{-4, -3, -2}));
    EXPECT_EQ(levelsOf("0;2-3;5"), (Levels{0, 2, 3, 5}));
    EXPECT_EQ(levelsOf("5-3"), (Levels{3, 4, 5}));
    EXPECT_EQ(levelsOf(" 1 ; 2 "), (Levels{1, 2}));
    EXPECT_EQ(levelsOf("1 - 3"), (Levels{1, 2, 3}));
    EXPECT_EQ(levelsOf("-1;-2;0"), (Levels{-2, -1, 0}));
    EXPECT_EQ(levelsOf("1;1;1"), Levels{1});
    EXPECT_EQ(levelsOf("0.5-2"), (Levels{0.5, 1, 2}));
}

TEST(LevelParser, ForgivesCommonMistakes) {
    EXPECT_EQ(levelsOf("1,5"), Levels{1.5});
    EXPECT_EQ(levelsOf("0,-1"), (Levels{-1, 0}));
    EXPECT_EQ(levelsOf("0, 1"), (Levels{0, 1}));
    EXPECT_EQ(levelsOf("0,1,2"), (Levels{0, 1, 2}));
    EXPECT_EQ(levelsOf("0,5;1"), (Levels{0.5, 1}));
    EXPECT_EQ(levelsOf("1;"), Levels{1});
    EXPECT_EQ(levelsOf("+2"), Levels{2});
    EXPECT_EQ(levelsOf("\xE2\x88\x92"
                       "1"),
              Levels{-1});
}

TEST(LevelParser, TellsWhatItCannotRead) {
    for (const char* junk :
         {"EG", "1-", "--", "1 2", "nan", "inf", "1e3", "0x1", "1.2.3", "1-2-3", "99999999", "-"})
        EXPECT_FALSE(parseLevels(junk).understood) << junk;
    auto partly = parseLevels("EG;1");
    EXPECT_EQ(partly.levels, Levels{1});
    EXPECT_FALSE(partly.understood);
}

TEST(LevelParser, RefusesThousandsOfLevels) {
    EXPECT_EQ(levelsOf("0-999").size(), 1000U);
    EXPECT_FALSE(parseLevels("0-5000").understood);
    EXPECT_TRUE(parseLevels("0-5000").levels.empty());
    std::string many;
    for (int i = 0; i < 40; ++i) many += std::to_string(i * 100) + "-" + std::to_string(i * 100 + 99) + ";";
    EXPECT_FALSE(parseLevels(many).understood);
    EXPECT_TRUE(parseLevels(many).levels.empty());
    EXPECT_FALSE(parseLevels(std::string(100000, '-')).understood);
}

TEST(LevelParser, DoesNotDependOnTheLocale) {
    std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "pt_PT.UTF-8"}) std::setlocale(LC_ALL, name);
    EXPECT_EQ(levelsOf("0.5"), Levels{0.5});
    std::setlocale(LC_ALL, before.c_str());
}

} // namespace
