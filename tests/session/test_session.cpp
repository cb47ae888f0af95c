// The threads of a walk. Nothing here sleeps: sources and handlers wait for gates that the test opens.

#include "core/building/geopackage.h"
#include "core/session/navigation_session.h"
#include "tests/session/walk_fixture.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

namespace farol::session {
namespace {

using capture::SourceEventKind;
using test::Gate;
using test::ScriptedSource;
using testing::ElementsAre;
using testing::HasSubstr;

building::Location room(const char* id) {
    return {RegionId(id), std::nullopt};
}

SessionOptions quickOptions() {
    SessionOptions options;
    options.perception.landmarks = options.perception.doors = options.perception.signs =
        options.perception.text = false;
    options.sourceName = "scripted";
    return options;
}

/// Collects what the handlers are told. Read it after stop(), or from the handlers' own hooks.
struct Walk {
    std::vector<std::uint64_t> frames;
    std::vector<std::string> messages;
    std::vector<guidance::CueReason> warnings;
    std::vector<RunState> states;
    std::vector<guidance::Travel> travel;
    test::Lines lines;
    std::function<void(std::uint64_t)> onStep;
    std::function<void(const std::string&)> onMessage;
    std::function<void(RunState)> onState;

    SessionHandlers handlers() {
        SessionHandlers handlers;
        handlers.step = [this](const NavigationStep& step, const HopTimes&) {
            frames.push_back(step.percept.frame);
            travel.push_back(step.progress.travel);
            lines.step(step);
            if (onStep) onStep(step.percept.frame);
        };
        handlers.warning = [this](const guidance::Cue& cue) {
            warnings.push_back(cue.reason);
            lines.warning(cue);
        };
        handlers.message = [this](double time, std::uint64_t frame, const std::string& text) {
            messages.push_back(text);
            lines.message(time, frame, text);
            if (onMessage) onMessage(text);
        };
        handlers.state = [this](RunState state) {
            states.push_back(state);
            if (onState) onState(state);
        };
        return handlers;
    }
};

std::unique_ptr<NavigationSession> sessionOf(std::unique_ptr<ScriptedSource> source, Walk& walk,
                                             const SessionOptions& options = quickOptions()) {
    auto made =
        NavigationSession::create(test::threeRooms(), nullptr, std::move(source), options, walk.handlers());
    EXPECT_TRUE(made) << made.error().text();
    return std::move(made).value();
}

std::vector<std::uint64_t> countTo(std::uint64_t end) {
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t i = 0; i < end; ++i) numbers.push_back(i);
    return numbers;
}

TEST(Session, AFileIsWalkedToItsEndWithoutALoss) {
    Walk walk;
    auto session = sessionOf(std::make_unique<ScriptedSource>(40), walk);
    EXPECT_EQ(session->state(), RunState::Idle);
    session->start();
    session->wait();
    session->stop();
    EXPECT_EQ(walk.frames, countTo(40));
    EXPECT_THAT(walk.states, ElementsAre(RunState::Running, RunState::Ended));
    EXPECT_EQ(session->state(), RunState::Ended);
    auto last = session->snapshot();
    ASSERT_TRUE(last);
    EXPECT_EQ(last->frame.index, 39U);
    EXPECT_EQ(last->framesDropped, 0U);
    EXPECT_EQ(last->source, "scripted");
    EXPECT_EQ(last->state, RunState::Ended);
}

TEST(Session, NoFramesAtAllIsAnEndToo) {
    Walk walk;
    auto session = sessionOf(std::make_unique<ScriptedSource>(0), walk);
    session->start();
    session->wait();
    session->stop();
    EXPECT_THAT(walk.states, ElementsAre(RunState::Running, RunState::Ended));
}

TEST(Session, ALiveSourceDropsTheOldestAndCounts) {
    Gate firstIsBusy, firstMayGo, secondSeen;
    Walk walk;
    walk.onStep = [&](std::uint64_t frame) {
        if (frame == 0) {
            firstIsBusy.open();
            firstMayGo.wait();
        } else {
            secondSeen.open();
        }
    };
    auto source = std::make_unique<ScriptedSource>(6, true);
    ScriptedSource* camera = source.get();
    camera->before = [&, camera](std::size_t index) {
        if (index == 1) firstIsBusy.wait();
        if (index == 5) { // 1, 2, 3 and 4 came while 0 was looked at
            firstMayGo.open();
            camera->hang();
        }
    };
    auto session = sessionOf(std::move(source), walk);
    session->start();
    secondSeen.wait();
    session->stop();
    EXPECT_THAT(walk.frames, ElementsAre(0U, 4U));
    EXPECT_EQ(session->snapshot()->framesDropped, 3U);
}

TEST(Session, AFileInRealTimeDropsWhatNobodyTook) {
    Gate firstIsBusy, firstMayGo;
    Walk walk;
    walk.onStep = [&](std::uint64_t frame) {
        if (frame == 0) {
            firstIsBusy.open();
            firstMayGo.wait();
        }
    };
    auto source = std::make_unique<ScriptedSource>(4);
    source->timeOf = [](std::size_t) { return 0.0; }; // all due at once
    source->before = [&](std::size_t index) {
        if (index == 1) firstIsBusy.wait();
        if (index == 4) firstMayGo.open();
    };
    SessionOptions options = quickOptions();
    options.pace = Pace::RealTime;
    auto session = sessionOf(std::move(source), walk, options);
    session->start();
    session->wait();
    session->stop();
    // Which of the three is left depends on how busy this machine is; that none is kept waiting does not.
    EXPECT_EQ(walk.frames.front(), 0U);
    EXPECT_GE(session->snapshot()->framesDropped, 2U);
    EXPECT_EQ(walk.frames.size() + session->snapshot()->framesDropped, 4U);
}

TEST(Session, ALateSessionThreadMakesAFileWait) {
    Gate firstMayGo;
    Walk walk;
    walk.onStep = [&](std::uint64_t frame) {
        if (frame == 0) firstMayGo.wait();
    };
    auto source = std::make_unique<ScriptedSource>(5);
    source->before = [&](std::size_t index) {
        if (index == 2) firstMayGo.open(); // 1 lies in the slot
    };
    auto session = sessionOf(std::move(source), walk);
    session->start();
    session->wait();
    session->stop();
    EXPECT_EQ(walk.frames, countTo(5));
}

TEST(Session, StepsLetOneFrameThroughEach) {
    Gate paused, first, second;
    Walk walk;
    walk.onState = [&](RunState state) {
        if (state == RunState::Paused) paused.open();
    };
    walk.onStep = [&](std::uint64_t frame) { (frame == 0 ? first : second).open(); };
    auto session = sessionOf(std::make_unique<ScriptedSource>(10), walk);
    session->pause();
    session->start();
    paused.wait();
    EXPECT_EQ(session->state(), RunState::Paused);
    session->stepOnce();
    first.wait();
    session->stepOnce();
    second.wait();
    session->stop();
    EXPECT_THAT(walk.frames, ElementsAre(0U, 1U));
    EXPECT_THAT(walk.states, ElementsAre(RunState::Paused, RunState::Ended));
}

TEST(Session, AfterAPauseTheWalkGoesOnWhereItWas) {
    Gate third, paused;
    Walk walk;
    std::unique_ptr<NavigationSession> session;
    walk.onStep = [&](std::uint64_t frame) {
        if (frame == 2) {
            session->pause();
            third.open();
        }
    };
    walk.onState = [&](RunState state) {
        if (state == RunState::Paused) paused.open();
    };
    session = sessionOf(std::make_unique<ScriptedSource>(8), walk);
    session->start();
    third.wait();
    paused.wait();
    session->setSpeed(2.0);
    session->resume();
    session->wait();
    session->stop();
    EXPECT_EQ(walk.frames, countTo(8));
    EXPECT_THAT(walk.states,
                ElementsAre(RunState::Running, RunState::Paused, RunState::Running, RunState::Ended));
}

TEST(Session, CommandsGivenBeforeTheStartHoldFromTheFirstFrame) {
    Walk walk;
    auto session = sessionOf(std::make_unique<ScriptedSource>(2), walk);
    session->setStart(RegionId("D"));
    session->setStart(RegionId("A")); // the later one counts
    session->setDestination(room("B"));
    session->setDestination(room("C"));
    session->start();
    session->wait();
    session->stop();
    auto route = session->snapshot()->step.progress.route;
    ASSERT_TRUE(route);
    EXPECT_THAT(route->regions, ElementsAre(RegionId("A"), RegionId("B"), RegionId("C")));
    EXPECT_EQ(walk.travel.front(), guidance::Travel::OnRoute);
}

TEST(Session, ADestinationChosenInAPauseShowsItsRouteAtOnce) {
    Gate paused;
    Walk walk;
    walk.onState = [&](RunState state) {
        if (state == RunState::Paused) paused.open();
    };
    auto session = sessionOf(std::make_unique<ScriptedSource>(5), walk);
    session->pause();
    session->start();
    paused.wait();
    session->setStart(RegionId("A"));
    session->setDestination(room("C"));
    // A frame is not needed, so nothing tells the end but the picture itself.
    std::shared_ptr<const Snapshot> shown;
    do {
        std::this_thread::yield();
        shown = session->snapshot();
    } while (!shown->step.progress.route);
    EXPECT_THAT(shown->step.progress.route->regions,
                ElementsAre(RegionId("A"), RegionId("B"), RegionId("C")));
    EXPECT_TRUE(shown->frame.image.empty());
    EXPECT_EQ(shown->state, RunState::Paused);
    session->stop();
    EXPECT_TRUE(walk.frames.empty());
}

TEST(Session, ACameraThatGoesAndComesIsToldOnceEach) {
    Walk walk;
    Gate over;
    walk.onStep = [&](std::uint64_t frame) {
        if (frame == 1) over.open();
    };
    auto source = std::make_unique<ScriptedSource>(2, true);
    ScriptedSource* camera = source.get();
    camera->before = [camera](std::size_t index) {
        if (index == 1) {
            camera->say(SourceEventKind::ConnectionLost, "the camera is gone");
            camera->say(SourceEventKind::Reconnecting, "trying again");
            camera->say(SourceEventKind::ConnectionLost, "still gone");
            camera->say(SourceEventKind::Reconnected, "the camera is back");
            camera->say(SourceEventKind::Reconnected, "really back");
        }
        if (index == 2) camera->hang();
    };
    auto session = sessionOf(std::move(source), walk);
    session->start();
    over.wait();
    session->stop();
    EXPECT_THAT(walk.warnings, ElementsAre(guidance::CueReason::CameraLost, guidance::CueReason::CameraBack));
    EXPECT_EQ(walk.messages.size(), 5U);
    EXPECT_EQ(session->snapshot()->warnings.back(), "really back");
}

TEST(Session, ACameraThatStaysAwayEndsTheWalkWithAWarning) {
    Walk walk;
    auto session = sessionOf(std::make_unique<ScriptedSource>(3, true), walk);
    session->start();
    session->wait();
    EXPECT_EQ(session->state(), RunState::Failed);
    session->stop();
    EXPECT_EQ(session->state(), RunState::Failed);
    EXPECT_THAT(walk.warnings, ElementsAre(guidance::CueReason::CameraLost));
    EXPECT_THAT(walk.messages.back(), HasSubstr("no more pictures"));
}

TEST(Session, AnUnreadablePictureIsOnlyAMessageBeforeTheNextFrame) {
    Walk walk;
    std::vector<std::uint64_t> framesThen;
    walk.onMessage = [&](const std::string&) { framesThen = walk.frames; };
    auto source = std::make_unique<ScriptedSource>(4);
    ScriptedSource* folder = source.get();
    folder->before = [folder](std::size_t index) {
        if (index == 2) folder->say(SourceEventKind::FrameSkipped, "7.jpg cannot be read");
    };
    auto session = sessionOf(std::move(source), walk);
    session->start();
    session->wait();
    session->stop();
    EXPECT_THAT(walk.messages, ElementsAre("7.jpg cannot be read"));
    EXPECT_THAT(framesThen, ElementsAre(0U, 1U));
    EXPECT_TRUE(walk.warnings.empty());
    EXPECT_EQ(walk.frames, countTo(4));
    EXPECT_EQ(session->snapshot()->framesSkipped, 1U);
}

TEST(Session, ASourceThatBreaksDownEndsTheWalkWithAWord) {
    Walk walk;
    auto source = std::make_unique<ScriptedSource>(9);
    source->before = [](std::size_t index) {
        if (index == 3) throw std::runtime_error("out of luck");
    };
    auto session = sessionOf(std::move(source), walk);
    session->start();
    session->wait();
    session->stop();
    EXPECT_EQ(session->state(), RunState::Failed);
    EXPECT_THAT(walk.messages.back(), HasSubstr("out of luck"));
    EXPECT_EQ(walk.frames, countTo(3));
}

TEST(Session, APictureOfAStrangeFormatDoesNotEndTheWalk) {
    Walk walk;
    auto source = std::make_unique<ScriptedSource>(4);
    source->imageOf = [](std::size_t index) {
        return index == 1   ? cv::Mat()
               : index == 2 ? cv::Mat(9, 9, CV_64FC2, cv::Scalar(1))
                            : test::drawnFrame(index);
    };
    auto session = sessionOf(std::move(source), walk);
    session->start();
    session->wait();
    session->stop();
    EXPECT_EQ(walk.frames, countTo(4));
    EXPECT_EQ(session->state(), RunState::Ended);
}

TEST(Session, ARecordedWalkReplaysToTheByteWithItsCommandsAndWarnings) {
    test::TemporaryFolder temporary;
    Walk walk;
    std::unique_ptr<NavigationSession> session;
    walk.onStep = [&](std::uint64_t frame) {
        if (frame == 3) session->setDestination(room("C"));
        if (frame == 4) session->ask(guidance::Question::Remaining);
        if (frame == 5) session->ask(guidance::Question::AroundMe);
        if (frame == 6) session->setVerbosity(guidance::Verbosity::Directions);
        if (frame == 8) session->setStart(RegionId("B"));
        if (frame == 9) session->setDestination(std::nullopt);
        if (frame == 11) session->setDestination(room("D"));
    };
    auto source = std::make_unique<ScriptedSource>(18);
    ScriptedSource* folder = source.get();
    folder->before = [folder](std::size_t index) {
        if (index == 5) folder->say(SourceEventKind::FrameSkipped, "5.jpg cannot be read");
        if (index == 7) folder->say(SourceEventKind::ConnectionLost, "the share is gone");
        if (index == 9) folder->say(SourceEventKind::Reconnected, "the share is back");
    };
    SessionOptions options = quickOptions();
    options.perception.landmarks = true; // gives the message that there are none
    options.recordFolder = temporary.path / "walk";
    session = sessionOf(std::move(source), walk, options);
    session->setStart(RegionId("A"));
    session->start();
    session->wait();
    session->stop();
    session.reset();
    EXPECT_THAT(walk.messages.front(), HasSubstr("no trained landmarks"));

    auto recording = loadRecording(temporary.path / "walk");
    ASSERT_TRUE(recording) << recording.error().text();
    EXPECT_EQ(recording->header.source, "scripted");
    auto map = building::loadBuilding((recording->folder / "map.gpkg").string());
    ASSERT_TRUE(map) << map.error().text();
    for (int time = 0; time < 2; ++time) {
        test::Lines again;
        ASSERT_TRUE(replay(*recording, map->building, {}, again.handlers()));
        EXPECT_EQ(again.text, walk.lines.text);
    }
}

TEST(Session, AFullDiskEndsTheRecordingAndNotTheWalk) {
    test::TemporaryFolder temporary;
    Walk walk;
    SessionOptions options = quickOptions();
    options.recordFolder = temporary.path / "walk";
    auto session = sessionOf(std::make_unique<ScriptedSource>(60), walk, options);
    {
        test::SmallFilesOnly full(4000);
        session->start();
        session->wait();
    }
    session->stop();
    EXPECT_EQ(walk.frames, countTo(60));
    EXPECT_THAT(walk.warnings, ElementsAre(guidance::CueReason::RecordingStopped));
    ASSERT_EQ(walk.messages.size(), 1U);
    EXPECT_THAT(walk.messages[0], HasSubstr("the walk goes on"));
    auto recording = loadRecording(temporary.path / "walk");
    ASSERT_TRUE(recording) << recording.error().text();
    EXPECT_FALSE(recording->entries.empty());
}

TEST(Session, AUsedFolderIsRefusedBeforeTheWalk) {
    test::TemporaryFolder temporary;
    std::filesystem::create_directories(temporary.path / "something");
    Walk walk;
    SessionOptions options = quickOptions();
    options.recordFolder = temporary.path;
    auto made = NavigationSession::create(test::threeRooms(), nullptr, std::make_unique<ScriptedSource>(1),
                                          options, walk.handlers());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, ErrorCode::Conflict);
}

TEST(Session, WhatCannotWorkIsRefused) {
    Walk walk;
    SessionOptions options = quickOptions();
    options.speed = 0.0;
    EXPECT_FALSE(NavigationSession::create(test::threeRooms(), nullptr, std::make_unique<ScriptedSource>(1),
                                           options, {}));
    EXPECT_FALSE(NavigationSession::create(test::threeRooms(), nullptr, nullptr, quickOptions(), {}));
    EXPECT_FALSE(
        NavigationSession::create(nullptr, nullptr, std::make_unique<ScriptedSource>(1), quickOptions(), {}));
    options = quickOptions();
    options.navigator.localiser = "magic";
    EXPECT_FALSE(NavigationSession::create(test::threeRooms(), nullptr, std::make_unique<ScriptedSource>(1),
                                           options, {}));
}

} // namespace
} // namespace farol::session
