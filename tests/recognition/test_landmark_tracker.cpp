// Things followed through drawn pictures: a wall with posters, a camera that pans and walks.

#include "core/recognition/landmark_tracker.h"
#include "tests/recognition/drawn_pictures.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace farol::recognition {
namespace {

constexpr double kPeriod = 1.0 / 30.0;

/// A wall of twice the view's width with posters on it, seen through a camera that is moved along it.
class Wall {
public:
    explicit Wall(std::uint64_t seed = 1) : m_wall(test::room(seed, {1400, 700})) {}

    void hang(std::uint64_t poster, const Quad& quad) { test::hang(m_wall, test::poster(poster), quad); }
    Wall covered(cv::Rect where) const {
        Wall other = *this;
        other.m_wall = m_wall.clone();
        cv::rectangle(other.m_wall, where, cv::Scalar(60, 60, 60), cv::FILLED);
        return other;
    }

    /// The view 640 x 480 whose left upper corner is at `at`, made larger by `zoom` about its middle.
    cv::Mat seenFrom(cv::Point2d at, double zoom = 1.0) const {
        cv::Matx23d toView(zoom, 0, 320 - zoom * (at.x + 320), 0, zoom, 240 - zoom * (at.y + 240));
        cv::Mat view;
        cv::warpAffine(m_wall, view, toView, {640, 480}, cv::INTER_LINEAR, cv::BORDER_REFLECT);
        return view;
    }
    static Quad inView(const Quad& onWall, cv::Point2d at, double zoom = 1.0) {
        Quad quad;
        for (std::size_t i = 0; i < 4; ++i)
            quad[i] = {320 + zoom * (onWall[i].x - at.x - 320), 240 + zoom * (onWall[i].y - at.y - 240)};
        return quad;
    }

private:
    cv::Mat m_wall;
};

Detection sight(Kind kind, const std::string& templateId, const Quad& quad) {
    Detection detection;
    detection.kind = kind;
    detection.templateId = TemplateId(templateId);
    detection.quad = quad;
    detection.image = {640, 480};
    detection.score = 0.9;
    return detection;
}

/// Feeds frames of 30 a second.
struct Film {
    LandmarkTracker tracker;
    std::uint64_t frame = 0;
    std::uint64_t oldestNeeded = ~std::uint64_t{0};
    int scene = 0;

    void show(const cv::Mat& picture, bool cut = false) {
        if (cut) ++scene;
        std::uint64_t index = frame++;
        tracker.advance(picture, index, kPeriod * static_cast<double>(index), scene, cut,
                        std::min(index, oldestNeeded));
    }
    std::vector<Detection> see(const std::vector<Detection>& found, bool complete = true) {
        return tracker.join(Sense::Landmarks, frame - 1, found, complete);
    }
    std::vector<std::string> ended() {
        std::vector<std::string> reasons;
        for (const Rejection& one : tracker.takeEnded()) reasons.push_back(one.reason);
        return reasons;
    }
};

const Quad kPoster = quadOf({500, 250, 120, 90});

TEST(LandmarkTracker, AThingPassedIsOneTrackThatStaysWhereItHangs) {
    Wall wall;
    wall.hang(3, kPoster);
    Film film;
    std::uint64_t track = 0;
    for (int i = 0; i < 30; ++i) {
        cv::Point2d at(200.0 + 8.0 * i, 100.0);
        double zoom = 1.0 + 0.01 * i;
        film.show(wall.seenFrom(at, zoom));
        Quad truth = Wall::inView(kPoster, at, zoom);
        if (i % 10 == 0) {
            auto joined = film.see({sight(Kind::Poster, "p", truth)});
            ASSERT_EQ(joined.size(), 1U);
            if (i == 0) track = joined[0].track;
            EXPECT_EQ(joined[0].track, track);
            EXPECT_EQ(joined[0].confirmations, 1 + i / 10);
        }
        auto tracks = film.tracker.tracks();
        ASSERT_EQ(tracks.size(), 1U) << "frame " << i;
        EXPECT_EQ(tracks[0].now.track, track);
        EXPECT_GT(test::sharedArea(tracks[0].now.quad, truth), 0.9) << "frame " << i;
    }
    ASSERT_TRUE(film.tracker.tracks()[0].growth);
    EXPECT_NEAR(*film.tracker.tracks()[0].growth, 0.3, 0.1) << "it comes nearer by a hundredth a frame";
}

TEST(LandmarkTracker, RangeAndBearingGoWithTheThing) {
    Wall wall;
    wall.hang(3, kPoster);
    Film film;
    Detection first = sight(Kind::Poster, "p", Wall::inView(kPoster, {240, 55}));
    first.rangeM = 4.0;
    first.bearing = Radians{0.0};
    film.show(wall.seenFrom({240, 55}));
    film.see({first});
    for (int i = 1; i <= 10; ++i) film.show(wall.seenFrom({240.0 - 10.0 * i, 55}, 1.0 + 0.02 * i));
    auto tracks = film.tracker.tracks();
    ASSERT_EQ(tracks.size(), 1U);
    EXPECT_NEAR(tracks[0].now.rangeM.value(), 4.0 / 1.2, 0.15);
    EXPECT_LT(tracks[0].now.bearing->value, -0.15) << "to the right is negative";
}

TEST(LandmarkTracker, ASlowAnswerGivesTheSameTracksAsAQuickOne) {
    Wall wall;
    wall.hang(3, kPoster);
    wall.hang(5, quadOf({720, 300, 100, 130}));
    Quad second = quadOf({720, 300, 100, 130});
    auto viewAt = [](int i) { return cv::Point2d(250.0 + 6.0 * i, 120.0 + 2.0 * i); };
    auto sights = [&](int i) {
        std::vector<Detection> found{sight(Kind::Poster, "p", Wall::inView(kPoster, viewAt(i)))};
        if (i > 0) found.push_back(sight(Kind::Sign, "s", Wall::inView(second, viewAt(i))));
        return found;
    };
    for (int late : {1, 3, 5}) {
        Film quick, slow;
        for (int i = 0; i < 24; ++i) {
            cv::Mat picture = wall.seenFrom(viewAt(i));
            quick.show(picture);
            if (i % 6 == 0) quick.see(sights(i));
            int looked = i - i % 6;
            slow.oldestNeeded = static_cast<std::uint64_t>(looked);
            slow.show(picture);
            if (i % 6 == late)
                slow.tracker.join(Sense::Landmarks, static_cast<std::uint64_t>(looked), sights(looked), true);
            if (i % 6 < late) continue;
            auto a = quick.tracker.tracks(), b = slow.tracker.tracks();
            ASSERT_EQ(a.size(), b.size()) << "frame " << i;
            for (std::size_t k = 0; k < a.size(); ++k) {
                EXPECT_EQ(a[k].now.track, b[k].now.track);
                EXPECT_EQ(a[k].now.confirmations, b[k].now.confirmations);
                EXPECT_EQ(a[k].now.quad, b[k].now.quad) << "to the last digit, frame " << i;
                EXPECT_EQ(a[k].firstTime, b[k].firstTime);
                EXPECT_EQ(a[k].growth, b[k].growth);
            }
        }
    }
}

TEST(LandmarkTracker, TwoLikeThingsSideBySideKeepTheirOwnTracks) {
    Wall wall;
    Quad left = quadOf({460, 250, 70, 110}), right = quadOf({560, 250, 70, 110});
    wall.hang(3, left);
    wall.hang(3, right);
    Film film;
    std::vector<std::uint64_t> ids;
    for (int i = 0; i < 20; ++i) {
        cv::Point2d at(300.0 + 9.0 * i, 100.0);
        film.show(wall.seenFrom(at));
        Detection a = sight(Kind::Extinguisher, "red", Wall::inView(left, at));
        Detection b = sight(Kind::Extinguisher, "red", Wall::inView(right, at));
        if (i % 5 != 0) continue;
        // Told in any order, and now and then one of them only.
        auto joined = film.see(i % 10 == 0 ? std::vector{a, b} : std::vector{b, a});
        if (ids.empty()) ids = {joined[0].track, joined[1].track};
        EXPECT_EQ(joined[i % 10 == 0 ? 0 : 1].track, ids[0]);
        EXPECT_EQ(joined[i % 10 == 0 ? 1 : 0].track, ids[1]);
    }
    EXPECT_NE(ids[0], ids[1]);
    EXPECT_EQ(film.tracker.tracks().size(), 2U);
}

TEST(LandmarkTracker, WhatIsHiddenIsLostAndKnownAgainWhenItComesBack) {
    Wall wall;
    wall.hang(3, kPoster);
    Wall hidden = wall.covered(cv::Rect(470, 200, 180, 300));
    Film film;
    film.show(wall.seenFrom({300, 100}));
    std::uint64_t track = film.see({sight(Kind::Poster, "p", Wall::inView(kPoster, {300, 100}))})[0].track;
    for (int i = 1; i < 4; ++i) film.show(wall.seenFrom({300.0 + i, 100}));
    EXPECT_EQ(film.tracker.tracks().size(), 1U);
    for (int i = 4; i < 10; ++i) film.show(hidden.seenFrom({300.0 + i, 100}));
    EXPECT_TRUE(film.tracker.tracks().empty()) << "it must not go on with what hides it";
    EXPECT_EQ(film.ended().size(), 1U);
    for (int i = 10; i < 14; ++i) film.show(wall.seenFrom({300.0 + i, 100}));
    EXPECT_TRUE(film.tracker.tracks().empty()) << "only recognition brings it back";
    auto again = film.see({sight(Kind::Poster, "p", Wall::inView(kPoster, {313, 100}))});
    EXPECT_EQ(again[0].track, track);
    EXPECT_EQ(again[0].confirmations, 2);
}

TEST(LandmarkTracker, ACoveredPictureEndsAllTracks) {
    Wall wall;
    wall.hang(3, kPoster);
    Film film;
    for (int i = 0; i < 3; ++i) {
        film.show(wall.seenFrom({300, 100}));
        film.see({sight(Kind::Poster, "p", Wall::inView(kPoster, {300, 100})),
                  sight(Kind::Poster, "q", quadOf({40, 40, 90, 80}))});
    }
    film.show(cv::Mat(480, 640, CV_8UC3, cv::Scalar(12, 10, 9)));
    EXPECT_TRUE(film.tracker.tracks().empty());
}

TEST(LandmarkTracker, ACutEndsAllTracksAndNothingIsKnownAgainAfterIt) {
    Wall wall;
    wall.hang(3, kPoster);
    Film film;
    film.show(wall.seenFrom({300, 100}));
    Detection seen = sight(Kind::Poster, "p", Wall::inView(kPoster, {300, 100}));
    std::uint64_t before = film.see({seen})[0].track;
    film.show(wall.seenFrom({300, 100}), true);
    EXPECT_TRUE(film.tracker.tracks().empty());
    EXPECT_THAT(film.ended(), testing::ElementsAre("cut"));
    EXPECT_NE(film.see({seen})[0].track, before);
}

TEST(LandmarkTracker, AnotherPictureWithoutNoticeIsNotFollowedInto) {
    Wall wall, other(9);
    wall.hang(3, kPoster);
    other.hang(8, quadOf({420, 200, 260, 200}));
    Film film;
    film.show(wall.seenFrom({300, 100}));
    film.see({sight(Kind::Poster, "p", Wall::inView(kPoster, {300, 100}))});
    film.show(other.seenFrom({300, 100}));
    EXPECT_TRUE(film.tracker.tracks().empty());
}

TEST(LandmarkTracker, AFalseSightIsDroppedWhenTheNextLooksDoNotShareIt) {
    Wall wall;
    wall.hang(3, kPoster);
    Film film;
    Quad wrong = quadOf({80, 60, 100, 90});
    for (int i = 0; i < 6; ++i) {
        film.show(wall.seenFrom({300, 100}));
        std::vector<Detection> found{sight(Kind::Poster, "p", Wall::inView(kPoster, {300, 100}))};
        if (i == 0) found.push_back(sight(Kind::Sign, "ghost", wrong));
        film.see(found);
    }
    ASSERT_EQ(film.tracker.tracks().size(), 1U);
    EXPECT_EQ(film.tracker.tracks()[0].now.templateId.value, "p");
}

TEST(LandmarkTracker, WhatIsSeenAsSomethingElseIsNotFollowedUnderItsOldName) {
    Wall wall;
    wall.hang(3, kPoster);
    Film film;
    Quad there = Wall::inView(kPoster, {300, 100});
    film.show(wall.seenFrom({300, 100}));
    film.see({sight(Kind::Poster, "one", there)});
    film.show(wall.seenFrom({302, 100}));
    film.see({sight(Kind::Poster, "other", Wall::inView(kPoster, {302, 100}))});
    ASSERT_EQ(film.tracker.tracks().size(), 1U);
    EXPECT_EQ(film.tracker.tracks()[0].now.templateId.value, "other");
    EXPECT_THAT(film.ended(), testing::ElementsAre("contradicted"));
}

TEST(LandmarkTracker, WhatLeavesThePictureEnds) {
    Wall wall;
    wall.hang(3, kPoster);
    Film film;
    film.show(wall.seenFrom({300, 100}));
    film.see({sight(Kind::Poster, "p", Wall::inView(kPoster, {300, 100}))});
    for (int i = 1; i < 30; ++i) film.show(wall.seenFrom({300.0 + 15.0 * i, 100}));
    EXPECT_TRUE(film.tracker.tracks().empty());
}

TEST(LandmarkTracker, FramesFarApartAreNotFollowedButATrainedThingIsKnownAgain) {
    Wall wall;
    wall.hang(3, kPoster);
    LandmarkTracker tracker;
    std::vector<std::uint64_t> ids;
    for (std::uint64_t i = 0; i < 4; ++i) {
        cv::Point2d at(200.0 + 60.0 * static_cast<double>(i), 100.0);
        tracker.advance(wall.seenFrom(at), i, static_cast<double>(i), i < 3 ? 0 : 1, i == 3, i);
        EXPECT_TRUE(tracker.tracks().empty());
        EXPECT_TRUE(tracker.sparse(i));
        Detection seen = sight(Kind::Poster, "p", Wall::inView(kPoster, at));
        ids.push_back(tracker.join(Sense::Landmarks, i, {seen}, true)[0].track);
    }
    EXPECT_EQ(ids[1], ids[0]);
    EXPECT_EQ(ids[2], ids[0]);
    EXPECT_NE(ids[3], ids[0]) << "another scene";
}

TEST(LandmarkTracker, APlaceLastsWhileItIsRecognised) {
    Wall wall;
    Film film;
    Quad whole = quadOf({0, 0, 640, 480});
    for (int i = 0; i < 6; ++i) {
        film.show(wall.seenFrom({300.0 + 5.0 * i, 100}));
        if (i >= 3) continue;
        EXPECT_EQ(film.see({sight(Kind::Place, "a", whole)})[0].track, 1U);
    }
    EXPECT_EQ(film.tracker.tracks().size(), 1U);
    film.see({sight(Kind::Place, "b", whole)});
    ASSERT_EQ(film.tracker.tracks().size(), 1U);
    EXPECT_EQ(film.tracker.tracks()[0].now.templateId.value, "b");
}

TEST(LandmarkTracker, StrangePicturesAndOutlinesBreakNothing) {
    Film film;
    Detection odd =
        sight(Kind::Door, "", Quad{ImagePoint{-500, -500}, {2000, -500}, {2000, 9000}, {-5, 9000}});
    Detection point = sight(Kind::Door, "", Quad{ImagePoint{50, 50}, {50, 50}, {50, 50}, {50, 50}});
    Detection crossed = sight(Kind::Door, "", Quad{ImagePoint{50, 50}, {150, 150}, {150, 50}, {50, 150}});
    for (const cv::Mat& picture :
         {cv::Mat(), cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(9)), cv::Mat(480, 640, CV_64FC2, cv::Scalar(1)),
          cv::Mat(480, 640, CV_8UC1, cv::Scalar(80)), test::room(4), test::room(4),
          cv::Mat(40, 4000, CV_8UC3)}) {
        film.show(picture);
        EXPECT_EQ(film.see({odd, point, crossed}).size(), 3U);
    }
    EXPECT_EQ(film.tracker.join(Sense::Text, 999, {odd}, true).size(), 1U) << "a frame nobody knows";
}

TEST(LandmarkTracker, SenselessOptionsAreRefused) {
    EXPECT_TRUE(TrackerOptions{}.check());
    TrackerOptions options;
    options.sameOverlap = 0.0;
    EXPECT_FALSE(options.check());
    options = {};
    options.flow.minPoints = 2;
    EXPECT_FALSE(options.check());
    options = {};
    options.unconfirmedSeconds = -1.0;
    EXPECT_FALSE(options.check());
}

} // namespace
} // namespace farol::recognition
