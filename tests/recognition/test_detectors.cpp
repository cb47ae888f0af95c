#include "core/recognition/door_detector.h"
#include "core/recognition/rectangle_detector.h"

#include <opencv2/imgproc.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_pictures.h"

namespace farol::recognition {
namespace {

using testing::IsEmpty;

/// A wall with a floor, and a dark door leaf with its frame standing on the floor.
cv::Mat wallWithDoor(const cv::Rect& door, cv::Scalar leaf = cv::Scalar::all(50)) {
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar(180, 200, 210));
    cv::rectangle(picture, cv::Rect(0, 450, 640, 30), cv::Scalar(120, 130, 130), cv::FILLED);
    if (door.area() > 0) {
        cv::rectangle(picture, door, cv::Scalar::all(90), cv::FILLED);
        cv::rectangle(picture, cv::Rect(door.x + 6, door.y + 6, door.width - 12, door.height - 6), leaf,
                      cv::FILLED);
        cv::circle(picture, {door.x + door.width - 20, door.y + door.height / 2}, 5, cv::Scalar::all(200),
                   cv::FILLED);
    }
    cv::Mat noise(picture.size(), CV_16SC3);
    cv::RNG(5).fill(noise, cv::RNG::NORMAL, 0.0, 3.0);
    cv::add(picture, noise, picture, cv::noArray(), CV_8UC3);
    return picture;
}

TEST(Doors, AFrontalDoorIsFoundWhereItStands) {
    for (const cv::Rect& door :
         {cv::Rect(240, 90, 160, 362), cv::Rect(60, 60, 190, 392), cv::Rect(430, 200, 110, 252)}) {
        auto found = detectDoors(wallWithDoor(door)).detections;
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].kind, Kind::Door);
        ImageBox truth{static_cast<double>(door.x), static_cast<double>(door.y),
                       static_cast<double>(door.width), static_cast<double>(door.height)};
        EXPECT_GT(overlap(boundingBox(found[0].quad), truth), 0.8);
        EXPECT_GE(found[0].score, 0.55);
        EXPECT_LE(found[0].score, 1.0);
    }
}

TEST(Doors, WhatOnlyLooksLikeADoorIsNone) {
    EXPECT_THAT(detectDoors(wallWithDoor({})).detections, IsEmpty()) << "a bare wall";
    EXPECT_THAT(detectDoors(wallWithDoor({240, 250, 100, 200})).detections, IsEmpty())
        << "too small to be near";
    EXPECT_THAT(detectDoors(wallWithDoor({150, 60, 360, 392})).detections, IsEmpty()) << "too wide";
    cv::Mat board = wallWithDoor({});
    cv::rectangle(board, cv::Rect(240, 40, 130, 260), cv::Scalar::all(60), cv::FILLED);
    EXPECT_THAT(detectDoors(board).detections, IsEmpty()) << "a board does not reach the floor";
    cv::Mat pillar = wallWithDoor({});
    cv::rectangle(pillar, cv::Rect(240, 0, 160, 455), cv::Scalar::all(90), cv::FILLED);
    EXPECT_THAT(detectDoors(pillar).detections, IsEmpty()) << "a pillar has no lintel";
    cv::Mat shelf = wallWithDoor({240, 90, 160, 362}, cv::Scalar::all(220));
    cv::Mat goods;
    cv::resize(test::poster(3), goods, cv::Size(148, 350));
    goods.copyTo(shelf(cv::Rect(246, 98, 148, 350)));
    for (int y = 100; y < 440; y += 14) cv::line(shelf, {246, y}, {394, y}, cv::Scalar::all(y % 3 * 90), 3);
    for (int x = 250; x < 390; x += 12) cv::line(shelf, {x, 98}, {x, 448}, cv::Scalar::all(x % 2 * 200), 2);
    EXPECT_THAT(detectDoors(shelf).detections, IsEmpty()) << "a shelf is full of things";
}

TEST(Doors, StrangePicturesAreAnsweredWithNothing) {
    for (const cv::Mat& picture :
         {cv::Mat(), cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(5)), cv::Mat(2, 900, CV_8U, cv::Scalar(5)),
          cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(128)), cv::Mat(480, 640, CV_32F, cv::Scalar(1))}) {
        EXPECT_THAT(detectDoors(picture).detections, IsEmpty());
        EXPECT_THAT(detectRectangles(picture).detections, IsEmpty());
    }
    cv::Mat grey;
    cv::cvtColor(wallWithDoor({240, 90, 160, 362}), grey, cv::COLOR_BGR2GRAY);
    EXPECT_EQ(detectDoors(grey).detections.size(), 1U) << "a grey camera sees doors too";
}

TEST(Rectangles, BoardsAreFoundOnceEachWithTheirCorners) {
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(190));
    Quad first = quadOf({80, 100, 160, 110});
    Quad second{ImagePoint{360, 120}, {520, 150}, {520, 300}, {360, 320}};
    test::hang(picture, cv::Mat(300, 400, CV_8UC3, cv::Scalar(60, 40, 30)), first);
    test::hang(picture, cv::Mat(300, 400, CV_8UC3, cv::Scalar::all(245)), second);
    cv::rectangle(picture, cv::Rect(380, 150, 110, 130), cv::Scalar::all(230),
                  2); // a frame inside, nearly as large
    auto found = detectRectangles(picture).detections;
    ASSERT_GE(found.size(), 2U);
    for (const Quad& truth : {first, second}) {
        auto near = std::count_if(found.begin(), found.end(),
                                  [&](const Detection& d) { return test::sharedArea(d.quad, truth) > 0.85; });
        EXPECT_EQ(near, 1);
    }
    for (std::size_t i = 1; i < found.size(); ++i)
        EXPECT_GE(found[i - 1].score, found[i].score) << "best first";
    for (const Detection& d : found) {
        EXPECT_EQ(d.kind, Kind::Rectangle);
        EXPECT_LT(d.quad[0].x, d.quad[1].x) << "clockwise from the top left";
        EXPECT_LT(d.quad[0].y, d.quad[3].y);
    }
}

TEST(Rectangles, CirclesTrianglesAndDiamondsAreNone) {
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar::all(190));
    cv::circle(picture, {150, 150}, 80, cv::Scalar::all(30), cv::FILLED);
    cv::fillPoly(picture, std::vector<cv::Point>{{350, 80}, {450, 220}, {300, 220}}, cv::Scalar::all(30));
    cv::fillPoly(picture, std::vector<cv::Point>{{500, 300}, {580, 380}, {500, 460}, {420, 380}},
                 cv::Scalar::all(30));
    EXPECT_THAT(detectRectangles(picture).detections, IsEmpty());
}

TEST(DetectorOptions, OutOfRangeIsRefused) {
    DoorDetectorOptions door;
    EXPECT_TRUE(door.check());
    door.maxAspect = 1.0;
    EXPECT_FALSE(door.check());
    RectangleDetectorOptions rectangle;
    EXPECT_TRUE(rectangle.check());
    rectangle.minAreaShare = 0.0;
    EXPECT_FALSE(rectangle.check());
}

} // namespace
} // namespace farol::recognition
