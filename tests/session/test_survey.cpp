#include "core/session/survey.h"
#include "tests/recognition/corridor_camera.h"
#include "tests/session/walk_fixture.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace farol::session {
namespace {

constexpr double kFps = 8.0;
constexpr int kFrames = 184;

/// A straight corridor of 60 m, 2.2 m wide.
std::shared_ptr<const building::Building> corridor() {
    building::BuildingData data;
    data.levels.push_back({0.0, "Ground floor", "0", std::nullopt, std::nullopt, {}});
    building::Region region;
    region.id = RegionId("K");
    region.kind = building::RegionKind::Corridor;
    region.polygon.outer = {{0, -1.1}, {60, -1.1}, {60, 1.1}, {0, 1.1}};
    data.regions.push_back(region);
    return std::make_shared<const building::Building>(std::move(data));
}

/// From 4 m to 22 m: slowly at first, then a pause, then quicker.
double spotAt(double t) {
    return 4.0 + 0.5 * std::min(t, 8.0) + (t > 11.0 ? (t - 11.0) * 14.0 / 12.0 : 0.0);
}

cv::Mat viewAt(double x) {
    recognition::test::CameraPose pose;
    pose.x = x;
    return recognition::test::corridorView(pose);
}

Result<std::unique_ptr<capture::FrameSource>> recording() {
    auto source = std::make_unique<farol::test::ScriptedSource>(kFrames);
    source->timeOf = [](std::size_t i) { return static_cast<double>(i) / kFps; };
    source->imageOf = [](std::size_t i) { return viewAt(spotAt(static_cast<double>(i) / kFps)); };
    return std::unique_ptr<capture::FrameSource>(std::move(source));
}

building::Location spot(double x) {
    return {RegionId("K"), Point2{x, 0.0}};
}

TEST(Survey, PlacesAreTrainedWhereTheWalkReallyWas) {
    recognition::LandmarkLibrary library;
    auto survey = surveyWalk(corridor(), library, recording, {spot(4.0), spot(22.0)});
    ASSERT_TRUE(survey) << survey.error().text();
    EXPECT_NEAR(survey->lengthM, 18.0, 0.01);
    EXPECT_GE(survey->places.size(), 15U);
    EXPECT_EQ(library.templates.size(), survey->places.size());
    std::vector<double> errors;
    for (const SurveyedPlace& place : survey->places) {
        EXPECT_EQ(place.landmark.kind, Kind::Place);
        EXPECT_EQ(place.landmark.region, RegionId("K"));
        EXPECT_EQ(place.landmark.templateId.value, place.landmark.id.value);
        ASSERT_TRUE(place.landmark.heading);
        EXPECT_NEAR(place.landmark.heading->value, 0.0, 0.01);
        errors.push_back(std::abs(place.landmark.position.x - spotAt(place.time)));
    }
    std::sort(errors.begin(), errors.end());
    EXPECT_LT(errors[errors.size() / 2], 0.6);
    EXPECT_LT(errors.back(), 2.0);

    // The next visitor is recognised at the place.
    recognition::LandmarkRecogniser recogniser(std::make_shared<const recognition::LandmarkLibrary>(library));
    auto seen = recogniser.recognise(viewAt(12.3));
    ASSERT_FALSE(seen.detections.empty());
    const recognition::Detection& detection = seen.detections.front();
    auto known = std::find_if(survey->places.begin(), survey->places.end(), [&](const SurveyedPlace& place) {
        return place.landmark.templateId == detection.templateId;
    });
    ASSERT_NE(known, survey->places.end());
    EXPECT_NEAR(known->landmark.position.x, 12.3, 1.6);
}

TEST(Survey, AtABendWithoutMotionThePlaceHasNoHeading) {
    // A frame every other second: too far apart for the gyroscope.
    auto sparse = []() -> Result<std::unique_ptr<capture::FrameSource>> {
        auto source = std::make_unique<farol::test::ScriptedSource>(16);
        source->timeOf = [](std::size_t i) { return 2.0 * static_cast<double>(i); };
        source->imageOf = [](std::size_t i) { return viewAt(4.0 + 9.0 * static_cast<double>(i)); };
        return std::unique_ptr<capture::FrameSource>(std::move(source));
    };
    building::BuildingData data = corridor()->data();
    data.regions[0].polygon.outer = {{0, -1.1}, {20, -1.1}, {20, 20}, {0, 20}};
    auto square = std::make_shared<const building::Building>(std::move(data));
    recognition::LandmarkLibrary library;
    auto survey =
        surveyWalk(square, library, sparse, {spot(3.0), spot(17.0), {RegionId("K"), Point2{17.0, 15.0}}});
    ASSERT_TRUE(survey) << survey.error().text();
    int without = 0;
    for (const SurveyedPlace& place : survey->places) {
        double corner = distance(place.landmark.position, Point2{17.0, 0.0});
        without += place.landmark.heading ? 0 : 1;
        EXPECT_TRUE(place.landmark.heading || corner < 1.5);
    }
    EXPECT_EQ(survey->leftOut, 0U);
    EXPECT_GE(without, 1);
}

TEST(Survey, NothingIsChangedWhenTheWalkDoesNotFit) {
    recognition::LandmarkLibrary library;
    auto tooLong = surveyWalk(corridor(), library, recording, {spot(1.0), spot(59.0)});
    ASSERT_FALSE(tooLong);
    EXPECT_EQ(tooLong.error().code, ErrorCode::InvalidArgument);
    auto nowhere = surveyWalk(corridor(), library, recording, {spot(1.0)});
    EXPECT_FALSE(nowhere);
    auto unknown = surveyWalk(corridor(), library, recording, {spot(1.0), {RegionId("X"), std::nullopt}});
    EXPECT_FALSE(unknown);
    EXPECT_TRUE(library.templates.empty());
}

TEST(Survey, BlankPicturesAreNotTrained) {
    auto blank = []() -> Result<std::unique_ptr<capture::FrameSource>> {
        auto source = std::make_unique<farol::test::ScriptedSource>(40);
        source->imageOf = [](std::size_t) { return cv::Mat(240, 320, CV_8UC3, cv::Scalar(90, 90, 90)); };
        return std::unique_ptr<capture::FrameSource>(std::move(source));
    };
    recognition::LandmarkLibrary library;
    auto survey = surveyWalk(corridor(), library, blank, {spot(4.0), spot(14.0)});
    ASSERT_FALSE(survey);
    EXPECT_NE(survey.error().text().find("40 of 40"), std::string::npos) << survey.error().text();
}

} // namespace
} // namespace farol::session
