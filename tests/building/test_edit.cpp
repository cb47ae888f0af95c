#include "core/building/edit.h"

#include <gtest/gtest.h>
#include <limits>

namespace {

using namespace farol;
using namespace farol::building;

Region room(const char* id, double left, double right) {
    Region region;
    region.id = RegionId(id);
    region.polygon.outer = {{left, 0}, {right, 0}, {right, 4}, {left, 4}};
    return region;
}

/// Two rooms side by side with a door and a landmark in the left one.
Building house() {
    BuildingData data;
    data.levels = {{0.0, "Ground", "0", {}, {}, {}}};
    data.regions = {room("a", 0, 5), room("b", 5, 10)};
    Access door;
    door.id = AccessId("d");
    door.regionA = RegionId("a");
    door.regionB = RegionId("b");
    door.line = {{5, 1}, {5, 2}};
    data.accesses = {door};
    Landmark sign;
    sign.id = LandmarkId("L2");
    sign.region = RegionId("a");
    sign.position = {1, 1};
    data.landmarks = {sign};
    return Building(std::move(data));
}

Building after(const Building& building, const Edit& edit) {
    BuildingData data = building.data();
    apply(data, edit);
    return Building(std::move(data));
}

TEST(Edit, AMovedLandmarkIsInTheRegionWhereItStands) {
    const Building before = house();
    const auto edit = change(before, 0, moved(before, before.landmarks()[0], {7, 2}));
    ASSERT_TRUE(edit.ok());
    const Building now = after(before, *edit);
    EXPECT_EQ(now.landmarks()[0].region, RegionId("b"));
    const Building back = after(now, reversed(*edit));
    EXPECT_EQ(back.landmarks()[0].region, RegionId("a"));
    EXPECT_EQ(back.landmarks()[0].position, (Point2{1, 1}));
}

TEST(Edit, OutsideEveryRegionALandmarkHasNone) {
    const Building before = house();
    EXPECT_TRUE(moved(before, before.landmarks()[0], {50, 50}).region.empty());
}

TEST(Edit, ANewLandmarkTakesAnIdOfItsOwn) {
    const Building before = house(); // "L2" is what a count would give
    const Landmark landmark = newLandmark(before, Kind::Sign, {6, 1}, 0.0);
    EXPECT_EQ(landmark.id, LandmarkId("L3"));
    EXPECT_EQ(landmark.region, RegionId("b"));
    const auto edit = insertion(before, landmark);
    ASSERT_TRUE(edit.ok());
    const Building now = after(before, *edit);
    ASSERT_EQ(now.landmarks().size(), 2U);
    EXPECT_EQ(after(now, reversed(*edit)).landmarks().size(), 1U);
    EXPECT_FALSE(insertion(now, landmark).ok()); // twice
}

TEST(Edit, ANewDoorLiesInTheWallAndJoinsBothRooms) {
    const Building before = house();
    const Access door = newAccess(before, AccessKind::Door, {5.2, 3}, 0.0);
    ASSERT_EQ(door.line.size(), 2U);
    EXPECT_DOUBLE_EQ(door.line[0].x, 5.0);
    EXPECT_NEAR(distance(door.line[0], door.line[1]), 0.9, 1e-9);
    EXPECT_NE(door.regionA, door.regionB);
    EXPECT_FALSE(door.regionA.empty());
    EXPECT_FALSE(door.regionB.empty());
}

TEST(Edit, ADoorFarFromEverythingJoinsNothing) {
    const Building before = house();
    const Access door = newAccess(before, AccessKind::Door, {100, 100}, 0.0);
    EXPECT_EQ(door.line.size(), 1U);
    EXPECT_TRUE(door.regionA.empty());
    EXPECT_TRUE(door.regionB.empty());
}

TEST(Edit, AMovedDoorJoinsWhatLiesBesideItNow) {
    const Building before = house();
    const Access outside = moved(before, before.accesses()[0], {5, 0}); // on the outer wall of b
    EXPECT_TRUE(outside.regionA.empty() || outside.regionB.empty());
    const Access along = moved(before, before.accesses()[0], {0, 1});
    EXPECT_NE(along.regionA, along.regionB);
    EXPECT_FALSE(along.regionA.empty());
}

TEST(Edit, StairsKeepTheirSides) {
    const Building before = house();
    Access stairs = before.accesses()[0];
    stairs.kind = AccessKind::Stairs;
    EXPECT_EQ(moved(before, stairs, {40, 0}).regionB, RegionId("b"));
}

TEST(Edit, WhatWasTakenOutComesBackInItsPlace) {
    const Building before = house();
    const Edit edit = removalOfAccess(before, 0);
    const Building now = after(before, edit);
    EXPECT_TRUE(now.accesses().empty());
    EXPECT_TRUE(now.neighboursOf(0).empty());
    EXPECT_EQ(after(now, reversed(edit)).accesses()[0].id, AccessId("d"));
    EXPECT_TRUE(after(before, removalOfLandmark(before, 0)).landmarks().empty());
}

TEST(Edit, SenselessChangesAreRefused) {
    const Building before = house();
    Access door = before.accesses()[0];
    door.regionB = door.regionA;
    EXPECT_EQ(change(before, 0, door).error().code, ErrorCode::InvalidArgument);
    door = before.accesses()[0];
    door.widthM = -1.0;
    EXPECT_FALSE(change(before, 0, door).ok());
    door.widthM.reset();
    door.line.clear();
    EXPECT_FALSE(change(before, 0, door).ok());
    Landmark sign = before.landmarks()[0];
    sign.position.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(change(before, 0, sign).ok());
    EXPECT_EQ(change(before, 5, before.landmarks()[0]).error().code, ErrorCode::NotFound);
    Region region = before.regions()[0];
    region.id = RegionId("b");
    EXPECT_EQ(change(before, 0, region).error().code, ErrorCode::Conflict);
    region = before.regions()[0];
    region.polygon.outer.clear();
    EXPECT_FALSE(change(before, 0, region).ok());
}

} // namespace
