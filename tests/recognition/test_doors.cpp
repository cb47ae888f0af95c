#include "core/recognition/boosted_trees.h"
#include "core/recognition/door_detector.h"

#include <opencv2/imgproc.hpp>

#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_scenes.h"

namespace farol::recognition {
namespace {

using testing::IsEmpty;

constexpr double kWallX = -4.5, kDoorX = 4.05; // the door's middle is straight ahead of x = 0

/// A painted wall across the view with a floor and a ceiling.
cv::Mat roomWith(const std::function<void(test::PaintedWall&)>& paint, const test::SceneCamera& camera,
                 double distance, std::uint64_t seed = 3, double gain = 1.0) {
    test::PaintedWall wall(9.0, 2.7, cv::Scalar(190, 205, 215));
    wall.skirting(cv::Scalar(90, 100, 110));
    paint(wall);
    wall.roughen(seed, 1.5);
    test::DrawnScene scene;
    scene.addWall(wall, kWallX, distance);
    scene.addFloor(cv::Scalar(120, 130, 140));
    scene.addCeiling(cv::Scalar::all(235), 2.7);
    return scene.render(camera, seed, 2.5, gain);
}

/// Stands aside and turns towards the door.
test::SceneCamera turned(double degrees, double distance) {
    test::SceneCamera camera;
    camera.x = -std::tan(degrees * kPi / 180.0) * distance;
    camera.yaw = degrees;
    camera.focal = 430.0;
    camera.pitch = 6.0;
    return camera;
}

std::vector<test::DoorLook> looks() {
    test::DoorLook dark, wooden, pale;
    wooden.leaf = {70, 110, 160};
    wooden.window = true;
    wooden.handleLeft = true;
    pale.leaf = {205, 210, 210};
    pale.trim = {90, 110, 130};
    pale.plate = true;
    return {dark, wooden, pale};
}

TEST(Doors, AreFoundFromAheadAndFromBothSides) {
    int asked = 0, found = 0, others = 0;
    for (const test::DoorLook& look : looks()) {
        for (double degrees : {-30.0, -15.0, 0.0, 15.0, 30.0}) {
            for (double distance : {2.4, 3.2}) {
                auto camera = turned(degrees, distance);
                auto doors = detectDoors(roomWith([&](auto& wall) { test::paintDoor(wall, kDoorX, look); },
                                                  camera, distance))
                                 .detections;
                ImageBox truth = boundingBox(test::doorOutline(camera, kWallX, distance, kDoorX, look));
                ++asked;
                bool hit = false;
                for (const Detection& d : doors) {
                    EXPECT_EQ(d.kind, Kind::Door);
                    EXPECT_GT(d.score, 0.5);
                    EXPECT_LE(d.score, 1.0);
                    bool right = overlap(boundingBox(d.quad), truth) > 0.6;
                    hit = hit || right;
                    others += right ? 0 : 1;
                }
                found += hit ? 1 : 0;
            }
        }
    }
    EXPECT_GE(found, asked * 8 / 10) << "of " << asked;
    EXPECT_EQ(others, 0);
}

TEST(Doors, TooNearForTheLintelOrTheFootAreStillFound) {
    for (double pitch : {-14.0, 20.0}) { // only the upper part, only the lower part
        test::SceneCamera camera;
        camera.focal = 430.0;
        camera.pitch = pitch;
        camera.size = {480, 640};
        test::DoorLook look;
        auto picture = roomWith([&](auto& wall) { test::paintDoor(wall, kDoorX, look); }, camera, 1.5);
        auto doors = detectDoors(picture).detections;
        ASSERT_EQ(doors.size(), 1U) << "pitch " << pitch;
        EXPECT_GT(doors[0].quad[1].x - doors[0].quad[0].x, 150.0);
    }
}

TEST(Doors, WhatOnlyLooksLikeADoorIsNone) {
    struct Thing {
        const char* name;
        std::function<void(test::PaintedWall&)> paint;
    };
    const Thing things[] = {
        {"a bare wall", [](auto&) {}},
        {"a poster", [](auto& w) { test::paintPoster(w, 4.0, 0.7, 0.9, 1.3, 5); }},
        {"a white board", [](auto& w) { w.fill(3.8, 0.9, 1.2, 1.0, cv::Scalar::all(245)); }},
        {"a cupboard", [](auto& w) { test::paintCupboard(w, 3.8, 1.4, 1.9, cv::Scalar(150, 170, 190), 3); }},
        {"a refrigerator", [](auto& w) { test::paintRefrigerator(w, 4.1, 1.7, cv::Scalar::all(235), 0.6); }},
        {"shelves", [](auto& w) { test::paintShelves(w, 4.0, 1.0, 2.0, 6, 9); }},
        {"lockers", [](auto& w) { test::paintLockers(w, 3.9, 4, cv::Scalar(140, 120, 90)); }},
        {"a pillar", [](auto& w) { w.fill(4.2, 0.0, 0.7, 2.7, cv::Scalar::all(110)); }},
        {"blinds", [](auto& w) { test::paintBlinds(w, 3.9, 0.8, 1.2, 1.5, 20); }},
    };
    int wrong = 0;
    for (const Thing& thing : things) {
        for (double degrees : {-20.0, 0.0, 20.0}) {
            auto result = detectDoors(roomWith(thing.paint, turned(degrees, 2.6), 2.6));
            wrong += result.detections.empty() ? 0 : 1;
            if (degrees == 0.0) {
                EXPECT_THAT(result.detections, IsEmpty()) << thing.name;
            }
        }
    }
    EXPECT_LE(wrong, 1) << "of 27 views";
}

TEST(Doors, ARejectedCandidateSaysWhy) {
    auto result =
        detectDoors(roomWith([](auto& w) { test::paintRefrigerator(w, 4.1, 1.7, cv::Scalar::all(235), 0.6); },
                             turned(0.0, 2.6), 2.6));
    EXPECT_THAT(result.detections, IsEmpty());
    ASSERT_FALSE(result.rejections.empty());
    for (const Rejection& r : result.rejections) {
        EXPECT_EQ(r.detector, "doors");
        EXPECT_FALSE(r.reason.empty());
    }
    EXPECT_LE(result.rejections.size(), 20U);
}

TEST(Doors, AWholeDoorTellsHowFarItIs) {
    DoorDetectorOptions options;
    options.focalPx = 430.0;
    for (double distance : {2.6, 3.4}) {
        test::DoorLook look;
        auto camera = turned(0.0, distance);
        auto picture = roomWith([&](auto& wall) { test::paintDoor(wall, kDoorX, look); }, camera, distance);
        auto doors = detectDoors(picture, options).detections;
        ASSERT_EQ(doors.size(), 1U);
        ASSERT_TRUE(doors[0].rangeM);
        EXPECT_NEAR(*doors[0].rangeM, distance, 0.12 * distance);
        ASSERT_TRUE(doors[0].bearing);
        EXPECT_NEAR(doors[0].bearing->value, 0.0, 0.05);
        RangeEstimate range = doorRange(doors[0].quad, options);
        EXPECT_GT(range.spread, 0.04 * range.metres);
        EXPECT_LT(range.spread, 0.2 * range.metres);
        EXPECT_FALSE(detectDoors(picture).detections.at(0).rangeM) << "an unknown camera tells no range";
    }
    EXPECT_EQ(doorRange(Quad{}, options).metres, 0.0);
}

TEST(Doors, DarknessAndNoiseAreNoDoors) {
    auto dark =
        roomWith([&](auto& wall) { test::paintDoor(wall, kDoorX, {}); }, turned(0.0, 2.6), 2.6, 3, 0.02);
    EXPECT_THAT(detectDoors(dark).detections, IsEmpty());
    cv::Mat noise(480, 640, CV_8UC3);
    cv::RNG(4).fill(noise, cv::RNG::UNIFORM, 0, 256);
    EXPECT_THAT(detectDoors(noise).detections, IsEmpty());
}

TEST(Doors, StrangePicturesAreAnsweredWithNothing) {
    for (const cv::Mat& picture :
         {cv::Mat(), cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(5)), cv::Mat(2, 900, CV_8U, cv::Scalar(5)),
          cv::Mat(33, 4000, CV_8UC3, cv::Scalar::all(9)), cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(128)),
          cv::Mat(480, 640, CV_32F, cv::Scalar(1))})
        EXPECT_THAT(detectDoors(picture).detections, IsEmpty());
    test::DoorLook look;
    auto picture = roomWith([&](auto& wall) { test::paintDoor(wall, kDoorX, look); }, turned(0.0, 2.6), 2.6);
    cv::Mat grey, deep, large;
    cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    picture.convertTo(deep, CV_16U, 257.0);
    cv::resize(picture, large, cv::Size(), 4.0, 4.0);
    EXPECT_EQ(detectDoors(grey).detections.size(), 1U) << "a grey camera sees doors too";
    EXPECT_EQ(detectDoors(deep).detections.size(), 1U);
    EXPECT_EQ(detectDoors(large).detections.size(), 1U);
}

TEST(Doors, TheSamePictureGetsTheSameAnswer) {
    auto scene = test::randomDoorScene(12);
    auto a = detectDoors(scene.picture), b = detectDoors(scene.picture.clone());
    ASSERT_EQ(a.detections.size(), b.detections.size());
    for (std::size_t i = 0; i < a.detections.size(); ++i)
        EXPECT_EQ(a.detections[i].score, b.detections[i].score);
    EXPECT_EQ(a.rejections.size(), b.rejections.size());
}

TEST(DoorOptions, OutOfRangeIsRefused) {
    EXPECT_TRUE(DoorDetectorOptions{}.check());
    DoorDetectorOptions aspect, focal, leaf;
    aspect.maxAspect = 1.0;
    focal.focalPx = -1.0;
    leaf.leafHeightM = 0.0;
    EXPECT_FALSE(aspect.check());
    EXPECT_FALSE(focal.check());
    EXPECT_FALSE(leaf.check());
}

TEST(BoostedTrees, DamagedTextIsRefusedAndSoundTextIsKept) {
    const std::string sound = "farol-trees 1 2 2 -0.5\n3 1 0.25 1 2 -1 -1.5 -1 2\n1 -1 0.125\n";
    auto trees = BoostedTrees::parse(sound, 2);
    ASSERT_TRUE(trees) << trees.error().text();
    EXPECT_EQ(trees->text(2), sound);
    const float low[] = {0.0F, 0.0F}, high[] = {0.0F, 1.0F};
    EXPECT_LT(trees->probability(low), 0.2);
    EXPECT_GT(trees->probability(high), 0.8);
    EXPECT_FALSE(BoostedTrees::parse(sound, 3)) << "made for other cues";
    for (const char* text :
         {"", "trees", "farol-trees 2 2 1 0\n1 -1 0\n", "farol-trees 1 2 1 0\n", "farol-trees 1 2 1 0\n0\n",
          "farol-trees 1 2 1 0\n3 1 0.5 0 2 -1 1 -1 1\n", "farol-trees 1 2 1 0\n3 1 0.5 1 9 -1 1 -1 1\n",
          "farol-trees 1 2 1 0\n3 7 0.5 1 2 -1 1 -1 1\n", "farol-trees 1 2 99999999 0\n",
          "farol-trees 1 2 1 0\n3 1 0.5"})
        EXPECT_FALSE(BoostedTrees::parse(text, 2)) << text;
}

} // namespace
} // namespace farol::recognition
