#pragma once
// Rows of parallel edges in a picture that may be a flight of stairs, each with the cues by which a
// classifier tells stairs from tiles, blinds, shelves and windows. For the detector and the program that
// trains it.

#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <array>
#include <vector>

namespace farol::recognition {

inline constexpr std::size_t kStairsCueCount = 20;
using StairsCues = std::array<float, kStairsCueCount>;

struct StairsCandidate {
    Quad quad{}; ///< around the edges, in pixels of the picture given
    StairsCues cues{};
    int edges = 0;           ///< nosings in the row
    double widthShare = 0.0; ///< of the picture's width: the median edge
};

/// The longest row of each polarity (nosings lighter or darker than the riser below). `image` 8-bit BGR or
/// grey.
std::vector<StairsCandidate> stairsCandidates(const cv::Mat& image);

} // namespace farol::recognition
