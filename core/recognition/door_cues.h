#pragma once
// Quadrilaterals in a picture that may be doors, each with the cues by which a classifier tells doors from
// refrigerators, cupboards, windows and boards. For the detector and the program that trains it.

#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <array>
#include <vector>

namespace farol::recognition {

inline constexpr std::size_t kDoorCueCount = 52;
using DoorCues = std::array<float, kDoorCueCount>;

struct DoorCandidate {
    Quad quad{}; ///< clockwise from the top left, in pixels of the picture given
    DoorCues cues{};
    bool topSeen = true, footSeen = true; ///< false where the picture's border cuts the door
};

struct DoorCueOptions {
    double minHeightShare = 0.40; ///< of the frame's height
    double maxTiltDegrees = 16.0; ///< of the jambs from the vertical
    double minAspect = 1.3;       ///< height over width of a whole one
    double maxAspect = 4.0;
    std::size_t most = 90; ///< candidates: the best outlined ones
};

/// `image` 8-bit BGR or grey.
std::vector<DoorCandidate> doorCandidates(const cv::Mat& image, const DoorCueOptions& options = {});

} // namespace farol::recognition
