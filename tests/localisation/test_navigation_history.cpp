#include "tests/localisation/walk.h"

#include <gtest/gtest.h>

using namespace farol;
using namespace farol::localisation;
using farol::test::seen;

namespace {

Observation at(recognition::Detection detection, std::uint64_t frame, int scene) {
    return {std::move(detection), 0.1 * static_cast<double>(frame), frame, scene};
}

const ImageBox kLeft{50, 100, 80, 120}, kRight{450, 100, 80, 120};

TEST(NavigationHistory, KeepsTheLastFourOldestFirst) {
    NavigationHistory history;
    for (int i = 0; i < 6; ++i) history.add({at(seen(Kind::Door, {}, {}), static_cast<std::uint64_t>(i), i)});
    ASSERT_EQ(history.items().size(), 4U);
    EXPECT_EQ(history.items().front().scene, 2);
    EXPECT_EQ(history.items().back().scene, 5);
}

TEST(NavigationHistory, OneObjectInManyFramesOfAScenesIsOneObject) {
    NavigationHistory history;
    EXPECT_EQ(history.add({at(seen(Kind::Door), 1, 0)}).size(), 1U);
    recognition::Detection again = seen(Kind::Door, {}, {}, {105, 102, 80, 120});
    again.score = 0.95;
    EXPECT_TRUE(history.add({at(again, 2, 0)}).empty());
    ASSERT_EQ(history.items().size(), 1U);
    EXPECT_EQ(history.items().front().frame, 2U);
    EXPECT_DOUBLE_EQ(history.items().front().detection.score, 0.95);
    EXPECT_DOUBLE_EQ(boundingBox(history.items().front().detection.quad).x, 105.0);
}

TEST(NavigationHistory, AWeakerRepeatKeepsTheBetterScore) {
    NavigationHistory history;
    history.add({at(seen(Kind::Door), 1, 0)});
    recognition::Detection weaker = seen(Kind::Door);
    weaker.score = 0.2;
    history.add({at(weaker, 2, 0)});
    EXPECT_DOUBLE_EQ(history.items().front().detection.score, 0.8);
}

TEST(NavigationHistory, TwoDoorsOfOneFrameAreTwo) {
    NavigationHistory history;
    auto fresh =
        history.add({at(seen(Kind::Door, {}, {}, kLeft), 1, 0), at(seen(Kind::Door, {}, {}, kRight), 1, 0)});
    EXPECT_EQ(fresh.size(), 2U);
}

TEST(NavigationHistory, TheSameDoorTwiceInOneFrameIsOne) {
    NavigationHistory history;
    EXPECT_EQ(history.add({at(seen(Kind::Door), 1, 0), at(seen(Kind::Door), 1, 0)}).size(), 1U);
}

TEST(NavigationHistory, ANewSceneMakesANewObject) {
    NavigationHistory history;
    history.add({at(seen(Kind::Door), 1, 0)});
    EXPECT_EQ(history.add({at(seen(Kind::Door), 2, 1)}).size(), 1U);
}

TEST(NavigationHistory, ATrainedObjectThatMovesThroughThePictureStaysOne) {
    NavigationHistory history;
    history.add({at(seen(Kind::Poster, "fair", {}, kLeft), 1, 0)});
    EXPECT_TRUE(history.add({at(seen(Kind::Poster, "fair", {}, kRight), 2, 0)}).empty());
    EXPECT_EQ(history.add({at(seen(Kind::Poster, "fair", {}, kRight), 3, 1)}).size(), 1U);
    EXPECT_EQ(history.items().size(), 2U);
}

TEST(NavigationHistory, TwoCopiesOfATrainedObjectInOneFrameAreTwo) {
    NavigationHistory history;
    EXPECT_EQ(history
                  .add({at(seen(Kind::Sign, "exit", {}, kLeft), 1, 0),
                        at(seen(Kind::Sign, "exit", {}, kRight), 1, 0)})
                  .size(),
              2U);
}

TEST(NavigationHistory, APlaceComeBackToCountsOnceAsTheNewest) {
    NavigationHistory history;
    history.add({at(seen(Kind::Place, "p1"), 1, 0)});
    history.add({at(seen(Kind::Place, "p2"), 2, 1)});
    EXPECT_EQ(history.add({at(seen(Kind::Place, "p1"), 3, 2)}).size(), 1U);
    ASSERT_EQ(history.items().size(), 2U);
    EXPECT_EQ(history.items().back().detection.templateId.value, "p1");
}

TEST(NavigationHistory, OtherWordsAtTheSameSpotAreAnotherObject) {
    NavigationHistory history;
    history.add({at(seen(Kind::Text, {}, "2.14"), 1, 0)});
    EXPECT_EQ(history.add({at(seen(Kind::Text, {}, "2.15"), 2, 0)}).size(), 1U);
}

Observation followed(const recognition::Detection& detection, std::uint64_t frame, int scene,
                     std::uint64_t track) {
    Observation observation = at(detection, frame, scene);
    observation.track = track;
    return observation;
}

TEST(NavigationHistory, AFollowedObjectIsOneObservationWhateverTheSceneAndThePlaceInThePicture) {
    NavigationHistory history;
    std::size_t fresh = 0;
    for (std::uint64_t i = 0; i < 30; ++i) {
        ImageBox box{20.0 + 15.0 * static_cast<double>(i), 100, 60, 120};
        fresh += history.add({followed(seen(Kind::Door, "", "", box), i, static_cast<int>(i / 7), 5)}).size();
    }
    EXPECT_EQ(fresh, 1U);
    ASSERT_EQ(history.items().size(), 1U);
    EXPECT_NEAR(history.items().front().time, 2.9, 1e-9);
}

TEST(NavigationHistory, TwoFollowedCopiesOfATrainedObjectStayTwo) {
    NavigationHistory history;
    std::size_t fresh = 0;
    for (std::uint64_t i = 0; i < 10; ++i) {
        double x = 100.0 + static_cast<double>(i);
        Observation left = followed(seen(Kind::Extinguisher, "red", "", {x, 100, 50, 90}), i, 0, 1);
        Observation right = followed(seen(Kind::Extinguisher, "red", "", {x + 200, 100, 50, 90}), i, 0, 2);
        fresh += history.add(i % 2 == 0 ? std::vector{left, right} : std::vector{right, left}).size();
    }
    EXPECT_EQ(fresh, 2U);
    ASSERT_EQ(history.items().size(), 2U);
    EXPECT_NE(history.items()[0].track, history.items()[1].track);
    EXPECT_NEAR(history.items()[0].detection.quad[0].x, 109.0, 1e-9);
    EXPECT_NEAR(history.items()[1].detection.quad[0].x, 309.0, 1e-9);
}

TEST(NavigationHistory, AFollowedObjectThatNewerOnesPushedOutIsNotCountedAgain) {
    NavigationHistory history;
    Observation door = followed(seen(Kind::Door, "", "", kLeft), 0, 0, 1);
    EXPECT_EQ(history.add({door}).size(), 1U);
    for (std::uint64_t i = 2; i < 6; ++i)
        history.add({followed(seen(Kind::Poster, "p" + std::to_string(i)), i, 0, i)});
    EXPECT_TRUE(history.add({door}).empty());
    EXPECT_EQ(history.items().size(), 4U);
    history.clear();
    EXPECT_EQ(history.add({door}).size(), 1U);
}

TEST(NavigationHistory, ATrackThatWasLostAndBeganAnewInOneSceneIsStillOneTrainedObject) {
    NavigationHistory history;
    history.add({followed(seen(Kind::Poster, "map", "", kLeft), 0, 3, 1)});
    EXPECT_TRUE(history.add({followed(seen(Kind::Poster, "map", "", kRight), 9, 3, 2)}).empty());
    EXPECT_EQ(history.items().size(), 1U);
}

TEST(NavigationHistory, ClearForgets) {
    NavigationHistory history;
    history.add({at(seen(Kind::Door), 1, 0)});
    history.clear();
    EXPECT_TRUE(history.items().empty());
    EXPECT_EQ(history.add({at(seen(Kind::Door), 2, 0)}).size(), 1U);
}

TEST(NavigationHistory, OptionsOutOfRangeAreRefused) {
    EXPECT_TRUE(HistoryOptions{}.check().ok());
    EXPECT_FALSE((HistoryOptions{0, 0.5}.check().ok()));
    EXPECT_FALSE((HistoryOptions{4, 1.5}.check().ok()));
}

} // namespace
