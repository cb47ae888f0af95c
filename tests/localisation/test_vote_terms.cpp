// The weights of the paper's 4.2, one by one, on buildings small enough to count by hand.

#include "core/localisation/vote_counter.h"
#include "tests/localisation/walk.h"
#include "tests/support/ascii_map.h"

#include <gtest/gtest.h>
#include <random>

using namespace farol;
using namespace farol::localisation;
using farol::test::AsciiMap;
using farol::test::regionOf;
using farol::test::seen;
using farol::test::Walk;

namespace {

using Terms = std::map<std::string, double>;

Terms termsOf(const Fix& fix, const std::string& region) {
    for (const RegionVote& vote : fix.votes) {
        if (vote.region.value == region) return vote.terms;
    }
    ADD_FAILURE() << "no vote for " << region;
    return {};
}

bool hasVote(const Fix& fix, const std::string& region) {
    return std::any_of(fix.votes.begin(), fix.votes.end(),
                       [&](const RegionVote& vote) { return vote.region.value == region; });
}

/// A row of rooms on two levels; the same extinguisher hangs in B and in the room above it.
std::shared_ptr<const building::Building> twoLevels() {
    return AsciiMap()
        .floor(R"(
            +----+----+----+----+----+
            |A   |B e |C f |D   |S   |
            |    /    /    /    /    |
            +----+----+----+----+----+
        )",
               0.0)
        .floor(R"(
            +----+----+----+----+----+
            |Z   |Y e |X f |W   |T  s|
            |    /    /    /    /    |
            +----+----+----+----+----+
        )",
               1.0)
        .join(building::AccessKind::Stairs, 'S', 'T')
        .landmark('e', {Kind::Extinguisher})
        .landmark('f', {Kind::Fountain})
        .landmark('s', {Kind::Stairs})
        .build();
}

std::shared_ptr<const building::Building> oneLevel() {
    return AsciiMap()
        .floor(R"(
            +-----+-----+-----+-----+-----+
            |A p  |B ef |C g  |D d  |E b  |
            |     /     /     /     /     |
            +-----+-----+-----+-----+-----+
        )")
        .landmark('p', {Kind::Poster})
        .landmark('e', {Kind::Extinguisher})
        .landmark('f', {Kind::Fountain})
        .landmark('g', {Kind::Hydrant})
        .landmark('d', {Kind::Door})
        .landmark('b', {Kind::Bin})
        .build();
}

TEST(VoteTerms, LevelWeightOnTheUsersLevelOnly) {
    Walk walk(twoLevels());
    walk.start("A");
    Fix fix = walk.see(seen(Kind::Extinguisher));
    EXPECT_DOUBLE_EQ(termsOf(fix, "B").at("Pf"), 3.0);
    EXPECT_DOUBLE_EQ(termsOf(fix, "B").at("Pobj"), 4.0);
    EXPECT_DOUBLE_EQ(termsOf(fix, "Y").at("Pf"), 0.0);
    EXPECT_DOUBLE_EQ(termsOf(fix, "B").at("Vreg"), 6.0); // Pobj 4 + Ppos 2
    EXPECT_DOUBLE_EQ(termsOf(fix, "Y").at("Vreg"), 1.0);
    EXPECT_EQ(regionOf(fix), "B");
    EXPECT_EQ(fix.level, 0.0);
}

TEST(VoteTerms, NoLevelWeightNearStairs) {
    Walk walk(twoLevels());
    walk.start("D"); // adjoins the stairwell
    EXPECT_DOUBLE_EQ(termsOf(walk.see(seen(Kind::Extinguisher)), "B").at("Pf"), 0.0);
}

TEST(VoteTerms, NoLevelWeightWhenStairsAreSeen) {
    Walk walk(twoLevels());
    walk.start("A");
    Fix fix = walk.see({seen(Kind::Extinguisher), seen(Kind::Stairs, {}, {}, {400, 100, 100, 200})});
    EXPECT_DOUBLE_EQ(termsOf(fix, "B").at("Pf"), 0.0);
}

TEST(VoteTerms, LevelWeightAtStairsIsAnOption) {
    VotingOptions always;
    always.levelWeightAtStairs = true;
    Walk walk(twoLevels(), always);
    walk.start("D"); // adjoins the stairwell
    Fix fix = walk.see({seen(Kind::Extinguisher), seen(Kind::Stairs, {}, {}, {400, 100, 100, 200})});
    EXPECT_DOUBLE_EQ(termsOf(fix, "B").at("Pf"), 3.0);
}

TEST(VoteTerms, NoLevelWeightFromAnUnknownStart) {
    Walk walk(twoLevels());
    walk.start();
    Fix fix = walk.see(seen(Kind::Extinguisher));
    EXPECT_DOUBLE_EQ(termsOf(fix, "B").at("Pf"), 0.0);
    EXPECT_DOUBLE_EQ(termsOf(fix, "B").at("Ppos"), 0.0);
    EXPECT_EQ(regionOf(fix), "none") << "two levels look the same";
    EXPECT_FALSE(fix.level.has_value());
    EXPECT_FALSE(fix.note.empty());
}

TEST(VoteTerms, NoLevelWeightWithOneLevel) {
    Walk walk(oneLevel());
    walk.start("A");
    EXPECT_DOUBLE_EQ(termsOf(walk.see(seen(Kind::Extinguisher)), "B").at("Pf"), 0.0);
}

TEST(VoteTerms, ALowerLevelBelowGroundIsALevelLikeAnyOther) {
    auto map = AsciiMap()
                   .floor("+---+\n|A  |\n| e |\n+---+", 0.0)
                   .floor("+---+---+\n|B  |C  |\n| e /   |\n+---+---+", -1.0)
                   .landmark('e', {Kind::Extinguisher})
                   .build();
    Walk walk(map);
    walk.start("C");
    Fix fix = walk.see(seen(Kind::Extinguisher));
    EXPECT_EQ(regionOf(fix), "B");
    EXPECT_EQ(fix.level, -1.0);
}

TEST(VoteTerms, DirectionByTheSignsOfBothComponents) {
    auto map = AsciiMap()
                   .floor(R"(
                       +-----------+
                       |a    n    b|
                       |           |
                       |     H     |
                       |           |
                       |c         d|
                       +-----------+
                   )")
                   .landmark('a', {Kind::Poster})
                   .landmark('b', {Kind::Bin})
                   .landmark('c', {Kind::Plant})
                   .landmark('d', {Kind::Locker})
                   .landmark('n', {Kind::Fountain});
    RouteContext route;
    route.regions = {RegionId("H")};
    route.nextAccess = map.build()->landmark(LandmarkId("b"))->position; // north-east of the centre
    const std::map<Kind, double> expected{{Kind::Bin, 3.0},
                                          {Kind::Poster, 2.0},
                                          {Kind::Locker, 2.0},
                                          {Kind::Plant, 1.0},
                                          {Kind::Fountain, 2.0}};
    for (const auto& [kind, pdir] : expected) {
        Walk walk(map.build());
        walk.start("H");
        walk.localiser->setRoute(route);
        EXPECT_DOUBLE_EQ(termsOf(walk.see(seen(kind)), "H").at("Pdir"), pdir) << kindName(kind);
    }
}

TEST(VoteTerms, DirectionWithoutDisplacement) {
    VotingOptions zero;
    zero.directionUnknownIsOne = false;
    Walk one(oneLevel()), none(oneLevel(), zero);
    one.start("A");
    none.start("A");
    EXPECT_DOUBLE_EQ(termsOf(one.see(seen(Kind::Poster)), "A").at("Pdir"), 1.0);
    EXPECT_DOUBLE_EQ(termsOf(none.see(seen(Kind::Poster)), "A").at("Pdir"), 0.0);
}

TEST(VoteTerms, DirectionFromTheRegionIsAnOption) {
    RouteContext route;
    route.nextAccess = oneLevel()->landmark(LandmarkId("b"))->position; // east, the y of the objects
    VotingOptions strict;
    strict.directionFromRegion = false;
    Walk region(oneLevel()), position(oneLevel(), strict);
    for (Walk* walk : {&region, &position}) {
        walk->start("A");
        walk->localiser->setRoute(route);
    }
    EXPECT_GT(termsOf(region.see(seen(Kind::Extinguisher)), "B").at("Pdir"), 1.0);
    EXPECT_DOUBLE_EQ(termsOf(position.see(seen(Kind::Extinguisher)), "B").at("Pdir"), 1.0);
}

TEST(VoteTerms, NeighbourhoodOfTheLastRegion) {
    Walk walk(oneLevel());
    walk.start("B");
    EXPECT_DOUBLE_EQ(termsOf(walk.see(seen(Kind::Hydrant)), "C").at("Ppos"), 2.0);
    walk.history.clear();
    walk.start("B");
    EXPECT_DOUBLE_EQ(termsOf(walk.see(seen(Kind::Bin)), "E").at("Ppos"), 0.0);
}

TEST(VoteTerms, StayingIsPunishedOnlyWhenReadLiterally) {
    Walk repaired(oneLevel()), literal(oneLevel(), VotingOptions::literal());
    repaired.start("A");
    literal.start("A");
    EXPECT_DOUBLE_EQ(termsOf(repaired.see(seen(Kind::Poster)), "A").at("Ppos"), 2.0);
    EXPECT_DOUBLE_EQ(termsOf(literal.see(seen(Kind::Poster)), "A").at("Ppos"), 0.0);
}

TEST(VoteTerms, RegionsOfTheRoute) {
    RouteContext route;
    route.regions = {RegionId("A"), RegionId("B")};
    Walk walk(oneLevel());
    walk.start("C");
    walk.localiser->setRoute(route);
    EXPECT_DOUBLE_EQ(termsOf(walk.see(seen(Kind::Poster)), "A").at("Pperc"), 1.5);
    EXPECT_DOUBLE_EQ(termsOf(walk.see(seen(Kind::Hydrant)), "C").at("Pperc"), 0.0);
}

TEST(VoteTerms, RouteWeightOnlyWithAnIdenticalObjectIsAnOption) {
    RouteContext route;
    route.regions = {RegionId("A"), RegionId("B")};
    VotingOptions strict;
    strict.percNeedsObject = true;
    Walk walk(oneLevel(), strict);
    walk.start("B");
    walk.localiser->setRoute(route);
    Fix fix = walk.see(seen(Kind::Poster));
    EXPECT_DOUBLE_EQ(termsOf(fix, "A").at("Pperc"), 1.5);
    EXPECT_DOUBLE_EQ(termsOf(fix, "B").at("Pperc"), 0.0);
}

TEST(VoteTerms, ObjectsOfOneSceneWithinAMetre) {
    std::vector<recognition::Detection> both{seen(Kind::Extinguisher),
                                             seen(Kind::Fountain, {}, {}, {400, 100, 80, 120})};
    Walk together(oneLevel());
    together.start("A");
    EXPECT_DOUBLE_EQ(termsOf(together.see(both), "B").at("PID"), 2.0);

    Walk apart(oneLevel());
    apart.start("A");
    apart.see(both[0]);
    EXPECT_DOUBLE_EQ(termsOf(apart.see(both[1]), "B").at("PID"), 0.0) << "another scene";

    VotingOptions close;
    close.sameSceneRadiusM = 0.5;
    Walk strict(oneLevel(), close);
    strict.start("A");
    EXPECT_DOUBLE_EQ(termsOf(strict.see(both), "B").at("PID"), 0.0);
}

TEST(VoteTerms, OneObjectSeenTwiceIsNoPairOfObjects) {
    Walk walk(oneLevel());
    walk.start("A");
    Fix fix = walk.see({seen(Kind::Extinguisher), seen(Kind::Extinguisher, {}, {}, {400, 100, 80, 120})});
    EXPECT_DOUBLE_EQ(termsOf(fix, "B").at("PID"), 0.0);
}

TEST(VoteTerms, SharesOfTheHistory) {
    Walk walk(oneLevel());
    walk.start("B");
    walk.see(seen(Kind::Poster));
    walk.see(seen(Kind::Extinguisher));
    Fix fix = walk.see(seen(Kind::Hydrant));
    Terms b = termsOf(fix, "B");
    EXPECT_DOUBLE_EQ(b.at("Np"), 1.0);
    EXPECT_DOUBLE_EQ(b.at("Nv"), 2.0);
    EXPECT_DOUBLE_EQ(b.at("Nobj"), 3.0);
    EXPECT_DOUBLE_EQ(b.at("Rp"), 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(b.at("Rv"), 2.0 / 3.0);
    EXPECT_DOUBLE_EQ(b.at("Vreg"), b.at("Preg") * b.at("Rp") + (b.at("Preg") - 1) * b.at("Rv"));
}

TEST(VoteTerms, NeighboursTogetherOrTheBestOfThem) {
    VotingOptions best;
    best.nv = NeighbourCount::BestNeighbour;
    Walk together(oneLevel()), single(oneLevel(), best);
    for (Walk* walk : {&together, &single}) {
        walk->start("B");
        walk->see(seen(Kind::Poster));
    }
    EXPECT_DOUBLE_EQ(termsOf(together.see(seen(Kind::Hydrant)), "B").at("Nv"), 2.0);
    EXPECT_DOUBLE_EQ(termsOf(single.see(seen(Kind::Hydrant)), "B").at("Nv"), 1.0);
}

TEST(VoteTerms, AMappedObjectExplainsOneSight) {
    VotingOptions independent;
    independent.eachLandmarkOnce = false;
    Walk once(oneLevel()), often(oneLevel(), independent);
    for (Walk* walk : {&once, &often}) {
        walk->start("D");
        walk->see(seen(Kind::Door));
    }
    EXPECT_DOUBLE_EQ(termsOf(once.see(seen(Kind::Door)), "D").at("Np"), 1.0);
    EXPECT_DOUBLE_EQ(termsOf(often.see(seen(Kind::Door)), "D").at("Np"), 2.0);
}

TEST(VoteTerms, ObjectsThatTheMapDoesNotKnow) {
    Walk repaired(oneLevel()), literal(oneLevel(), VotingOptions::literal());
    for (Walk* walk : {&repaired, &literal}) {
        walk->start("B");
        walk->see(seen(Kind::Plant));
    }
    EXPECT_DOUBLE_EQ(termsOf(repaired.see(seen(Kind::Hydrant)), "C").at("Nobj"), 1.0);
    EXPECT_DOUBLE_EQ(termsOf(literal.see(seen(Kind::Hydrant)), "C").at("Nobj"), 2.0);
}

TEST(VoteTerms, NegativeVotesOnlyWhenReadLiterally) {
    Walk repaired(oneLevel()), literal(oneLevel(), VotingOptions::literal());
    repaired.start();
    literal.start();
    // B adjoins the poster's room and has nothing of its own: Preg 0, so the printed formula gives -Rv.
    EXPECT_FALSE(hasVote(repaired.see(seen(Kind::Poster)), "B"));
    EXPECT_DOUBLE_EQ(termsOf(literal.see(seen(Kind::Poster)), "B").at("Vreg"), -1.0);
}

TEST(VoteTerms, WallsJoinRegionsOnlyInThatReading) {
    auto map = AsciiMap()
                   .floor(R"(
                       +-----+-----+
                       |A p  |B    |
                       |     |     |
                       +--/--+--/--+
                       |C          |
                       |           |
                       +-----------+
                   )")
                   .landmark('p', {Kind::Poster})
                   .build();
    VotingOptions walls;
    walls.neighbours = NeighbourRule::AccessesAndWalls;
    Walk doors(map), both(map, walls);
    doors.start("B");
    both.start("B");
    EXPECT_DOUBLE_EQ(termsOf(doors.see(seen(Kind::Poster)), "A").at("Ppos"), 0.0);
    EXPECT_DOUBLE_EQ(termsOf(both.see(seen(Kind::Poster)), "A").at("Ppos"), 2.0);
}

TEST(VoteFormula, TheNeighbourTermCanDominate) {
    EXPECT_DOUBLE_EQ(regionVote(11.5, 0.25, 0.75, true), 10.75);
    EXPECT_DOUBLE_EQ(regionVote(11.5, 1.0, 0.0, true), 11.5);
    EXPECT_DOUBLE_EQ(regionVote(0.0, 0.0, 1.0, false), -1.0);
    EXPECT_DOUBLE_EQ(regionVote(0.0, 0.0, 1.0, true), 0.0);
    EXPECT_DOUBLE_EQ(regionVote(0.5, 0.5, 0.5, true), 0.25);
}

TEST(VoteFormula, TheGreatestVoteIsReachedWithEveryBonus) {
    auto map = AsciiMap()
                   .floor(R"(
                       +-----+---------+----+
                       |A    |B      ef|C   |
                       |     /         /    |
                       |     |         |    |
                       +-----+---------+----+
                   )")
                   .floor("+---+\n|Z  |\n|   |\n+---+", 1.0)
                   .landmark('e', {Kind::Extinguisher})
                   .landmark('f', {Kind::Fountain});
    Walk walk(map.build());
    walk.start("A");
    RouteContext route;
    route.regions = {RegionId("A"), RegionId("B"), RegionId("C")};
    route.nextAccess = map.build()->landmark(LandmarkId("f"))->position;
    walk.localiser->setRoute(route);
    Fix fix = walk.see({seen(Kind::Extinguisher), seen(Kind::Fountain, {}, {}, {400, 100, 80, 120})});
    Terms b = termsOf(fix, "B");
    EXPECT_DOUBLE_EQ(b.at("Pobj"), 6.0);
    EXPECT_DOUBLE_EQ(b.at("Preg"), 11.5);
    EXPECT_DOUBLE_EQ(b.at("Vreg"), 11.5);
}

/// 1 <= Pobj <= 6, 0 <= Preg <= 11.5, and no vote beyond -1 to 11.5, whichever way the paper is read.
void staysWithinBounds(const VotingOptions& options) {
    const std::vector<Kind> kinds{Kind::Extinguisher, Kind::Fountain, Kind::Stairs, Kind::Poster};
    std::mt19937 random(7);
    auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    auto map = twoLevels();
    for (int run = 0; run < 60; ++run) {
        Walk walk(map, options);
        walk.start(pick(3) == 0 ? "" : map->regions()[pick(map->regions().size())].id.value);
        RouteContext route;
        route.regions = {map->regions()[pick(10)].id, map->regions()[pick(10)].id};
        route.nextAccess = Point2{static_cast<double>(pick(30)), static_cast<double>(pick(5))};
        walk.localiser->setRoute(route);
        for (int step = 0; step < 8; ++step) {
            Fix fix = walk.see({seen(kinds[pick(4)]), seen(kinds[pick(4)], {}, {}, {400, 100, 80, 120})});
            for (const RegionVote& vote : fix.votes) {
                const Terms& terms = vote.terms;
                if (terms.at("Pmaxobj") > 0) {
                    EXPECT_GE(terms.at("Pobj"), 1.0);
                    EXPECT_LE(terms.at("Pobj"), 6.0);
                }
                EXPECT_GE(terms.at("Preg"), 0.0);
                EXPECT_LE(terms.at("Preg"), 11.5);
                EXPECT_GE(vote.vote, options.clampNeighbourWeight ? 0.0 : -1.0);
                EXPECT_LE(vote.vote, 11.5);
                EXPECT_LE(terms.at("Np") + terms.at("Nv"), terms.at("Nobj"));
            }
        }
    }
}

TEST(VoteFormula, AllTermsStayWithinTheirBounds) {
    staysWithinBounds(VotingOptions::repaired());
    staysWithinBounds(VotingOptions::literal());
}

TEST(VotingPresets, AreTheReadingsAsTabled) {
    VotingOptions printed = VotingOptions::literal(), mended = VotingOptions::repaired();
    for (const VotingOptions& each : {printed, mended}) {
        EXPECT_EQ(each.neighbours, NeighbourRule::Accesses);
        EXPECT_EQ(each.nv, NeighbourCount::UnionOfNeighbours);
        EXPECT_TRUE(each.eachLandmarkOnce && each.directionUnknownIsOne && each.directionFromRegion);
        EXPECT_TRUE(each.lostWithoutObject && each.tiesByRoute && each.positionNeedsUnique);
        EXPECT_FALSE(each.levelWeightAtStairs || each.percNeedsObject);
        EXPECT_DOUBLE_EQ(each.componentDeadBandM, 0.5);
        EXPECT_DOUBLE_EQ(each.sameSceneRadiusM, 1.0);
        EXPECT_EQ(each.textTolerance, 0);
        EXPECT_EQ(each.minimumObjects, 1);
        EXPECT_DOUBLE_EQ(each.pf, 3.0);
        EXPECT_DOUBLE_EQ(each.ppos, 2.0);
        EXPECT_DOUBLE_EQ(each.pperc, 1.5);
        EXPECT_DOUBLE_EQ(each.pid, 2.0);
    }
    EXPECT_FALSE(printed.stayCounts || printed.clampNeighbourWeight);
    EXPECT_TRUE(printed.unmappedObjectsCount && printed.alwaysAnswers);
    EXPECT_TRUE(mended.stayCounts && mended.clampNeighbourWeight);
    EXPECT_FALSE(mended.unmappedObjectsCount || mended.alwaysAnswers);
    EXPECT_EQ(HistoryOptions{}.capacity, 4U);
}

} // namespace
