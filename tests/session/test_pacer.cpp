// When a frame is due, with a clock that the test holds in its hand.

#include "core/session/inbox.h"
#include "core/session/pacer.h"

#include <cmath>
#include <gtest/gtest.h>

namespace farol::session {
namespace {

using std::chrono::milliseconds;

class PacerTest : public testing::Test {
protected:
    Pacer::TimePoint at(int ms) const { return m_zero + milliseconds(ms); }
    static long long millisecondsBetween(Pacer::TimePoint a, Pacer::TimePoint b) {
        return std::chrono::duration_cast<milliseconds>(b - a).count();
    }
    Pacer::TimePoint m_zero{std::chrono::hours(5)};
};

TEST_F(PacerTest, FramesAreDueAtTheirOwnTime) {
    Pacer pacer;
    EXPECT_EQ(pacer.due(7.0, at(0)), at(0)) << "the first at once, whatever its clock says";
    EXPECT_TRUE(pacer.accept(7.0, at(0)));
    EXPECT_EQ(pacer.due(7.5, at(100)), at(500));
    EXPECT_TRUE(pacer.accept(7.5, at(530)));
    EXPECT_EQ(pacer.due(8.0, at(540)), at(1000)) << "a late frame does not shift the next";
}

TEST_F(PacerTest, SpeedDividesTheWait) {
    Pacer pacer(2.0);
    pacer.accept(0.0, at(0));
    EXPECT_EQ(pacer.due(1.0, at(0)), at(500));
    pacer.setSpeed(0.5);
    EXPECT_EQ(pacer.due(1.0, at(0)), at(2000));
    for (double senseless : {0.0, -1.0, std::nan(""), HUGE_VAL}) pacer.setSpeed(senseless);
    EXPECT_EQ(pacer.speed(), 0.5);
}

TEST_F(PacerTest, WhatComesMuchTooLateIsDropped) {
    Pacer pacer;
    EXPECT_TRUE(pacer.accept(0.0, at(0)));
    EXPECT_FALSE(pacer.accept(0.1, at(900)));
    EXPECT_FALSE(pacer.accept(0.2, at(910)));
    EXPECT_TRUE(pacer.accept(0.9, at(920)));
}

TEST_F(PacerTest, AReaderThatCannotKeepUpStillDelivers) {
    Pacer pacer;
    int delivered = 0;
    for (int frame = 0; frame < 100; ++frame)
        if (pacer.accept(frame / 30.0, at(frame * 300))) ++delivered;
    EXPECT_GE(delivered, 20);
    EXPECT_LT(delivered, 100);
}

TEST_F(PacerTest, AfterAPauseTheNextFrameComesOnePeriodLater) {
    Pacer pacer;
    pacer.accept(0.0, at(0));
    pacer.restart(0.0, at(60000));
    EXPECT_EQ(pacer.due(0.5, at(60000)), at(60500));
}

TEST_F(PacerTest, ClocksThatJumpDoNotHangTheWalk) {
    Pacer pacer;
    pacer.accept(100.0, at(0));
    EXPECT_EQ(pacer.due(3.0, at(10)), at(0)) << "backwards: at once";
    EXPECT_LE(millisecondsBetween(at(0), pacer.due(1e300, at(10))), 3600LL * 1000);
    EXPECT_EQ(pacer.due(std::nan(""), at(10)), at(10));
}

Parcel parcel(std::size_t index, double capturedAt = 0.0) {
    Parcel made;
    made.frame.index = index;
    made.frame.capturedAt = capturedAt;
    return made;
}

TEST(Inbox, CommandsComeBeforeFramesAndInOrder) {
    Inbox inbox(1.0);
    inbox.begin();
    inbox.putNewest(parcel(0));
    inbox.post(Command(MessageCommand{"first"}));
    inbox.post(Command(MessageCommand{"second"}));
    Work work = inbox.next();
    ASSERT_EQ(work.kind, Work::Kind::Items);
    ASSERT_EQ(work.items.size(), 2U);
    EXPECT_EQ(std::get<MessageCommand>(std::get<Command>(work.items[0])).text, "first");
    EXPECT_EQ(inbox.next().kind, Work::Kind::Frame);
}

TEST(Inbox, APauseHoldsTheFrameAndAStepLetsOnePass) {
    Inbox inbox(1.0);
    inbox.begin();
    inbox.putNewest(parcel(0));
    inbox.pause();
    EXPECT_EQ(inbox.next().kind, Work::Kind::StateChanged);
    inbox.post(Command(MessageCommand{"meanwhile"}));
    EXPECT_EQ(inbox.next().kind, Work::Kind::Items);
    inbox.stepOnce();
    EXPECT_EQ(inbox.next().kind, Work::Kind::Frame);
    inbox.putNewest(parcel(1));
    EXPECT_EQ(inbox.state(), RunState::Paused);
    inbox.stop();
    EXPECT_EQ(inbox.next().kind, Work::Kind::Stopped) << "frame 1 was not let through";
}

TEST(Inbox, UntakenFramesAreDroppedAndCountedButNotInAPause) {
    Inbox inbox(1.0);
    inbox.begin();
    for (std::size_t i = 0; i < 4; ++i) inbox.putNewest(parcel(i));
    EXPECT_EQ(inbox.dropped(), 3U);
    inbox.pause();
    for (std::size_t i = 4; i < 9; ++i) inbox.putNewest(parcel(i));
    EXPECT_EQ(inbox.dropped(), 3U);
    inbox.resume();
    Work work = inbox.next();
    ASSERT_EQ(work.kind, Work::Kind::Frame);
    EXPECT_EQ(work.parcel.frame.index, 8U);
}

TEST(Inbox, MessagesOutliveTheFrameTheyCameWith) {
    Inbox inbox(1.0);
    inbox.begin();
    Parcel first = parcel(0);
    first.messages = {"one was skipped"};
    inbox.putNewest(std::move(first));
    inbox.putNewest(parcel(1));
    EXPECT_EQ(inbox.next().parcel.messages, std::vector<std::string>{"one was skipped"});
}

TEST(Inbox, PacedFramesThatNobodyTakesAreDropped) {
    Pacer::TimePoint now{std::chrono::hours(1)};
    Inbox inbox(1.0, [&] { return now; });
    inbox.begin();
    for (std::size_t i = 0; i < 5; ++i) EXPECT_TRUE(inbox.putWhenDue(parcel(i, 0.0))); // all due at once
    EXPECT_EQ(inbox.dropped(), 4U);
    Work work = inbox.next();
    EXPECT_EQ(work.parcel.frame.index, 4U);
    EXPECT_EQ(work.parcel.frame.arrivedAt, now);
    now += milliseconds(900);
    EXPECT_TRUE(inbox.putWhenDue(parcel(5, 0.1))); // 0.8 s late
    EXPECT_EQ(inbox.dropped(), 5U);
    EXPECT_TRUE(inbox.putWhenDue(parcel(6, 0.9)));
    EXPECT_EQ(inbox.next().parcel.frame.index, 6U);
}

TEST(Inbox, AStepInAPauseDoesNotWaitForTheClock) {
    Pacer::TimePoint now{std::chrono::hours(1)};
    Inbox inbox(1.0, [&] { return now; });
    inbox.begin();
    EXPECT_TRUE(inbox.putWhenDue(parcel(0, 0.0)));
    inbox.stepOnce();
    inbox.next(); // the state
    EXPECT_EQ(inbox.next().parcel.frame.index, 0U);
    inbox.stepOnce();
    EXPECT_TRUE(inbox.putWhenDue(parcel(1, 3000.0)));
    EXPECT_EQ(inbox.next().parcel.frame.index, 1U);
}

TEST(Inbox, TheEndComesOnceAndAfterTheLastFrame) {
    Inbox inbox(1.0);
    inbox.begin();
    inbox.putWhenFree(parcel(0));
    inbox.finish({"the last one was skipped"}, "");
    EXPECT_EQ(inbox.next().kind, Work::Kind::Frame);
    Work end = inbox.next();
    ASSERT_EQ(end.kind, Work::Kind::Ended);
    EXPECT_EQ(end.parcel.messages.size(), 1U);
    inbox.setOver(RunState::Ended);
    inbox.post(Command(MessageCommand{"afterwards"}));
    EXPECT_EQ(inbox.next().kind, Work::Kind::Items);
    inbox.waitUntilOver();
    EXPECT_EQ(inbox.state(), RunState::Ended);
}

TEST(Inbox, AfterAStopNothingIsTakenIn) {
    Inbox inbox(1.0);
    inbox.begin();
    inbox.putWhenFree(parcel(0));
    inbox.stop();
    EXPECT_FALSE(inbox.putWhenFree(parcel(1)));
    EXPECT_FALSE(inbox.putNewest(parcel(1)));
    EXPECT_FALSE(inbox.putWhenDue(parcel(1)));
    EXPECT_FALSE(inbox.waitUntilReady());
    EXPECT_EQ(inbox.next().kind, Work::Kind::Stopped);
    EXPECT_EQ(inbox.state(), RunState::Ended);
}

} // namespace
} // namespace farol::session
