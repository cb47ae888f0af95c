#include "core/localisation/scene_context.h"

#include <opencv2/imgproc.hpp>

#include <gtest/gtest.h>

using namespace farol::localisation;

namespace {

/// A wall of one colour with a door of another.
cv::Mat view(const cv::Scalar& wall, const cv::Scalar& door, double doorShare = 0.3) {
    cv::Mat image(240, 320, CV_8UC3, wall);
    int width = static_cast<int>(320 * doorShare);
    cv::rectangle(image, cv::Rect(40, 40, width, 200), door, cv::FILLED);
    return image;
}

const cv::Scalar kCream(190, 225, 240), kBrown(40, 80, 130), kBlue(200, 90, 30), kGreen(60, 160, 60);

TEST(SceneContext, TheFirstFrameIsSceneZero) {
    SceneContext scenes;
    EXPECT_EQ(scenes.observe(view(kCream, kBrown)), 0);
    EXPECT_DOUBLE_EQ(scenes.correlationToPrevious(), 1.0);
    EXPECT_DOUBLE_EQ(scenes.correlationToFirst(), 1.0);
}

TEST(SceneContext, FramesThatLookAlikeStayInTheScene) {
    SceneContext scenes;
    scenes.observe(view(kCream, kBrown));
    EXPECT_EQ(scenes.observe(view(kCream, kBrown, 0.33)), 0);
    EXPECT_GT(scenes.correlationToPrevious(), 0.9);
}

TEST(SceneContext, AnotherWallIsAnotherScene) {
    SceneContext scenes;
    scenes.observe(view(kCream, kBrown));
    EXPECT_EQ(scenes.observe(view(kBlue, kGreen)), 1);
    EXPECT_EQ(scenes.observe(view(kBlue, kGreen)), 1);
    EXPECT_EQ(scenes.observe(view(kCream, kBrown)), 2);
}

TEST(SceneContext, ASlowPanEndsTheSceneThoughEachFrameIsLikeTheOneBefore) {
    SceneContext scenes;
    int scene = 0;
    double leastToPrevious = 1.0;
    cv::Mat walls(240, 1000, CV_8UC3, kCream); // a cream wall, then a blue one
    cv::rectangle(walls, cv::Rect(400, 0, 600, 240), kBlue, cv::FILLED);
    for (int i = 0; i <= 40; ++i) {
        scene = scenes.observe(walls(cv::Rect(16 * i, 0, 320, 240)));
        leastToPrevious = std::min(leastToPrevious, scenes.correlationToPrevious());
    }
    EXPECT_GT(leastToPrevious, SceneOptions{}.minCorrelationToPrevious);
    EXPECT_GE(scene, 1);
}

TEST(SceneContext, OddPicturesAreSurvived) {
    SceneContext scenes;
    EXPECT_EQ(scenes.observe(cv::Mat()), 0);
    EXPECT_EQ(scenes.observe(cv::Mat(1, 1, CV_8UC3, kCream)), 0);
    EXPECT_GE(scenes.observe(cv::Mat(240, 320, CV_8UC1, cv::Scalar(0))), 0);
    int scene = scenes.observe(cv::Mat(240, 320, CV_8UC4, cv::Scalar(1, 2, 3, 255)));
    EXPECT_EQ(scenes.observe(cv::Mat()), scene);
}

TEST(SceneContext, TheHistogramIsAShareOfThePicture) {
    cv::Mat histogram = sceneHistogram(view(kCream, kBrown), {});
    EXPECT_EQ(histogram.type(), CV_32F);
    EXPECT_EQ(histogram.total(), 512U);
    EXPECT_NEAR(cv::sum(histogram)[0], 1.0, 1e-5);
}

TEST(SceneContext, OptionsOutOfRangeAreRefused) {
    EXPECT_TRUE(SceneOptions{}.check().ok());
    EXPECT_FALSE((SceneOptions{2.0, 0.4, 8, 8, 8}.check().ok()));
    EXPECT_FALSE((SceneOptions{0.7, 0.4, 0, 8, 8}.check().ok()));
}

} // namespace
