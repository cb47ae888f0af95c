#include "core/building/adjacency.h"
#include "core/building/building.h"
#include "tests/support/ascii_map.h"
#include "tests/support/campus.h"

#include <gmock/gmock.h>
#include <random>
#include <set>

namespace farol::building {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Adjacency, joinsBothWaysAndOnce) {
    Adjacency map(4, {{0, 1}, {1, 0}, {0, 1}, {2, 0}, {3, 3}, {1, 7}});
    EXPECT_TRUE(map.joined(0, 1));
    EXPECT_TRUE(map.joined(1, 0));
    EXPECT_FALSE(map.joined(1, 2));
    EXPECT_FALSE(map.joined(3, 3));
    EXPECT_FALSE(map.joined(1, 7));
    EXPECT_FALSE(map.joined(7, 1));
    EXPECT_THAT(map.row(0), ElementsAre(1U, 2U));
    EXPECT_THAT(map.row(3), IsEmpty());
    EXPECT_THAT(map.row(7), IsEmpty());
}

TEST(Adjacency, nothingAtAll) {
    EXPECT_EQ(Adjacency().size(), 0U);
    EXPECT_FALSE(Adjacency().joined(0, 0));
    EXPECT_THAT(Adjacency(0, {{0, 0}}).row(0), IsEmpty());
    EXPECT_THAT(Adjacency(1, {}).row(0), IsEmpty());
}

TEST(Adjacency, takesTheSmallerForm) {
    std::vector<std::pair<std::size_t, std::size_t>> chain, all;
    for (std::size_t i = 0; i + 1 < 2000; ++i) chain.emplace_back(i, i + 1);
    for (std::size_t i = 0; i < 300; ++i)
        for (std::size_t j = 0; j < i; ++j) all.emplace_back(i, j);
    EXPECT_FALSE(Adjacency(40, {{0, 1}, {1, 2}}).isMatrix()) << "40 words, but 45 numbers of half a word";
    Adjacency dense(300, all), sparse(2000, chain);
    EXPECT_TRUE(dense.isMatrix());
    EXPECT_EQ(dense.bytes(), 300U * 5 * 8);
    EXPECT_FALSE(sparse.isMatrix());
    EXPECT_EQ(sparse.bytes(), (2001U + 2 * 1999) * 4);
}

TEST(Adjacency, bothFormsSayTheSame) {
    std::mt19937 random(3);
    for (std::size_t size : {63U, 64U, 65U, 200U}) {
        for (std::size_t joins : {10U, 5000U}) {
            std::vector<std::pair<std::size_t, std::size_t>> pairs;
            std::set<std::pair<std::size_t, std::size_t>> known;
            for (std::size_t i = 0; i < joins; ++i) {
                std::size_t a = random() % size, b = random() % size;
                pairs.emplace_back(a, b);
                if (a != b) known.insert({{a, b}, {b, a}});
            }
            Adjacency map(size, pairs);
            for (std::size_t a = 0; a < size; ++a) {
                std::vector<std::size_t> row;
                for (std::size_t b = 0; b < size; ++b) {
                    EXPECT_EQ(map.joined(a, b), known.count({a, b}) != 0);
                    if (map.joined(a, b)) row.push_back(b);
                }
                EXPECT_EQ(map.row(a), row);
            }
        }
    }
}

TEST(Adjacency, ofABuilding) {
    auto building = test::asciiMap(R"(
        +---+---+---+
        |A  /B  *C  |
        +-%-+---+-/-+
        |D          |
        +-----------+
    )");
    Adjacency map = adjacencyOf(*building);
    EXPECT_THAT(map.row(0), ElementsAre(1U)) << "neither through windows nor closed doors";
    EXPECT_TRUE(map.joined(2, 3));
    EXPECT_FALSE(map.joined(1, 2));
}

TEST(Adjacency, ofACampus) {
    auto building = test::makeCampus({});
    Adjacency map = adjacencyOf(*building);
    EXPECT_FALSE(map.isMatrix());
    for (std::size_t i = 0; i < building->regions().size(); ++i) {
        auto row = building->neighboursOf(i);
        EXPECT_EQ(map.row(i), std::vector<std::size_t>(row.begin(), row.end()));
    }
}

} // namespace
} // namespace farol::building
