#include "core/recognition/stairs_detector.h"

#include <opencv2/imgproc.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_scenes.h"

namespace farol::recognition {
namespace {

using testing::IsEmpty;

/// Stairs leading up and away in front of a wall.
cv::Mat stairsAt(double distance, int steps, const test::SceneCamera& camera, double width = 1.8,
                 double gain = 1.0) {
    test::DrawnScene scene;
    scene.addFloor(cv::Scalar(120, 125, 130));
    scene.addStairs(-width / 2.0, distance, width, steps, cv::Scalar(150, 160, 170), cv::Scalar(85, 90, 95));
    test::PaintedWall wall(10.0, 6.0, cv::Scalar(200, 210, 215));
    scene.addWall(wall, -5.0, distance + 0.29 * steps);
    return scene.render(camera, 5, 2.5, gain);
}

test::SceneCamera ahead(double yaw = 0.0, double roll = 0.0) {
    test::SceneCamera camera;
    camera.yaw = yaw;
    camera.roll = roll;
    camera.pitch = 5.0;
    return camera;
}

TEST(Stairs, AreFoundWithFewAndManySteps) {
    for (int steps : {7, 10, 15}) {
        for (double distance : {2.0, 3.0, 4.5}) {
            auto camera = ahead();
            auto found = detectStairs(stairsAt(distance, steps, camera)).detections;
            ASSERT_EQ(found.size(), 1U) << steps << " steps at " << distance << " m";
            EXPECT_EQ(found[0].kind, Kind::Stairs);
            EXPECT_GE(found[0].score, 0.5);
            EXPECT_LE(found[0].score, 1.0);
            EXPECT_EQ(found[0].image, (ImageSize{640, 480}));
            ImagePoint foot = camera.project({0.0, 0.17, distance}),
                       head = camera.project({0.0, 0.17 * steps, distance + 0.29 * steps});
            ImageBox box = boundingBox(found[0].quad);
            EXPECT_LT(box.y, foot.y) << "the box stands on the flight";
            EXPECT_GT(box.y + box.height, head.y);
            EXPECT_GT(box.height, 0.4 * (foot.y - std::max(head.y, 0.0)));
        }
    }
}

TEST(Stairs, AreFoundAskew) {
    for (double yaw : {-12.0, 12.0})
        EXPECT_EQ(detectStairs(stairsAt(3.0, 10, ahead(yaw))).detections.size(), 1U) << yaw;
    for (double roll : {-5.0, 5.0})
        EXPECT_EQ(detectStairs(stairsAt(3.0, 10, ahead(0.0, roll))).detections.size(), 1U) << roll;
    EXPECT_EQ(detectStairs(stairsAt(3.0, 10, ahead(), 1.0)).detections.size(), 1U) << "narrow ones";
}

TEST(Stairs, AKerbOrTwoAreNoFlight) {
    for (int steps : {0, 1, 2})
        EXPECT_THAT(detectStairs(stairsAt(3.0, steps, ahead())).detections, IsEmpty()) << steps;
}

TEST(Stairs, ParallelLinesThatAreNoSteps) {
    for (double tile : {0.3, 0.5}) {
        test::DrawnScene floor;
        floor.addFloor(cv::Scalar(150, 155, 160), tile, cv::Scalar(60, 60, 60));
        floor.addWall(test::PaintedWall(10.0, 3.0, cv::Scalar(200, 210, 215)), -5.0, 6.0);
        for (double pitch : {8.0, 25.0}) {
            auto camera = ahead();
            camera.pitch = pitch;
            auto result = detectStairs(floor.render(camera));
            EXPECT_THAT(result.detections, IsEmpty()) << "tiles of " << tile << " m, pitch " << pitch;
        }
    }
    auto onWall = [&](auto paint, double pitch) {
        test::PaintedWall wall(10.0, 3.0, cv::Scalar(200, 210, 215));
        paint(wall);
        test::DrawnScene scene;
        scene.addWall(wall, -5.0, 2.5);
        scene.addFloor(cv::Scalar(120, 130, 140));
        auto camera = ahead();
        camera.pitch = pitch;
        return detectStairs(scene.render(camera)).detections;
    };
    for (double pitch : {0.0, 10.0}) {
        EXPECT_THAT(onWall([](auto& w) { test::paintBlinds(w, 4.2, 0.3, 1.6, 1.8, 16); }, pitch), IsEmpty())
            << "blinds";
        EXPECT_THAT(onWall([](auto& w) { test::paintShelves(w, 4.2, 1.6, 2.1, 7, 4); }, pitch), IsEmpty())
            << "shelves";
        EXPECT_THAT(onWall([](auto& w) { test::paintLockers(w, 4.2, 6, cv::Scalar(140, 120, 90)); }, pitch),
                    IsEmpty())
            << "lockers";
        EXPECT_THAT(onWall([](auto&) {}, pitch), IsEmpty()) << "a bare wall";
    }
}

TEST(Stairs, ARejectedRowSaysWhy) {
    test::PaintedWall wall(10.0, 3.0, cv::Scalar(200, 210, 215));
    test::paintBlinds(wall, 4.0, 0.2, 2.0, 2.0, 14);
    test::DrawnScene scene;
    scene.addWall(wall, -5.0, 2.5);
    auto result = detectStairs(scene.render(ahead()));
    ASSERT_FALSE(result.rejections.empty());
    for (const Rejection& r : result.rejections) {
        EXPECT_EQ(r.detector, "stairs");
        EXPECT_EQ(r.kind, Kind::Stairs);
        EXPECT_FALSE(r.reason.empty());
    }
}

TEST(Stairs, StrangePicturesAreAnsweredWithNothing) {
    cv::Mat noise(480, 640, CV_8UC3);
    cv::RNG(4).fill(noise, cv::RNG::UNIFORM, 0, 256);
    for (const cv::Mat& picture :
         {cv::Mat(), cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(5)), cv::Mat(2, 900, CV_8U, cv::Scalar(5)),
          cv::Mat(49, 4000, CV_8UC3, cv::Scalar::all(9)), cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(128)),
          cv::Mat(480, 640, CV_32F, cv::Scalar(1)), noise, stairsAt(3.0, 10, ahead(), 1.8, 0.01)})
        EXPECT_THAT(detectStairs(picture).detections, IsEmpty());
    cv::Mat grey, deep;
    cv::cvtColor(stairsAt(3.0, 10, ahead()), grey, cv::COLOR_BGR2GRAY);
    grey.convertTo(deep, CV_16U, 257.0);
    EXPECT_EQ(detectStairs(grey).detections.size(), 1U);
    EXPECT_EQ(detectStairs(deep).detections.size(), 1U);
}

TEST(StairsOptions, OutOfRangeIsRefused) {
    EXPECT_TRUE(StairsDetectorOptions{}.check());
    StairsDetectorOptions edges, width, score;
    edges.minEdges = 1;
    width.minWidthShare = 0.0;
    score.minScore = 2.0;
    EXPECT_FALSE(edges.check());
    EXPECT_FALSE(width.check());
    EXPECT_FALSE(score.check());
}

} // namespace
} // namespace farol::recognition
