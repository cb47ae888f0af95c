#pragma once
// A camera's focal length, middle and bend from photographs of a printed chessboard.

#include "core/base/error.h"
#include "core/recognition/camera_model.h"

#include <opencv2/core.hpp>

#include <string>
#include <vector>

namespace farol::recognition {

/// Corners where four squares meet: one fewer than squares, each way.
struct Chessboard {
    int columns = 9, rows = 6;

    Result<void> check() const;
};

class CameraCalibration {
public:
    explicit CameraCalibration(const Chessboard& board) : m_board(board) {}

    /// NotFound where the whole board is not seen; Conflict where the picture is of another size than those
    /// before. Either way the calibration goes on without it.
    Result<void> add(const cv::Mat& picture, const std::string& name);
    int pictures() const { return static_cast<int>(m_corners.size()); }

    /// Conflict, with what to photograph again, where the pictures do not suffice or do not fit together. The
    /// real size of the squares does not matter.
    Result<CameraModel> solve() const;

private:
    Chessboard m_board;
    cv::Size m_size;
    std::vector<std::vector<cv::Point2f>> m_corners;
};

} // namespace farol::recognition
