#include "core/recognition/training.h"
#include "core/session/perception.h"
#include "tests/recognition/tiny_network.h"
#include "tests/session/walk_fixture.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace farol::session {
namespace {

using testing::HasSubstr;

capture::Frame frameOf(cv::Mat image, std::uint64_t index, double time) {
    capture::Frame frame;
    frame.index = index;
    frame.capturedAt = time;
    frame.image = std::move(image);
    frame.name = "picture";
    return frame;
}

/// A wall with a door plate.
cv::Mat plate() {
    cv::Mat image(480, 640, CV_8UC3, cv::Scalar(150, 160, 165));
    cv::rectangle(image, cv::Rect(190, 150, 260, 120), cv::Scalar(250, 250, 250), cv::FILLED);
    cv::rectangle(image, cv::Rect(190, 150, 260, 120), cv::Scalar(20, 20, 20), 3);
    cv::putText(image, "2.14", cv::Point(222, 235), cv::FONT_HERSHEY_DUPLEX, 2.6, cv::Scalar(10, 10, 10), 5,
                cv::LINE_AA);
    return image;
}

bool readsSomething(const Percept& percept) {
    return std::any_of(percept.detections.begin(), percept.detections.end(),
                       [](const recognition::Detection& detection) { return detection.kind == Kind::Text; });
}

TEST(Perception, SaysWhatItCannotDo) {
    std::vector<std::string> warnings;
    PerceptionOptions options;
    options.textReader.languages = "klingon";
    Perception perception(nullptr, options, warnings);
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_THAT(warnings[0], HasSubstr("no trained landmarks"));
    EXPECT_THAT(warnings[1], HasSubstr("signs are not read"));
    Percept percept = perception.look(frameOf(plate(), 0, 0.0));
    EXPECT_FALSE(readsSomething(percept));

    warnings.clear();
    options.landmarks = options.text = false;
    Perception silent(nullptr, options, warnings);
    EXPECT_TRUE(warnings.empty()) << "what was not asked for is not missed";
}

TEST(Perception, AnEmptyLibraryIsNoLibrary) {
    std::vector<std::string> warnings;
    PerceptionOptions options;
    options.text = false;
    Perception perception(std::make_shared<recognition::LandmarkLibrary>(), options, warnings);
    EXPECT_EQ(warnings.size(), 1U);
    EXPECT_TRUE(perception.look(frameOf(test::drawnFrame(0), 0, 0.0)).detections.empty());
}

/// Was the text reader asked?
bool reads(Perception& perception, const cv::Mat& image, std::uint64_t index, double time,
           Percept* percept = nullptr) {
    HopTimes times;
    Percept seen = perception.look(frameOf(image, index, time), &times);
    if (percept != nullptr) *percept = std::move(seen);
    return times.textMs > 0.0;
}

TEST(Perception, ReadsAtMostSoOftenByTheFramesOwnClock) {
    std::vector<std::string> warnings;
    PerceptionOptions options;
    options.landmarks = options.doors = false;
    Perception perception(nullptr, options, warnings);
    ASSERT_TRUE(warnings.empty()) << warnings.front();
    std::vector<bool> read;
    for (double time : {0.0, 0.1, 0.2, 0.31, 0.4, 0.62, 0.1}) // the last: a clock that was set back
        read.push_back(reads(perception, plate(), read.size(), time));
    EXPECT_THAT(read, testing::ElementsAre(true, false, false, true, false, true, true));
}

/// Frames in which the plate's words are told, ten frames a second.
std::vector<int> framesTold(const std::vector<std::string>& words, int frames) {
    std::vector<std::string> warnings;
    PerceptionOptions options;
    options.landmarks = options.doors = false;
    options.textReader.words = words;
    Perception perception(nullptr, options, warnings);
    std::vector<int> told;
    for (int i = 0; i < frames; ++i) {
        Percept percept;
        reads(perception, plate(), static_cast<std::uint64_t>(i), 0.1 * i, &percept);
        bool settled = !percept.tracks.empty() && percept.tracks[0].now.text == "2.14";
        EXPECT_EQ(settled, !told.empty() || readsSomething(percept)) << "frame " << i;
        if (!readsSomething(percept)) continue;
        told.push_back(i);
        EXPECT_EQ(percept.detections.front().text, "2.14");
        EXPECT_NE(percept.detections.front().track, 0U);
    }
    return told;
}

TEST(Perception, APlateIsToldWhenThreeReadingsAgreeAndThenNotReadAgainAtOnce) {
    std::vector<int> told = framesTold({}, 45);
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0], 6) << "read at 0, 0.3 and 0.6 seconds";
    EXPECT_GE(told[1], 36) << "checked again after three seconds";
}

TEST(Perception, AWordOfTheMapIsToldWhenTwoSharpReadingsAgree) {
    EXPECT_THAT(framesTold({"2.14"}, 20), testing::ElementsAre(3));
}

TEST(PlateReadings, WhatMostReadingsDoNotShareIsNotTold) {
    PlateReadings plates({"2.14"});
    for (const char* reading : {"2.14", "2.11", "2.14", "2.11", "2.17", "2.14"}) {
        plates.add(1, reading, false, 0.0);
        EXPECT_EQ(plates.agreed(1), nullptr);
    }
    plates.add(1, "2.14", false, 0.0); // four of seven
    EXPECT_NE(plates.agreed(1), nullptr);
    for (int i = 0; i < 3; ++i) plates.add(1, "2.11", false, 0.0);
    EXPECT_EQ(plates.agreed(1), nullptr) << "later readings may take it back";
    plates.add(2, "2.14", true, 1.0);
    EXPECT_EQ(plates.agreed(2), nullptr);
    plates.add(2, "2.14", true, 2.0);
    ASSERT_NE(plates.agreed(2), nullptr);
    EXPECT_EQ(*plates.agreed(2), "2.14");
    plates.forgetBefore(1.5);
    EXPECT_NE(plates.agreed(2), nullptr);
    plates.forgetBefore(2.5);
    EXPECT_EQ(plates.agreed(2), nullptr);
}

TEST(Perception, TheSamePicturesGiveTheSamePercepts) {
    std::vector<std::string> warnings;
    Perception first(nullptr, {}, warnings);
    Perception second(nullptr, {}, warnings);
    for (std::uint64_t i = 0; i < 4; ++i) {
        cv::Mat image = i % 2 == 0 ? plate() : test::drawnFrame(i);
        EXPECT_EQ(dumped(perceptJson(first.look(frameOf(image, i, 0.5 * double(i))))),
                  dumped(perceptJson(second.look(frameOf(image.clone(), i, 0.5 * double(i))))));
    }
}

TEST(Perception, AnotherRoomIsAnotherScene) {
    std::vector<std::string> warnings;
    PerceptionOptions options;
    options.landmarks = options.text = options.doors = false;
    Perception perception(nullptr, options, warnings);
    int first = perception.look(frameOf(test::drawnFrame(0), 0, 0.0)).scene;
    EXPECT_EQ(perception.look(frameOf(test::drawnFrame(1), 1, 0.1)).scene, first);
    EXPECT_GT(perception.look(frameOf(plate(), 2, 0.2)).scene, first);
}

TEST(Perception, NoPictureIsAPerceptWithNothing) {
    std::vector<std::string> warnings;
    Perception perception(nullptr, {}, warnings);
    Percept percept = perception.look(frameOf(cv::Mat(), 4, 2.0));
    EXPECT_EQ(percept.frame, 4U);
    EXPECT_EQ(percept.time, 2.0);
    EXPECT_TRUE(percept.detections.empty());
    EXPECT_TRUE(perceptFromJson(perceptJson(percept)));
}

TEST(Perception, BoardsAreDetectionsOnlyWhenAskedFor) {
    std::vector<std::string> warnings;
    PerceptionOptions options;
    options.landmarks = options.doors = options.text = false;
    options.rectangles = true;
    Perception perception(nullptr, options, warnings);
    Percept percept = perception.look(frameOf(plate(), 0, 0.0));
    ASSERT_FALSE(percept.detections.empty());
    EXPECT_EQ(percept.detections.front().kind, Kind::Rectangle);
}

TEST(Perception, ADetectorOfTheUsersOwnLooksToo) {
    std::string pattern = (std::filesystem::temp_directory_path() / "farol-own-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    std::filesystem::path folder = pattern;
    recognition::test::writeFile(
        folder / "tiny.onnx", recognition::test::onnxBytes({32, 32, {1, 1, 6}, {16, 16, 8, 8, 1, 0.9F}, {}}));
    recognition::test::writeFile(
        folder / "own.json",
        R"({"model": "tiny.onnx", "input": {"width": 32, "height": 32}, "layout": "yolo",
                                     "classes": [{"name": "tap", "kind": "fountain"}]})");
    auto own = recognition::NetworkDetector::load(folder / "own.json");
    std::filesystem::remove_all(folder);
    ASSERT_TRUE(own) << own.error().text();
    std::vector<std::string> warnings;
    PerceptionOptions options;
    options.landmarks = options.doors = options.stairs = options.signs = options.text = false;
    options.ownDetector = std::make_shared<recognition::NetworkDetector>(std::move(*own));
    Perception perception(nullptr, options, warnings);
    bool seen = false;
    for (std::uint64_t i = 0; i < 3; ++i) // a second apart: each is told as it is seen
        for (const auto& one : perception.look(frameOf(plate(), i, static_cast<double>(i))).detections)
            seen = seen || one.kind == Kind::Fountain;
    EXPECT_TRUE(seen);
}

/// A poster of 0.6 x 0.45 m, 240 pixels wide in the left half of the picture.
cv::Mat posterOnAWall(recognition::LandmarkLibrary& library) {
    cv::Mat poster(225, 300, CV_8UC3, cv::Scalar(200, 210, 220));
    cv::RNG draw(11);
    for (int i = 0; i < 140; ++i)
        cv::circle(poster, {draw.uniform(0, 300), draw.uniform(0, 225)}, draw.uniform(3, 14),
                   cv::Scalar(draw.uniform(0, 255), draw.uniform(0, 255), draw.uniform(0, 255)), cv::FILLED);
    std::vector<unsigned char> bytes;
    cv::imencode(".png", poster, bytes);
    auto added = recognition::addView(library, {TemplateId("poster"), Kind::Poster, "", 0.6, 0.45},
                                      {bytes.begin(), bytes.end()}, {});
    EXPECT_TRUE(added);
    cv::Mat picture(480, 640, CV_8UC3, cv::Scalar(150, 150, 150)), small;
    cv::resize(poster, small, {240, 180}, 0, 0, cv::INTER_AREA);
    small.copyTo(picture(cv::Rect(40, 150, 240, 180)));
    return picture;
}

TEST(Perception, ATrainedThingOfKnownSizeHasARangeAndWithAKnownCameraABearing) {
    auto library = std::make_shared<recognition::LandmarkLibrary>();
    const cv::Mat picture = posterOnAWall(*library);
    PerceptionOptions options;
    options.text = options.doors = options.stairs = options.signs = options.motion = false;
    auto seen = [&]() -> std::optional<recognition::Detection> {
        std::vector<std::string> warnings;
        Perception perception(library, options, warnings);
        auto detections = perception.look(frameOf(picture, 0, 0.0)).detections;
        if (detections.size() != 1) return std::nullopt;
        return detections.front();
    };
    auto assumed = seen();
    ASSERT_TRUE(assumed && assumed->rangeM && assumed->rangeSpread);
    EXPECT_FALSE(assumed->bearing);
    EXPECT_NEAR(*assumed->rangeM, 1.45, 0.15); // 60 degrees across
    EXPECT_GT(*assumed->rangeSpread, 0.15);

    recognition::CameraModel camera = recognition::CameraModel::assumed({1280, 960});
    camera.focalX = camera.focalY = 1200.0;
    camera.focalSpread = 0.005;
    camera.pictures = 12;
    options.useCamera(camera); // calibrated with larger pictures
    auto known = seen();
    ASSERT_TRUE(known && known->rangeM && known->rangeSpread && known->bearing);
    EXPECT_NEAR(*known->rangeM, 1.5 / std::cos(known->bearing->value), 0.06);
    EXPECT_LT(*known->rangeSpread, 0.05);
    EXPECT_NEAR(known->bearing->value, std::atan(160.0 / 600.0), 0.01);
}

TEST(Perception, SenselessOptionsAreRefused) {
    PerceptionOptions options;
    EXPECT_TRUE(options.check());
    options.secondsBetweenReadings = -1.0;
    EXPECT_FALSE(options.check());
}

} // namespace
} // namespace farol::session
