#include "core/localisation/bayes_localiser.h"
#include "tests/localisation/walk.h"
#include "tests/support/ascii_map.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace {

using namespace farol;
using namespace farol::localisation;
using namespace farol::test;

/// Somebody who walks through a drawn building; what is seen is told with range and bearing.
class Person {
public:
    explicit Person(std::shared_ptr<const building::Building> building, BayesOptions options = {})
        : m_localiser(makeBayesLocaliser(std::move(building), options)) {}

    Fix start(const std::string& region = {}) {
        m_localiser->start(m_time, region.empty() ? std::nullopt : std::optional(RegionId(region)));
        return pass(0.0);
    }
    void headFor(const std::string& region) {
        RouteContext route;
        if (!region.empty()) route.destination = building::Location{RegionId(region), std::nullopt};
        m_localiser->setRoute(route);
    }
    /// Seconds without anything seen.
    Fix pass(double seconds) {
        double until = m_time + seconds;
        Fix fix = m_localiser->update(m_time, {}, {});
        while (m_time < until - 1e-9) {
            m_time = std::min(until, m_time + 1.0);
            if (m_motion) m_localiser->moved(m_time, *m_motion);
            fix = m_localiser->update(m_time, {}, {});
        }
        return fix;
    }
    Fix see(Kind kind, double rangeM, double bearingDeg, const std::string& text = {}) {
        Observation seen;
        seen.detection.kind = kind;
        seen.detection.text = text;
        seen.detection.image = {640, 480};
        seen.detection.rangeM = rangeM;
        seen.detection.bearing = fromDegrees(bearingDeg);
        return see(seen);
    }
    Fix see(Observation seen) {
        seen.time = m_time;
        return m_localiser->update(m_time, std::vector{seen}, {});
    }
    void measures(std::optional<recognition::Motion> motion) { m_motion = motion; }
    Localiser& localiser() { return *m_localiser; }
    double time() const { return m_time; }

private:
    std::unique_ptr<Localiser> m_localiser;
    double m_time = 0.0;
    std::optional<recognition::Motion> m_motion;
};

double voteFor(const Fix& fix, const std::string& region) {
    for (const RegionVote& vote : fix.votes)
        if (vote.region.value == region) return vote.vote;
    return 0.0;
}

recognition::Motion motion(double turnDeg, double speed) {
    recognition::Motion told;
    told.turn = fromDegrees(turnDeg);
    told.speed = speed;
    return told;
}

/// Two rooms at either end of three pieces of corridor; every room has a door, some have a plate.
AsciiMap corridorMap() {
    AsciiMap map;
    map.floor(R"(
+-------+-------+-------+-------+
|R      |S      |T      |U      |
|       |       |       |       |
|       |       |       |       |
+---/---+---/---+---/---+---/---+
|A  a   :B  b   :C  c   :D  d   |
|       :   x   :   y  z:       |
+-------+-------+-------+-------+
)");
    for (char letter : {'A', 'B', 'C', 'D'}) map.region(letter, {.kind = building::RegionKind::Corridor});
    for (char door : {'a', 'b', 'c', 'd'}) map.landmark(door, {.kind = Kind::Door, .headingDeg = 270.0});
    map.landmark('x', {.kind = Kind::Text, .text = "WARD 7", .headingDeg = 90.0});
    map.landmark('y', {.kind = Kind::Text, .text = "WARD 9", .headingDeg = 90.0});
    map.landmark('z', {.kind = Kind::Extinguisher, .headingDeg = 90.0});
    return map;
}

TEST(BayesLocaliser, KnowsAToldStartAndFollowsTheWayToTheDestination) {
    Person person(corridorMap().build());
    person.headFor("D");
    Fix fix = person.start("A");
    EXPECT_EQ(regionOf(fix), "A");
    EXPECT_GT(fix.confidence, 0.8);
    // A corridor of doors that all look alike: 8 m in about 11 s, a door on the left in each piece.
    for (int i = 0; i < 3; ++i) {
        person.pass(6.0);
        fix = person.see(Kind::Door, 1.5, 25.0);
        person.pass(5.0);
    }
    fix = person.pass(8.0);
    EXPECT_TRUE(regionOf(fix) == "D" || regionOf(fix) == "C") << regionOf(fix);
    EXPECT_GT(fix.nearConfidence, 0.5);
}

TEST(BayesLocaliser, AnUnknownStartIsFoundByWhatIsReadOnTheWay) {
    Person person(corridorMap().build());
    Fix fix = person.start();
    EXPECT_LT(fix.confidence, 0.5) << "nothing was seen yet";
    person.pass(1.0);
    person.see(Kind::Text, 1.5, -20.0, "WARD 7");
    person.pass(2.0);
    fix = person.see(Kind::Text, 1.2, -30.0, "WARD 7");
    EXPECT_EQ(regionOf(fix), "B");
    EXPECT_GT(fix.confidence, 0.6);
    ASSERT_TRUE(fix.position);
    EXPECT_LT(fix.sigmaM, 4.0);
}

TEST(BayesLocaliser, AMisreadLetterStillHelps) {
    Person person(corridorMap().build());
    person.start();
    person.see(Kind::Text, 1.5, 0.0, "WARO 7");
    person.pass(5.0);
    EXPECT_EQ(regionOf(person.see(Kind::Text, 1.5, 0.0, "WARD 7")), "B");
}

TEST(BayesLocaliser, OneFalseSightDoesNotMoveASureFix) {
    Person person(corridorMap().build());
    person.start("B");
    person.see(Kind::Text, 1.5, -20.0, "WARD 7");
    Fix before = person.pass(1.0);
    ASSERT_EQ(regionOf(before), "B");
    Fix after = person.see(Kind::Extinguisher, 1.5, 0.0);
    EXPECT_EQ(regionOf(after), "B");
}

TEST(BayesLocaliser, OneCarriedElsewhereIsFoundAgain) {
    Person person(corridorMap().build());
    person.start("A");
    Fix fix = person.pass(3.0);
    ASSERT_EQ(regionOf(fix), "A");
    for (int i = 0; i < 6 && regionOf(fix) != "C"; ++i) {
        person.pass(4.5);
        fix = person.see(Kind::Text, 1.5, 0.0, "WARD 9");
    }
    EXPECT_EQ(regionOf(fix), "C");
}

TEST(BayesLocaliser, BlankInputIsHonest) {
    Person person(corridorMap().build());
    Fix fix = person.start("A");
    double before = fix.confidence;
    fix = person.pass(30.0);
    EXPECT_LT(fix.confidence, before);
    Fix later = person.pass(300.0);
    EXPECT_LT(later.confidence, 0.7);
    EXPECT_DOUBLE_EQ(later.evidenceTime, 0.0) << "nothing was seen since the start";
}

TEST(BayesLocaliser, ACameraThatStopsTellingMotionIsBelievedLess) {
    auto confidenceAfter = [](bool goesOn) {
        Person person(corridorMap().build());
        person.measures(motion(0.0, 0.0));
        person.start("R");
        person.pass(20.0);
        if (!goesOn) person.measures(std::nullopt);
        return person.pass(60.0).confidence;
    };
    EXPECT_LT(confidenceAfter(false), confidenceAfter(true));
}

TEST(BayesLocaliser, StairsLeadToTheOtherLevel) {
    AsciiMap map;
    map.floor(R"(
+--------+---+
|A      a:S  |
|        :   |
+--------+---+
)");
    map.floor(R"(
+--------+---+
|B       :T  |
|   b    :   |
+--------+---+
)",
              1.0);
    map.region('S', {.kind = building::RegionKind::Stairwell});
    map.region('T', {.kind = building::RegionKind::Stairwell});
    map.landmark('a', {.kind = Kind::Text, .text = "STAIRS"});
    map.landmark('b', {.kind = Kind::Text, .text = "LIBRARY"});
    map.join(building::AccessKind::Stairs, 'S', 'T');
    Person person(map.build());
    person.headFor("B");
    Fix fix = person.start("A");
    EXPECT_EQ(fix.level, 0.0);
    person.pass(6.0);
    person.see(Kind::Text, 1.5, 0.0, "STAIRS");
    person.pass(35.0);
    fix = person.see(Kind::Text, 2.0, 0.0, "LIBRARY");
    EXPECT_EQ(regionOf(fix), "B");
    EXPECT_EQ(fix.level, 1.0);
}

TEST(BayesLocaliser, AnotherDestinationChangesWhereTheUserIsExpected) {
    auto after = [](const std::string& destination) {
        Person person(corridorMap().build());
        person.start("B");
        person.headFor("A");
        person.pass(1.0);
        person.headFor(destination);
        return regionOf(person.pass(14.0));
    };
    EXPECT_EQ(after("A"), "A");
    EXPECT_NE(after("D"), "A");
}

TEST(BayesLocaliser, MotionTellsStandingFromWalking) {
    auto walked = [](double speed) {
        Person person(corridorMap().build());
        person.headFor("D");
        person.start("A");
        person.measures(motion(0.0, 0.8)); // a few steps, so that the scale is known
        person.pass(3.0);
        person.measures(motion(0.0, speed));
        return *person.pass(12.0).position;
    };
    EXPECT_GT(walked(0.8).x, walked(0.0).x + 4.0);
}

TEST(BayesLocaliser, TheScaleOfTheSpeedDoesNotMatter) {
    auto regionAt = [](double scale) {
        Person person(corridorMap().build());
        person.headFor("D");
        person.start("A");
        person.measures(motion(0.0, scale * 1.0));
        return *person.pass(12.0).position;
    };
    EXPECT_NEAR(regionAt(0.8).x, regionAt(4.0).x, 2.0);
}

TEST(BayesLocaliser, IsDeterministic) {
    auto run = [] {
        Person person(corridorMap().build());
        person.start();
        person.headFor("D");
        person.see(Kind::Door, 2.0, 10.0);
        person.pass(7.0);
        person.see(Kind::Text, 1.5, 0.0, "WARD 9");
        return person.pass(3.0);
    };
    Fix one = run(), two = run();
    EXPECT_EQ(one.region, two.region);
    EXPECT_EQ(one.confidence, two.confidence);
    EXPECT_EQ(one.position, two.position);
}

TEST(BayesLocaliser, StartingAnewForgetsTheWalkBefore) {
    Person person(corridorMap().build());
    person.start("A");
    person.see(Kind::Text, 1.5, 0.0, "WARD 9");
    person.pass(5.0);
    Fix fix = person.start();
    EXPECT_LT(fix.confidence, 0.5);
    EXPECT_DOUBLE_EQ(fix.evidenceTime, person.time());
}

TEST(BayesLocaliser, ARegionWithoutLandmarksCanBeTheAnswer) {
    Person person(corridorMap().build());
    person.headFor("U");
    person.start("D");
    Fix fix = person.pass(20.0);
    EXPECT_EQ(regionOf(fix), "U");
}

TEST(BayesLocaliser, APlaceTellsWhereTheCameraIsAndWhichWayItLooks) {
    AsciiMap map = corridorMap();
    map.floor(R"(
+---------+
|P        |
|  p      |
+---------+
)",
              5.0);
    map.landmark('p', {.kind = Kind::Place, .templateId = "lap-1", .headingDeg = 90.0});
    Person person(map.build());
    person.start();
    Observation seen;
    seen.detection.kind = Kind::Place;
    seen.detection.templateId = TemplateId("lap-1");
    seen.detection.image = {640, 480};
    person.see(seen);
    person.pass(5.0);
    Fix fix = person.see(seen);
    EXPECT_EQ(regionOf(fix), "P");
    ASSERT_TRUE(fix.position);
    EXPECT_LT(distance(*fix.position, map.spot('p').position.value()), 3.0);
}

TEST(BayesLocaliser, OddInputIsSurvived) {
    Person person(corridorMap().build());
    Fix fix = person.start("no such region");
    EXPECT_LT(fix.confidence, 0.5);
    Observation seen;
    seen.detection.kind = Kind::Other;
    seen.detection.templateId = TemplateId("not in the map");
    seen.detection.rangeM = std::numeric_limits<double>::quiet_NaN();
    seen.detection.bearing = Radians{std::numeric_limits<double>::infinity()};
    fix = person.see(seen);
    EXPECT_TRUE(std::isfinite(fix.confidence));
    fix = person.localiser().update(-100.0, {}, {});
    EXPECT_TRUE(std::isfinite(fix.confidence));
    fix = person.localiser().update(std::numeric_limits<double>::quiet_NaN(), {}, {});
    EXPECT_TRUE(std::isfinite(fix.time));
    person.headFor("gone");
    EXPECT_TRUE(std::isfinite(person.pass(2.0).confidence));
}

TEST(BayesLocaliser, AnEmptyMapAndASingleRegionAreFine) {
    Person nowhere(std::make_shared<building::Building>(building::BuildingData{}));
    Fix fix = nowhere.start();
    EXPECT_FALSE(fix.region);
    EXPECT_FALSE(fix.note.empty());
    Person alone(asciiMap(R"(
+------+
|A     |
|      |
+------+
)"));
    alone.start();
    fix = alone.see(Kind::Door, 2.0, 0.0);
    EXPECT_EQ(regionOf(fix), "A");
}

TEST(BayesLocaliser, WhatTheMapDoesNotKnowMovesNobodyAndIsTold) {
    Person person(corridorMap().build());
    person.start("B");
    Fix before = person.pass(1.0), fix;
    Observation seen;
    seen.detection.image = {640, 480};
    seen.detection.kind = Kind::Fountain;
    for (int i = 0; i < 5; ++i) {
        seen.detection.templateId = TemplateId("not in the map " + std::to_string(i));
        fix = person.see(seen);
    }
    EXPECT_EQ(regionOf(fix), "B");
    EXPECT_LE(fix.confidence, before.confidence + 1e-6);
    EXPECT_FALSE(fix.note.empty());
    person.see(Kind::Text, 1.5, -20.0, "WARD 7");
    EXPECT_TRUE(person.pass(1.0).note.empty());
}

TEST(BayesLocaliser, NothingRecognisedIsNeverSure) {
    AsciiMap single;
    single.floor("+---+\n|A  |\n|  d|\n+---+");
    single.landmark('d', {Kind::Door});
    Person person(single.build());
    Fix fix = person.start();
    EXPECT_LE(fix.confidence, 0.5) << "the only region, but nobody said that the user is in the building";
    EXPECT_LE(fix.nearConfidence, 0.5);
    person.measures(motion(0.0, 1.0));
    EXPECT_LE(person.pass(60.0).confidence, 0.5);
    fix = person.see(Kind::Door, 1.5, 0.0);
    EXPECT_GT(fix.confidence, 0.5);
    Person bare(asciiMap("+---+---+\n|A  /B  |\n+---+---+"));
    bare.start();
    fix = bare.see(Kind::Door, 1.5, 0.0);
    EXPECT_LE(fix.confidence, 0.5);
    EXPECT_NE(fix.note.find("no landmarks"), std::string::npos);
}

TEST(BayesLocaliser, TimeThatRunsBackwardsOrJumpsIsSurvived) {
    Person person(corridorMap().build());
    person.start("A");
    person.pass(20.0);
    Observation old;
    old.detection.kind = Kind::Text;
    old.detection.text = "WARD 7";
    old.detection.image = {640, 480};
    old.time = -1e9;
    Fix fix = person.localiser().update(1.0, std::vector{old}, {});
    EXPECT_GE(fix.time, 20.0) << "time does not run backwards";
    EXPECT_TRUE(std::isfinite(fix.confidence));
    person.localiser().moved(-5.0, motion(10.0, 1.0));
    fix = person.localiser().update(1e12, {}, {});
    EXPECT_TRUE(std::isfinite(fix.confidence));
    EXPECT_LT(fix.confidence, 0.8) << "after ages unseen nobody knows";
}

TEST(BayesLocaliser, WildMotionIsNoMeasurement) {
    const double inf = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
    Person person(corridorMap().build());
    person.headFor("D");
    person.start("A");
    for (double wild : {1e9, -1e300, inf, -inf, nan}) {
        person.measures(motion(wild, wild));
        Fix fix = person.pass(1.0);
        EXPECT_TRUE(std::isfinite(fix.confidence)) << wild;
        EXPECT_TRUE(!fix.position || isFinite(*fix.position)) << wild;
    }
    person.measures(motion(0.0, 0.8));
    Fix before = person.pass(2.0), after = person.pass(10.0);
    EXPECT_GT(after.position->x, before.position->x + 2.0) << "afterwards it is measured as ever";
}

TEST(BayesLocaliser, ADestinationThatVanishesIsForgotten) {
    Person person(corridorMap().build());
    person.start("B");
    person.headFor("D");
    person.pass(1.0);
    person.headFor("gone");
    Person wanderer(corridorMap().build());
    wanderer.start("B");
    wanderer.pass(1.0);
    EXPECT_LT(person.pass(20.0).confidence, 0.8) << "no way is expected any more";
}

Observation tracked(std::uint64_t track, int confirmations, double rangeM) {
    Observation seen;
    seen.detection.kind = Kind::Extinguisher;
    seen.detection.image = {640, 480};
    seen.detection.rangeM = rangeM;
    seen.detection.bearing = fromDegrees(0.0);
    seen.track = track;
    seen.detection.confirmations = seen.confirmations = confirmations;
    return seen;
}

TEST(BayesLocaliser, OneFollowedThingCountsOnce) {
    auto weightOfC = [](std::vector<Observation> sights) {
        BayesOptions raw;
        raw.rawConfidence = true;
        Person person(corridorMap().build(), raw);
        Fix fix = person.start();
        for (const Observation& seen : sights) fix = person.see(seen);
        return voteFor(fix, "C");
    };
    double once = weightOfC({tracked(7, 1, 1.5)});
    EXPECT_GT(once, 0.2) << "the only extinguisher hangs there";
    EXPECT_NEAR(weightOfC({tracked(7, 1, 1.5), tracked(7, 2, 1.5), tracked(7, 3, 1.5)}), once, 0.02);
    EXPECT_GT(weightOfC({tracked(7, 4, 1.5)}), once + 0.02) << "confirmed, it is less likely an invention";
}

/// Posters of one maker share their heading: what matches in that only is hardly known.
TEST(BayesLocaliser, APosterThatIsWeaklyExplainedIsHardlyBelieved) {
    AsciiMap map = corridorMap();
    map.landmark('x', {.kind = Kind::Poster, .templateId = "open-day", .headingDeg = 90.0});
    auto building = map.build();
    auto weightOfB = [&](std::optional<double> strength) {
        BayesOptions raw;
        raw.rawConfidence = true;
        Person person(building, raw);
        Fix fix = person.start();
        Observation seen = tracked(7, 1, 1.5);
        seen.detection.kind = Kind::Poster;
        seen.detection.templateId = TemplateId("open-day");
        seen.detection.strength = strength.value_or(0.0);
        if (strength) fix = person.see(seen);
        return voteFor(fix, "B");
    };
    double untold = weightOfB(0.0), weak = weightOfB(2.0), usual = weightOfB(5.25), strong = weightOfB(8.0);
    EXPECT_NEAR(usual, untold, 0.02) << "who does not tell is believed as ever";
    EXPECT_LT(weak, usual - 0.1);
    EXPECT_GT(strong, usual);
    EXPECT_GT(weak, weightOfB(std::nullopt) - 0.01) << "but it is no proof to the contrary";
}

/// Two storeys alike, joined by stairs that only the lower one lists; a plate and a picture in either room.
AsciiMap twoStoreys() {
    const char* const kStorey = R"(
+--------+----+
|R       |S   |
|   p q  |    |
|        |   s|
+---/----+--/-+
|C            |
|             |
+-------------+
)";
    std::string upper = kStorey;
    std::replace(upper.begin(), upper.end(), 'R', 'U');
    std::replace(upper.begin(), upper.end(), 'S', 'T');
    std::replace(upper.begin(), upper.end(), 'C', 'D');
    std::replace(upper.begin(), upper.end(), 'p', 'x');
    std::replace(upper.begin(), upper.end(), 'q', 'y');
    std::replace(upper.begin(), upper.end(), 's', ' ');
    AsciiMap map;
    map.floor(kStorey).floor(upper, 1.0);
    for (char stairwell : {'S', 'T'}) map.region(stairwell, {.kind = building::RegionKind::Stairwell});
    map.landmark('p', {.kind = Kind::Text, .text = "1.01", .headingDeg = 270.0});
    map.landmark('q', {.kind = Kind::Picture, .templateId = "sea", .headingDeg = 270.0});
    map.landmark('x', {.kind = Kind::Text, .text = "2.01", .headingDeg = 270.0});
    map.landmark('y', {.kind = Kind::Picture, .templateId = "hills", .headingDeg = 270.0});
    map.landmark('s', {.kind = Kind::Stairs, .headingDeg = 180.0});
    map.join(building::AccessKind::Stairs, 'S', 'T');
    return map;
}

/// The way of the guided: sees as this program's recognisers do.
BayesOptions guidedOptions() {
    BayesOptions options;
    options.walking = WalkingOptions::obedient();
    options.sensors = SensorOptions::ofCamera();
    options.rawConfidence = true;
    return options;
}

/// Nobody reads a plate clearly and takes its number for that of the room below again and again.
TEST(BayesLocaliser, APlateAndAPictureOfTheStoreyAboveAreNotExplainedAwayBelow) {
    Person person(twoStoreys().build(), guidedOptions());
    person.start("R");
    Observation plate = tracked(1, 3, 2.0), picture = tracked(2, 2, 2.5);
    plate.detection.kind = Kind::Text;
    plate.detection.text = "2.01";
    plate.detection.rangeM.reset();
    picture.detection.kind = Kind::Picture;
    picture.detection.templateId = TemplateId("hills");
    picture.detection.strength = 8.9;
    person.pass(2.0);
    person.see(plate);
    person.pass(4.0);
    Fix fix = person.see(picture);
    EXPECT_EQ(regionOf(fix), "U");
    EXPECT_LT(voteFor(fix, "R"), 0.3);
}

/// The map lists stairs at their foot only, and a camera sees them from their head as well.
TEST(BayesLocaliser, StairsSeenFromTheirHeadAreNoProofOfHavingClimbedDown) {
    auto building = twoStoreys().build();
    auto upperAfter = [&](bool sees) {
        Person person(building, guidedOptions());
        person.headFor("R");
        person.start("T");
        person.pass(20.0);
        Observation stairs = tracked(1, 2, 2.0);
        stairs.detection.kind = Kind::Stairs;
        stairs.detection.rangeM.reset();
        Fix fix = sees ? person.see(stairs) : person.pass(0.0);
        return voteFor(fix, "T") / std::max(1e-9, voteFor(fix, "S") + voteFor(fix, "T"));
    };
    double before = upperAfter(false);
    ASSERT_GT(before, 0.1);
    ASSERT_LT(before, 0.95);
    EXPECT_GT(upperAfter(true), before / 4.0);
}

TEST(BayesOptions, AreChecked) {
    EXPECT_TRUE(BayesOptions{}.check().ok());
    BayesOptions bad;
    bad.sensors.falsePerSecond = 0.0;
    EXPECT_FALSE(bad.check().ok());
    bad = {};
    bad.startTrust = 1.0;
    EXPECT_FALSE(bad.check().ok());
    bad = {};
    bad.walking.slowest = -1.0;
    EXPECT_FALSE(bad.check().ok());
}

TEST(ShortEditDistance, CountsUpToTwo) {
    EXPECT_EQ(shortEditDistance("2.14", "2.14"), 0);
    EXPECT_EQ(shortEditDistance("2.14", "2.15"), 1);
    EXPECT_EQ(shortEditDistance("2.14", "3.15"), 2);
    EXPECT_EQ(shortEditDistance("2.14", "ROOM"), 3);
    EXPECT_EQ(shortEditDistance("", "AB"), 2);
    EXPECT_EQ(shortEditDistance(std::string(40, 'A'), std::string(40, 'B')), 3);
}

TEST(BayesOptions, WhatIsOutOfRangeIsRefused) {
    EXPECT_TRUE(BayesOptions{}.check().ok());
    BayesOptions climbs, even, back;
    climbs.climbSees = 1.5;
    even.evenness = -0.1;
    back.walking.straightBack = -1.0;
    EXPECT_FALSE(climbs.check().ok());
    EXPECT_FALSE(even.check().ok());
    EXPECT_FALSE(back.check().ok());
    BayesOptions wall, track, reach;
    wall.walking.alongWallM = 0.0;
    track.trackSeconds = -1.0;
    reach.sensors.farthestM = 0.0;
    for (const BayesOptions& each : {wall, track, reach}) EXPECT_FALSE(each.check().ok());
}

} // namespace
