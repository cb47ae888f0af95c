// Adding to and taking from an index, and a recogniser that follows its library.

#include "core/recognition/byte_index.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/training.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "drawn_pictures.h"

namespace farol::recognition {
namespace {

cv::Mat rowsFrom(int count, std::uint64_t seed) {
    cv::Mat rows(count, 128, CV_8U);
    cv::RNG draw(seed);
    draw.fill(rows, cv::RNG::UNIFORM, 0, 120);
    return rows;
}

/// The nearest row to each of the queries.
std::vector<int> nearest(const ByteIndex& index, const cv::Mat& queries) {
    Neighbours found = index.search(queries, 4, 4000);
    std::vector<int> rows;
    for (int query = 0; query < queries.rows; ++query)
        rows.push_back(found.rows[static_cast<std::size_t>(query * found.each)]);
    return rows;
}

TEST(ByteIndex, FindsWhatIsAddedLaterAndNotWhatIsTakenOut) {
    ByteIndex index;
    cv::Mat first = rowsFrom(900, 1), later = rowsFrom(200, 2);
    index.add(first);
    index.add(later);
    auto found = nearest(index, later);
    for (int i = 0; i < later.rows; ++i) EXPECT_EQ(found[static_cast<std::size_t>(i)], 900 + i);
    index.remove(100, 300);
    EXPECT_EQ(index.living(), 800);
    EXPECT_EQ(index.size(), 1100);
    found = nearest(index, first);
    for (int i = 0; i < first.rows; ++i) {
        int row = found[static_cast<std::size_t>(i)];
        EXPECT_EQ(row == i, i < 100 || i >= 400) << i;
        EXPECT_FALSE(row >= 100 && row < 400) << i;
    }
    index.remove(100, 300); // again: nothing more to take
    index.remove(-5, 3);
    index.remove(5000, 10);
    EXPECT_EQ(index.living(), 800);
}

TEST(ByteIndex, WhatIsTakenOutStaysAwayWhenTheIndexIsMadeAnew) {
    ByteIndex index;
    cv::Mat first = rowsFrom(300, 3);
    index.add(first);
    index.remove(0, 150);
    index.add(rowsFrom(700, 4)); // more than doubles it
    for (int row : nearest(index, first)) EXPECT_GE(row, 150);
}

TEST(ByteIndex, ACopyGoesItsOwnWay) {
    ByteIndex index;
    index.add(rowsFrom(300, 5));
    ByteIndex copy(index);
    cv::Mat mine = rowsFrom(50, 6), its = rowsFrom(50, 7);
    index.add(mine);
    copy.add(its);
    copy.remove(0, 300);
    EXPECT_EQ(index.living(), 350);
    EXPECT_EQ(copy.living(), 50);
    EXPECT_EQ(nearest(index, mine).front(), 300);
    EXPECT_EQ(nearest(copy, its).front(), 300);
    EXPECT_EQ(index.distance(mine.ptr(0), 300), 0);
    EXPECT_EQ(copy.distance(its.ptr(0), 300), 0);
}

std::shared_ptr<LandmarkLibrary> posters(std::uint64_t from, std::uint64_t to) {
    auto library = std::make_shared<LandmarkLibrary>();
    for (std::uint64_t seed = from; seed <= to; ++seed) test::trainPoster(*library, seed);
    return library;
}

/// What is seen of the posters 1 to 8, hung one by one, as words.
std::vector<std::string> seenBy(const LandmarkRecogniser& recogniser) {
    std::vector<std::string> seen;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        cv::Mat picture = test::room(seed);
        test::hang(picture, test::poster(seed), quadOf({190, 130, 260, 195}));
        std::string line;
        for (const Detection& one : recogniser.recognise(picture).detections)
            line += one.templateId.value + " ";
        seen.push_back(line);
    }
    return seen;
}

TEST(RecogniserThatFollows, AnswersAsOneMadeAnew) {
    std::shared_ptr<const LandmarkLibrary> first = posters(1, 6);
    LandmarkRecogniser before(first);
    auto next = std::make_shared<LandmarkLibrary>(*first);
    ASSERT_TRUE(removeTemplate(*next, TemplateId("poster-3")));
    test::trainPoster(*next, 7);
    LandmarkRecogniser after(next, before);
    EXPECT_EQ(seenBy(after), seenBy(LandmarkRecogniser(next)));
    EXPECT_EQ(seenBy(after)[2], "");
    EXPECT_EQ(seenBy(after)[6], "poster-7 ");
    EXPECT_EQ(seenBy(before)[2], "poster-3 ") << "the one before is as it was";
    EXPECT_EQ(&after.library(), next.get());
}

TEST(RecogniserThatFollows, ATemplateTrainedAgainIsTheNewOne) {
    std::shared_ptr<const LandmarkLibrary> first = posters(1, 3);
    auto next = std::make_shared<LandmarkLibrary>(*first);
    removeTemplate(*next, TemplateId("poster-2"));
    test::trainPoster(*next, 8);
    next->templates.back().id = TemplateId("poster-2"); // another picture under the old name
    LandmarkRecogniser after(next, LandmarkRecogniser(first));
    EXPECT_EQ(seenBy(after)[1], "");
    EXPECT_EQ(seenBy(after)[7], "poster-2 ");
}

TEST(RecogniserThatFollows, AnEmptiedAndARefilledLibrary) {
    std::shared_ptr<const LandmarkLibrary> first = posters(1, 3);
    auto none = std::make_shared<LandmarkLibrary>();
    LandmarkRecogniser emptied(none, LandmarkRecogniser(first));
    EXPECT_EQ(seenBy(emptied), std::vector<std::string>(8));
    EXPECT_EQ(seenBy(LandmarkRecogniser(first, emptied)), seenBy(LandmarkRecogniser(first)));
}

} // namespace
} // namespace farol::recognition
