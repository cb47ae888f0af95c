#include "core/recognition/network_detector.h"

#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tiny_network.h"

namespace farol::recognition {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

namespace fs = std::filesystem;

class NetworkDetectorTest : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "farol-detector-XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        m_folder = pattern;
    }
    void TearDown() override { fs::remove_all(m_folder); }

    fs::path description(const std::string& text) {
        fs::path file = m_folder / "detector.json";
        test::writeFile(file, text);
        return file;
    }
    void network(const test::TinyNetwork& made) {
        test::writeFile(m_folder / "tiny.onnx", test::onnxBytes(made));
    }
    Error refused(const std::string& text) {
        auto loaded = NetworkDetector::load(description(text));
        EXPECT_FALSE(loaded) << text;
        return loaded ? Error{} : loaded.error();
    }

    fs::path m_folder;
};

std::string described(const std::string& layout, const std::string& classes, const std::string& input = "",
                      const std::string& more = "") {
    return R"({"model": "tiny.onnx", "input": {"width": 32, "height": 32)" + input + R"(}, "layout": ")" +
           layout + R"(", "classes": )" + classes + more + "}";
}

const char* const kExit = R"([{"name": "way out", "kind": "exit_sign"}])";
const char* const kTwo = R"([{"name": "background", "kind": null}, {"name": "pharmacy", "kind": "sign"}])";

/// One box at (16, 8) of 8 x 4 whose score grows with the first channel.
test::TinyNetwork seesBrightness() {
    return {32, 32, {1, 1, 6}, {16, 8, 8, 4, 1, 0}, {0, 0, 0, 0, 0, 0.9F}};
}

TEST_F(NetworkDetectorTest, TellsWhatAYoloFindsInPixelsOfThePicture) {
    network(seesBrightness());
    auto detector = NetworkDetector::load(description(described("yolo", kExit, R"(, "fit": "stretch")")));
    ASSERT_TRUE(detector) << detector.error().text();
    cv::Mat red(240, 320, CV_8UC3, cv::Scalar(0, 0, 255));
    auto found = detector->detect(red);
    ASSERT_THAT(found.detections, SizeIs(1));
    const Detection& one = found.detections[0];
    EXPECT_EQ(one.kind, Kind::ExitSign);
    EXPECT_EQ(one.text, "") << "the kind says it";
    EXPECT_NEAR(one.score, 0.9, 1e-4);
    EXPECT_EQ(one.image, (ImageSize{320, 240}));
    ImageBox box = boundingBox(one.quad);
    EXPECT_NEAR(box.x, 120.0, 1e-3);
    EXPECT_NEAR(box.y, 45.0, 1e-3);
    EXPECT_NEAR(box.width, 80.0, 1e-3);
    EXPECT_NEAR(box.height, 30.0, 1e-3);
}

TEST_F(NetworkDetectorTest, ALetterboxKeepsProportions) {
    test::TinyNetwork always{32, 32, {1, 1, 6}, {16, 8, 8, 4, 1, 0.8F}, {}};
    network(always);
    auto detector = NetworkDetector::load(description(described("yolo", kExit)));
    ASSERT_TRUE(detector) << detector.error().text();
    auto found = detector->detect(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(0)));
    ASSERT_THAT(found.detections, SizeIs(1));
    ImageBox box = boundingBox(found.detections[0].quad);
    EXPECT_NEAR(box.x, 120.0, 1e-3);
    EXPECT_NEAR(box.y, 60.0, 1e-3);
    EXPECT_NEAR(box.width, 80.0, 1e-3);
    EXPECT_NEAR(box.height, 40.0, 1e-3);
}

TEST_F(NetworkDetectorTest, MeansScalesAndChannelsAreAsDescribed) {
    cv::Mat red(64, 64, CV_8UC3, cv::Scalar(0, 0, 255)), blue(64, 64, CV_8UC3, cv::Scalar(255, 0, 0));
    network(seesBrightness());
    auto rgb = NetworkDetector::load(description(described("yolo", kExit, R"(, "channels": "rgb")")));
    auto bgr = NetworkDetector::load(description(described("yolo", kExit, R"(, "channels": "bgr")")));
    auto dim = NetworkDetector::load(description(
        described("yolo", kExit, R"(, "scale": 0.002, "mean": [55, 0, 0])", R"(, "score": 0.3)")));
    ASSERT_TRUE(rgb && bgr && dim);
    EXPECT_THAT(rgb->detect(red).detections, SizeIs(1));
    EXPECT_THAT(rgb->detect(blue).detections, IsEmpty());
    EXPECT_THAT(bgr->detect(red).detections, IsEmpty());
    EXPECT_THAT(bgr->detect(blue).detections, SizeIs(1));
    auto found = dim->detect(red).detections;
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_NEAR(found[0].score, 0.9 * 200.0 * 0.002, 1e-4);
}

TEST_F(NetworkDetectorTest, RowsMayBeColumnsAndTheChanceOfAnythingMayBeMissing) {
    // Three boxes of a network without the fifth number, as columns: two alike, one weak.
    network({32, 32, {1, 5, 3}, {8, 8.5F, 24, 8, 8, 24, 8, 8, 8, 8, 8, 8, 0.9F, 0.8F, 0.3F}, {}});
    auto detector = NetworkDetector::load(description(described("yolo", kExit)));
    ASSERT_TRUE(detector) << detector.error().text();
    auto found = detector->detect(cv::Mat(32, 32, CV_8UC3, cv::Scalar::all(90)));
    ASSERT_THAT(found.detections, SizeIs(1)) << "the second is a copy of the first";
    EXPECT_NEAR(found.detections[0].score, 0.9, 1e-5);
    ASSERT_THAT(found.rejections, SizeIs(1));
    EXPECT_EQ(found.rejections[0].detector, "network");
    EXPECT_EQ(found.rejections[0].reason, "low_score");
    EXPECT_NEAR(found.rejections[0].value, 0.3, 1e-5);
}

TEST_F(NetworkDetectorTest, TellsWhatAnSsdFindsAndNotTheBackground) {
    network({32,
             32,
             {1, 1, 4, 7},
             {0, 1, 0.8F, 0.25F, 0.5F, 0.75F, 1.5F, 0,  0, 0.9F, 0, 0, 1, 1,
              0, 7, 0.9F, 0,     0,    1,     1,    -1, 1, 0.9F, 0, 0, 1, 1},
             {}});
    auto detector = NetworkDetector::load(description(described("ssd", kTwo, R"(, "fit": "stretch")")));
    ASSERT_TRUE(detector) << detector.error().text();
    auto found = detector->detect(cv::Mat(100, 200, CV_8UC3, cv::Scalar::all(90))).detections;
    ASSERT_THAT(found, SizeIs(1)) << "not the background, not a class beyond the list, not past the end";
    EXPECT_EQ(found[0].kind, Kind::Sign);
    EXPECT_EQ(found[0].text, "pharmacy");
    ImageBox box = boundingBox(found[0].quad);
    EXPECT_NEAR(box.x, 50.0, 1e-3);
    EXPECT_NEAR(box.y, 50.0, 1e-3);
    EXPECT_NEAR(box.width, 100.0, 1e-3);
    EXPECT_NEAR(box.height, 50.0, 1e-3) << "cut at the border";
}

TEST_F(NetworkDetectorTest, NumbersThatAreNoneAreNotTold) {
    float nan = std::nanf("");
    network({32, 32, {1, 3, 6}, {nan, 8, 8, 4, 1, 0.9F, 16, 8, 8, 4, 1, nan, 16, 8, -8, 4, 1, 0.9F}, {}});
    auto detector = NetworkDetector::load(description(described("yolo", kExit)));
    ASSERT_TRUE(detector) << detector.error().text();
    EXPECT_THAT(detector->detect(cv::Mat(32, 32, CV_8UC3, cv::Scalar::all(90))).detections, IsEmpty());
}

TEST_F(NetworkDetectorTest, OtherPicturesHoldNothing) {
    network(seesBrightness());
    auto detector = NetworkDetector::load(description(described("yolo", kExit)));
    ASSERT_TRUE(detector);
    EXPECT_THAT(detector->detect(cv::Mat()).detections, IsEmpty());
    EXPECT_THAT(detector->detect(cv::Mat(50, 50, CV_8UC1, cv::Scalar(200))).detections, IsEmpty());
    EXPECT_THAT(detector->detect(cv::Mat(50, 50, CV_16UC3, cv::Scalar::all(60000))).detections, IsEmpty());
    EXPECT_THAT(detector->detect(cv::Mat(1, 9000, CV_8UC3, cv::Scalar::all(200))).detections, IsEmpty());
}

TEST_F(NetworkDetectorTest, MissingFilesAreNamed) {
    auto none = NetworkDetector::load(m_folder / "none.json");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::NotFound);
    EXPECT_THAT(none.error().text(), HasSubstr("none.json"));
    Error model = refused(described("yolo", kExit));
    EXPECT_EQ(model.code, ErrorCode::NotFound);
    EXPECT_THAT(model.text(), HasSubstr("tiny.onnx"));
    EXPECT_THAT(model.text(), HasSubstr("detector.json"));
}

TEST_F(NetworkDetectorTest, WhatIsNoNetworkIsRefused) {
    for (const std::string& content : {std::string(), std::string("not a network"), std::string(200, '\xFF'),
                                       test::onnxBytes(seesBrightness()).substr(0, 300)}) {
        test::writeFile(m_folder / "tiny.onnx", content);
        Error error = refused(described("yolo", kExit));
        EXPECT_TRUE(error.code == ErrorCode::UnsupportedFormat || error.code == ErrorCode::Conflict)
            << error.text();
        EXPECT_THAT(error.text(), HasSubstr("tiny.onnx"));
    }
}

TEST_F(NetworkDetectorTest, AnotherShapeThanDescribedIsRefusedBeforeAWalk) {
    network(seesBrightness());
    Error classes = refused(described("yolo", R"([{"name": "a", "kind": null}, {"name": "b", "kind": null},
                                                  {"name": "c", "kind": "door"}])"));
    EXPECT_EQ(classes.code, ErrorCode::Conflict);
    EXPECT_THAT(classes.text(), HasSubstr("a yolo of 3 classes"));
    Error layout = refused(described("ssd", kExit));
    EXPECT_EQ(layout.code, ErrorCode::Conflict);
    EXPECT_THAT(layout.text(), HasSubstr("7 numbers"));
    EXPECT_THAT(layout.text(), HasSubstr("1 x 1 x 6"));
    std::string larger = described("yolo", kExit);
    larger.replace(larger.find("32"), 2, "16");
    Error size = refused(larger);
    EXPECT_EQ(size.code, ErrorCode::Conflict);
    EXPECT_THAT(size.text(), HasSubstr("16 x 32"));
}

TEST_F(NetworkDetectorTest, MistakesInTheDescriptionAreSaid) {
    const std::pair<std::string, std::string> mistakes[] = {
        {"", "JSON"},
        {"[1, 2]", "JSON"},
        {"{\"model\": ", "JSON"},
        {"{}", "\"model\": is missing"},
        {described("darknet", kExit), "\"darknet\" is not known"},
        {described("yolo", "[]"), "1 to 1000 classes"},
        {described("yolo", "[3]"), "classes[0]"},
        {described("yolo", R"([{"name": "x", "kind": "dragon"}])"),
         "\"dragon\" is not a known kind; there are place, door"},
        {described("yolo", R"([{"name": "x"}])"), "or null for a class that is not told"},
        {described("yolo", R"([{"kind": "door"}])"), "\"name\": is missing"},
        {described("yolo", kExit, R"(, "channels": "grey")"), "\"grey\" is not known"},
        {described("yolo", kExit, R"(, "mean": [1, 2])"), "three numbers"},
        {described("yolo", kExit, R"(, "scale": "1/255")"), "\"scale\""},
        {described("yolo", kExit, R"(, "hight": 3)"), "\"input.hight\": is not a known name"},
        {described("yolo", kExit, "", R"(, "score": 7)"), "\"score\""},
        {described("yolo", kExit, "", R"(, "nms": null)"), "\"nms\""},
        {R"({"model": "a", "input": {"width": 100000, "height": 32}, "layout": "yolo", "classes": []})",
         "16 to 2048"},
        {R"({"model": "a", "input": {"width": 32.5, "height": 32}, "layout": "yolo", "classes": []})",
         "whole number"},
    };
    for (const auto& [text, expected] : mistakes) {
        Error error = refused(text);
        EXPECT_THAT(error.text(), HasSubstr(expected)) << text;
        EXPECT_THAT(error.text(), HasSubstr("detector.json"));
    }
}

} // namespace
} // namespace farol::recognition
