// What is answered when the user asks.

#include "tests/guidance/guided.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace farol;
using namespace farol::guidance;
using farol::test::AsciiMap;
using farol::test::at;
using farol::test::Guided;

namespace {

struct Asked : Guided {
    using Guided::Guided;
    Cue ask(Question question) { return scheduler.answer(question, frame, fix, progress); }
};

AsciiMap lobby() {
    return AsciiMap()
        .floor(R"(
            +-------+-------+
            |A      |B      |
            |       |       |
            +---/---+---/---+
            |L              |
            |       1      e|
            |               |
            +---/-------*---+
            |C      |D      |
            +-------+-------+
        )")
        .region('A', {"input name here", building::RegionKind::Room})
        .region('B', {"Bar", building::RegionKind::Room})
        .landmark('e', {Kind::Extinguisher});
}

TEST(Answers, WhereOneIs) {
    Asked walk;
    walk.seen("K", '5');
    Cue cue = walk.ask(Question::WhereAmI);
    EXPECT_EQ(cue.kind, CueKind::Located);
    EXPECT_TRUE(cue.asked);
    EXPECT_TRUE(cue.sure);
    EXPECT_EQ(cue.regionName, "Corridor");
    EXPECT_EQ(cue.levelName, "Level 0");
    EXPECT_EQ(cue.priority, CuePriority::Answer);
    EXPECT_TRUE(cue.validIn.empty());
}

TEST(Answers, NamesAreInTheLanguageThatIsSpoken) {
    building::BuildingData data = lobby().data();
    for (building::Region& region : data.regions)
        if (region.id.value == "L") region.extra["name_pt"] = std::string("Átrio");
    data.levels.front().extra["name_pt"] = std::string("Piso 0");
    auto building = std::make_shared<const building::Building>(std::move(data));
    GuidanceOptions options;
    options.language = "pt";
    CueScheduler scheduler(building, options);
    localisation::Fix fix;
    fix.region = RegionId("L");
    fix.confidence = 0.95;
    fix.level = 0.0;
    fix.position = Point2{6.0, 3.0};
    fix.sigmaM = 0.5;
    Cue here = scheduler.answer(Question::WhereAmI, 1, fix, {});
    EXPECT_EQ(here.regionName, "Átrio");
    Cue around = scheduler.answer(Question::AroundMe, 1, fix, {});
    EXPECT_TRUE(std::any_of(around.around.begin(), around.around.end(), [](const Surrounding& each) {
        return each.name == "Bar";
    })) << "a name in no other language stays";
    scheduler.setLanguage("en");
    EXPECT_NE(scheduler.answer(Question::WhereAmI, 1, fix, {}).regionName, "Átrio");
}

TEST(Answers, InOrNextToWhenOnlyThatIsSure) {
    Asked walk;
    walk.seen("K", 0, 0.3);
    walk.fix.nearConfidence = 0.95;
    Cue cue = walk.ask(Question::WhereAmI);
    EXPECT_EQ(cue.kind, CueKind::Located);
    EXPECT_FALSE(cue.sure);
    walk.fix.nearConfidence = 0.4;
    cue = walk.ask(Question::WhereAmI);
    EXPECT_EQ(cue.kind, CueKind::Unsure) << "else not sure, and look around";
    EXPECT_EQ(cue.sweep, SweepStep::Right);
}

TEST(Answers, NobodyKnownIsAskedToLookAround) {
    Asked walk;
    for (Question question : {Question::WhereAmI, Question::AroundMe, Question::Repeat})
        EXPECT_EQ(walk.ask(question).kind, CueKind::Unsure);
    for (Question question : {Question::Next, Question::Remaining, Question::Preview}) {
        EXPECT_EQ(walk.ask(question).kind, CueKind::NoRoute);
        EXPECT_EQ(walk.ask(question).reason, CueReason::NoDestination);
    }
    walk.tracker.setDestination(at("B"));
    walk.seen("");
    EXPECT_EQ(walk.ask(Question::Next).kind, CueKind::Unsure);
}

TEST(Answers, AskedInTheMiddleOfALookAroundTheOrderIsToldAgain) {
    Asked walk;
    walk.tracker.setDestination(at("B"));
    walk.seen("");
    walk.wait(16);
    ASSERT_GE(walk.count(CueKind::Unsure), 2U);
    SweepStep last = SweepStep::None;
    for (const Cue& cue : walk.all)
        if (cue.kind == CueKind::Unsure) last = cue.sweep;
    EXPECT_EQ(walk.ask(Question::Repeat).sweep, last == SweepStep::None ? SweepStep::Right : last);
}

TEST(Answers, AroundIsTheOpenDoorsAndTheThings) {
    Asked walk(lobby());
    walk.seen("L", '1');
    walk.fix.heading = fromDegrees(0.0);
    walk.fix.headingSigma = fromDegrees(10.0);
    Cue cue = walk.ask(Question::AroundMe);
    ASSERT_EQ(cue.kind, CueKind::Around);
    EXPECT_EQ(cue.bearing, Bearing::Facing);
    ASSERT_EQ(cue.around.size(), 4U) << "the closed door of D is no way";
    for (std::size_t i = 1; i < cue.around.size(); ++i)
        EXPECT_LE(*cue.around[i - 1].distanceM, *cue.around[i].distanceM);
    for (const Surrounding& each : cue.around) {
        ASSERT_TRUE(each.direction);
        double degrees = toDegrees(*each.direction);
        if (each.name == "Bar") {
            EXPECT_GT(degrees, 10.0) << "ahead, to the left";
            EXPECT_LT(degrees, 80.0);
        }
        if (!each.access) {
            EXPECT_EQ(each.kind, Kind::Extinguisher);
            EXPECT_NEAR(degrees, 0.0, 5.0);
        }
        EXPECT_NE(each.name, "input name here");
    }
}

TEST(Answers, DirectionsCountFromWhatIsKnown) {
    Asked walk(lobby());
    walk.seen("L", '1');
    EXPECT_EQ(walk.ask(Question::AroundMe).bearing, Bearing::Map);
    walk.fix.heading = fromDegrees(0.0);
    EXPECT_EQ(walk.ask(Question::AroundMe).bearing, Bearing::Map) << "a heading of unknown quality is none";
    walk.tracker.setDestination(at("B"));
    walk.seen("L", '1');
    EXPECT_EQ(walk.ask(Question::AroundMe).bearing, Bearing::AlongWay);
    walk.seen("L");
    Cue cue = walk.ask(Question::AroundMe);
    EXPECT_EQ(cue.bearing, Bearing::None);
    EXPECT_EQ(cue.around.size(), 3U);
    for (const Surrounding& each : cue.around) EXPECT_FALSE(each.direction);
}

TEST(Answers, NextIsMadeForThePresentPlaceAndChangesNothing) {
    Asked walk;
    walk.tracker.setDestination(at("C"));
    walk.seen("K", '1');
    Cue far = walk.ask(Question::Next);
    ASSERT_EQ(far.kind, CueKind::Prepare);
    walk.seen("K", '4');
    Cue near = walk.ask(Question::Repeat);
    ASSERT_TRUE(near.manoeuvre && near.distanceM && far.distanceM);
    EXPECT_LT(*near.distanceM, *far.distanceM);
    Asked silent;
    silent.tracker.setDestination(at("C"));
    silent.seen("K", '1');
    silent.seen("K", '4');
    silent.seen("K", '5');
    walk.seen("K", '5');
    EXPECT_EQ(walk.count(CueKind::Prepare), silent.count(CueKind::Prepare));
    EXPECT_EQ(walk.count(CueKind::Act), silent.count(CueKind::Act));
}

TEST(Answers, RepeatAtTheEndAndWhereNoWayLeads) {
    Asked walk;
    walk.tracker.setDestination(at("A"));
    walk.seen("A");
    EXPECT_EQ(walk.ask(Question::Repeat).kind, CueKind::AlreadyThere);
    walk.tracker.setDestination(at("X"));
    walk.seen("A");
    Cue cue = walk.ask(Question::Repeat);
    EXPECT_EQ(cue.kind, CueKind::NoRoute);
    EXPECT_EQ(cue.reason, CueReason::DestinationUnreachable);
}

TEST(Answers, TheListHoldsAllThatIsLeft) {
    Asked walk;
    walk.tracker.setDestination(at("U"));
    walk.seen("A");
    auto accesses = [](const Cue& cue) {
        std::vector<std::string> ids;
        for (const Cue& step : cue.steps) ids.push_back(step.manoeuvre->access.value);
        return ids;
    };
    const std::vector<std::string> all{"A-K", "K-S", "S-T", "T-U"};
    EXPECT_EQ(accesses(walk.ask(Question::Preview)), all);
    EXPECT_EQ(accesses(walk.ask(Question::Remaining)), all);
    walk.seen("K");
    walk.seen("S");
    Cue rest = walk.ask(Question::Remaining);
    EXPECT_EQ(accesses(rest), (std::vector<std::string>{"S-T", "T-U"}));
    EXPECT_EQ(rest.steps.front().levelName, "Level 1");
    EXPECT_EQ(rest.steps.front().manoeuvre->steps, 18);
    ASSERT_TRUE(rest.steps.back().next);
    EXPECT_EQ(rest.steps.back().next->kind, routing::ManoeuvreKind::Arrive);
    EXPECT_EQ(accesses(walk.ask(Question::Preview)), all) << "the whole way, wherever one is";
}

TEST(Answers, IdsRiseWithTheOtherCues) {
    Asked walk;
    walk.tracker.setDestination(at("B"));
    walk.seen("A");
    std::uint64_t before = walk.cues.back().id;
    EXPECT_EQ(walk.ask(Question::WhereAmI).id, before + 1);
    walk.seen("K");
    ASSERT_FALSE(walk.cues.empty());
    EXPECT_EQ(walk.cues.front().id, before + 2);
}

TEST(Chimes, AFixIsHeardOnceAndAgainAfterItWasLost) {
    Guided walk;
    walk.seen("K", '5');
    ASSERT_FALSE(walk.cues.empty());
    EXPECT_EQ(walk.cues.front().chime, Chime::Fix);
    walk.all.clear();
    for (int i = 0; i < 5; ++i) walk.seen("K", '5');
    for (const Cue& cue : walk.all) EXPECT_EQ(cue.chime, Chime::None);
    walk.seen("");
    walk.wait(4);
    walk.seen("K", '5');
    ASSERT_FALSE(walk.cues.empty());
    EXPECT_EQ(walk.cues.front().chime, Chime::Fix);
    EXPECT_EQ(walk.scheduler.warning(1, 2.0, CueReason::CameraLost, "").chime, Chime::Warning);
}

/// "On your left" would be the wall that it lies behind.
TEST(Answers, WhatLiesBehindAWallOfTheSamePlaceIsNotAroundOne) {
    AsciiMap ring = AsciiMap()
                        .floor(R"(
            +-----+-----+-----+
            |A    |B    |C    |
            +--/--+--/--+--/--+
            |K   e            |
            |   +---------+   |
            |   |X        |   |
            |   +---------+   |
            |      1          |
            +--/--------/-----+
            |D       |E       |
            +--------+--------+
        )")
                        .landmark('e', {Kind::Extinguisher});
    Asked walk(ring);
    walk.seen("K", '1');
    std::string names;
    for (const Surrounding& each : walk.ask(Question::AroundMe).around) {
        names += each.name;
        EXPECT_TRUE(each.access) << "the extinguisher is behind the core";
    }
    for (char inSight : std::string("DE")) EXPECT_NE(names.find(inSight), std::string::npos) << names;
    for (char behind : std::string("B")) EXPECT_EQ(names.find(behind), std::string::npos) << names;
}

/// Half of a wide opening is straight ahead of whoever walks along its side.
TEST(Answers, AWideOpeningIsWhereItIsNearest) {
    AsciiMap halls = AsciiMap().floor(R"(
            +--------+--------+
            |A       :B       |
            |        :        |
            |     1  :        |
            |        :        |
            |        :        |
            +--------+--------+
        )");
    Asked walk(halls);
    walk.seen("A", '1');
    walk.fix.heading = fromDegrees(0.0);
    walk.fix.headingSigma = fromDegrees(10.0);
    walk.fix.sigmaM = 0.5;
    const Cue around = walk.ask(Question::AroundMe);
    ASSERT_EQ(around.around.size(), 1U);
    ASSERT_TRUE(around.around.front().direction);
    EXPECT_NEAR(toDegrees(*around.around.front().direction), 0.0, 10.0);
}

} // namespace
