#include "core/recognition/camera_calibration.h"
#include "core/recognition/camera_model.h"
#include "core/recognition/door_detector.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>

namespace farol::recognition {
namespace {

namespace fs = std::filesystem;

constexpr double kFocal = 620.0;
const cv::Size kPicture(640, 480);

/// A board of 9 x 6 inner corners, turned and leaning by so many degrees, seen without lens bend.
cv::Mat boardPicture(double yaw, double lean, double distance, double aside, double middle = 320.0) {
    constexpr int kSquare = 40, kAcross = 10, kDown = 7;
    cv::Mat board((kDown + 2) * kSquare, (kAcross + 2) * kSquare, CV_8U, cv::Scalar(255));
    for (int y = 0; y < kDown; ++y)
        for (int x = 0; x < kAcross; ++x)
            if ((x + y) % 2 == 0)
                board(cv::Rect((x + 1) * kSquare, (y + 1) * kSquare, kSquare, kSquare)).setTo(0);
    double a = yaw * CV_PI / 180.0, b = lean * CV_PI / 180.0;
    cv::Matx33d turn(std::cos(a), 0, std::sin(a), 0, 1, 0, -std::sin(a), 0, std::cos(a));
    cv::Matx33d nod(1, 0, 0, 0, std::cos(b), -std::sin(b), 0, std::sin(b), std::cos(b));
    cv::Matx33d r = nod * turn;
    const double metre = 1.0 / board.cols; // the sheet is a metre wide
    cv::Matx33d place(r(0, 0) * metre, r(0, 1) * metre, aside, r(1, 0) * metre, r(1, 1) * metre, 0.05,
                      r(2, 0) * metre, r(2, 1) * metre, distance);
    cv::Matx33d centre(1, 0, -board.cols / 2.0, 0, 1, -board.rows / 2.0, 0, 0, 1);
    cv::Matx33d camera(kFocal, 0, middle, 0, kFocal, 240, 0, 0, 1);
    cv::Mat fine;
    cv::Matx33d twice(2, 0, 0, 0, 2, 0, 0, 0, 1);
    cv::warpPerspective(board, fine, twice * camera * place * centre, kPicture * 2, cv::INTER_LINEAR,
                        cv::BORDER_CONSTANT, cv::Scalar(180));
    cv::Mat picture;
    cv::resize(fine, picture, kPicture, 0, 0, cv::INTER_AREA);
    return picture;
}

CameraModel knownCamera() {
    CameraModel camera = CameraModel::assumed({640, 480});
    camera.focalX = camera.focalY = kFocal;
    camera.focalSpread = 0.005;
    camera.pictures = 12;
    return camera;
}

/// A board of the size in metres, its middle so far ahead and so far to the left, turned.
Quad seen(double width, double height, double ahead, double left, double yawDegrees) {
    double a = yawDegrees * CV_PI / 180.0;
    Quad quad;
    std::size_t i = 0;
    for (auto [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
        double px = x * width * std::cos(a) - left, pz = ahead - x * width * std::sin(a);
        quad[i++] = {320.0 + kFocal * px / pz, 240.0 + kFocal * y * height / pz};
    }
    return quad;
}

fs::path folder() {
    fs::path made = fs::path(testing::TempDir()) / "camera_files";
    fs::create_directories(made);
    return made;
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

TEST(CameraCalibration, FindsTheFocalLengthFromBoardsSeenAtASlant) {
    CameraCalibration calibration(Chessboard{9, 6});
    int number = 0;
    for (double yaw : {-35.0, -15.0, 20.0, 40.0})
        for (double lean : {-25.0, 5.0, 30.0})
            ASSERT_TRUE(calibration.add(boardPicture(yaw, lean, 1.5 + 0.1 * number, 0.12 * (number % 3 - 1)),
                                        "board " + std::to_string(number)))
                << number++;
    auto camera = calibration.solve();
    ASSERT_TRUE(camera) << camera.error().text();
    EXPECT_NEAR(camera->focalX, kFocal, 0.01 * kFocal);
    EXPECT_NEAR(camera->focalY, kFocal, 0.01 * kFocal);
    EXPECT_NEAR(camera->centreX, 320.0, 8.0);
    EXPECT_LT(camera->focalSpread, 0.02);
    EXPECT_TRUE(camera->calibrated());
}

TEST(CameraCalibration, RefusesALensWhoseMiddleLiesFarAside) {
    CameraCalibration calibration(Chessboard{9, 6});
    int number = 0;
    for (double yaw : {-35.0, -15.0, 20.0, 40.0})
        for (double lean : {-25.0, 5.0, 30.0}) {
            double distance = 1.8 + 0.1 * number, aside = 0.5 + 0.12 * (number % 3 - 1);
            ASSERT_TRUE(calibration.add(boardPicture(yaw, lean, distance, aside, 150.0), "board")) << number;
            ++number;
        }
    auto camera = calibration.solve();
    ASSERT_FALSE(camera) << camera->centreX << ", " << camera->centreY;
    EXPECT_NE(camera.error().message.find("middle"), std::string::npos) << camera.error().message;
}

TEST(CameraCalibration, RefusesBoardsThatAreAllSeenSquareOn) {
    CameraCalibration calibration(Chessboard{9, 6});
    for (int i = 0; i < 6; ++i) ASSERT_TRUE(calibration.add(boardPicture(0, 0, 1.5 + 0.2 * i, 0.0), "board"));
    auto camera = calibration.solve();
    ASSERT_FALSE(camera);
    EXPECT_EQ(camera.error().code, ErrorCode::Conflict);
    EXPECT_NE(camera.error().message.find("slant"), std::string::npos) << camera.error().message;
}

TEST(CameraCalibration, NamesPicturesThatDoNotHelpAndGoesOn) {
    CameraCalibration calibration(Chessboard{9, 6});
    auto none = calibration.add(cv::Mat(480, 640, CV_8U, cv::Scalar(90)), "wall.jpg");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::NotFound);
    EXPECT_EQ(none.error().context, "wall.jpg");
    ASSERT_TRUE(calibration.add(boardPicture(20, 10, 1.6, 0), "first.jpg"));
    cv::Mat small;
    cv::resize(boardPicture(20, 10, 1.6, 0), small, {320, 240});
    auto other = calibration.add(small, "small.jpg");
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code, ErrorCode::Conflict);
    EXPECT_FALSE(calibration.add(cv::Mat(), "empty"));
    EXPECT_EQ(calibration.pictures(), 1);
    auto camera = calibration.solve();
    ASSERT_FALSE(camera);
    EXPECT_NE(camera.error().message.find("at least 5"), std::string::npos) << camera.error().message;
    EXPECT_FALSE((CameraCalibration(Chessboard{1, 6}).add(boardPicture(0, 0, 2, 0), "x")));
}

TEST(CameraFile, ComesBackAsItWasWritten) {
    fs::path file = folder() / "camera.json";
    CameraModel camera = knownCamera();
    camera.distortion = {0.1, -0.2, 0.001, -0.002, 0.03};
    ASSERT_TRUE(saveCamera(camera, file));
    auto back = loadCamera(file);
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->focalX, camera.focalX);
    EXPECT_EQ(back->distortion, camera.distortion);
    EXPECT_EQ(back->pictures, camera.pictures);
    EXPECT_EQ(back->size.width, 640);
}

TEST(CameraFile, RefusesWhatIsNoCamera) {
    const std::string good = R"({"camera_version": 1, "size": [640, 480], "focal": [620, 620],
        "centre": [320, 240], "distortion": [0, 0, 0, 0, 0], "focal_spread": 0.01, "reprojection_px": 0.2,
        "pictures": 9})";
    fs::path file = folder() / "bad.json";
    write(file, good);
    ASSERT_TRUE(loadCamera(file));
    auto refused = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        write(file, text);
        auto camera = loadCamera(file);
        return camera ? std::string("accepted") : std::string(errorCodeName(camera.error().code));
    };
    const std::string corrupt = errorCodeName(ErrorCode::Corrupt);
    EXPECT_EQ(refused("\"camera_version\": 1", "\"camera_version\": 2"),
              errorCodeName(ErrorCode::UnsupportedFormat));
    EXPECT_EQ(refused("[620, 620]", "[620]"), corrupt);
    EXPECT_EQ(refused("[620, 620]", "[0, 620]"), corrupt);
    EXPECT_EQ(refused("[620, 620]", "[\"a\", 620]"), corrupt);
    EXPECT_EQ(refused("[320, 240]", "[3200, 240]"), corrupt);
    EXPECT_EQ(refused("0.01", "-1"), corrupt);
    EXPECT_EQ(refused("\"pictures\": 9", "\"pictures\": null"), corrupt);
    write(file, "{\"regions\": []}");
    EXPECT_FALSE(loadCamera(file));
    write(file, "no JSON");
    EXPECT_FALSE(loadCamera(file));
    EXPECT_EQ(loadCamera(folder() / "missing.json").error().code, ErrorCode::NotFound);
}

TEST(CameraModel, ServesPicturesOfTheSameShapeOnly) {
    auto half = knownCamera().forPictures({320, 240});
    ASSERT_TRUE(half);
    EXPECT_DOUBLE_EQ(half->focalX, kFocal / 2.0);
    auto wide = knownCamera().forPictures({1280, 720});
    ASSERT_FALSE(wide);
    EXPECT_EQ(wide.error().code, ErrorCode::Conflict);
    // A phone held upright sees as far along its longer side.
    EXPECT_DOUBLE_EQ(CameraModel::assumed({480, 640}).focalX, CameraModel::assumed({640, 480}).focalX);
    EXPECT_NEAR(CameraModel::assumed({640, 480}).horizontalViewDegrees(), 60.0, 1e-9);
}

TEST(RangeOf, TellsHowFarAThingOfKnownSizeIs) {
    for (double yaw : {0.0, 35.0, -50.0}) {
        auto range = rangeOf(seen(0.6, 0.4, 2.5, 0.3, yaw), knownCamera(), 0.6, 0.4);
        ASSERT_TRUE(range);
        EXPECT_NEAR(range->metres, std::hypot(2.5, 0.3), 0.02) << yaw;
        EXPECT_LT(range->spread, 0.05);
    }
    auto tall = rangeOf(seen(0.6, 0.4, 2.5, 0.0, 40.0), knownCamera(), {}, 0.4);
    ASSERT_TRUE(tall);
    EXPECT_NEAR(tall->metres, 2.5, 0.1);
    EXPECT_GT(tall->spread, 0.1);
    auto assumed = rangeOf(seen(0.6, 0.4, 2.5, 0.0, 0.0), CameraModel::assumed({640, 480}), 0.6, 0.4);
    ASSERT_TRUE(assumed);
    EXPECT_LT(std::abs(assumed->metres - 2.5), 2.0 * assumed->spread * assumed->metres);
}

TEST(RangeOf, TellsNothingWithoutASizeOrTheWholeOutline) {
    EXPECT_FALSE(rangeOf(seen(0.6, 0.4, 2.5, 0.0, 0.0), knownCamera(), {}, {}));
    EXPECT_FALSE(rangeOf(seen(0.6, 0.4, 0.6, 0.5, 0.0), knownCamera(), 0.6, 0.4)) << "cut by the picture";
    EXPECT_FALSE(rangeOf(Quad{}, knownCamera(), 0.6, 0.4));
}

TEST(Place, GivesABearingOnlyWhereTheCameraIsKnown) {
    Detection detection;
    detection.quad = seen(0.6, 0.4, 2.0, 0.5, 0.0);
    detection.image = {640, 480};
    Detection assumed = detection;
    place(detection, knownCamera(), 0.6, 0.4);
    ASSERT_TRUE(detection.bearing && detection.rangeM && detection.rangeSpread);
    EXPECT_NEAR(detection.bearing->value, std::atan2(0.5, 2.0), 0.01); // left is positive
    place(assumed, CameraModel::assumed({640, 480}), 0.6, 0.4);
    EXPECT_FALSE(assumed.bearing);
    EXPECT_TRUE(assumed.rangeM);
}

TEST(DoorRange, IsLessSureWithALessSureFocalLength) {
    DoorDetectorOptions options;
    options.focalPx = kFocal;
    Quad door = seen(0.9, 2.05, 4.0, 0.0, 0.0);
    RangeEstimate known = doorRange(door, options);
    options.focalSpread = 0.2;
    RangeEstimate assumed = doorRange(door, options);
    EXPECT_NEAR(known.metres, 4.0, 0.01);
    EXPECT_GT(assumed.spread, 2.0 * known.spread);
    options.focalSpread = 1.5;
    EXPECT_FALSE(options.check());
}

} // namespace
} // namespace farol::recognition
