// The filter for those who are guided: they go where they face, not from door to door, and the camera is the
// program's own.

#include "core/localisation/localisers.h"
#include "tests/support/ascii_map.h"

#include <gtest/gtest.h>

namespace {

using namespace farol;
using namespace farol::localisation;
using namespace farol::test;

/// Two rooms on either side of a corridor, a poster at its east end.
std::shared_ptr<const building::Building> corridor() {
    AsciiMap map;
    map.floor(R"(
+-----------+-----------+
|A          |B          |
|           |           |
|           |           |
+-----/-----+-----/-----+
|K         z           p|
|                       |
+-----/-----+-----/-----+
|C          |D          |
|           |           |
|           |           |
+-----------+-----------+
)");
    map.region('K', {.kind = building::RegionKind::Corridor});
    map.landmark('p', {.kind = Kind::Poster, .templateId = "sea", .headingDeg = 180.0});
    map.landmark('z', {.kind = Kind::Text, .text = "FLOOR 0", .headingDeg = 270.0});
    return map.build();
}

/// Five pictures a second.
class Blind {
public:
    Blind(const std::shared_ptr<const building::Building>& building, const std::string& from)
        : m_localiser(makeLocaliser("bayes-guided", building).value()) {
        m_localiser->start(0.0, from.empty() ? std::nullopt : std::optional(RegionId(from)));
        m_fix = m_localiser->update(0.0, {}, {});
    }
    Blind& walk(double metres) { return move(metres / kSpeed, 0.0, kSpeed); }
    /// The same steps, told as slower ones.
    Blind& walkToldAs(double metres, double share) { return move(metres / kSpeed, 0.0, share * kSpeed); }
    Blind& stand(double seconds) { return move(seconds, 0.0, 0.0); }
    Blind& turn(double degrees) { return move(std::abs(degrees) / 75.0, degrees, 0.0); }
    Blind& see(Kind kind, const std::string& templateId, const std::string& text, double rangeM,
               double bearingDeg) {
        Observation seen;
        seen.time = m_time;
        seen.track = ++m_track;
        seen.detection.kind = kind;
        seen.detection.templateId = TemplateId(templateId);
        seen.detection.text = text;
        seen.detection.image = {640, 480};
        seen.detection.rangeM = rangeM;
        seen.detection.rangeSpread = 0.1;
        seen.detection.bearing = fromDegrees(bearingDeg);
        m_fix = m_localiser->update(m_time, std::vector{seen}, {});
        return *this;
    }
    /// So near a bare wall that the picture shows nothing, motion neither.
    Blind& faceAWall(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds / kFrameS); ++i) {
            m_time += kFrameS;
            m_fix = m_localiser->update(m_time, {}, {});
        }
        return *this;
    }
    Blind& told(building::AccessKind kind, double targetLevel = 0.0, bool intoLift = false) {
        m_localiser->told(ToldWay{{{kind, 0.0, targetLevel, intoLift}}});
        return *this;
    }
    Blind& goal(const std::string& region) {
        RouteContext route;
        route.destination = building::Location{RegionId(region), std::nullopt};
        m_localiser->setRoute(route);
        return *this;
    }
    double share(const std::string& region) const {
        for (const RegionVote& vote : m_fix.votes)
            if (vote.region.value == region) return vote.vote;
        return 0.0;
    }
    std::string region() const { return m_fix.region ? m_fix.region->value : ""; }
    const Fix& fix() const { return m_fix; }

private:
    static constexpr double kSpeed = 0.75, kFrameS = 0.2;

    Blind& move(double seconds, double degrees, double speed) {
        int frames = std::max(1, static_cast<int>(seconds / kFrameS + 0.5));
        for (int i = 0; i < frames; ++i) {
            m_time += kFrameS;
            recognition::Motion motion;
            motion.turn = fromDegrees(degrees / frames);
            motion.speed = speed;
            m_localiser->moved(m_time, motion);
            m_fix = m_localiser->update(m_time, {}, {});
        }
        return *this;
    }

    std::unique_ptr<Localiser> m_localiser;
    double m_time = 0.0;
    std::uint64_t m_track = 0;
    Fix m_fix;
};

/// Known to stand in the corridor facing east, 6 m before the doors of B and D.
Blind beforeTheDoors() {
    Blind person(corridor(), "K");
    person.stand(1.0).see(Kind::Poster, "sea", "", 10.5, 3.0).walk(1.0);
    person.see(Kind::Poster, "sea", "", 9.5, 3.0).walk(1.0);
    return person;
}

TEST(GuidedWalk, ATurnThroughADoorIsFollowedIntoTheRoom) {
    for (auto [degrees, room] : {std::pair{-90.0, "D"}, {90.0, "B"}}) {
        Blind person = beforeTheDoors();
        EXPECT_EQ(person.region(), "K");
        person.walk(3.2).turn(degrees).walk(3.5);
        EXPECT_EQ(person.region(), room);
    }
}

TEST(GuidedWalk, WhoWalksOnStaysInTheCorridor) {
    Blind person = beforeTheDoors();
    person.walk(6.0);
    EXPECT_EQ(person.region(), "K");
    EXPECT_GT(person.fix().confidence, 0.7);
}

TEST(GuidedWalk, AWideRoomThatLooksLikeASlowerWalkHidesFewSteps) {
    Blind person(corridor(), "K");
    person.stand(1.0).see(Kind::Poster, "sea", "", 10.5, 3.0).walk(1.5);
    person.see(Kind::Poster, "sea", "", 9.0, 3.0);
    ASSERT_TRUE(person.fix().position);
    double before = person.fix().position->x;
    person.walkToldAs(3.0, 0.55);
    ASSERT_TRUE(person.fix().position);
    EXPECT_GT(person.fix().position->x - before, 0.6 * 3.0);
}

TEST(GuidedWalk, OneMoreThingLikeThoseOnTheMapMakesNobodySureOfAnotherRoom) {
    AsciiMap map;
    map.floor(R"(
+-----------+-----------+
|A          |B          |
|           |           |
|           |           |
+-----/-----+-----/-----+
|K          e           |
|    f            g     |
+-----------------------+
)");
    map.region('K', {.kind = building::RegionKind::Corridor});
    for (char spot : {'e', 'f', 'g'})
        map.landmark(spot, {.kind = Kind::Extinguisher, .templateId = "red", .headingDeg = 90.0});
    Blind person(map.build(), "A");
    person.stand(3.0).see(Kind::Extinguisher, "red", "", 3.0, 10.0).stand(3.0);
    person.see(Kind::Extinguisher, "red", "", 3.0, 10.0).stand(2.0);
    EXPECT_LT(person.share("K"), 0.98) << "one that nobody has drawn hangs in many a room";
}

TEST(GuidedWalk, WhoStandsAndLooksRoundStaysWhereTheyAre) {
    Blind person = beforeTheDoors();
    person.turn(-90.0).turn(180.0).turn(-90.0).stand(10.0);
    EXPECT_EQ(person.region(), "K");
    ASSERT_TRUE(person.fix().heading);
    EXPECT_LT(std::abs(toDegrees(*person.fix().heading)), 30.0) << "the turns were counted";
}

TEST(GuidedWalk, ATrainedThingIsKnownFromFarAway) {
    Blind person(corridor(), "");
    person.stand(2.0)
        .see(Kind::Poster, "sea", "", 9.0, 0.0)
        .stand(3.0)
        .see(Kind::Poster, "sea", "", 9.0, 0.0);
    EXPECT_EQ(person.region(), "K");
    ASSERT_TRUE(person.fix().position);
    Point2 poster = corridor()->landmarks().front().position;
    for (const auto& landmark : corridor()->landmarks())
        if (landmark.templateId.value == "sea") poster = landmark.position;
    EXPECT_NEAR(distance(*person.fix().position, poster), 9.0, 1.5);
}

TEST(GuidedWalk, ADoorThatThePlanOnlyDrawsIsSomethingToSee) {
    AsciiMap map;
    map.floor(R"(
+-----------------------------+
|K                           k|
|                             |
+---------------------------/-+
|R                            |
|                             |
+-----------------------------+
)");
    auto building = map.build();
    ASSERT_TRUE(building->landmarks().empty());
    Blind person(building, "K");
    for (int i = 0; i < 6; ++i) person.see(Kind::Door, "", "", 1.2, 0.0).stand(1.0);
    EXPECT_EQ(person.region(), "K");
    ASSERT_TRUE(person.fix().position);
    EXPECT_LT(distance(*person.fix().position, building->accesses().front().midpoint()), 2.0);
}

TEST(GuidedWalk, LettersThatLookAlikeAreReadForOneAnother) {
    AsciiMap map;
    map.floor(R"(
+-------+-------+-------+
|A      :B      :C      |
|   x   :   y   :   z   |
+-------+-------+-------+
)");
    map.landmark('x', {.kind = Kind::Text, .text = "FLOOR 0", .headingDeg = 270.0});
    map.landmark('y', {.kind = Kind::Text, .text = "FLOOR 1", .headingDeg = 270.0});
    map.landmark('z', {.kind = Kind::Text, .text = "FLOOR 2", .headingDeg = 270.0});
    Blind person(map.build(), "");
    for (int i = 0; i < 3; ++i) person.see(Kind::Text, "", "FLOOR O", 1.0, 0.0).stand(4.5);
    EXPECT_EQ(person.region(), "A");
}

/// Stairs in a small stairwell, on the way.
std::shared_ptr<const building::Building> stairwell() {
    AsciiMap map;
    map.floor(R"(
+-----+-----+
|S    |K    |
|     /     |
+-----+-----+
)");
    map.floor(R"(
+-----+-----+
|T    |L    |
|     /     |
+-----+-----+
)",
              1.0);
    map.join(building::AccessKind::Stairs, 'S', 'T', "main", 18);
    return map.build();
}

TEST(GuidedWalk, NobodyClimbsWhoWasToldOfADoor) {
    Blind door(stairwell(), "S"), stairs(stairwell(), "S");
    door.goal("L").told(building::AccessKind::Door).walk(10.0);
    stairs.goal("L").told(building::AccessKind::Stairs, 1.0).walk(10.0);
    EXPECT_LT(door.share("T") + door.share("L"), 0.15);
    EXPECT_GT(stairs.share("T") + stairs.share("L"), 0.5);
}

/// A lift's door and an ordinary one at the end of a corridor.
std::shared_ptr<const building::Building> liftLobby() {
    AsciiMap map;
    map.floor(R"(
+-------+-----+
|K      /R    |
|   1   |     |
|       +-----+
|       /L    |
|       |     |
+-------+-----+
)");
    map.floor(R"(
+-------+-----+
|M      |     |
|       |     |
|       +-----+
|       /U    |
|       |     |
+-------+-----+
)",
              1.0);
    map.region('L', {"Lift", building::RegionKind::Elevator});
    map.region('U', {"Lift", building::RegionKind::Elevator});
    map.join(building::AccessKind::Elevator, 'L', 'U', "one");
    return map.build();
}

TEST(GuidedWalk, NobodyTakesARoomForTheLiftThatWasTold) {
    auto walked = [](bool intoLift, const char* room) {
        Blind person(liftLobby(), "K");
        person.goal("M").told(building::AccessKind::Door, 0.0, intoLift).walk(8.0).stand(5.0);
        return person.share(room);
    };
    EXPECT_LT(walked(true, "R"), 0.7 * walked(false, "R"));
    EXPECT_GT(walked(true, "L"), walked(false, "L"));
}

TEST(GuidedWalk, WhoIsToldToTakeTheLiftGoesInFirst) {
    Blind lift(liftLobby(), "K"), stairs(liftLobby(), "K");
    lift.goal("M").told(building::AccessKind::Elevator, 1.0).walk(8.0).stand(40.0);
    stairs.goal("M").told(building::AccessKind::Stairs, 1.0).walk(8.0).stand(40.0);
    EXPECT_GT(lift.share("U") + lift.share("M"), 2.0 * (stairs.share("U") + stairs.share("M")));
}

TEST(GuidedWalk, WhoWasToldOfStairsFindsThemAlsoWhereStepsWereMeasuredShort) {
    // As the picture has it the user stops a good two metres before the stairs, and stands.
    auto standing = [](building::AccessKind kind, double level) {
        Blind person(stairwell(), "S");
        person.goal("L").told(kind, level).walk(0.5).stand(25.0);
        return person.share("T") + person.share("L");
    };
    EXPECT_GT(standing(building::AccessKind::Stairs, 1.0), 0.5);
    EXPECT_LT(standing(building::AccessKind::Door, 0.0), 0.15);
}

TEST(GuidedWalk, BeforeABareWallNothingIsMissed) {
    // A hall full of posters and an empty one: whoever sees no poster for long is in the empty one, unless
    // there was nothing to be seen at all.
    AsciiMap map;
    map.floor(R"(
+-----------+-----------+
|A  p   q   |B          |
|r          /           |
|   s   t   |           |
+-----------+-----------+
)");
    int number = 0;
    for (char each : {'p', 'q', 'r', 's', 't'})
        map.landmark(each, {.kind = Kind::Poster, .templateId = "poster-" + std::to_string(number++)});
    auto building = map.build();
    Blind looking(building, ""), close(building, "");
    looking.walk(1.0);
    close.walk(1.0);
    for (int i = 0; i < 6; ++i) {
        looking.turn(90.0).stand(1.4);
        close.faceAWall(2.4).stand(0.2);
    }
    EXPECT_LT(looking.share("A"), 0.25);
    EXPECT_GT(close.share("A"), looking.share("A") + 0.2);
}

TEST(GuidedWalk, WhoWasToldOfADoorMayHaveTakenAnother) {
    // Along the corridor to its east end, told of a door; B and D are there, one of them is meant.
    Blind user(corridor(), "K");
    user.goal("B").told(building::AccessKind::Door).walk(4.0).turn(90.0).walk(4.0);
    Blind untold(corridor(), "K");
    untold.goal("B").walk(4.0).turn(90.0).walk(4.0);
    double other = user.share("D") + user.share("A") + user.share("C");
    double otherUntold = untold.share("D") + untold.share("A") + untold.share("C");
    EXPECT_GE(other, otherUntold);
}

} // namespace
