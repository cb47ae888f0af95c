// The lines of the command line are a contract: scripts read them.

#include "tests/session/walk_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace farol::session {
namespace {

using testing::HasSubstr;

NavigationStep stepWith(Percept percept) {
    NavigationStep step;
    step.fix.time = percept.time;
    step.percept = std::move(percept);
    return step;
}

Percept framed() {
    Percept percept;
    percept.frame = 371;
    percept.time = 12.3456;
    percept.name = "371.jpg";
    percept.size = {640, 480};
    percept.scene = 14;
    percept.sharpness = 21.98765;
    return percept;
}

TEST(JsonLines, ADetectionHasTheSharedForm) {
    Percept percept = framed();
    recognition::Detection detection = test::seen(Kind::Extinguisher, "red-one", 10.0004);
    detection.text = "2.14";
    detection.score = 0.93;
    detection.rangeM = 2.1;
    detection.bearing = fromDegrees(-12.0);
    percept.detections = {detection};
    EXPECT_EQ(
        linesOf(stepWith(percept), nullptr).at(1),
        R"({"type":"detection","t":12.346,"frame":371,"scene":14,"kind":"extinguisher","template":"red-one",)"
        R"("text":"2.14","box":[10.0,80.0,60.0,90.0],"image":[640,480],"score":0.93,"range_m":2.1,)"
        R"("bearing_deg":-12.0,"zone":"left-up","quad":[[10.0,80.0],[70.0,80.0],[70.0,170.0],[10.0,170.0]]})");
}

TEST(JsonLines, WhatIsNotKnownIsNull) {
    Percept percept = framed();
    percept.detections = {test::seen(Kind::Door, "")};
    std::string line = linesOf(stepWith(percept), nullptr).at(1);
    EXPECT_THAT(line, HasSubstr(R"("template":null,"text":null)"));
    EXPECT_THAT(line, HasSubstr(R"("range_m":null,"bearing_deg":null)"));
}

TEST(JsonLines, AFrameLineNamesPictureSceneAndSize) {
    EXPECT_EQ(
        linesOf(stepWith(framed()), nullptr).front(),
        R"({"type":"frame","t":12.346,"frame":371,"name":"371.jpg","scene":14,"sharpness":21.988,"size":[640,480]})");
}

TEST(JsonLines, AFixLineFollowsEachFrameAndShowsItsVotes) {
    NavigationStep step = stepWith(framed());
    step.fix.region = RegionId("leg-a");
    step.fix.confidence = 2.0 / 3.0;
    step.fix.near = {RegionId("leg-a"), RegionId("leg-b")};
    step.fix.nearConfidence = 0.9;
    step.fix.level = 0.5;
    step.fix.position = Point2{1.23456, -0.0001};
    step.fix.sigmaM = 1.5;
    step.fix.heading = fromDegrees(90.0);
    step.fix.votes = {{RegionId("leg-a"), 12.0, {{"Pobj", 3.0}, {"PID", 2.0}}, {}}};
    EXPECT_EQ(
        linesOf(step, nullptr).at(1),
        R"({"type":"fix","t":12.346,"frame":371,"region":"leg-a","confidence":0.667,"near":["leg-a","leg-b"],)"
        R"("near_confidence":0.9,"level":0.5,"position":[1.235,0.0],"sigma_m":1.5,"heading_deg":90.0,)"
        R"("votes":[{"region":"leg-a","vote":12.0,"terms":{"PID":2.0,"Pobj":3.0}}]})");
}

TEST(JsonLines, AnUnknownPlaceIsNullEverywhere) {
    NavigationStep step = stepWith(framed());
    EXPECT_EQ(
        linesOf(step, nullptr).at(1),
        R"({"type":"fix","t":12.346,"frame":371,"region":null,"confidence":0.0,"near":[],"near_confidence":0.0,)"
        R"("level":null,"position":null,"sigma_m":0.0,"heading_deg":null,"votes":[]})");
    EXPECT_EQ(dumped(fixJson(step.fix)),
              R"({"t":12.346,"region":null,"confidence":0.0,"near":[],"near_confidence":0.0,)"
              R"("level":null,"position":null,"sigma_m":0.0,"heading_deg":null,"votes":[]})");
}

TEST(JsonLines, ProgressIsToldOnlyWhenItChanged) {
    NavigationStep step = stepWith(framed());
    step.progress.travel = guidance::Travel::OnRoute;
    step.progress.distanceM = 4.0;
    EXPECT_THAT(linesOf(step, nullptr).back(), HasSubstr(R"("type":"progress")"));
    guidance::Progress before = step.progress;
    EXPECT_EQ(linesOf(step, &before).size(), 2U);
    before.distanceM = 4.00001; // the same once it is printed
    EXPECT_EQ(linesOf(step, &before).size(), 2U);
    before.distanceM = 4.1;
    EXPECT_EQ(linesOf(step, &before).size(), 3U);
    step.progress.travel = guidance::Travel::Arrived;
    EXPECT_THAT(linesOf(step, &before).back(), HasSubstr(R"("arrived":true)"));
}

TEST(JsonLines, ANewRouteIsToldWithItsProgress) {
    NavigationStep step = stepWith(framed());
    auto route = std::make_shared<routing::Route>();
    route->regions = {RegionId("A"), RegionId("B")};
    route->accesses = {AccessId("A-B")};
    step.progress.travel = guidance::Travel::OnRoute;
    step.progress.routeVersion = 1;
    step.progress.route = route;
    std::string first = linesOf(step, nullptr).back();
    EXPECT_THAT(first, HasSubstr(R"("region":"A")"));
    EXPECT_THAT(first, HasSubstr(R"("regions":["A","B"],"accesses":["A-B"])"));
    guidance::Progress before = step.progress;
    step.progress.regionsPassed = 1;
    std::string second = linesOf(step, &before).back();
    EXPECT_THAT(second, HasSubstr(R"("region":"B")"));
    EXPECT_THAT(second, testing::Not(HasSubstr(R"("regions")")));
}

TEST(JsonLines, ACueShowsTheFieldsThatAreSet) {
    guidance::Cue cue;
    cue.kind = guidance::CueKind::Detection;
    cue.priority = guidance::CuePriority::Detection;
    cue.id = 7;
    cue.frame = 3;
    cue.time = 1.5;
    cue.validUntil = 4.5;
    cue.objectKind = Kind::Extinguisher;
    cue.zone = {Column::Left, Row::Down};
    Json json = Json::parse(cueLine(cue));
    EXPECT_EQ(json["type"], "cue");
    EXPECT_EQ(json["id"], 7);
    EXPECT_EQ(json["object_kind"], "extinguisher");
    EXPECT_EQ(json["zone"], "left-down");
    for (const char* absent :
         {"hour", "distance_m", "manoeuvre", "region", "valid_in", "reason", "text", "route_version"})
        EXPECT_FALSE(json.contains(absent)) << absent;
    cue.hour = 3;
    cue.distanceM = 2.5;
    cue.manoeuvre = routing::Manoeuvre{};
    EXPECT_EQ(Json::parse(cueLine(cue))["hour"], 3);
    EXPECT_TRUE(Json::parse(cueLine(cue))["manoeuvre"].is_object());
}

TEST(JsonLines, TextThatIsNoUtf8BreaksNothing) {
    Percept percept = framed();
    percept.name = "caf\xe9.jpg";
    EXPECT_THAT(linesOf(stepWith(percept), nullptr).front(), HasSubstr("caf\xef\xbf\xbd.jpg"));
    EXPECT_NO_THROW((void)warningLine(0.0, 0, "\xff\xfe"));
}

TEST(JsonLines, FiguresAreRoundedAndNeverNegativeZero) {
    EXPECT_EQ(dumped(printedNumber(0.1 + 0.2)), "0.3");
    EXPECT_EQ(dumped(printedNumber(-0.0001)), "0.0");
    EXPECT_EQ(dumped(printedNumber(std::nan(""))), "null");
    EXPECT_EQ(dumped(printedNumber(HUGE_VAL)), "null");
    EXPECT_EQ(Json::parse(dumped(printedNumber(1e307))).get<double>(), 1e307);
}

TEST(LogLines, ADetectionLineOfAWalkReadsBack) {
    Percept percept = framed();
    recognition::Detection detection = test::seen(Kind::Sign, "exit", 33.25);
    detection.text = "EXIT";
    detection.rangeM = 3.5;
    detection.bearing = fromDegrees(10.0);
    percept.detections = {detection};
    auto line = parseLogLine(linesOf(stepWith(percept), nullptr).at(1));
    ASSERT_TRUE(line) << line.error().text();
    const auto& read = std::get<LogDetection>(*line);
    EXPECT_TRUE(read.unknownKind.empty());
    EXPECT_TRUE(read.frameGiven);
    EXPECT_EQ(read.percept.frame, 371U);
    EXPECT_EQ(read.percept.scene, 14);
    EXPECT_DOUBLE_EQ(read.percept.time, 12.346);
    const recognition::Detection& back = read.percept.detections.at(0);
    EXPECT_EQ(back.kind, Kind::Sign);
    EXPECT_EQ(back.templateId, detection.templateId);
    EXPECT_EQ(back.text, "EXIT");
    EXPECT_EQ(back.quad, detection.quad);
    EXPECT_EQ(back.zone(), detection.zone());
    EXPECT_DOUBLE_EQ(*back.rangeM, 3.5);
    EXPECT_NEAR(toDegrees(*back.bearing), 10.0, 1e-9);
}

TEST(LogLines, AFollowedDetectionKeepsItsTrack) {
    NavigationStep step;
    step.percept.detections.push_back(test::seen(Kind::Door, "", 33.0));
    std::string plain = linesOf(step, nullptr).at(1);
    EXPECT_FALSE(Json::parse(plain).contains("track")) << "nothing is followed: the line is as it always was";
    step.percept.detections[0].track = 7;
    step.percept.detections[0].confirmations = 3;
    auto line = parseLogLine(linesOf(step, nullptr).at(1));
    ASSERT_TRUE(line);
    const auto& back = std::get<LogDetection>(*line).percept.detections.at(0);
    EXPECT_EQ(back.track, 7U);
    EXPECT_EQ(back.confirmations, 3);
    auto kept = perceptFromJson(perceptJson(step.percept));
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->detections.at(0).track, 7U);
    EXPECT_EQ(kept->detections.at(0).confirmations, 3);
}

TEST(LogLines, APlaceKeepsItsLookAlikes) {
    NavigationStep step;
    recognition::Detection place = test::seen(Kind::Place, "hall-1-4", 320.0);
    std::string plain = [&] {
        NavigationStep other;
        other.percept.detections.push_back(place);
        return linesOf(other, nullptr).at(1);
    }();
    EXPECT_FALSE(Json::parse(plain).contains("strength"));
    EXPECT_FALSE(Json::parse(plain).contains("look_alikes"));
    place.strength = 17.25;
    place.lookAlikes = {{TemplateId("hall-2-4"), 16.5}, {TemplateId("hall-3-4"), 9.0}};
    step.percept.detections.push_back(place);
    auto line = parseLogLine(linesOf(step, nullptr).at(1));
    ASSERT_TRUE(line) << line.error().text();
    auto kept = perceptFromJson(perceptJson(step.percept));
    ASSERT_TRUE(kept);
    for (const recognition::Detection& back :
         {std::get<LogDetection>(*line).percept.detections.at(0), kept->detections.at(0)}) {
        EXPECT_DOUBLE_EQ(back.strength, 17.25);
        ASSERT_EQ(back.lookAlikes.size(), 2U);
        EXPECT_EQ(back.lookAlikes[1].templateId, TemplateId("hall-3-4"));
        EXPECT_DOUBLE_EQ(back.lookAlikes[1].strength, 9.0);
    }
    Json broken = Json::parse(linesOf(step, nullptr).at(1));
    broken["look_alikes"][0]["strength"] = -1.0;
    EXPECT_FALSE(parseLogLine(broken.dump()));
    broken["look_alikes"] = Json::array({"hall"});
    EXPECT_FALSE(parseLogLine(broken.dump()));
}

TEST(LogLines, TheOtherLinesOfAWalkOnlyTellTheTime) {
    NavigationStep step = stepWith(framed());
    for (const std::string& text : linesOf(step, nullptr)) {
        auto line = parseLogLine(text);
        ASSERT_TRUE(line) << text;
        EXPECT_DOUBLE_EQ(std::get<LogOther>(*line).time, 12.346);
    }
    EXPECT_TRUE(std::holds_alternative<LogOther>(*parseLogLine(warningLine(1.0, 2, "careful"))));
    EXPECT_TRUE(std::holds_alternative<LogOther>(*parseLogLine(utteranceLine(1.0, 2, 3, "Turn left."))));
}

TEST(LogLines, StartDestinationAndMotion) {
    EXPECT_EQ(std::get<LogStart>(*parseLogLine(R"({"t":0,"start":"R12"})")).region, RegionId("R12"));
    EXPECT_FALSE(std::get<LogStart>(*parseLogLine(R"({"t":0,"start":null})")).region);
    EXPECT_EQ(std::get<LogDestination>(*parseLogLine(R"({"t":0,"to":"R40"})")).where, "R40");
    auto motion = std::get<LogMotion>(*parseLogLine(R"({"t":1,"motion":{"turn_deg":-90,"speed":null}})"));
    EXPECT_NEAR(motion.motion.turn->value, -kPi / 2.0, 1e-12);
    EXPECT_FALSE(motion.motion.speed);
}

TEST(LogLines, AnUnknownKindIsKeptAsOther) {
    auto line = parseLogLine(R"({"t":1,"kind":"unicorn","box":[1,2,3,4],"image":[64,48]})");
    ASSERT_TRUE(line);
    EXPECT_EQ(std::get<LogDetection>(*line).unknownKind, "unicorn");
    EXPECT_EQ(std::get<LogDetection>(*line).percept.detections.at(0).kind, Kind::Other);
    EXPECT_FALSE(std::get<LogDetection>(*line).frameGiven);
}

TEST(LogLines, WhatIsWrongIsSaid) {
    const std::pair<const char*, const char*> cases[] = {
        {"", "not JSON"},
        {"{", "not JSON"},
        {"[]", "not a JSON object"},
        {"3", "not a JSON object"},
        {R"({"t":NaN,"kind":"door"})", "not JSON"},
        {R"({"t":1e999,"kind":"door"})", "not JSON"},
        {R"({"kind":"door","box":[1,2,3,4],"image":[64,48]})", "\"t\" is missing"},
        {R"({"t":"1","kind":"door","box":[1,2,3,4],"image":[64,48]})", "\"t\" is not a finite number"},
        {R"({"t":1,"kind":"door","box":[1,2,3],"image":[64,48]})", "\"box\""},
        {R"({"t":1,"kind":"door","box":[1,2,3,4,5],"image":[64,48]})", "\"box\""},
        {R"({"t":1,"kind":"door","box":[1,2,-3,4],"image":[64,48]})", "negative width"},
        {R"({"t":1,"kind":"door","box":"all","image":[64,48]})", "\"box\""},
        {R"({"t":1,"kind":"door","box":[1,2,3,4]})", "\"image\""},
        {R"({"t":1,"kind":"door","box":[1,2,3,4],"image":[0,48]})", "\"image\""},
        {R"({"t":1,"kind":"door","box":[1,2,3,4],"image":[1e12,48]})", "\"image\""},
        {R"({"t":1,"kind":5,"box":[1,2,3,4],"image":[64,48]})", "\"kind\""},
        {R"({"t":1,"kind":"door","box":[1,2,3,4],"image":[64,48],"score":2})", "\"score\""},
        {R"({"t":1,"kind":"door","box":[1,2,3,4],"image":[64,48],"frame":-1})", "\"frame\""},
        {R"({"t":1,"kind":"door","box":[1,2,3,4],"image":[64,48],"frame":18446744073709551615})",
         "\"frame\""},
        {R"({"t":1,"kind":"door","box":[1,2,3,4],"image":[64,48],"scene":1.5})", "\"scene\""},
        {R"({"t":1,"kind":"door","box":[1,2,3,4],"image":[64,48],"quad":[[1,2],[3]]})", "\"quad\""},
        {R"({"t":1,"kind":"door","box":[1,2,3,4],"image":[64,48],"range_m":-1})", "\"range_m\""},
        {R"({"t":1,"motion":5})", "\"motion\""},
        {R"({"t":1,"motion":{"speed":-1}})", "\"speed\""},
        {R"({"t":1,"to":null})", "\"to\""},
        {R"({"t":1,"start":12})", "\"start\""},
        {R"({"t":1})", "neither"},
        {R"({"t":1,"type":"poem"})", "poem"},
    };
    for (const auto& [text, reason] : cases) {
        auto line = parseLogLine(text);
        ASSERT_FALSE(line) << text;
        EXPECT_EQ(line.error().code, ErrorCode::Corrupt) << text;
        EXPECT_THAT(line.error().message, HasSubstr(reason)) << text;
    }
}

TEST(PerceptJson, KeepsEveryDigit) {
    for (Percept& percept : test::walkThroughTheRooms()) {
        percept.time += 0.1 + 0.2;
        auto back = perceptFromJson(Json::parse(dumped(perceptJson(percept))));
        ASSERT_TRUE(back) << back.error().text();
        EXPECT_EQ(back->time, percept.time);
        EXPECT_EQ(back->sharpness, percept.sharpness);
        EXPECT_EQ(dumped(perceptJson(*back)), dumped(perceptJson(percept)));
        ASSERT_EQ(back->detections.size(), percept.detections.size());
        for (std::size_t i = 0; i < back->detections.size(); ++i) {
            EXPECT_EQ(back->detections[i].quad, percept.detections[i].quad);
            EXPECT_EQ(back->detections[i].rangeM, percept.detections[i].rangeM);
            EXPECT_EQ(back->detections[i].bearing, percept.detections[i].bearing);
            EXPECT_EQ(back->detections[i].text, percept.detections[i].text);
        }
        EXPECT_EQ(back->motion.turn, percept.motion.turn);
        EXPECT_EQ(back->motion.walking, percept.motion.walking);
        EXPECT_EQ(back->motion.stepsPerSecond, percept.motion.stepsPerSecond);
        EXPECT_EQ(back->rejections.size(), percept.rejections.size());
    }
}

TEST(PerceptJson, DamageIsRefusedWithItsPlace) {
    Json json = perceptJson(test::walkThroughTheRooms().at(13));
    json["detections"][0]["score"] = nullptr;
    auto back = perceptFromJson(json);
    ASSERT_FALSE(back);
    EXPECT_THAT(back.error().message, HasSubstr("detections"));
    EXPECT_THAT(back.error().message, HasSubstr("score"));
    EXPECT_FALSE(perceptFromJson(Json::array()));
    EXPECT_FALSE(perceptFromJson(Json(3)));
}

} // namespace
} // namespace farol::session
