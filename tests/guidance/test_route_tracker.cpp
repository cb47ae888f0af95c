#include "tests/guidance/guided.h"

#include <gtest/gtest.h>

using namespace farol;
using namespace farol::guidance;
using farol::test::AsciiMap;
using farol::test::at;
using farol::test::Guided;
using farol::test::sureArrivals;

namespace {

std::string nextAccess(const Progress& progress) {
    return progress.next ? progress.next->access.value : "none";
}

TEST(RouteTracker, PlansOnceDestinationAndRegionAreKnown) {
    Guided walk;
    walk.seen("A");
    EXPECT_EQ(walk.progress.travel, Travel::NoDestination);
    EXPECT_FALSE(walk.progress.route);
    walk.tracker.setDestination(at("D"));
    walk.seen("");
    EXPECT_EQ(walk.progress.travel, Travel::NoFix);
    EXPECT_EQ(walk.planner->plans, 0);
    walk.seen("A");
    ASSERT_TRUE(walk.progress.route);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute);
    EXPECT_EQ(walk.progress.routeVersion, 1U);
    EXPECT_EQ(nextAccess(walk.progress), "A-K");
    ASSERT_TRUE(walk.progress.afterNext);
    EXPECT_EQ(walk.progress.afterNext->access.value, "D-K");
    EXPECT_FALSE(walk.progress.distanceM) << "no position, no distance";
    EXPECT_FALSE(walk.progress.replanned);
}

// A way that was given up, or changed while nobody knows yet where its beginning is: older words are void by
// it.
TEST(RouteTracker, AWayGivenUpIsOlderThanWhatFollows) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    const std::uint64_t way = walk.progress.routeVersion;
    walk.tracker.setDestination(std::nullopt);
    walk.seen("A");
    EXPECT_GT(walk.progress.routeVersion, way);
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    const std::uint64_t again = walk.progress.routeVersion;
    walk.tracker.setDestination(at("B"));
    walk.seen("");
    EXPECT_EQ(walk.progress.travel, Travel::NoFix);
    EXPECT_GT(walk.progress.routeVersion, again);
}

TEST(RouteTracker, FollowsTheRouteToTheDestination) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("K");
    EXPECT_EQ(walk.progress.regionsPassed, 1U);
    EXPECT_EQ(nextAccess(walk.progress), "D-K");
    walk.seen("D");
    EXPECT_EQ(walk.progress.travel, Travel::Arrived);
    EXPECT_EQ(walk.planner->plans, 1);
    EXPECT_EQ(walk.progress.routeVersion, 1U);
}

TEST(RouteTracker, DistancesAlongThePathOnlyWithAPosition) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("K", '6');
    ASSERT_TRUE(walk.progress.distanceM);
    double far = *walk.progress.distanceM, remaining = *walk.progress.remainingM;
    walk.seen("K", '3');
    EXPECT_LE(*walk.progress.distanceM, far);
    EXPECT_LE(*walk.progress.distanceM, *walk.progress.remainingM);
    EXPECT_GT(remaining, 0.0);
    walk.seen("K");
    EXPECT_FALSE(walk.progress.distanceM);
    EXPECT_FALSE(walk.progress.remainingM);
}

TEST(RouteTracker, DistanceToAStraightAheadDoorIsTheWalkingDistance) {
    auto map = AsciiMap().floor(R"(
        +-----------------------+------+
        |K 1       2           3/   B  |
        +-----------------------+------+
    )");
    Guided walk(map);
    walk.tracker.setDestination(at("B"));
    walk.seen("K", '1');
    double door = walk.building->access(AccessId("B-K"))->midpoint().x;
    EXPECT_NEAR(*walk.progress.distanceM, door - walk.map.spot('1').position->x, 0.1);
    walk.seen("K", '2');
    EXPECT_NEAR(*walk.progress.distanceM, door - walk.map.spot('2').position->x, 0.1);
    walk.seen("K", '3');
    EXPECT_NEAR(*walk.progress.distanceM, door - walk.map.spot('3').position->x, 0.1);
}

TEST(RouteTracker, RegionsOfTheRouteMayBeJumpedOverWhenSure) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    walk.seen("A"); // A K S T U
    walk.seen("T", 0, 0.9);
    EXPECT_EQ(walk.progress.regionsPassed, 3U);
    EXPECT_EQ(walk.planner->plans, 1);
}

TEST(RouteTracker, AJumpToTheDestinationIsNotBelievedFromOneDoubtfulSight) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    walk.seen("A");
    walk.seen("U", 0, 0.2);
    EXPECT_NE(walk.progress.travel, Travel::Arrived);
    walk.later(1.0);
    walk.later(1.0);
    EXPECT_NE(walk.progress.travel, Travel::Arrived) << "the same sight again is no confirmation";
    walk.seen("U", 0, 0.2);
    EXPECT_EQ(walk.progress.travel, Travel::Arrived);
}

TEST(RouteTracker, NorIsTheStepThroughTheLastDoor) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("K");
    walk.seen("D", 0, 0.2);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute);
    EXPECT_EQ(walk.progress.regionsPassed, 1U);
    walk.seen("D", 0, 0.2);
    EXPECT_EQ(walk.progress.travel, Travel::Arrived);
}

TEST(RouteTracker, OneDoubtfulFixBesideTheRouteChangesNothing) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("K");
    walk.seen("B", 0, 0.3);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute);
    EXPECT_EQ(walk.progress.regionsPassed, 1U);
    walk.later(0.1);
    walk.later(0.1);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute);
    walk.seen("K", 0, 0.3);
    walk.seen("B", 0, 0.3);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute) << "not twice in a row";
    EXPECT_EQ(walk.planner->plans, 1);
}

TEST(RouteTracker, PlansAnewOnceTheRouteIsLeft) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("B", 0, 0.3);
    walk.seen("B", 0, 0.3);
    EXPECT_EQ(walk.progress.travel, Travel::OffRoute);
    EXPECT_TRUE(walk.progress.replanned);
    EXPECT_EQ(walk.progress.routeVersion, 2U);
    EXPECT_EQ(walk.progress.regionsPassed, 0U);
    EXPECT_EQ(nextAccess(walk.progress), "B-K");
    walk.later(0.1);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute);
    EXPECT_FALSE(walk.progress.replanned);
}

TEST(RouteTracker, AGuessBesideTheRouteHasToLast) {
    TrackerOptions patient;
    patient.offRouteSeconds = 3.5 * Guided().secondsBetween;
    Guided walk(test::corridorMap(), {}, patient);
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    for (int i = 0; i < 3; ++i) walk.seen("B", 0, 0.54);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute);
    walk.seen("A", 0, 0.54);
    for (int i = 0; i < 4; ++i) walk.seen("B", 0, 0.54);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute) << "the time before does not count";
    walk.seen("B", 0, 0.54);
    EXPECT_EQ(walk.progress.travel, Travel::OffRoute);
    walk.seen("B", 0, 0.9);
    walk.seen("C", 0, 0.9);
    EXPECT_EQ(walk.progress.travel, Travel::OffRoute) << "what is sure need not last";
}

TEST(RouteTracker, ASureFixBesideTheRouteIsBelievedAtOnce) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("C", 0, 0.8);
    EXPECT_EQ(walk.progress.travel, Travel::OffRoute);
}

TEST(RouteTracker, DestinationInTheRegionOneIsIn) {
    Guided walk;
    walk.tracker.setDestination(at("A"));
    walk.seen("A");
    EXPECT_EQ(walk.progress.travel, Travel::Arrived);
    ASSERT_TRUE(walk.progress.route);
    EXPECT_TRUE(walk.progress.route->accesses.empty());
}

TEST(RouteTracker, UnreachableDestinationHasAReasonAndIsTriedAgainElsewhere) {
    Guided walk;
    walk.tracker.setDestination(at("X"));
    walk.seen("A");
    EXPECT_EQ(walk.progress.travel, Travel::Unreachable);
    EXPECT_FALSE(walk.progress.reason.empty());
    EXPECT_FALSE(walk.progress.route);
    std::uint64_t version = walk.progress.routeVersion;
    for (int i = 0; i < 5; ++i) walk.seen("A");
    EXPECT_EQ(walk.planner->plans, 1) << "not searched in every frame";
    walk.seen("K");
    EXPECT_EQ(walk.planner->plans, 2);
    EXPECT_EQ(walk.progress.routeVersion, version);
    walk.seen("X");
    EXPECT_EQ(walk.progress.travel, Travel::Arrived);
    EXPECT_TRUE(walk.progress.reason.empty());
}

TEST(RouteTracker, DestinationThatIsNotInTheMap) {
    Guided walk;
    walk.tracker.setDestination(at("nowhere"));
    walk.seen("A");
    EXPECT_EQ(walk.progress.travel, Travel::Unreachable);
    EXPECT_NE(walk.progress.reason.find("nowhere"), std::string::npos);
    EXPECT_EQ(walk.planner->plans, 0);
}

TEST(RouteTracker, ANewDestinationLeavesNothingOfTheOldRoute) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    walk.seen("A");
    walk.seen("K", '5');
    const std::uint64_t old = walk.progress.routeVersion;
    walk.tracker.setDestination(at("D"));
    EXPECT_TRUE(walk.tracker.context().regions.empty());
    walk.seen("K", '5');
    const std::uint64_t version = walk.progress.routeVersion;
    EXPECT_GT(version, old);
    EXPECT_EQ(walk.progress.regionsPassed, 0U);
    EXPECT_EQ(walk.progress.route->regions.front().value, "K");
    EXPECT_EQ(walk.progress.route->regions.back().value, "D");
    walk.tracker.setDestination(std::nullopt);
    walk.seen("K");
    EXPECT_EQ(walk.progress.travel, Travel::NoDestination);
    EXPECT_FALSE(walk.progress.route);
    EXPECT_FALSE(walk.progress.next);
    EXPECT_GT(walk.progress.routeVersion, version) << "never goes back";
}

TEST(RouteTracker, ChangesOfLevelOnTheWay) {
    Guided walk;
    walk.tracker.setDestination(at("U"));
    walk.seen("K", '5');
    walk.seen("S");
    ASSERT_TRUE(walk.progress.next);
    EXPECT_EQ(walk.progress.next->kind, routing::ManoeuvreKind::Stairs);
    EXPECT_EQ(walk.progress.next->vertical, routing::Vertical::Up);
    EXPECT_EQ(walk.progress.next->level, 0.0);
    EXPECT_EQ(walk.progress.next->targetLevel, 1.0);
    walk.seen("T");
    EXPECT_EQ(nextAccess(walk.progress), "T-U");
    EXPECT_EQ(walk.tracker.context().level, 1.0);
    walk.seen("U");
    EXPECT_EQ(walk.progress.travel, Travel::Arrived);
}

TEST(RouteTracker, GoingBackAlongTheRouteIsFollowed) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("K");
    walk.seen("A");
    EXPECT_EQ(walk.progress.regionsPassed, 0U);
    EXPECT_EQ(nextAccess(walk.progress), "A-K");
    EXPECT_EQ(walk.planner->plans, 1);
}

TEST(RouteTracker, AWrongArrivalIsTakenBack) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A");
    walk.seen("K");
    walk.seen("D", 0, 0.9);
    EXPECT_EQ(walk.progress.travel, Travel::Arrived);
    walk.seen("K");
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute);
    EXPECT_EQ(nextAccess(walk.progress), "D-K");
}

TEST(RouteTracker, LosingTheFixKeepsThePlan) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("A", 'a');
    walk.seen("");
    EXPECT_EQ(walk.progress.travel, Travel::NoFix);
    EXPECT_TRUE(walk.progress.route);
    EXPECT_FALSE(walk.progress.distanceM);
    walk.seen("K");
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute);
    EXPECT_EQ(walk.planner->plans, 1);
}

TEST(RouteTracker, RegionsThatTheMapDoesNotHaveAreNoFix) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    walk.seen("nowhere");
    EXPECT_EQ(walk.progress.travel, Travel::NoFix);
    EXPECT_EQ(walk.planner->plans, 0);
}

TEST(RouteTracker, TellsTheLocaliserWhatIsAhead) {
    Guided walk;
    walk.tracker.setDestination(at("D"));
    EXPECT_TRUE(walk.tracker.context().regions.empty());
    walk.seen("A");
    walk.seen("K");
    localisation::RouteContext context = walk.tracker.context();
    EXPECT_EQ(context.regions, (std::vector<RegionId>{RegionId("K"), RegionId("D")}));
    ASSERT_TRUE(context.nextAccess);
    EXPECT_EQ(*context.nextAccess, walk.building->access(AccessId("D-K"))->midpoint());
    EXPECT_EQ(context.level, 0.0);
}

TEST(RouteTracker, FixesBelowTheLeastConfidenceChangeNothing) {
    TrackerOptions strict;
    strict.minConfidence = 0.4;
    Guided walk(test::corridorMap(), {}, strict);
    walk.tracker.setDestination(at("D"));
    walk.seen("A", 0, 0.3);
    EXPECT_EQ(walk.progress.travel, Travel::NoFix);
    walk.seen("A", 0, 0.4);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute);
}

TEST(RouteTracker, AnArrivalWantsConfidenceAndSomethingSeenSince) {
    Guided walk(test::corridorMap(), {}, sureArrivals(0.9));
    walk.tracker.setDestination(at("D"));
    walk.seen("A", 0, 0.95);
    walk.seen("K", 0, 0.95);
    walk.seen("D", 0, 0.95);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute) << "so far it is only expected there";
    walk.seen("D", 0, 0.8);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute) << "not sure enough";
    walk.seen("D", 0, 0.95);
    EXPECT_EQ(walk.progress.travel, Travel::Arrived);
}

TEST(RouteTracker, NobodyHasArrivedBetweenTheSidesOfAnOpening) {
    auto map = AsciiMap().floor(R"(
        +-------+-------+
        |A      :B      |
        |    1  :2    3 |
        |       :       |
        +-------+-------+
    )");
    const TrackerOptions honest = sureArrivals(0.9);
    auto secondsUntilArrived = [&](Point2 spot) {
        Guided walk(map, {}, honest);
        walk.tracker.setDestination(at("B"));
        walk.seen("A", '1', 0.99);
        double since = walk.time;
        while (walk.progress.travel != Travel::Arrived && walk.time - since < 20.0) {
            walk.fix.region = RegionId("B");
            walk.fix.position = spot;
            walk.fix.evidenceTime = walk.time + 0.5;
            walk.later(0.5);
        }
        return walk.time - since;
    };
    const Point2 inside = *map.spot('2').position;
    EXPECT_LT(secondsUntilArrived(inside), 2.0) << "there is nothing to wait for";
    EXPECT_GE(secondsUntilArrived(inside - Point2{0.8, 0.0}), 8.0) << "as soon out again as in";
}

TEST(RouteTracker, WhoWaitsInARoomThatShowsNothingHasProbablyArrived) {
    Guided walk(test::corridorMap(), {}, sureArrivals(0.95, 5));
    walk.tracker.setDestination(at("D"));
    walk.seen("A", 0, 0.95);
    walk.seen("K", 0, 0.95);
    for (int i = 0; i < 4; ++i) walk.seen("D", 0, 0.8);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute) << "a moment only";
    walk.seen("K", 0, 0.8);
    for (int i = 0; i < 4; ++i) walk.seen("D", 0, 0.8);
    EXPECT_EQ(walk.progress.travel, Travel::OnRoute) << "the time before does not count";
    for (int i = 0; i < 4; ++i) walk.seen("D", 0, 0.8);
    EXPECT_EQ(walk.progress.travel, Travel::Arrived);
    EXPECT_TRUE(walk.progress.doubtful);
}

TEST(RouteTracker, NobodyIsThereAlreadyByOneSightThatMayBeWrong) {
    Guided walk(test::corridorMap(), {}, sureArrivals(0.95, 5));
    walk.tracker.setDestination(at("D"));
    for (int i = 0; i < 10; ++i) {
        walk.seen("D", 0, 0.6);
        ASSERT_EQ(walk.progress.travel, Travel::NoFix);
    }
    for (int i = 0; i < 6; ++i) walk.seen("D", 0, 0.8);
    EXPECT_EQ(walk.progress.travel, Travel::Arrived) << "nothing has spoken against it for long";
    EXPECT_TRUE(walk.progress.doubtful);
}

TEST(RouteTracker, WhoStandsThereAndIsToldSoHasNotToWait) {
    const TrackerOptions honest = sureArrivals();
    Guided sure(test::corridorMap(), {}, honest);
    sure.tracker.setDestination(at("D"));
    sure.seen("D", 0, 0.93);
    EXPECT_EQ(sure.progress.travel, Travel::Arrived) << "a start that was told";
    auto afterWaiting = [&](const std::string& second) {
        Guided dark(test::corridorMap(), {}, honest);
        dark.seen("D", 0, 0.93);
        dark.seen(second, 0, 0.7);
        dark.tracker.setDestination(at("D"));
        dark.seen("D", 0, 0.6);
        return dark.progress.travel;
    };
    EXPECT_EQ(afterWaiting("D"), Travel::Arrived) << "nothing has spoken against it";
    EXPECT_EQ(afterWaiting("K"), Travel::NoFix);
}

TEST(RouteTracker, AnHourWithoutAFixIsNoWaitingInTheDestination) {
    Guided walk(test::corridorMap(), {}, sureArrivals(0.95, 5));
    walk.tracker.setDestination(at("D"));
    walk.seen("A", 0, 0.95);
    walk.seen("K", 0, 0.95);
    walk.seen("D", 0, 0.8);
    for (int i = 0; i < 10; ++i) walk.seen("");
    walk.seen("D", 0, 0.8);
    EXPECT_NE(walk.progress.travel, Travel::Arrived);
}

TEST(RouteTracker, NoWayBeginsWithAGuessAndNoneIsGivenUpForOneBeforeALookAround) {
    TrackerOptions honest;
    honest.guessConfidence = 0.5;
    honest.guessSeconds = 5.0 * Guided().secondsBetween;
    Guided walk(test::corridorMap(), {}, honest);
    walk.tracker.setDestination(at("D"));
    walk.seen("B", 0, 0.3);
    EXPECT_EQ(walk.progress.travel, Travel::NoFix) << "a start is a guess as well";
    walk.seen("A", 0, 0.6);
    ASSERT_EQ(walk.progress.travel, Travel::OnRoute);
    EXPECT_EQ(walk.progress.route->regions.front().value, "A");
    for (int i = 0; i < 5; ++i) {
        walk.seen("C", 0, 0.3);
        EXPECT_FALSE(walk.progress.replanned) << i;
        EXPECT_EQ(walk.count(CueKind::OffRoute), 0U) << i;
    }
    EXPECT_GE(walk.count(CueKind::Unsure), 1U) << "who is seen elsewhere is asked to look around";
    walk.seen("C", 0, 0.3);
    EXPECT_TRUE(walk.progress.replanned) << "a guess that stays after that is better than nothing";
}

TEST(RouteTracker, NoWayFollowsFromAHopelessGuessHoweverLongItLasts) {
    TrackerOptions honest;
    honest.guessConfidence = 0.5;
    honest.guessSeconds = 5.0 * Guided().secondsBetween;
    honest.hopelessConfidence = 0.25;
    Guided walk(test::corridorMap(), {}, honest);
    walk.tracker.setDestination(at("D"));
    for (int i = 0; i < 20; ++i) walk.seen("B", 0, 0.2);
    EXPECT_EQ(walk.count(CueKind::RouteStart), 0U);
    walk.seen("A", 0, 0.6);
    for (int i = 0; i < 20; ++i) walk.seen("C", 0, 0.2);
    EXPECT_EQ(walk.count(CueKind::OffRoute), 0U);
    walk.seen("C", 0, 0.3);
    EXPECT_EQ(walk.count(CueKind::OffRoute), 1U) << "a guess that has lasted by then";
}

TEST(RouteTracker, AnUnknownStartIsNoArrivalByAGuess) {
    Guided walk(test::corridorMap(), {}, sureArrivals());
    walk.tracker.setDestination(at("D"));
    walk.seen("D", 0, 0.3);
    EXPECT_EQ(walk.progress.travel, Travel::NoFix);
    walk.seen("D", 0, 0.96);
    walk.seen("D", 0, 0.96);
    EXPECT_EQ(walk.progress.travel, Travel::Arrived);
}

TEST(TrackerOptions, ValuesOutOfRangeAreRefused) {
    EXPECT_TRUE(TrackerOptions{}.check().ok());
    EXPECT_FALSE(TrackerOptions{.offRouteFixes = 0}.check().ok());
    EXPECT_FALSE(TrackerOptions{.offRouteSeconds = -1.0}.check().ok());
    EXPECT_FALSE(TrackerOptions{.offRouteConfidence = 1.6}.check().ok());
    EXPECT_FALSE(TrackerOptions{.minConfidence = -1.0}.check().ok());
    EXPECT_FALSE(TrackerOptions{.hopelessConfidence = -0.1}.check().ok());
    EXPECT_FALSE(TrackerOptions{.arrivalConfidence = 1.5}.check().ok());
}

} // namespace
