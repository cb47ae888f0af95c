// Orders for somebody whose facing is followed all the while.

#include "core/routing/route.h"
#include "tests/guidance/guided.h"
#include "tests/support/lobby_map.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace farol;
using namespace farol::guidance;
using farol::test::AsciiMap;
using farol::test::at;
using farol::test::Guided;

namespace {

/// At a spot, facing so many degrees counter-clockwise from east, for some seconds.
std::vector<Cue> standing(Guided& walk, const std::string& region, char spot, double headingDeg,
                          double seconds, double sigmaDeg = 15.0, double sigmaM = 0.5) {
    std::vector<Cue> heard;
    for (double t = 0.0; t < seconds; t += 0.5) {
        walk.fix = {};
        walk.fix.followed = true;
        walk.fix.region = RegionId(region);
        walk.fix.confidence = 0.95;
        walk.fix.level = 0.0;
        walk.fix.position = walk.map.spot(spot).position;
        walk.fix.sigmaM = sigmaM;
        walk.fix.heading = fromDegrees(headingDeg);
        walk.fix.headingSigma = fromDegrees(sigmaDeg);
        walk.later(0.5);
        heard.insert(heard.end(), walk.cues.begin(), walk.cues.end());
    }
    return heard;
}

/// The last order to pass something.
const Cue* lastOrder(const std::vector<Cue>& heard) {
    const Cue* last = nullptr;
    for (const Cue& cue : heard)
        if (cue.kind == CueKind::Prepare || cue.kind == CueKind::Act || cue.kind == CueKind::RouteStart)
            last = &cue;
    return last;
}

TEST(Facing, WhoFacesAwayIsTurnedRoundAndThenLed) {
    Guided walk;
    walk.tracker.setDestination(at("S"));
    standing(walk, "K", '5', 180.0, 2.0);
    const std::vector<Cue> heard = standing(walk, "K", '5', 180.0, 8.0);
    const Cue* order = lastOrder(heard);
    ASSERT_NE(order, nullptr) << "nobody who goes the wrong way waits for the next announcement";
    ASSERT_TRUE(order->turnFirst);
    EXPECT_NEAR(std::abs(toDegrees(*order->turnFirst)), 180.0, 30.0);
    EXPECT_TRUE(order->facingWay);
    EXPECT_FALSE(order->hour) << "it would not hold after the turn";
}

/// Comes into the lobby from W, on the way to F.
Guided inLobby() {
    Guided walk(test::lobbyMap(), {}, {}, true);
    walk.tracker.setDestination(at("F"));
    standing(walk, "W", '1', 0.0, 2.0);
    return walk;
}

TEST(Facing, InALobbyTheWallIsToldFromTheDoorOn) {
    Guided walk = inLobby();
    const std::vector<Cue> heard = standing(walk, "L", '6', 0.0, 12.0);
    const Cue* told = lastOrder(heard);
    ASSERT_NE(told, nullptr);
    EXPECT_EQ(told->manoeuvre->number, 2);
    EXPECT_EQ(told->manoeuvre->side, routing::Side::Right);
    EXPECT_TRUE(told->facingWay) << "one faces inwards in the door";
    for (const Cue& cue : heard)
        EXPECT_FALSE(cue.manoeuvre && !cue.manoeuvre->alongWall) << "of five doors around one is ahead";
}

TEST(Facing, OnTheWayAlongTheWallTheDoorsThatAreLeftAreTold) {
    Guided walk = inLobby();
    const std::vector<Cue> heard = standing(walk, "L", '7', -80.0, 40.0, 15.0, 0.2);
    const Cue* order = lastOrder(heard);
    ASSERT_NE(order, nullptr);
    EXPECT_TRUE(order->manoeuvre->alongWall);
    EXPECT_EQ(order->manoeuvre->side, routing::Side::Right);
    EXPECT_FALSE(order->hour);
    EXPECT_FALSE(order->distanceM);
}

TEST(Facing, InTheMiddleOfALobbyNoWallIsToldToOneWhoFacesNobodyKnowsWhere) {
    Guided walk = inLobby();
    const std::vector<Cue> heard = standing(walk, "L", '8', 0.0, 40.0, 90.0);
    const Cue* order = lastOrder(heard);
    ASSERT_NE(order, nullptr) << "silence is no answer either";
    EXPECT_FALSE(order->manoeuvre->alongWall);
    EXPECT_EQ(order->manoeuvre->side, routing::Side::None);
    EXPECT_FALSE(order->facingWay) << "nor is it ahead";
}

TEST(Facing, WhoFacesTheWayIsNotTurned) {
    Guided walk;
    walk.tracker.setDestination(at("S"));
    for (const Cue& cue : standing(walk, "K", '3', 5.0, 20.0)) EXPECT_FALSE(cue.turnFirst);
}

/// "Then, straight away, through the next door" was said before the first one; between the two it is still to
/// be found.
TEST(Facing, ADoorThatWasToldWithTheOneBeforeIsNotLeftOut) {
    auto map = AsciiMap().floor(R"(
        +------+---+---+------+
        |A     |L  |K  |E     |
        |   1  / 2 / 3 /      |
        +------+---+---+------+
    )");
    Guided walk(map);
    walk.tracker.setDestination(at("E"));
    standing(walk, "A", '1', 0.0, 1.0);
    const std::vector<Cue> heard = standing(walk, "L", '2', 0.0, 10.0);
    const Cue* order = lastOrder(heard);
    ASSERT_NE(order, nullptr);
    EXPECT_EQ(order->manoeuvre->access.value, "K-L");
    ASSERT_TRUE(order->next);
    EXPECT_EQ(order->next->access.value, "E-K");
}

/// "The door on your left", and another one comes first: that one would be taken.
TEST(Facing, ADoorBehindAnotherIsNotAnnouncedWhereThePlaceIsVague) {
    auto map = AsciiMap().floor(R"(
        +----+----+----+----+----+----+
        |A   |B   |C   |D   |E   |F   |
        +--/-+--/-+--/-+--/-+--/-+--/-+
        |K 1 2 3 4 5 6 7 8     9      |
        +-----------------------------+
    )");
    map.region('K', {"Corridor", building::RegionKind::Corridor});
    auto doorsTold = [&](double sigmaM) {
        GuidanceOptions early;
        early.repeatAfterSeconds = 5.0;
        early.prepareDistanceM = 8.0;
        Guided walk(map, early);
        // The one that knows on which side a door is.
        walk.tracker = RouteTracker(walk.building, routing::makeOptimalPlanner(walk.building));
        walk.tracker.setDestination(at("E"));
        for (char spot : std::string("1234567")) standing(walk, "K", spot, 0.0, 2.0, 15.0, sigmaM);
        std::vector<Cue> told = standing(walk, "K", '8', 0.0, 3.0, 15.0, sigmaM);
        std::size_t tooEarly = told.size();
        std::vector<Cue> near = standing(walk, "K", '9', 0.0, 8.0, 15.0, sigmaM);
        EXPECT_NE(lastOrder(near), nullptr) << sigmaM;
        return tooEarly;
    };
    EXPECT_EQ(doorsTold(2.5), 0U);
}

TEST(Facing, WhoWasSentIntoALiftIsToldWhatToDoInside) {
    auto map = AsciiMap()
                   .floor(R"(
        +----------+----+
        |K         |L   |
        |   1    2 /    |
        +----------+----+
    )")
                   .floor(R"(
        +----------+----+
        |M         |U   |
        |          /    |
        +----------+----+
    )",
                          1.0)
                   .join(building::AccessKind::Elevator, 'L', 'U', "one")
                   .region('L', {"Lift", building::RegionKind::Elevator})
                   .region('U', {"Lift", building::RegionKind::Elevator});
    Guided walk(map);
    walk.tracker.setDestination(at("M"));
    standing(walk, "K", '1', 0.0, 6.0);
    const std::vector<Cue> there = standing(walk, "K", '2', 0.0, 8.0);
    const Cue* order = lastOrder(there);
    ASSERT_NE(order, nullptr);
    EXPECT_EQ(order->manoeuvre->kind, routing::ManoeuvreKind::Door);
    // As far as can be seen nothing has changed since.
    const std::vector<Cue> later = standing(walk, "K", '2', 0.0, 14.0);
    auto ride = std::find_if(later.begin(), later.end(), [](const Cue& cue) {
        return cue.manoeuvre && cue.manoeuvre->kind == routing::ManoeuvreKind::Elevator;
    });
    ASSERT_NE(ride, later.end()) << "nobody in a car waits for a word in vain";
    EXPECT_FALSE(ride->levelName.empty());
}

TEST(Facing, AVagueHeadingTurnsNobody) {
    Guided walk;
    walk.tracker.setDestination(at("S"));
    for (const Cue& cue : standing(walk, "K", '5', 180.0, 20.0, 60.0)) {
        EXPECT_FALSE(cue.turnFirst);
        EXPECT_FALSE(cue.hour);
    }
}

TEST(Facing, AVagueHeadingGivesNoHourToWhoWalksAlong) {
    Guided walk;
    walk.tracker.setDestination(at("S"));
    int orders = 0;
    for (char spot : std::string("123456")) {
        for (const Cue& cue : standing(walk, "K", spot, 150.0, 3.0, 70.0)) {
            orders += cue.kind == CueKind::Prepare || cue.kind == CueKind::Act ? 1 : 0;
            EXPECT_FALSE(cue.hour) << "the way is walked, but who knows where the camera looks?";
        }
    }
    EXPECT_GT(orders, 0);
}

TEST(Facing, WhoIsTurningIsNotToldToTurnAgain) {
    Guided walk;
    walk.tracker.setDestination(at("S"));
    standing(walk, "K", '5', 180.0, 2.0);
    int told = 0;
    for (int i = 0; i < 12; ++i)
        for (const Cue& cue : standing(walk, "K", '5', 180.0 + 45.0 * i, 0.5)) told += cue.turnFirst ? 1 : 0;
    EXPECT_EQ(told, 0);
}

TEST(Facing, OneOrderToTurnIsFollowedBeforeTheNext) {
    Guided walk;
    walk.tracker.setDestination(at("S"));
    std::vector<double> times;
    for (const Cue& cue : standing(walk, "K", '5', 180.0, 40.0))
        if (cue.turnFirst) times.push_back(cue.time);
    ASSERT_GE(times.size(), 2U);
    for (std::size_t i = 1; i < times.size(); ++i) EXPECT_GE(times[i] - times[i - 1], 4.0);
}

TEST(Facing, ADoorAtHandIsWhereItsWallIs) {
    // In room B before its door, which is in the south wall; facing east.
    Guided walk(test::corridorMap().landmark('b', {Kind::Poster}));
    walk.tracker.setDestination(at("A"));
    std::vector<Cue> heard = standing(walk, "B", 'b', 0.0, 3.0);
    walk.fix.position = walk.building->access(AccessId("B-K"))->midpoint() + Point2{0.0, 0.6};
    heard.clear();
    for (int i = 0; i < 30; ++i) {
        walk.later(0.5);
        heard.insert(heard.end(), walk.cues.begin(), walk.cues.end());
    }
    const Cue* order = lastOrder(heard);
    ASSERT_NE(order, nullptr);
    ASSERT_TRUE(order->turnFirst) << "the door is on the right";
    EXPECT_NEAR(toDegrees(*order->turnFirst), -90.0, 5.0);
    EXPECT_EQ(order->manoeuvre->side, routing::Side::None) << "after the turn it is ahead";
}

TEST(Facing, AnAnswerKnowsWhereOneFacesToo) {
    Guided walk;
    walk.tracker.setDestination(at("S"));
    standing(walk, "K", '5', 180.0, 30.0);
    // Its words came long ago.
    Cue answer = walk.scheduler.answer(Question::Next, walk.frame, walk.fix, walk.progress);
    EXPECT_TRUE(answer.turnFirst || answer.hour);
}

} // namespace
