#include "core/recognition/camera_calibration.h"

#include "core/recognition/grey.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr int kFewestPictures = 5;
constexpr double kWorstReprojectionPx = 2.0; // of a picture 640 wide
constexpr double kWorstFocalSpread = 0.05;

std::string twoDigits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

std::vector<cv::Point3f> cornersOf(const Chessboard& board) {
    std::vector<cv::Point3f> corners;
    for (int row = 0; row < board.rows; ++row)
        for (int column = 0; column < board.columns; ++column)
            corners.emplace_back(static_cast<float>(column), static_cast<float>(row), 0.0F);
    return corners;
}

/// Square on from everywhere, distance and focal length cannot be told apart: is any board seen at a slant?
bool anySlanted(const std::vector<cv::Mat>& turns) {
    constexpr double kLeastSlant = 0.2; // radians
    return std::any_of(turns.begin(), turns.end(), [](const cv::Mat& turn) {
        cv::Matx33d rotation;
        cv::Rodrigues(turn, rotation);
        return std::acos(std::clamp(std::abs(rotation(2, 2)), 0.0, 1.0)) > kLeastSlant;
    });
}

} // namespace

Result<void> Chessboard::check() const {
    if (columns < 3 || rows < 3 || columns > 50 || rows > 50)
        return Error{ErrorCode::InvalidArgument,
                     "a chessboard has 3 to 50 inner corners each way: one fewer than its squares", "board"};
    return {};
}

Result<void> CameraCalibration::add(const cv::Mat& picture, const std::string& name) {
    if (auto checked = m_board.check(); !checked) return checked;
    cv::Mat grey = greyOf(picture);
    if (grey.empty()) return Error{ErrorCode::Corrupt, "is no picture that a camera gives", name};
    if (!m_corners.empty() && grey.size() != m_size)
        return Error{ErrorCode::Conflict,
                     "is " + std::to_string(grey.cols) + " x " + std::to_string(grey.rows) +
                         " pixels, the pictures before " + std::to_string(m_size.width) + " x " +
                         std::to_string(m_size.height) + "; take all in one mode of the camera",
                     name};
    std::vector<cv::Point2f> corners;
    try {
        bool found = cv::findChessboardCorners(grey, {m_board.columns, m_board.rows}, corners,
                                               cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE |
                                                   cv::CALIB_CB_FAST_CHECK);
        if (!found)
            return Error{
                ErrorCode::NotFound,
                "a board of " + std::to_string(m_board.columns) + " x " + std::to_string(m_board.rows) +
                    " inner corners is not seen whole; hold it flat, evenly lit and all of it in view",
                name};
        int reach = std::clamp(grey.cols / 120, 3, 15);
        cv::cornerSubPix(grey, corners, {reach, reach}, {-1, -1},
                         {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 40, 0.005});
    } catch (const cv::Exception& problem) {
        return Error{ErrorCode::Internal, std::string("the board could not be looked for: ") + problem.what(),
                     name};
    }
    m_size = grey.size();
    m_corners.push_back(std::move(corners));
    return {};
}

Result<CameraModel> CameraCalibration::solve() const {
    auto notEnough = [](const std::string& message) {
        return Error{ErrorCode::Conflict, message, "calibration"};
    };
    if (pictures() < kFewestPictures)
        return notEnough("the board was found in " + std::to_string(pictures()) + " pictures; at least " +
                         std::to_string(kFewestPictures) +
                         " are needed, from different sides and in all parts of the picture");
    std::vector<std::vector<cv::Point3f>> board(m_corners.size(), cornersOf(m_board));
    cv::Mat matrix, bend, spreads;
    std::vector<cv::Mat> turns, shifts;
    double error = 0.0;
    try {
        error = cv::calibrateCamera(board, m_corners, m_size, matrix, bend, turns, shifts, spreads,
                                    cv::noArray(), cv::noArray());
    } catch (const cv::Exception& problem) {
        return notEnough(std::string("the pictures do not fit together: ") + problem.what());
    }
    CameraModel camera;
    camera.size = {m_size.width, m_size.height};
    camera.focalX = matrix.at<double>(0, 0);
    camera.focalY = matrix.at<double>(1, 1);
    // OpenCV's pixel centres stand at 0, ours at +0.5.
    camera.centreX = matrix.at<double>(0, 2) + 0.5;
    camera.centreY = matrix.at<double>(1, 2) + 0.5;
    for (std::size_t i = 0; i < camera.distortion.size(); ++i)
        camera.distortion[i] = bend.at<double>(static_cast<int>(i));
    camera.reprojectionPx = error;
    camera.pictures = pictures();
    camera.focalSpread =
        std::max(spreads.at<double>(0) / camera.focalX, spreads.at<double>(1) / camera.focalY);
    if (!std::isfinite(camera.focalSpread) || !(camera.focalSpread < kWorstFocalSpread) || !anySlanted(turns))
        return notEnough(
            "the focal length cannot be told from these pictures; photograph the board at a slant, "
            "too: turned to each side, leaning back and forth");
    double worst = kWorstReprojectionPx * std::max(1.0, m_size.width / 640.0);
    if (!(error < worst))
        return notEnough("the corners miss their places by " + twoDigits(error) +
                         " pixels; is the board flat, and are the pictures sharp?");
    // Bearings follow the middle of the lens: far off the picture's, it was not measured but made up.
    constexpr double kMostOffMiddle = 0.08; // cameras as they are sold lie well within
    if (std::abs(camera.centreX - m_size.width / 2.0) > kMostOffMiddle * m_size.width ||
        std::abs(camera.centreY - m_size.height / 2.0) > kMostOffMiddle * m_size.height)
        return notEnough(
            "the middle of the lens comes out far from the middle of the picture; photograph the "
            "board in all parts of the picture, and do not cut the pictures");
    if (auto checked = camera.check(); !checked)
        return notEnough("the pictures lead to an impossible camera (" + checked.error().message +
                         "); take sharper ones, in all parts of the picture");
    return camera;
}

} // namespace farol::recognition
