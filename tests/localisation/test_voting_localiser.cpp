// Where the user is said to be, and how sure: what the votes are made into.

#include "core/localisation/localisers.h"
#include "tests/localisation/walk.h"
#include "tests/support/ascii_map.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using namespace farol;
using namespace farol::localisation;
using farol::test::AsciiMap;
using farol::test::regionOf;
using farol::test::seen;
using farol::test::Walk;

namespace {

/// A and B know their places and signs; C and D only have a door each, and B one too.
std::shared_ptr<const building::Building> corridor() {
    return AsciiMap()
        .floor(R"(
            +-------+-------+-------+-------+
            |A      |B  d   |C  d   |D  d   |
            |1 2 3 4/5 6   t/       /   u   |
            +-------+-------+-------+-------+
        )")
        .landmark('1', {Kind::Place, {}, "p1"})
        .landmark('2', {Kind::Place, {}, "p2"})
        .landmark('3', {Kind::Place, {}, "p3"})
        .landmark('4', {Kind::Place, {}, "p4"})
        .landmark('5', {Kind::Place, {}, "p5"})
        .landmark('6', {Kind::Place, {}, "p6"})
        .landmark('d', {Kind::Door})
        .landmark('t', {Kind::Text, "2.14"})
        .landmark('u', {Kind::Text, "2.15"})
        .build();
}

RouteContext routeOf(const std::vector<std::string>& regions, std::optional<Point2> next = std::nullopt) {
    RouteContext route;
    for (const std::string& region : regions) route.regions.emplace_back(region);
    route.nextAccess = next;
    return route;
}

recognition::Detection place(const std::string& name) {
    return seen(Kind::Place, name);
}

TEST(VotingSafety, OneFalseDoorDoesNotMoveTheFixOutOfAWellKnownPlace) {
    const std::vector<std::vector<std::string>> routes{{}, {"A", "B", "C"}, {"B", "C", "D"}, {"C", "D"}};
    for (const auto& route : routes) {
        for (const std::string start : {"", "A"}) {
            Walk walk(corridor());
            walk.start(start);
            walk.localiser->setRoute(routeOf(route, Point2{8, 1}));
            for (const char* name : {"p1", "p2", "p3", "p4"}) walk.see(place(name));
            Fix fix = walk.see(seen(Kind::Door));
            EXPECT_EQ(regionOf(fix), "A")
                << "start '" << start << "', " << route.size() << " regions on the route";
        }
    }
}

TEST(VotingSafety, TakenAtItsWordThePaperMovesThere) {
    Walk walk(corridor(), VotingOptions::literal());
    walk.start("A");
    for (const char* name : {"p1", "p2", "p3", "p4"}) walk.see(place(name));
    EXPECT_EQ(regionOf(walk.see(seen(Kind::Door))), "B");
}

TEST(VotingSafety, SeveralGenericObjectsOverruleTheUnmistakableOne) {
    Walk walk(corridor());
    walk.start("B");
    walk.see(seen(Kind::Text, {}, "2.14"));
    walk.localiser->setRoute(routeOf({"B", "C", "D"}, Point2{24, 1}));
    walk.see(seen(Kind::Door));
    Fix fix = walk.see(seen(Kind::Door));
    EXPECT_NE(fix.votes.front().terms.at("Pmaxobj"), 0.0);
    EXPECT_TRUE(regionOf(fix) == "B" || regionOf(fix) == "C");
}

TEST(VotingSafety, ANewUnmistakablePlaceNextDoorIsFollowedAtOnce) {
    Walk walk(corridor());
    walk.start("A");
    for (const char* name : {"p2", "p3", "p4"}) walk.see(place(name));
    EXPECT_EQ(regionOf(walk.see(place("p5"))), "B");
}

TEST(VotingSafety, OneUnmistakableObjectFarAwayIsNotBelievedAgainstFour) {
    Walk walk(corridor());
    walk.start("A");
    for (const char* name : {"p1", "p2", "p3", "p4"}) walk.see(place(name));
    EXPECT_EQ(regionOf(walk.see(seen(Kind::Text, {}, "2.15"))), "A");
}

TEST(VotingLocaliser, PlaceGivesPositionAndWalkingDirection) {
    Walk walk(corridor());
    walk.start("A");
    Fix first = walk.see(place("p1"));
    ASSERT_TRUE(first.position.has_value());
    EXPECT_FALSE(first.heading.has_value());
    EXPECT_DOUBLE_EQ(first.sigmaM, 1.5);
    EXPECT_EQ(first.landmark.value, "1");
    Fix second = walk.see(place("p2"));
    ASSERT_TRUE(second.heading.has_value());
    EXPECT_NEAR(second.heading->value, 0.0, 1e-9); // east
    EXPECT_GT(second.confidence, 0.0);
    EXPECT_LE(second.confidence, 1.0);
}

TEST(VotingLocaliser, APlaceWithADirectionTellsWhichWayTheUserFacesAtOnce) {
    auto map = AsciiMap()
                   .floor("+--------+\n|A 1   2 |\n|        |\n+--------+")
                   .landmark('1', {Kind::Place, {}, "p1", 90.0})
                   .landmark('2', {Kind::Place, {}, "p2", 90.0})
                   .build();
    Walk walk(map);
    walk.start("A");
    Fix first = walk.see(place("p1"));
    ASSERT_TRUE(first.heading.has_value());
    EXPECT_NEAR(toDegrees(*first.heading), 90.0, 1e-9);
    EXPECT_NEAR(toDegrees(*walk.see(place("p2")).heading), 90.0, 1e-9)
        << "sideways steps do not turn the camera";

    Walk literal(map, VotingOptions::literal());
    literal.start("A");
    EXPECT_FALSE(literal.see(place("p1")).heading.has_value());
    EXPECT_NEAR(toDegrees(*literal.see(place("p2")).heading), 0.0, 1e-9)
        << "the paper knows displacement only";
}

TEST(VotingLocaliser, TwoObjectsSeenFromOneSpotAreNoWalk) {
    Walk walk(corridor());
    walk.secondsBetween = 0.1;
    walk.start("A");
    walk.see(place("p1"));
    EXPECT_FALSE(walk.see(place("p4")).heading.has_value()) << "6 m in a tenth of a second";
}

TEST(VotingLocaliser, TwinObjectsInTheRegionGiveNoPosition) {
    auto map = test::asciiMap("+-------+\n|A d d  |\n|       |\n+-------+", {{'d', {Kind::Door}}});
    Walk walk(map);
    walk.start("A");
    Fix fix = walk.see(seen(Kind::Door));
    EXPECT_EQ(regionOf(fix), "A");
    EXPECT_FALSE(fix.position.has_value());
    EXPECT_EQ(fix.sigmaM, 0.0);
    VotingOptions any;
    any.positionNeedsUnique = false;
    Walk either(map, any);
    either.start("A");
    EXPECT_TRUE(either.see(seen(Kind::Door)).position.has_value());
}

TEST(VotingLocaliser, KnownStartHoldsBeforeAnythingIsSeen) {
    Walk walk(corridor());
    Fix fix = walk.start("B");
    EXPECT_EQ(regionOf(fix), "B");
    EXPECT_DOUBLE_EQ(fix.confidence, VotingOptions{}.startConfidence);
    EXPECT_GE(fix.nearConfidence, fix.confidence);
    EXPECT_EQ(fix.near, (std::vector<RegionId>{RegionId("B"), RegionId("A"), RegionId("C")}));
    EXPECT_FALSE(fix.position.has_value());
}

TEST(VotingLocaliser, UnknownStartSaysSo) {
    Walk walk(corridor());
    Fix fix = walk.start();
    EXPECT_EQ(regionOf(fix), "none");
    EXPECT_EQ(fix.confidence, 0.0);
    EXPECT_FALSE(fix.note.empty());
    EXPECT_EQ(regionOf(walk.see(seen(Kind::Text, {}, "2.15"))), "D");
}

TEST(VotingLocaliser, AStartThatIsNotInTheMapIsNoStart) {
    Walk walk(corridor());
    Fix fix = walk.start("nowhere");
    EXPECT_EQ(regionOf(fix), "none");
    EXPECT_NE(fix.note.find("nowhere"), std::string::npos);
}

TEST(VotingLocaliser, MinimumOfObjectsFromAnUnknownStart) {
    VotingOptions patient;
    patient.minimumObjects = 2;
    Walk walk(corridor(), patient);
    walk.start();
    EXPECT_EQ(regionOf(walk.see(place("p1"))), "none");
    EXPECT_EQ(regionOf(walk.see(place("p2"))), "A");
    Walk known(corridor(), patient);
    known.start("A");
    EXPECT_EQ(regionOf(known.see(place("p1"))), "A");
}

TEST(VotingLocaliser, ATieKeepsTheCurrentRegionAndIsDoubtful) {
    Walk walk(corridor());
    walk.start("C");
    Fix fix = walk.see(seen(Kind::Door)); // B, C and D have one each
    EXPECT_EQ(regionOf(fix), "C");
    EXPECT_LE(fix.confidence, VotingOptions{}.startConfidence / 2);
    EXPECT_NE(fix.note.find("doubtful"), std::string::npos);
}

TEST(VotingLocaliser, ATieAmongOthersIsNoFix) {
    Walk walk(corridor());
    walk.start();
    Fix fix = walk.see(seen(Kind::Door));
    EXPECT_EQ(regionOf(fix), "none");
    EXPECT_EQ(fix.confidence, 0.0);
    EXPECT_EQ(fix.level, 0.0) << "all of them are on one level";
}

TEST(VotingLocaliser, TiesReadLiterallyGoToTheRouteThenTheLowestId) {
    Walk walk(corridor(), VotingOptions::literal());
    walk.start();
    EXPECT_EQ(regionOf(walk.see(seen(Kind::Door))), "B");
    Walk onRoute(corridor(), [] {
        VotingOptions options = VotingOptions::literal();
        options.pperc = 0.0;
        return options;
    }());
    onRoute.start();
    onRoute.localiser->setRoute(routeOf({"D", "C"}));
    EXPECT_EQ(regionOf(onRoute.see(seen(Kind::Door))), "D");
    Walk byId(corridor(), [] {
        VotingOptions options = VotingOptions::literal();
        options.pperc = 0.0;
        options.tiesByRoute = false;
        return options;
    }());
    byId.start();
    byId.localiser->setRoute(routeOf({"D", "C"}));
    EXPECT_EQ(regionOf(byId.see(seen(Kind::Door))), "B");
}

TEST(VotingLocaliser, LostWhenTheWinnerHoldsNothingThatWasSeen) {
    // The hall adjoins two rooms with one object each and lies on the route, so its neighbour term wins.
    auto map = AsciiMap()
                   .floor(R"(
                       +-----+-----+-----+
                       |A p  |H    |B b  |
                       |     /     /     |
                       +-----+-----+-----+
                   )")
                   .landmark('p', {Kind::Poster})
                   .landmark('b', {Kind::Bin})
                   .build();
    VotingOptions never;
    never.lostWithoutObject = false;
    Walk loses(map), keeps(map, never);
    std::vector<Fix> fixes;
    for (Walk* walk : {&loses, &keeps}) {
        walk->start("H");
        walk->localiser->setRoute(routeOf({"H"}));
        walk->history.add({{seen(Kind::Poster), 0.0, 0, 0}});
        fixes.push_back(walk->see(seen(Kind::Bin)));
    }
    EXPECT_EQ(regionOf(fixes[0]), "none");
    EXPECT_NE(fixes[0].note.find("lost"), std::string::npos);
    EXPECT_EQ(regionOf(fixes[1]), "H");
    Fix next = loses.see(seen(Kind::Poster));
    for (const RegionVote& vote : next.votes)
        EXPECT_EQ(vote.terms.at("Ppos"), 0.0) << "lost: no neighbourhood";
}

TEST(VotingLocaliser, ReadLiterallyTheWinnerIsAnsweredThoughLost) {
    auto map = AsciiMap()
                   .floor(R"(
                       +-----+-----+-----+
                       |A    |H    |B b  |
                       |     /     /     |
                       +-----+-----+-----+
                   )")
                   .landmark('b', {Kind::Bin})
                   .build();
    Walk walk(map, VotingOptions::literal());
    walk.start("A");
    walk.localiser->setRoute(routeOf({"A", "H"}));
    Fix fix = walk.see(seen(Kind::Bin)); // H: Ppos and Pperc, times its neighbour's bin
    EXPECT_EQ(regionOf(fix), "H");
    EXPECT_EQ(fix.confidence, 0.0);
    EXPECT_NE(fix.note.find("lost"), std::string::npos);
}

TEST(VotingLocaliser, FixLastsBetweenDetectionsWithLessAndLessConfidence) {
    Walk walk(corridor());
    walk.start("A");
    walk.see(place("p1"));
    Fix fresh = walk.see(place("p2"));
    Fix later = walk.wait(VotingOptions{}.halfLifeSeconds);
    EXPECT_EQ(regionOf(later), "A");
    EXPECT_NEAR(later.confidence, fresh.confidence / 2, 1e-9);
    EXPECT_EQ(later.evidenceTime, fresh.evidenceTime);
    EXPECT_GT(later.time, fresh.time);
    EXPECT_LT(walk.wait(3600).confidence, 1e-9);
}

TEST(VotingLocaliser, UnknownObjectsMoveNothing) {
    Walk walk(corridor());
    walk.start("A");
    Fix before = walk.see(place("p1"));
    Fix after = walk.see(seen(Kind::VendingMachine));
    EXPECT_EQ(after.region, before.region);
    EXPECT_EQ(after.evidenceTime, before.evidenceTime);
    EXPECT_FALSE(after.note.empty());
}

TEST(VotingLocaliser, MapWithoutLandmarksGivesNoFixAndSaysSo) {
    auto map = test::asciiMap("+---+---+\n|A  |B  |\n|   /   |\n+---+---+");
    Walk walk(map);
    Fix fix = walk.start();
    EXPECT_EQ(regionOf(fix), "none");
    EXPECT_NE(fix.note.find("no landmarks"), std::string::npos);
    EXPECT_EQ(regionOf(walk.see(seen(Kind::Door))), "none");
}

TEST(VotingLocaliser, EmptyBuildingIsSurvived) {
    Walk walk(std::make_shared<const building::Building>(building::BuildingData{}));
    walk.start("A");
    EXPECT_EQ(regionOf(walk.see(seen(Kind::Door))), "none");
}

TEST(VotingLocaliser, NoFigureIsEverNotANumber) {
    Walk walk(corridor());
    walk.localiser->start(std::numeric_limits<double>::quiet_NaN(), std::nullopt);
    walk.localiser->setRoute(routeOf({"A"}, Point2{std::numeric_limits<double>::quiet_NaN(), 0.0}));
    walk.time = std::numeric_limits<double>::quiet_NaN();
    Fix fix = walk.see(place("p1"));
    EXPECT_TRUE(std::isfinite(fix.time));
    EXPECT_TRUE(std::isfinite(fix.confidence));
    for (const RegionVote& vote : fix.votes) EXPECT_TRUE(std::isfinite(vote.vote));
    walk.time = -5.0; // a clock that runs backwards
    fix = walk.see(place("p2"));
    EXPECT_LE(fix.confidence, 1.0);
}

TEST(VotingLocaliser, TextToleranceIsAnOption) {
    VotingOptions tolerant;
    tolerant.textTolerance = 1;
    Walk exact(corridor()), loose(corridor(), tolerant);
    exact.start();
    loose.start();
    EXPECT_EQ(regionOf(exact.see(seen(Kind::Text, {}, "2.I4"))), "none");
    EXPECT_EQ(regionOf(loose.see(seen(Kind::Text, {}, "2.I4"))), "B");
}

TEST(VotingLocaliser, StartForgetsTheWalkBefore) {
    Walk walk(corridor());
    walk.start("A");
    walk.see(place("p1"));
    walk.see(place("p2"));
    Fix fix = walk.start("D");
    EXPECT_EQ(regionOf(fix), "D");
    EXPECT_TRUE(fix.votes.empty());
    EXPECT_FALSE(fix.position.has_value());
    walk.history.clear();
    EXPECT_FALSE(walk.see(seen(Kind::Text, {}, "2.15")).heading.has_value());
}

TEST(VotingLocaliser, TheSameWalkGivesTheSameFixes) {
    std::vector<Fix> runs[2];
    for (auto& fixes : runs) {
        Walk walk(corridor());
        walk.start();
        for (const char* name : {"p1", "p3", "p5"}) fixes.push_back(walk.see(place(name)));
        fixes.push_back(walk.see(seen(Kind::Door)));
    }
    for (std::size_t i = 0; i < runs[0].size(); ++i) {
        EXPECT_EQ(runs[0][i].region, runs[1][i].region);
        EXPECT_EQ(runs[0][i].confidence, runs[1][i].confidence);
        ASSERT_EQ(runs[0][i].votes.size(), runs[1][i].votes.size());
        for (std::size_t k = 0; k < runs[0][i].votes.size(); ++k) {
            EXPECT_EQ(runs[0][i].votes[k].region, runs[1][i].votes[k].region);
            EXPECT_EQ(runs[0][i].votes[k].vote, runs[1][i].votes[k].vote);
        }
    }
}

TEST(VotingOptions, ValuesOutOfRangeAreRefused) {
    EXPECT_TRUE(VotingOptions::repaired().check().ok());
    EXPECT_TRUE(VotingOptions::literal().check().ok());
    VotingOptions bad;
    bad.pf = -1;
    EXPECT_FALSE(bad.check().ok());
    bad = {};
    bad.halfLifeSeconds = 0;
    EXPECT_FALSE(bad.check().ok());
    bad = {};
    bad.doubtfulMargin = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(bad.check().ok());
}

TEST(LocaliserNames, AreKnownAndOthersAreRefusedByName) {
    for (const std::string& name : localiserNames()) {
        auto made = makeLocaliser(name, corridor());
        ASSERT_TRUE(made.ok());
        EXPECT_EQ((*made)->name(), name);
    }
    auto wrong = makeLocaliser("gps", corridor());
    ASSERT_FALSE(wrong.ok());
    EXPECT_EQ(wrong.error().code, ErrorCode::InvalidArgument);
    EXPECT_NE(wrong.error().text().find("voting-literal"), std::string::npos);
}

} // namespace
