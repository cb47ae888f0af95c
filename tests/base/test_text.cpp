#include "core/base/text.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace farol {
namespace {

TEST(EditDistance, CountsCodePointsNotBytes) {
    EXPECT_EQ(editDistance("2.14", "2.14"), 0);
    EXPECT_EQ(editDistance("2.14", "2.l4"), 1);
    EXPECT_EQ(editDistance("saída", "saida"), 1);
    EXPECT_EQ(editDistance("", "ABC"), 3);
    EXPECT_EQ(editDistance("\xff\xc3", "\xff"), 1) << "malformed bytes count one each";
}

TEST(Folding, MakesNamesComparable) {
    EXPECT_EQ(foldedForMatching("  Sala   de Reuniões "), "SALA DE REUNIOES");
    EXPECT_EQ(foldedForMatching("Sortié"), foldedForMatching("SORTIE"));
    EXPECT_EQ(foldedForMatching("\t \n"), "");
    EXPECT_EQ(foldedForMatching("階段"), "階段");
}

TEST(NaturalOrder, DigitsCompareByValue) {
    std::vector<std::string> names{"10.jpg", "2.jpg", "1.jpg", "a10b2", "a10b10", "a2"};
    std::sort(names.begin(), names.end(), naturalLess);
    EXPECT_EQ(names, (std::vector<std::string>{"1.jpg", "2.jpg", "10.jpg", "a2", "a10b2", "a10b10"}));
}

TEST(NaturalOrder, IsStrictEvenForEqualValues) {
    EXPECT_TRUE(naturalLess("01", "1") != naturalLess("1", "01"));
    EXPECT_FALSE(naturalLess("7.jpg", "7.jpg"));
    EXPECT_TRUE(naturalLess("99999999999999999998", "99999999999999999999"))
        << "longer than any integer type";
}

TEST(Numbers, ReadBackTheSameInEveryLocale) {
    EXPECT_EQ(formatNumber(0.5), "0.5");
    EXPECT_EQ(formatNumber(-2.0), "-2");
    EXPECT_EQ(std::stod(formatNumber(0.1 + 0.2)), 0.1 + 0.2);
}

} // namespace
} // namespace farol
