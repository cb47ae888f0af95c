// A walk can be ended at any moment, and nothing hangs.

#include "core/session/navigation_session.h"
#include "tests/session/walk_fixture.h"

#include <gtest/gtest.h>
#include <thread>

namespace farol::session {
namespace {

using test::Gate;
using test::ScriptedSource;

std::unique_ptr<NavigationSession> sessionOf(std::unique_ptr<ScriptedSource> source, SessionHandlers handlers,
                                             Pace pace = Pace::AsFastAsPossible) {
    SessionOptions options;
    options.perception.landmarks = options.perception.doors = options.perception.signs =
        options.perception.text = false;
    options.pace = pace;
    auto made = NavigationSession::create(test::threeRooms(), nullptr, std::move(source), options,
                                          std::move(handlers));
    EXPECT_TRUE(made);
    return std::move(made).value();
}

TEST(SessionStop, BeforeTheStart) {
    auto session = sessionOf(std::make_unique<ScriptedSource>(5), {});
    session->stop();
    session->start();
    session->wait();
    EXPECT_EQ(session->state(), RunState::Ended);
    EXPECT_FALSE(session->snapshot());
}

TEST(SessionStop, NeverStartedAndNeverStopped) {
    auto session = sessionOf(std::make_unique<ScriptedSource>(5), {});
    session->wait();
    EXPECT_EQ(session->state(), RunState::Idle);
}

TEST(SessionStop, TwiceAndAfterTheEnd) {
    auto session = sessionOf(std::make_unique<ScriptedSource>(3), {});
    session->start();
    session->start();
    session->wait();
    session->stop();
    session->stop();
    EXPECT_EQ(session->state(), RunState::Ended);
}

TEST(SessionStop, WhileTheSourceHangs) {
    Gate hanging;
    auto source = std::make_unique<ScriptedSource>(3, true);
    ScriptedSource* camera = source.get();
    camera->before = [&, camera](std::size_t index) {
        if (index == 1) {
            hanging.open();
            camera->hang();
        }
    };
    auto session = sessionOf(std::move(source), {});
    session->start();
    hanging.wait();
    session->stop();
    EXPECT_EQ(session->state(), RunState::Ended);
}

TEST(SessionStop, WhileTheReaderWaitsForAFreeSlot) {
    Gate inHandler, slotFull, mayGo;
    SessionHandlers handlers;
    handlers.step = [&](const NavigationStep&, const HopTimes&) {
        inHandler.open();
        mayGo.wait();
    };
    auto source = std::make_unique<ScriptedSource>(100);
    source->before = [&](std::size_t index) {
        if (index == 3) slotFull.open();
        if (index == 2) slotFull.open();
    };
    auto session = sessionOf(std::move(source), handlers);
    session->start();
    inHandler.wait();
    slotFull.wait();
    std::thread stopper([&] { session->stop(); });
    mayGo.open();
    stopper.join();
    EXPECT_EQ(session->state(), RunState::Ended);
}

TEST(SessionStop, WhileAPacedFrameIsHoursAway) {
    Gate first;
    SessionHandlers handlers;
    handlers.step = [&](const NavigationStep&, const HopTimes&) { first.open(); };
    auto source = std::make_unique<ScriptedSource>(3);
    source->timeOf = [](std::size_t index) { return 3000.0 * static_cast<double>(index); };
    auto session = sessionOf(std::move(source), handlers, Pace::RealTime);
    session->start();
    first.wait();
    session->stop();
}

TEST(SessionStop, WhilePaused) {
    Gate paused;
    SessionHandlers handlers;
    handlers.state = [&](RunState state) {
        if (state == RunState::Paused) paused.open();
    };
    auto session = sessionOf(std::make_unique<ScriptedSource>(9), handlers);
    session->pause();
    session->start();
    paused.wait();
    session->stop();
    EXPECT_EQ(session->state(), RunState::Ended);
}

TEST(SessionStop, FromAHandler) {
    std::unique_ptr<NavigationSession> session;
    SessionHandlers handlers;
    std::size_t steps = 0;
    handlers.step = [&](const NavigationStep&, const HopTimes&) {
        ++steps;
        session->stop();
    };
    session = sessionOf(std::make_unique<ScriptedSource>(1000), handlers);
    session->start();
    session->wait();
    session->stop();
    EXPECT_EQ(steps, 1U);
}

TEST(SessionStop, FromManyThreadsAtOnce) {
    auto session = sessionOf(std::make_unique<ScriptedSource>(1000), {});
    session->start();
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 6; ++i)
            threads.emplace_back([&] {
                session->pause();
                session->setDestination(building::Location{RegionId("C"), std::nullopt});
                session->resume();
                (void)session->snapshot();
                (void)session->state();
                session->stop();
            });
    }
    EXPECT_EQ(session->state(), RunState::Ended);
}

TEST(SessionStop, ByDestruction) {
    for (std::size_t frames : {0U, 1U, 500U}) {
        auto session = sessionOf(std::make_unique<ScriptedSource>(frames), {});
        session->start();
        session.reset();
    }
}

TEST(SessionStop, NoHandlerIsCalledAfterwards) {
    std::atomic<bool> stopped{false};
    std::atomic<bool> calledLate{false};
    SessionHandlers handlers;
    handlers.step = [&](const NavigationStep&, const HopTimes&) { calledLate = calledLate || stopped; };
    handlers.state = [&](RunState) { calledLate = calledLate || stopped; };
    auto session = sessionOf(std::make_unique<ScriptedSource>(1000), handlers);
    session->start();
    session->stop();
    stopped = true;
    session->setDestination(std::nullopt);
    session->stepOnce();
    session->resume();
    session.reset();
    EXPECT_FALSE(calledLate);
}

TEST(SessionStop, AHandlerThatThrowsEndsTheWalkAndNotTheProgram) {
    SessionHandlers handlers;
    handlers.step = [&](const NavigationStep&, const HopTimes&) { throw std::runtime_error("a full list"); };
    auto session = sessionOf(std::make_unique<ScriptedSource>(1000), handlers);
    session->start();
    session->wait();
    session->stop();
    EXPECT_EQ(session->state(), RunState::Failed);
}

} // namespace
} // namespace farol::session
