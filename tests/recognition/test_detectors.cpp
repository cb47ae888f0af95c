#include "core/recognition/rectangle_detector.h"

#include <opencv2/imgproc.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drawn_pictures.h"

namespace farol::recognition {
namespace {

using testing::IsEmpty;

TEST(Rectangles, StrangePicturesAreAnsweredWithNothing) {
    for (const cv::Mat& picture :
         {cv::Mat(), cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(5)), cv::Mat(2, 900, CV_8U, cv::Scalar(5)),
          cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(128)), cv::Mat(480, 640, CV_32F, cv::Scalar(1))})
        EXPECT_THAT(detectRectangles(picture).detections, IsEmpty());
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

TEST(RectangleOptions, OutOfRangeIsRefused) {
    RectangleDetectorOptions rectangle;
    EXPECT_TRUE(rectangle.check());
    rectangle.minAreaShare = 0.0;
    EXPECT_FALSE(rectangle.check());
}

} // namespace
} // namespace farol::recognition
