#include "core/recognition/visual_motion.h"
#include "core/recognition/whole_turn.h"
#include "tests/recognition/corridor_camera.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <gtest/gtest.h>

namespace farol::recognition::test {
namespace {

constexpr double kFocal = 300.0;
const cv::Size kSize(320, 240);

/// Turns on the spot before a cylinder of boards: edges up and down, no corner anywhere.
cv::Mat boards(double yaw, std::uint64_t seed = 4) {
    cv::RNG rng(seed);
    cv::Mat round(1, 720, CV_8U);
    rng.fill(round, cv::RNG::UNIFORM, 60, 200);
    cv::Mat picture(kSize, CV_8U);
    for (int x = 0; x < picture.cols; ++x) {
        double azimuth = yaw - std::atan((x - 0.5 * (picture.cols - 1)) / kFocal);
        double at = azimuth * 180.0 / CV_PI * 2.0;
        at -= 720.0 * std::floor(at / 720.0);
        int left = static_cast<int>(at) % 720;
        double share = at - std::floor(at), a = round.at<unsigned char>(left),
               b = round.at<unsigned char>((left + 1) % 720);
        picture.col(x).setTo(static_cast<unsigned char>(a + share * (b - a)));
    }
    return picture;
}

double degrees(double radians) {
    return radians * 180.0 / CV_PI;
}

TEST(WholeTurn, BoardsWithoutACornerTellTheTurn) {
    PictureCompass compass;
    for (double turn : {0.0, 1.0, -4.0, 9.5, -15.0}) {
        SCOPED_TRACE(turn);
        auto told = compass.turn(boards(0.3), boards(0.3 + turn * CV_PI / 180.0), kFocal);
        ASSERT_TRUE(told);
        EXPECT_NEAR(degrees(told->yaw), turn, 0.3);
        EXPECT_LT(degrees(told->spread), 0.5);
    }
}

TEST(WholeTurn, OtherBoardsBlankWallsAndOtherSizesTellNothing) {
    PictureCompass compass;
    EXPECT_FALSE(compass.turn(boards(0.3, 4), boards(0.3, 5), kFocal)) << "cut to another view";
    cv::Mat blank(kSize, CV_8U, cv::Scalar(128)), grain = blank.clone();
    cv::RNG rng(9);
    rng.fill(grain, cv::RNG::NORMAL, 128.0, 3.0);
    EXPECT_FALSE(compass.turn(blank, blank, kFocal));
    EXPECT_FALSE(compass.turn(grain, grain, kFocal)) << "the grain of one and the same blank picture";
    EXPECT_FALSE(compass.turn(boards(0.3), blank, kFocal));
    EXPECT_FALSE(compass.turn(boards(0.3), boards(0.3)(cv::Rect(0, 0, 200, 240)), kFocal));
    EXPECT_FALSE(compass.turn({}, {}, kFocal));
}

TEST(WholeTurn, StripesThatRepeatThemselvesTellNothing) {
    auto fence = [](int by) {
        cv::Mat picture(kSize, CV_8U);
        for (int x = 0; x < picture.cols; ++x) picture.col(x).setTo((x + by) / 10 % 2 == 0 ? 60 : 190);
        return picture;
    };
    EXPECT_FALSE(PictureCompass().turn(fence(0), fence(7), kFocal)) << "any number of boards further fits";
}

TEST(VisualMotion, QuickTurnsAreToldAtFewPicturesASecond) {
    constexpr double kSeconds = 0.125, kRate = 95.0; // degrees a second, smeared by the shutter
    VisualMotion motion;
    double told = 0.0, truth = 0.0;
    int silent = 0, walking = 0;
    for (int i = 0; i <= 24; ++i) {
        CameraPose pose{10.0};
        pose.yaw = kRate * kSeconds * i * CV_PI / 180.0;
        cv::Mat image = corridorView(pose);
        cv::blur(image, image, {11, 1});
        Motion seen = motion.observe(image, kSeconds * i);
        if (i == 0) continue;
        if (!seen.turn) {
            ++silent;
            continue;
        }
        told += degrees(seen.turn->value);
        truth += kRate * kSeconds;
        walking += seen.walking.value_or(false);
    }
    EXPECT_LE(silent, 4) << "of 24";
    EXPECT_NEAR(told, truth, 0.02 * truth);
    EXPECT_LE(walking, 2) << "a turn on the spot is no walk";
}

} // namespace
} // namespace farol::recognition::test
