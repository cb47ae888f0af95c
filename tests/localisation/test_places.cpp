// Trained places in the filter: how much a view of one tells, and what look-alike floors take from it.

#include "core/localisation/bayes_localiser.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace {

using namespace farol;
using namespace farol::localisation;
using building::BuildingData;
using building::Landmark;
using building::Region;
using recognition::Detection;

/// Floors with one straight corridor of 40 m each, joined by stairs at its end.
BuildingData tower(int floors) {
    BuildingData data;
    for (int floor = 0; floor < floors; ++floor) {
        std::string number = std::to_string(floor);
        data.levels.push_back({double(floor), "Floor " + number, number, std::nullopt, std::nullopt, {}});
        Region corridor;
        corridor.id = RegionId("corridor-" + number);
        corridor.kind = building::RegionKind::Corridor;
        corridor.level = floor;
        corridor.polygon.outer = {{0, 0}, {40, 0}, {40, 2}, {0, 2}};
        data.regions.push_back(corridor);
        if (floor == 0) continue;
        building::Access stairs;
        stairs.id = AccessId("stairs-" + number);
        stairs.kind = building::AccessKind::Stairs;
        stairs.regionA = data.regions[data.regions.size() - 2].id;
        stairs.regionB = corridor.id;
        stairs.level = floor - 1;
        stairs.line = {{39, 0.5}, {39, 1.5}};
        data.accesses.push_back(stairs);
    }
    return data;
}

std::string placeName(int floor, int metre) {
    return "place-" + std::to_string(floor) + "-" + std::to_string(metre);
}

/// A place every two metres, looking east, as a survey leaves them.
void survey(BuildingData& data, int floor, bool east = true) {
    for (int metre = 1; metre < 40; metre += 2) {
        Landmark place;
        place.id = LandmarkId(placeName(floor, metre) + (east ? "" : "-west"));
        place.templateId = TemplateId(place.id.value);
        place.kind = Kind::Place;
        place.region = RegionId("corridor-" + std::to_string(floor));
        place.level = floor;
        place.position = {double(metre), 1.0};
        place.heading = Radians{east ? 0.0 : kPi};
        data.landmarks.push_back(place);
    }
}

Observation placeSeen(double time, const std::string& name, double strength,
                      std::vector<recognition::LookAlike> others = {}) {
    Observation seen;
    seen.time = time;
    seen.frame = static_cast<std::uint64_t>(time);
    seen.detection.kind = Kind::Place;
    seen.detection.templateId = TemplateId(name);
    seen.detection.image = {640, 480};
    seen.detection.quad = quadOf({0, 0, 640, 480});
    seen.detection.strength = strength;
    seen.detection.lookAlikes = std::move(others);
    return seen;
}

/// Walks east along a corridor from an unknown start, a place recognised at every second of `strength`.
std::vector<Fix> walk(const BuildingData& data, int recognisedFloor, double strength,
                      const std::vector<int>& alikeFloors, double alikeShare) {
    auto localiser = makeBayesLocaliser(std::make_shared<const building::Building>(BuildingData(data)));
    localiser->start(0.0, std::nullopt);
    std::vector<Fix> fixes;
    for (int second = 0; second < 16; ++second) {
        int metre = 1 + 2 * (second / 2);
        std::vector<recognition::LookAlike> others;
        for (int floor : alikeFloors)
            others.push_back({TemplateId(placeName(floor, metre)), alikeShare * strength});
        std::vector<Observation> fresh;
        if (second % 2 == 0)
            fresh.push_back(placeSeen(second, placeName(recognisedFloor, metre), strength, others));
        fixes.push_back(localiser->update(second, fresh, {}));
    }
    return fixes;
}

double mostConfident(const std::vector<Fix>& fixes) {
    double most = 0.0;
    for (const Fix& fix : fixes) most = std::max(most, fix.confidence);
    return most;
}

TEST(Places, AFloorThatLooksLikeNoOtherIsKnownAtOnce) {
    BuildingData data = tower(3);
    for (int floor = 0; floor < 3; ++floor) survey(data, floor);
    auto fixes = walk(data, 1, 30.0, {}, 0.0);
    EXPECT_EQ(fixes[5].region, RegionId("corridor-1"));
    EXPECT_GE(fixes[5].confidence, 0.8);
    ASSERT_TRUE(fixes[14].position);
    EXPECT_NEAR(fixes[14].position->x, 15.0, 1.5);
}

TEST(Places, FloorsThatFitNearlyAsWellShareTheEvidence) {
    BuildingData data = tower(3);
    for (int floor = 0; floor < 3; ++floor) survey(data, floor);
    auto fixes = walk(data, 1, 18.0, {0, 2}, 0.92);
    EXPECT_LT(mostConfident(fixes), 0.8) << "however long one walks";
}

TEST(Places, AFloorThatNobodySurveyedMayLookTheSame) {
    BuildingData data = tower(3);
    survey(data, 1);
    EXPECT_LT(mostConfident(walk(data, 1, 30.0, {}, 0.0)), 0.8) << "nothing in the library could deny it";
    survey(data, 0, false);
    survey(data, 2, false);
    EXPECT_LT(mostConfident(walk(data, 1, 30.0, {}, 0.0)), 0.8) << "surveyed the other way only";
    survey(data, 0);
    survey(data, 2);
    EXPECT_GE(mostConfident(walk(data, 1, 30.0, {}, 0.0)), 0.8);
}

TEST(Places, AStrongMatchTellsMoreThanAWeakOne) {
    BuildingData data = tower(1);
    survey(data, 0);
    Region yard;
    yard.id = RegionId("yard");
    yard.kind = building::RegionKind::Hall;
    yard.polygon.outer = {{0, 10}, {40, 10}, {40, 30}, {0, 30}};
    data.regions.push_back(yard);
    SensorModel model(std::make_shared<WalkingMap>(std::make_shared<const building::Building>(data)), {});
    auto ratio = [&](double strength, std::vector<recognition::LookAlike> others) {
        Look look = model.prepare(placeSeen(0.0, placeName(0, 9), strength, std::move(others)).detection);
        WalkingMap map(std::make_shared<const building::Building>(data));
        return model.ratio(look, 0, map.local({9.0, 1.0}), {0.0F, 100.0F, 0.0F});
    };
    EXPECT_GT(ratio(30.0, {}), 5.0F * ratio(14.0, {}));
    EXPECT_FLOAT_EQ(ratio(1e9, {}), ratio(60.0, {})) << "no figure makes certain";
    EXPECT_GE(ratio(20.0, {{TemplateId(placeName(0, 11)), 19.0}}), ratio(20.0, {}))
        << "a neighbour is no rival";
}

TEST(Places, APlaceWithoutAHeadingCountsWhereverOneLooks) {
    BuildingData data = tower(1);
    survey(data, 0);
    for (Landmark& place : data.landmarks) place.heading.reset();
    auto building = std::make_shared<const building::Building>(data);
    auto map = std::make_shared<WalkingMap>(building);
    SensorModel model(map, {});
    Look look = model.prepare(placeSeen(0.0, placeName(0, 9), 20.0).detection);
    float east = model.ratio(look, 0, map->local({9.0, 1.0}), {0.0F, 100.0F, 0.0F});
    float west = model.ratio(look, 0, map->local({9.0, 1.0}), {180.0F, 100.0F, 0.0F});
    EXPECT_GT(east, 1.0F);
    EXPECT_FLOAT_EQ(east, west);
}

TEST(Places, LookAlikesThatTheMapDoesNotHoldAndBrokenFiguresDoNoHarm) {
    BuildingData data = tower(2);
    survey(data, 0);
    auto localiser = makeBayesLocaliser(std::make_shared<const building::Building>(data));
    localiser->start(0.0, std::nullopt);
    double nan = std::nan("");
    Fix fix = localiser->update(
        1.0,
        std::vector{placeSeen(1.0, "gone", 20.0, {{TemplateId("gone too"), 19.0}}),
                    placeSeen(1.0, placeName(0, 9), nan, {{TemplateId("x"), nan}}),
                    placeSeen(1.0, placeName(0, 9), 20.0, {{TemplateId(placeName(0, 11)), nan}})},
        {});
    EXPECT_TRUE(std::isfinite(fix.confidence));
    EXPECT_LT(fix.confidence, 0.8);
}

} // namespace
