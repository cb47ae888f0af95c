// Slow looks on the spot, on threads and handed over by hand: the same tracks. Nothing here sleeps.

#include "core/localisation/navigation_history.h"
#include "core/session/perception.h"
#include "tests/recognition/drawn_pictures.h"
#include "tests/session/walk_fixture.h"

#include <opencv2/imgproc.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

namespace farol::session {
namespace {

namespace pictures = recognition::test;
using testing::HasSubstr;

/// A camera that pans along a wall with two posters, thirty frames a second.
class Pan {
public:
    Pan() : m_wall(pictures::room(2, {1100, 480})) {
        pictures::hang(m_wall, pictures::poster(3), quadOf({250, 120, 240, 180}));
        pictures::hang(m_wall, pictures::poster(5), quadOf({560, 140, 220, 165}));
        auto library = std::make_shared<recognition::LandmarkLibrary>();
        pictures::trainPoster(*library, 3);
        pictures::trainPoster(*library, 5);
        m_library = std::move(library);
    }

    std::shared_ptr<const recognition::LandmarkLibrary> library() const { return m_library; }
    capture::Frame frame(int i) const {
        capture::Frame frame;
        frame.index = static_cast<std::uint64_t>(i);
        frame.capturedAt = i / 30.0;
        frame.image = m_wall(cv::Rect(5 * i, 0, 640, 480)).clone();
        frame.name = "pan";
        return frame;
    }

private:
    cv::Mat m_wall;
    std::shared_ptr<const recognition::LandmarkLibrary> m_library;
};

PerceptionOptions quickOptions() {
    PerceptionOptions options;
    options.text = options.doors = options.stairs = options.signs = false;
    return options;
}

/// The answer is kept until the test hands it over.
class ByHand final : public Lookout {
public:
    bool free() const override { return !m_look && !m_sight; }
    void begin(Look look) override { m_look = std::move(look); }
    std::optional<Sight> finished() override { return std::exchange(m_sight, std::nullopt); }
    void wait() override { handOver(); }
    void handOver() {
        if (m_look) m_sight = (*std::exchange(m_look, std::nullopt))();
    }

private:
    std::optional<Look> m_look;
    std::optional<Sight> m_sight;
};

/// A thread whose answer is waited for, so that the moment of handing over is known.
class AwaitedThread final : public Lookout {
public:
    bool free() const override { return m_thread->free(); }
    void begin(Look look) override { m_thread->begin(std::move(look)); }
    std::optional<Sight> finished() override {
        m_thread->wait();
        return m_thread->finished();
    }
    void wait() override { m_thread->wait(); }

private:
    std::unique_ptr<Lookout> m_thread = lookOnAThread();
};

TEST(Lookouts, ThreadsSeeWhatIsSeenOnTheSpot) {
    Pan pan;
    std::vector<std::string> warnings;
    PerceptionOptions options;
    Perception single(pan.library(), options, warnings);
    Perception threaded(pan.library(), options, warnings, [] { return std::make_unique<AwaitedThread>(); });
    std::size_t told = 0;
    for (int i = 0; i < 25; ++i) {
        Percept a = single.look(pan.frame(i)), b = threaded.look(pan.frame(i));
        EXPECT_EQ(dumped(perceptJson(a)), dumped(perceptJson(b))) << "frame " << i;
        told += a.detections.size();
    }
    EXPECT_GE(told, 8U) << "both posters, again and again";
}

TEST(Lookouts, ALateAnswerLeadsToTheSameTracks) {
    Pan pan;
    std::vector<std::string> warnings;
    for (int late : {1, 2}) {
        ByHand* hand = nullptr;
        Perception single(pan.library(), quickOptions(), warnings);
        Perception slow(pan.library(), quickOptions(), warnings, [&] {
            auto made = std::make_unique<ByHand>();
            hand = made.get();
            return made;
        });
        int compared = 0;
        for (int i = 0; i < 30; ++i) {
            if (i % 3 == late) hand->handOver();
            Percept a = single.look(pan.frame(i)), b = slow.look(pan.frame(i));
            if (i % 3 < late) continue;
            Percept quick, answered;
            quick.tracks = a.tracks;
            answered.tracks = b.tracks;
            EXPECT_EQ(dumped(perceptJson(quick)), dumped(perceptJson(answered))) << "frame " << i;
            compared += static_cast<int>(a.tracks.size());
        }
        EXPECT_GT(compared, 10);
    }
}

TEST(Lookouts, AnAnswerIsToldWhereTheThingIsNow) {
    Pan pan;
    std::vector<std::string> warnings;
    ByHand* hand = nullptr;
    Perception slow(pan.library(), quickOptions(), warnings, [&] {
        auto made = std::make_unique<ByHand>();
        hand = made.get();
        return made;
    });
    slow.look(pan.frame(0));
    for (int i = 1; i < 5; ++i) EXPECT_TRUE(slow.look(pan.frame(i)).detections.empty());
    hand->handOver();
    Percept percept = slow.look(pan.frame(5));
    ASSERT_FALSE(percept.detections.empty());
    for (const recognition::Detection& seen : percept.detections) {
        if (seen.templateId.value != "poster-3") continue; // the other one is half outside
        EXPECT_NEAR(boundingBox(seen.quad).x, 225.0, 6.0) << "not where it was five frames ago";
    }
    EXPECT_EQ(percept.detections.front().templateId.value, "poster-3");
}

TEST(Lookouts, AnObjectSeenInThirtyFramesIsOneObservation) {
    Pan pan;
    std::vector<std::string> warnings;
    PerceptionOptions options = quickOptions();
    options.secondsBetweenLooks = 0.0;
    Perception perception(pan.library(), options, warnings);
    localisation::NavigationHistory history;
    std::map<std::string, int> observations, sights;
    for (int i = 0; i < 30; ++i) {
        Percept percept = perception.look(pan.frame(i));
        std::vector<localisation::Observation> seen;
        for (const recognition::Detection& detection : percept.detections) {
            seen.push_back({detection, percept.time, percept.frame, percept.scene});
            seen.back().track = detection.track;
            ++sights[detection.templateId.value];
        }
        for (const auto& fresh : history.add(seen)) ++observations[fresh.detection.templateId.value];
    }
    EXPECT_GE(sights["poster-3"], 20);
    EXPECT_EQ(observations["poster-3"], 1);
    EXPECT_EQ(observations["poster-5"], 1);
}

TEST(Lookouts, WhatIsSeenOnceOnlyIsNotToldWhereFramesComeDensely) {
    Pan pan;
    std::vector<std::string> warnings;
    Perception perception(pan.library(), quickOptions(), warnings);
    capture::Frame blank = pan.frame(0);
    blank.image = pictures::room(7);
    for (int i = 0; i < 10; ++i) {
        capture::Frame frame = i == 3 ? pan.frame(i) : blank;
        frame.index = static_cast<std::uint64_t>(i);
        frame.capturedAt = i / 30.0;
        EXPECT_TRUE(perception.look(frame).detections.empty()) << "frame " << i;
    }
    // Pictures a second apart cannot confirm each other: what is seen is told.
    capture::Frame late = pan.frame(3);
    late.index = 50;
    late.capturedAt = 9.0;
    EXPECT_FALSE(perception.look(late).detections.empty());
}

TEST(Lookouts, AnAnswerIsWaitedForWhereTheNextFrameIsFarAway) {
    Pan pan;
    std::vector<std::string> warnings;
    Perception threaded(pan.library(), quickOptions(), warnings, lookOnAThread);
    for (int i = 0; i < 3; ++i) {
        capture::Frame frame = pan.frame(i);
        frame.capturedAt = i;
        Percept percept = threaded.look(frame);
        EXPECT_EQ(percept.detections.empty(), i == 0) << "the answer belongs to this frame";
    }
}

TEST(Lookouts, AnAnswerIsFetchedOnce) {
    auto thread = lookOnAThread();
    thread->wait(); // nothing is under way
    EXPECT_TRUE(thread->free());
    thread->begin([] {
        Sight sight;
        sight.frame = 3;
        return sight;
    });
    thread->wait();
    EXPECT_FALSE(thread->free()) << "its answer was not fetched";
    EXPECT_EQ(thread->finished()->frame, 3U);
    EXPECT_TRUE(thread->free());
    EXPECT_FALSE(thread->finished());
}

TEST(Lookouts, AThreadWithALookUnderWayCanBeLeft) {
    test::Gate begun, go;
    {
        auto thread = lookOnAThread();
        thread->begin([&] {
            begun.open();
            go.wait();
            return Sight{};
        });
        begun.wait();
        go.open();
    }
}

} // namespace
} // namespace farol::session
