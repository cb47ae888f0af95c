#include "tests/guidance/guided.h"

#include <gtest/gtest.h>

using namespace farol;
using namespace farol::guidance;
using farol::test::AsciiMap;
using farol::test::at;
using farol::test::Guided;
using farol::test::sureArrivals;

namespace {

/// A long corridor K with a lobby L behind it, both to be crossed on the way to B.
AsciiMap longCorridor() {
    return AsciiMap()
        .floor(R"(
            +----+------------------------------------------+--+-------+
            |A   /K 1    2    3    4    5    6    7   8 9   /L /   B   |
            |    |                                          |  |       |
            +----+------------------------------------------+--+-------+
        )")
        .region('B', {"Library", building::RegionKind::Room});
}

localisation::Observation sight(Kind kind, const std::string& text = {}, ImageBox box = {20, 400, 60, 60}) {
    localisation::Observation observation;
    observation.detection.kind = kind;
    observation.detection.text = text;
    observation.detection.quad = quadOf(box);
    observation.detection.image = {640, 480};
    observation.detection.score = 0.9;
    return observation;
}

TEST(CueScheduler, StartOfTheRouteNamesDestinationAndFirstManoeuvre) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    walk.seen("K", '5');
    const Cue* start = walk.find(CueKind::RouteStart);
    ASSERT_NE(start, nullptr);
    EXPECT_EQ(start->region.value, "U");
    EXPECT_EQ(start->regionName, "Office");
    ASSERT_TRUE(start->manoeuvre);
    EXPECT_EQ(start->manoeuvre->access.value, "K-S");
    EXPECT_TRUE(start->distanceM);
    EXPECT_EQ(start->routeVersion, walk.progress.routeVersion);
    EXPECT_TRUE(start->sure);
    EXPECT_EQ(walk.cues.size(), 1U) << "nothing collides with the start";
    walk.later(0.1);
    EXPECT_TRUE(walk.cues.empty());
}

TEST(CueScheduler, NobodyIsSentThroughADoorByAGuess) {
    GuidanceOptions honest;
    honest.usableConfidence = 0.5;
    honest.usableNearConfidence = 0.8;
    Guided walk(test::corridorMap(), honest);
    walk.tracker.setDestination(at("D"));
    walk.seen("A", 0, 0.9);
    walk.all.clear();
    for (int i = 0; i < 2; ++i) walk.seen("K", '2', 0.3);
    EXPECT_EQ(walk.count(CueKind::Prepare) + walk.count(CueKind::Act), 0U);
    walk.seen("K", '2', 0.3);
    EXPECT_EQ(walk.count(CueKind::Unsure), 1U) << "asked to look around instead";
    Guided near(test::corridorMap(), honest);
    near.tracker.setDestination(at("D"));
    near.seen("A", 0, 0.9);
    near.all.clear();
    near.fix = {};
    near.fix.region = RegionId("K");
    near.fix.confidence = 0.3;
    near.fix.nearConfidence = 0.9;
    near.fix.level = 0.0;
    for (int i = 0; i < 20; ++i) {
        near.fix.evidenceTime = near.time + 1.0;
        near.later(1.0);
    }
    EXPECT_GE(near.count(CueKind::Prepare) + near.count(CueKind::Act), 1U) << "in it or next to it, surely";
    EXPECT_EQ(near.count(CueKind::Unsure), 0U);
}

/// A place seen in the middle of a corridor that runs east; the library lies to the west.
const Cue* startFacing(Guided& walk, double headingDegrees, Kind kind) {
    walk.tracker.setDestination(at("A"));
    walk.seen("K", '5');
    walk.tracker.setDestination(at("B"));
    walk.tracker.setDestination(at("A"));
    for (const building::Landmark& landmark : walk.building->landmarks()) {
        if (landmark.kind == kind) walk.fix.landmark = landmark.id;
    }
    walk.fix.heading = fromDegrees(headingDegrees);
    walk.time += 1.0;
    walk.fix.evidenceTime = walk.time;
    walk.later(0.0);
    return walk.find(CueKind::RouteStart);
}

AsciiMap corridorWithPlace() {
    return test::corridorMap().landmark('5', {Kind::Place, {}, "p5"}).landmark('4', {Kind::Poster});
}

TEST(CueScheduler, TurnsTheUserRoundWhenTheWayBeginsBehind) {
    Guided walk(corridorWithPlace());
    const Cue* start = startFacing(walk, 0.0, Kind::Place);
    ASSERT_NE(start, nullptr);
    ASSERT_TRUE(start->turnFirst.has_value());
    EXPECT_GT(std::abs(toDegrees(*start->turnFirst)), 120.0);
}

TEST(CueScheduler, SaysNothingOfTurningWhenTheWayIsAheadOrTheFacingIsAGuess) {
    Guided ahead(corridorWithPlace());
    const Cue* start = startFacing(ahead, 180.0, Kind::Place);
    ASSERT_NE(start, nullptr);
    EXPECT_FALSE(start->turnFirst.has_value());
    Guided guess(corridorWithPlace());
    start = startFacing(guess, 0.0, Kind::Poster);
    ASSERT_NE(start, nullptr);
    EXPECT_FALSE(start->turnFirst.has_value()) << "two rough positions do not tell which way one faces";
}

TEST(CueScheduler, PreparesAtSixMetresAndActsAtTwo) {
    Guided walk(longCorridor());
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    walk.seen("K", '1');
    EXPECT_EQ(walk.find(CueKind::Prepare), nullptr) << "far away yet";
    walk.seen("K", '7');
    EXPECT_EQ(walk.find(CueKind::Act), nullptr);
    walk.seen("K", '8');
    const Cue* prepare = walk.find(CueKind::Prepare);
    ASSERT_NE(prepare, nullptr);
    EXPECT_EQ(prepare->manoeuvre->access.value, "K-L");
    ASSERT_TRUE(prepare->distanceM);
    EXPECT_LE(*prepare->distanceM, 6.0);
    EXPECT_EQ(prepare->validIn, (std::vector<RegionId>{RegionId("K")}));
    EXPECT_EQ(prepare->intoName, "L");
}

TEST(CueScheduler, AnObjectSeenFromAfarIsNoGroundForAnOrderToAct) {
    Guided walk(longCorridor());
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    walk.seen("K", '8');
    walk.fix.position =
        Point2{walk.building->access(AccessId("K-L"))->midpoint().x - 1.0, walk.map.spot('9').position->y};
    walk.fix.sigmaM = 2.0;
    walk.fix.evidenceTime = walk.time + 4;
    walk.later(4.0);
    EXPECT_EQ(walk.find(CueKind::Act), nullptr);
}

TEST(CueScheduler, ActIsVoidOnceItsRegionIsLeft) {
    Guided walk(longCorridor());
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    walk.seen("K", '8');
    walk.fix.position =
        Point2{walk.building->access(AccessId("K-L"))->midpoint().x - 1.0, walk.map.spot('9').position->y};
    walk.fix.evidenceTime = walk.time + 4;
    walk.later(4.0);
    const Cue* act = walk.find(CueKind::Act);
    ASSERT_NE(act, nullptr);
    EXPECT_EQ(act->priority, CuePriority::ActNow);
    EXPECT_EQ(act->validIn, (std::vector<RegionId>{RegionId("K")}));
    EXPECT_LE(act->validUntil - act->time, 5.0);
    EXPECT_EQ(act->routeVersion, walk.progress.routeVersion);
}

TEST(CueScheduler, TwoManoeuvresCloseTogetherAreToldInOneBreath) {
    Guided walk(longCorridor());
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    walk.seen("K", '8');
    const Cue* prepare = walk.find(CueKind::Prepare);
    ASSERT_NE(prepare, nullptr);
    ASSERT_TRUE(prepare->next) << "the lobby's other door is three metres on";
    EXPECT_EQ(prepare->next->access.value, "B-L");
    walk.seen("L");
    EXPECT_EQ(walk.find(CueKind::Prepare), nullptr) << "told already";
    EXPECT_EQ(walk.find(CueKind::Act), nullptr);
}

TEST(CueScheduler, WithoutAPositionTheExitIsToldOnceOnEntering) {
    Guided walk(longCorridor());
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    walk.seen("K");
    const Cue* prepare = walk.find(CueKind::Prepare);
    ASSERT_NE(prepare, nullptr);
    EXPECT_FALSE(prepare->distanceM);
    EXPECT_FALSE(prepare->hour);
    EXPECT_EQ(walk.cues.size(), 1U);
    for (const Cue& cue : walk.wait(14)) EXPECT_NE(cue.kind, CueKind::Prepare);
}

TEST(CueScheduler, TheSameActionIsNotToldTwiceWithinFifteenSeconds) {
    Guided walk(longCorridor());
    walk.secondsBetween = 1.0;
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    std::map<CueKind, double> last;
    for (int i = 0; i < 40; ++i) {
        walk.seen("K", i % 2 == 0 ? '8' : '9');
        for (const Cue& cue : walk.cues) {
            auto before = last.find(cue.kind);
            if (before != last.end()) {
                EXPECT_GE(cue.time - before->second, 15.0) << cueKindName(cue.kind);
            }
            last[cue.kind] = cue.time;
        }
    }
}

TEST(CueScheduler, ReassuresEveryTenMetresOnAStraightStretch) {
    Guided walk(longCorridor());
    walk.secondsBetween = 6.0;
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    for (char spot : {'1', '2', '3', '4', '5', '6'}) walk.seen("K", spot); // 25 m
    std::size_t told = walk.count(CueKind::Reassure);
    EXPECT_GE(told, 2U);
    EXPECT_LE(told, 3U);
    EXPECT_EQ(walk.count(CueKind::Prepare), 0U);
}

TEST(CueScheduler, NobodyIsReassuredWithoutAnythingSeen) {
    Guided walk(longCorridor());
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    walk.seen("K");
    for (const Cue& cue : walk.wait(120)) EXPECT_NE(cue.kind, CueKind::Reassure);
}

TEST(CueScheduler, ArrivedIsSaidOnceAndOnlyInTheDestination) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("K", '1');
    walk.seen("K", '2');
    EXPECT_EQ(walk.count(CueKind::Arrived), 0U);
    walk.seen("D");
    const Cue* arrived = walk.find(CueKind::Arrived);
    ASSERT_NE(arrived, nullptr);
    EXPECT_EQ(arrived->region.value, "D");
    EXPECT_EQ(arrived->validIn, (std::vector<RegionId>{RegionId("D")}));
    for (int i = 0; i < 10; ++i) walk.seen("D");
    EXPECT_EQ(walk.count(CueKind::Arrived), 1U);
    EXPECT_EQ(walk.count(CueKind::AlreadyThere), 0U);
}

TEST(CueScheduler, DestinationWhereOneIsAlready) {
    Guided walk;
    walk.tracker.setDestination(at("A"));
    walk.seen("A");
    const Cue* there = walk.find(CueKind::AlreadyThere);
    ASSERT_NE(there, nullptr);
    EXPECT_EQ(there->regionName, "Library");
    EXPECT_EQ(walk.count(CueKind::Arrived), 0U);
    walk.seen("A");
    EXPECT_EQ(walk.count(CueKind::AlreadyThere), 1U);
}

TEST(CueScheduler, ChosenAgainItIsSaidAgain) {
    Guided walk;
    walk.tracker.setDestination(at("A"));
    walk.seen("A");
    walk.tracker.setDestination(at("A"));
    walk.seen("A");
    EXPECT_EQ(walk.count(CueKind::AlreadyThere), 2U);
    for (int i = 0; i < 2; ++i) {
        walk.tracker.setDestination(at("X"));
        walk.seen("A");
    }
    EXPECT_EQ(walk.count(CueKind::NoRoute), 2U);
}

TEST(CueScheduler, UnreachableAndUnknownDestinationsAreSpokenWithTheirReason) {
    Guided walk;
    walk.tracker.setDestination(at("X"));
    walk.seen("A");
    const Cue* cue = walk.find(CueKind::NoRoute);
    ASSERT_NE(cue, nullptr);
    EXPECT_EQ(cue->reason, CueReason::DestinationUnreachable);
    EXPECT_FALSE(cue->detail.empty());
    walk.seen("K");
    EXPECT_EQ(walk.count(CueKind::NoRoute), 1U);
    walk.tracker.setDestination(at("nowhere"));
    walk.seen("K");
    cue = walk.find(CueKind::NoRoute);
    ASSERT_NE(cue, nullptr);
    EXPECT_EQ(cue->reason, CueReason::DestinationUnknown);
}

TEST(CueScheduler, LeavingTheRouteIsSaidWithTheNewWay) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("C");
    const Cue* off = walk.find(CueKind::OffRoute);
    ASSERT_NE(off, nullptr);
    ASSERT_TRUE(off->manoeuvre);
    EXPECT_EQ(off->manoeuvre->access.value, "C-K");
    EXPECT_EQ(off->routeVersion, 2U);
    EXPECT_EQ(walk.count(CueKind::RouteStart), 1U) << "not a second start";
    walk.seen("B");
    EXPECT_EQ(walk.count(CueKind::OffRoute), 1U) << "not again within ten seconds";
    const Cue* prepare = walk.find(CueKind::Prepare);
    ASSERT_NE(prepare, nullptr) << "but the new way has to be told";
    EXPECT_EQ(prepare->manoeuvre->access.value, "B-K");
}

TEST(CueScheduler, LeavingTheRouteToWhereNoWayLeadsIsSaid) {
    auto map = AsciiMap().floor("+---+---+---+\n|A  /B  |C  |\n|   |   |   |\n+---+---+---+");
    Guided walk(map);
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    walk.seen("C");
    const Cue* off = walk.find(CueKind::OffRoute);
    ASSERT_NE(off, nullptr);
    EXPECT_EQ(off->reason, CueReason::DestinationUnreachable);
    EXPECT_FALSE(off->manoeuvre);
}

TEST(CueScheduler, AsksToLookAroundAfterEightSecondsWithoutAFix) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.later(0.0);
    for (const Cue& cue : walk.wait(7)) EXPECT_NE(cue.kind, CueKind::Unsure);
    walk.later(1.0);
    ASSERT_NE(walk.find(CueKind::Unsure), nullptr);
    EXPECT_EQ(walk.find(CueKind::Unsure)->sweep, SweepStep::Right);
}

TEST(CueScheduler, WhoIsLostIsLedThroughALookAroundOneOrderAtATime) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.later(0.0);
    std::vector<SweepStep> steps;
    for (const Cue& cue : walk.wait(55))
        if (cue.kind == CueKind::Unsure) steps.push_back(cue.sweep);
    EXPECT_EQ(steps, (std::vector{SweepStep::Right, SweepStep::Left, SweepStep::Up, SweepStep::Down,
                                  SweepStep::AskForHelp, SweepStep::Right, SweepStep::Left}));
}

TEST(CueScheduler, TheLookAroundStopsAsSoonAsThePlaceIsKnown) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.later(0.0);
    walk.wait(15);
    walk.seen("A");
    ASSERT_NE(walk.find(CueKind::Unsure), nullptr);
    EXPECT_EQ(walk.find(CueKind::Unsure)->sweep, SweepStep::Done);
    EXPECT_NE(walk.find(CueKind::RouteStart), nullptr) << "and the way is told";
    walk.seen("A");
    EXPECT_EQ(walk.find(CueKind::Unsure), nullptr);
}

TEST(CueScheduler, WhoWasAskedToLookAroundLongAgoIsNotToldToStop) {
    Guided walk;
    walk.later(0.0);
    walk.wait(60);
    walk.seen("A");
    EXPECT_EQ(walk.find(CueKind::Unsure), nullptr);
}

TEST(CueScheduler, AFixWithoutAnyConfidenceIsNoFix) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("K", 0, 0.0);
    EXPECT_TRUE(walk.cues.empty()) << "no instruction on such ground";
    bool asked = false;
    for (const Cue& cue : walk.wait(10)) asked = asked || cue.kind == CueKind::Unsure;
    EXPECT_TRUE(asked);
}

TEST(CueScheduler, ADoubtfulSightOfTheDestinationIsSettledByLookingAround) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("K");
    walk.seen("D", 0, 0.3);
    EXPECT_EQ(walk.count(CueKind::Arrived), 0U);
    bool asked = false;
    for (const Cue& cue : walk.wait(10)) asked = asked || cue.kind == CueKind::Unsure;
    EXPECT_TRUE(asked);
    walk.seen("D", 0, 0.3);
    EXPECT_EQ(walk.count(CueKind::Arrived), 1U);
}

TEST(CueScheduler, WhoIsPerhapsThereAlreadyIsAskedToLookAround) {
    Guided walk(test::corridorMap(), {}, sureArrivals());
    walk.tracker.setDestination(at("D"));
    walk.seen("D", 0, 0.3);
    bool asked = false;
    for (const Cue& cue : walk.wait(10)) asked = asked || cue.kind == CueKind::Unsure;
    EXPECT_TRUE(asked) << "a choice is answered, by a question if need be";
    EXPECT_EQ(walk.count(CueKind::AlreadyThere), 0U);
    walk.seen("D", 0, 0.96);
    walk.seen("D", 0, 0.96);
    EXPECT_EQ(walk.count(CueKind::AlreadyThere), 1U);
    EXPECT_EQ(walk.wait(30).size(), 0U);
}

TEST(CueScheduler, WithoutADestinationItAsksOnlyOnce) {
    Guided walk;
    walk.later(0.0);
    walk.wait(120);
    EXPECT_EQ(walk.count(CueKind::Unsure), 1U);
}

TEST(CueScheduler, SaysWhereOneIsWhenNoInstructionDoes) {
    Guided walk;
    walk.seen("A");
    const Cue* located = walk.find(CueKind::Located);
    ASSERT_NE(located, nullptr);
    EXPECT_EQ(located->regionName, "Library");
    EXPECT_FALSE(located->levelName.empty());
    walk.seen("A");
    EXPECT_EQ(walk.find(CueKind::Located), nullptr);
    walk.seen("K", 0, 0.2);
    EXPECT_EQ(walk.find(CueKind::Located), nullptr) << "one doubtful sight";
    walk.seen("K", 0, 0.2);
    ASSERT_NE(walk.find(CueKind::Located), nullptr);
    EXPECT_FALSE(walk.find(CueKind::Located)->sure);
}

TEST(CueScheduler, ARegionThatTheInstructionNamedIsNotSaidAgain) {
    Guided walk(longCorridor());
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    walk.seen("K", '1');
    EXPECT_EQ(walk.count(CueKind::Located), 0U) << "the start said: next, the corridor";
}

TEST(CueScheduler, DoubtfulFixesAreHedged) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A", 0, 0.3);
    ASSERT_NE(walk.find(CueKind::RouteStart), nullptr);
    EXPECT_FALSE(walk.find(CueKind::RouteStart)->sure);
}

TEST(CueScheduler, NoDistanceFromAVaguePosition) {
    Guided walk(longCorridor());
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    walk.seen("K", '7');
    walk.fix.position = walk.map.spot('8').position;
    walk.fix.sigmaM = 4.0;
    walk.fix.evidenceTime = walk.time + 1;
    walk.later(1.0);
    ASSERT_NE(walk.find(CueKind::Prepare), nullptr);
    EXPECT_FALSE(walk.find(CueKind::Prepare)->distanceM);
}

/// The hour of the announcement of the exit, after a sight at `before` and with this heading at the last one.
std::optional<int> hourAfter(char before, std::optional<Radians> heading, double confidence = 0.9) {
    Guided walk(longCorridor());
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    walk.seen("K", before);
    walk.fix.position = walk.map.spot('8').position;
    walk.fix.heading = heading;
    walk.fix.confidence = confidence;
    walk.fix.evidenceTime = walk.time + 4;
    walk.later(4.0);
    const Cue* prepare = walk.find(CueKind::Prepare);
    return prepare != nullptr ? prepare->hour : std::nullopt;
}

TEST(CueScheduler, ClockHourOnlyWhileWalkingAlongTheRouteAndSure) {
    EXPECT_EQ(hourAfter('6', Radians{0.0}), 12);
    EXPECT_EQ(hourAfter('6', fromDegrees(90)), 3) << "facing north, the door is in the east";
    EXPECT_EQ(hourAfter('6', std::nullopt), std::nullopt);
    EXPECT_EQ(hourAfter('6', Radians{0.0}, 0.3), std::nullopt) << "not sure";
    EXPECT_EQ(hourAfter('9', fromDegrees(180)), std::nullopt) << "walking away from the door";
}

TEST(CueScheduler, TurnsComeFromTheRouteWhateverTheHeadingSays) {
    for (double degrees : {0.0, 90.0, 180.0}) {
        Guided walk;
        walk.tracker.setDestination(at("U"));
        walk.seen("A");
        walk.seen("K");
        walk.fix.heading = fromDegrees(degrees);
        walk.later(16.0);
        for (const Cue& cue : walk.all) {
            if (cue.manoeuvre && cue.manoeuvre->access.value == "A-K") {
                EXPECT_GT(cue.manoeuvre->turn.value, 0.0) << "out of the room and to the left";
            }
        }
    }
}

TEST(CueScheduler, StairsAreToldWithTheirLevel) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    walk.seen("K");
    walk.seen("S");
    const Cue* prepare = walk.find(CueKind::Prepare);
    if (prepare == nullptr) prepare = walk.find(CueKind::Act);
    ASSERT_NE(prepare, nullptr);
    EXPECT_EQ(prepare->manoeuvre->kind, routing::ManoeuvreKind::Stairs);
    EXPECT_EQ(prepare->levelName, "Level 1");
    EXPECT_EQ(prepare->manoeuvre->steps, 18);
    EXPECT_FALSE(prepare->next) << "nobody knows the way one faces after stairs";
}

TEST(CueScheduler, ObjectsByVerbosityOnFirstSight) {
    for (auto [verbosity, expected] : {std::pair{Verbosity::Directions, 0}, std::pair{Verbosity::Objects, 1},
                                       std::pair{Verbosity::ObjectsAndTexts, 2}}) {
        GuidanceOptions options;
        options.verbosity = verbosity;
        Guided walk(test::corridorMap(), options);
        walk.seen("A");
        walk.fresh = {sight(Kind::Extinguisher), sight(Kind::Text, "2.14"), sight(Kind::Place)};
        walk.later(1.0);
        EXPECT_EQ(static_cast<int>(walk.cues.size()), expected);
    }
}

TEST(CueScheduler, ExtinguisherLeftDown) {
    Guided walk;
    walk.seen("A");
    walk.fresh = {sight(Kind::Extinguisher)};
    walk.later(1.0);
    const Cue* cue = walk.find(CueKind::Detection);
    ASSERT_NE(cue, nullptr);
    EXPECT_EQ(cue->objectKind, Kind::Extinguisher);
    EXPECT_EQ(zoneName(cue->zone), "left-down");
    walk.fresh = {sight(Kind::Extinguisher)};
    walk.later(19.0);
    EXPECT_EQ(walk.find(CueKind::Detection), nullptr);
    walk.fresh = {sight(Kind::Extinguisher)};
    walk.later(2.0);
    EXPECT_NE(walk.find(CueKind::Detection), nullptr);
}

TEST(CueScheduler, TextsAreToldWithTheirWords) {
    GuidanceOptions options;
    options.verbosity = Verbosity::ObjectsAndTexts;
    Guided walk(test::corridorMap(), options);
    walk.seen("A");
    walk.fresh = {sight(Kind::Text, "2.14"), sight(Kind::Text, "2.15"), sight(Kind::Text, "2.14")};
    walk.later(1.0);
    ASSERT_EQ(walk.cues.size(), 2U);
    EXPECT_EQ(walk.cues[0].text, "2.14");
    EXPECT_EQ(walk.cues[1].text, "2.15");
}

TEST(CueScheduler, MostUrgentFirstAndIdsRise) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.fresh = {sight(Kind::Extinguisher)};
    walk.seen("A");
    ASSERT_EQ(walk.cues.size(), 2U);
    EXPECT_EQ(walk.cues[0].kind, CueKind::RouteStart);
    EXPECT_EQ(walk.cues[1].kind, CueKind::Detection);
    EXPECT_EQ(walk.cues[0].id, 1U);
    EXPECT_EQ(walk.cues[1].id, 2U);
    Cue warning = walk.scheduler.warning(9, walk.time, CueReason::CameraLost, "unplugged");
    EXPECT_EQ(warning.id, 3U);
    EXPECT_EQ(warning.kind, CueKind::Warning);
    EXPECT_EQ(warning.priority, CuePriority::Warning);
    EXPECT_GT(warning.validUntil, warning.time);
    EXPECT_TRUE(warning.validIn.empty());
}

TEST(GuidanceOptions, ValuesOutOfRangeAreRefused) {
    EXPECT_TRUE(GuidanceOptions{}.check().ok());
    GuidanceOptions bad;
    bad.prepareDistanceM = 1.0;
    EXPECT_FALSE(bad.check().ok()) << "nearer than the act";
    bad = {};
    bad.repeatAfterSeconds = 0.0;
    EXPECT_FALSE(bad.check().ok());
    bad = {};
    bad.usableConfidence = -0.1;
    EXPECT_FALSE(bad.check());
    bad = {};
    bad.usableNearConfidence = 1.5;
    EXPECT_FALSE(bad.check());
    bad = {};
    bad.sureConfidence = 2.0;
    EXPECT_FALSE(bad.check().ok());
}

TEST(CueNames, AreStable) {
    EXPECT_EQ(cueKindName(CueKind::RouteStart), "route_start");
    EXPECT_EQ(cueKindName(CueKind::AlreadyThere), "already_there");
    EXPECT_EQ(cueReasonName(CueReason::DestinationUnreachable), "destination_unreachable");
    EXPECT_EQ(travelName(Travel::OffRoute), "off_route");
}

} // namespace
