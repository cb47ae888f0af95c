// Walking the wrong way, past the door, back through one: what the planned way's own geometry tells.

#include "tests/guidance/guided.h"

#include <gtest/gtest.h>

using namespace farol;
using namespace farol::guidance;
using farol::test::AsciiMap;
using farol::test::at;
using farol::test::Guided;

namespace {

/// A corridor K along which one walks from 1 to 9; the doors of B and of C are on its north side.
AsciiMap hallway() {
    return AsciiMap()
        .floor(R"(
            +----+--------------+-----------+--------------+
            |A   |              |B          |C             |
            |    |              |           |              |
            +----+--------------+----/------+-------/------+
            |K                                             |
            | 1  2  3  4  5  6  7  8  9  a  b  c  d  e  f  |
            |                                              |
            +----/-----------------------------------------+
            |D   |
            +----+
        )")
        .region('B', {"Bar", building::RegionKind::Room})
        .region('C', {"Court", building::RegionKind::Room});
}

struct Walked : Guided {
    explicit Walked(AsciiMap drawing = hallway()) : Guided(std::move(drawing)) {
        secondsBetween = 3.0;
        planner2 = std::shared_ptr<const routing::Planner>(routing::makeOptimalPlanner(building));
        tracker = RouteTracker(building, planner2);
    }
    /// Good positions, as from a trained place or a filter that is sure.
    void walk(const std::string& spots, double sigma = 1.0) {
        for (char spot : spots) {
            fix = {};
            time += secondsBetween;
            fix.time = fix.evidenceTime = time;
            fix.region = RegionId("K");
            fix.confidence = confidence;
            fix.level = 0.0;
            fix.position = map.spot(spot).position;
            fix.sigmaM = sigma;
            progress = tracker.update(fix);
            replans += progress.replanned ? 1 : 0;
            if (progress.replanned) deviation = progress.deviation;
            cues = scheduler.update(++frame, fix, progress, {});
            all.insert(all.end(), cues.begin(), cues.end());
        }
    }
    const Cue* offRoute() const {
        for (const Cue& cue : all)
            if (cue.kind == CueKind::OffRoute) return &cue;
        return nullptr;
    }
    std::shared_ptr<const routing::Planner> planner2;
    double confidence = 0.9;
    int replans = 0;
    Deviation deviation = Deviation::LeftRoute;
};

TEST(Straying, WhoWalksAsPlannedIsNotCalledBack) {
    Walked walk;
    walk.tracker.setDestination(at("C"));
    walk.walk("123456789abcd");
    EXPECT_EQ(walk.replans, 0);
    EXPECT_EQ(walk.offRoute(), nullptr);
}

TEST(Straying, TheWrongWayFromTheStartIsToldAndTurnedRound) {
    Walked walk;
    walk.tracker.setDestination(at("B"));
    walk.walk("bc");
    EXPECT_EQ(walk.offRoute(), nullptr) << "a step is no proof";
    walk.walk("d");
    ASSERT_NE(walk.offRoute(), nullptr);
    EXPECT_EQ(walk.offRoute()->deviation, Deviation::WrongWay);
    ASSERT_TRUE(walk.offRoute()->turnFirst);
    EXPECT_GT(std::abs(toDegrees(*walk.offRoute()->turnFirst)), 120.0);
    EXPECT_EQ(walk.offRoute()->chime, Chime::Warning);
    EXPECT_EQ(walk.offRoute()->manoeuvre->access.value, "B-K");
}

TEST(Straying, PositionsManyTimesASecondProveAsMuch) {
    Walked walk;
    walk.secondsBetween = 0.0;
    walk.tracker.setDestination(at("B"));
    Point2 from = *walk.map.spot('b').position, to = *walk.map.spot('f').position;
    for (int i = 0; i <= 60; ++i) {
        walk.fix = {};
        walk.time += 0.2;
        walk.fix.time = walk.fix.evidenceTime = walk.time;
        walk.fix.region = RegionId("K");
        walk.fix.confidence = 0.9;
        walk.fix.level = 0.0;
        walk.fix.position = from + (to - from) * (i / 60.0);
        walk.fix.sigmaM = 0.5;
        walk.progress = walk.tracker.update(walk.fix);
        walk.cues = walk.scheduler.update(++walk.frame, walk.fix, walk.progress, {});
        walk.all.insert(walk.all.end(), walk.cues.begin(), walk.cues.end());
    }
    ASSERT_NE(walk.offRoute(), nullptr);
    EXPECT_EQ(walk.offRoute()->deviation, Deviation::WrongWay);
}

TEST(Straying, WhoCameThroughAWrongDoorIsTurnedRound) {
    Walked walk;
    walk.tracker.setDestination(at("C"));
    walk.walk("789");
    const building::Access* access = walk.building->access(AccessId("B-K"));
    ASSERT_NE(access, nullptr);
    Point2 door = access->midpoint();
    for (int i = 0; i < 3; ++i) {
        walk.time += 1.0;
        walk.fix.time = walk.fix.evidenceTime = walk.time;
        walk.fix.region = RegionId("B");
        walk.fix.position = Point2{door.x, door.y + 0.8};
        walk.fix.sigmaM = 0.6;
        walk.fix.confidence = 0.95;
        walk.progress = walk.tracker.update(walk.fix);
        walk.cues = walk.scheduler.update(++walk.frame, walk.fix, walk.progress, {});
        walk.all.insert(walk.all.end(), walk.cues.begin(), walk.cues.end());
    }
    ASSERT_NE(walk.offRoute(), nullptr);
    EXPECT_EQ(walk.offRoute()->manoeuvre->access.value, "B-K");
    ASSERT_TRUE(walk.offRoute()->turnFirst);
    EXPECT_NEAR(std::abs(toDegrees(*walk.offRoute()->turnFirst)), 180.0, 1e-9);
}

TEST(Straying, WhoStandsAndWaitsIsToldAgainAndLessAndLess) {
    Walked walk;
    walk.tracker.setDestination(at("C"));
    walk.walk("1");
    std::vector<double> told;
    for (int i = 0; i < 200; ++i) {
        walk.time += 1.0;
        walk.fix.time = walk.fix.evidenceTime = walk.time;
        walk.progress = walk.tracker.update(walk.fix);
        for (const Cue& cue : walk.scheduler.update(++walk.frame, walk.fix, walk.progress, {}))
            if (cue.kind == CueKind::Prepare) told.push_back(walk.time);
    }
    ASSERT_GE(told.size(), 3U);
    EXPECT_LE(told.size(), 6U) << "nobody wants to hear the same thing every few seconds";
    EXPECT_LE(told[0], 20.0);
    for (std::size_t i = 2; i < told.size(); ++i)
        EXPECT_GE(told[i] - told[i - 1], told[i - 1] - told[i - 2] - 1.1);
    walk.all.clear();
    walk.walk("3456");
    for (const Cue& cue : walk.all) EXPECT_NE(cue.kind, CueKind::Prepare) << "who gets on is left in peace";
}

TEST(Straying, TurningBackOnTheWayIsTold) {
    Walked walk;
    walk.tracker.setDestination(at("C"));
    walk.walk("3456789");
    walk.walk("876");
    ASSERT_NE(walk.offRoute(), nullptr);
    EXPECT_EQ(walk.offRoute()->deviation, Deviation::WrongWay);
    EXPECT_EQ(walk.replans, 1) << "told once, from where the user is";
}

TEST(Straying, PastTheDoorIsTold) {
    Walked walk;
    walk.tracker.setDestination(at("B"));
    walk.walk("56789a");
    EXPECT_EQ(walk.offRoute(), nullptr);
    walk.walk("b");
    ASSERT_NE(walk.offRoute(), nullptr);
    EXPECT_EQ(walk.deviation, Deviation::Missed);
    const Cue& cue = *walk.offRoute();
    EXPECT_EQ(cue.manoeuvre->access.value, "B-K");
    EXPECT_EQ(cue.manoeuvre->side, routing::Side::Right) << "on the way back it is on the other side";
    ASSERT_TRUE(cue.turnFirst);
}

TEST(Straying, APositionThatIsVagueOrStandsStillProvesNothing) {
    Walked vague;
    vague.tracker.setDestination(at("B"));
    vague.walk("56789abcdef", 3.0);
    EXPECT_EQ(vague.offRoute(), nullptr);
    Walked standing;
    standing.tracker.setDestination(at("B"));
    standing.walk("789aaaaaaaaaaaa");
    EXPECT_EQ(standing.offRoute(), nullptr) << "one step too far is none";
}

TEST(Straying, NothingOfTheOldWayIsLeftOver) {
    Walked walk;
    walk.tracker.setDestination(at("B"));
    walk.walk("56789ab");
    ASSERT_EQ(walk.replans, 1);
    std::uint64_t version = walk.progress.routeVersion;
    walk.all.clear();
    walk.walk("a98");
    EXPECT_EQ(walk.replans, 1);
    for (const Cue& cue : walk.all) EXPECT_EQ(cue.routeVersion == 0 ? version : cue.routeVersion, version);
    walk.tracker.setDestination(at("C"));
    walk.walk("9a");
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute);
    EXPECT_EQ(walk.replans, 1) << "the way already walked is not held against the new route";
}

TEST(Straying, BackThroughADoorOfTheRouteAndOn) {
    Walked walk;
    walk.tracker.setDestination(at("C"));
    walk.seen("D");
    walk.walk("23456");
    walk.walk("5432");
    ASSERT_NE(walk.offRoute(), nullptr);
    EXPECT_EQ(walk.offRoute()->deviation, Deviation::WrongWay);
}

TEST(DoorCount, SaysTheNumberFromWhereOneIs) {
    AsciiMap map;
    map.floor(R"(
        +----+----+----+----+----+
        |A   |B   |C   |E   |F   |
        +-/--+-/--+-/--+-/--+-/--+
        |K                       |
        |1      2    3   4       |
        +------------------------+
    )");
    Guided walk(map);
    auto planner = std::shared_ptr<const routing::Planner>(routing::makeOptimalPlanner(walk.building));
    walk.tracker = RouteTracker(walk.building, planner);
    walk.tracker.setDestination(at("F"));
    for (char spot : {'1', '2', '3'}) {
        walk.seen("K", spot);
        walk.fix.sigmaM = 0.5;
    }
    Cue next = walk.scheduler.answer(Question::Next, 1, walk.fix, walk.progress);
    ASSERT_TRUE(next.manoeuvre);
    EXPECT_EQ(next.manoeuvre->side, routing::Side::Left);
    EXPECT_EQ(next.manoeuvre->number, 2) << "E and F are still to come";
    EXPECT_TRUE(next.facingWay);
    walk.fix.position = walk.building->access(AccessId("E-K"))->midpoint() + Point2{0.3, -1.0};
    next = walk.scheduler.answer(Question::Next, 1, walk.fix, walk.progress);
    EXPECT_EQ(next.manoeuvre->number, 0) << "is the door beside one passed or to come?";
    walk.fix.sigmaM = 4.0;
    walk.fix.position = walk.map.spot('3').position;
    next = walk.scheduler.answer(Question::Next, 1, walk.fix, walk.progress);
    EXPECT_EQ(next.manoeuvre->number, 0) << "a vague position counts nothing";
}

/// The way bends to the south in the middle of the corridor K; it goes on to the west.
TEST(Straying, PastTheBendIsTold) {
    Walked walk(AsciiMap().floor(R"(
            +---------------------------------------------+
            |K                                            |
            |  7  6  5  4  3     2       1       0        |
            |                                             |
            +----------------+    +-----------------------+
                             |    |
                             |    +----+
                             |    |B   |
                             |    /    |
                             +----+----+
        )"));
    walk.tracker.setDestination(at("B"));
    walk.walk("012");
    EXPECT_EQ(walk.offRoute(), nullptr);
    std::string on = "34567";
    while (walk.replans == 0 && !on.empty()) {
        walk.walk(on.substr(0, 1));
        on.erase(0, 1);
    }
    EXPECT_GE(on.size(), 2U) << "told within some metres";
    EXPECT_EQ(walk.deviation, Deviation::Missed)
        << "the nearest spot of the way is its bend, from whichever side it is seen";
    ASSERT_TRUE(walk.offRoute()->turnFirst);
    EXPECT_GT(std::abs(toDegrees(*walk.offRoute()->turnFirst)), 120.0);
}

/// Positions that are followed count also while nothing new is seen.
TEST(Straying, TheWrongWayIsToldWhileNothingIsSeen) {
    Walked walk;
    walk.tracker.setDestination(at("B"));
    walk.walk("b");
    double seen = walk.time;
    for (char spot : std::string("cdef")) {
        walk.time += 3.0;
        walk.fix.time = walk.time;
        walk.fix.evidenceTime = seen;
        walk.fix.followed = true;
        walk.fix.position = walk.map.spot(spot).position;
        walk.progress = walk.tracker.update(walk.fix);
        walk.cues = walk.scheduler.update(++walk.frame, walk.fix, walk.progress, {});
        walk.all.insert(walk.all.end(), walk.cues.begin(), walk.cues.end());
    }
    ASSERT_NE(walk.offRoute(), nullptr);
    EXPECT_EQ(walk.offRoute()->deviation, Deviation::WrongWay);
}

/// A guess is no ground to call somebody back; nor for a side that holds for those only who come as planned.
TEST(Straying, WhoComesBackFromBeyondHearsNoSide) {
    Walked walk;
    walk.confidence = 0.3;
    walk.tracker.setDestination(at("C"));
    walk.walk("56789abcdef");
    walk.all.clear();
    walk.walk("edcba987");
    int told = 0;
    for (const Cue& cue : walk.all) {
        if (cue.kind != CueKind::Prepare && cue.kind != CueKind::Act) continue;
        ++told;
        EXPECT_FALSE(cue.facingWay) << "the door is on the other hand now";
    }
    EXPECT_GT(told, 0);
}

/// The way's own nearest spot is the door, however far beyond somebody is.
TEST(Straying, NobodyFarBeyondADoorIsNearIt) {
    Walked walk;
    walk.confidence = 0.3;
    walk.tracker.setDestination(at("B"));
    Point2 door = walk.building->access(AccessId("B-K"))->midpoint();
    for (char spot : std::string("56789abcdef")) {
        walk.walk(std::string(1, spot));
        for (const Cue& cue : walk.cues)
            EXPECT_TRUE(cue.kind != CueKind::Act || distance(*walk.fix.position, door) <= 4.0);
    }
}

/// "First, go through the door": with others before it, only metres tell which.
TEST(Straying, TheFirstDoorIsToldWithItsDistance) {
    Walked walk;
    walk.tracker.setDestination(at("C"));
    walk.walk("1");
    ASSERT_EQ(walk.cues.front().kind, CueKind::RouteStart);
    ASSERT_TRUE(walk.cues.front().firstM);
    EXPECT_NEAR(*walk.cues.front().firstM, *walk.progress.distanceM, 1e-9);
    Walked near;
    near.tracker.setDestination(at("C"));
    near.walk("d");
    EXPECT_FALSE(near.cues.front().firstM) << "at hand";
    Walked vague;
    vague.tracker.setDestination(at("C"));
    vague.walk("1", 4.0);
    EXPECT_FALSE(vague.cues.front().firstM);
}

} // namespace
