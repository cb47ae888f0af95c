#pragma once
// Flights of stairs (paper section 3d): near-horizontal parallel edges, one above the other, whose spacing
// shrinks regularly with height in the picture. Seen from about 2 to 6 m. Whether the stairs lead up or down
// is the map's word, never the picture's, and no detection is a warning of a drop.

#include "core/base/error.h"
#include "core/recognition/detection.h"

#include <opencv2/core.hpp>

namespace farol::recognition {

struct StairsDetectorOptions {
    int minEdges = 5;            ///< steps that must be seen
    double minWidthShare = 0.12; ///< of the picture's width: the median step
    double minScore = 0.5;

    Result<void> check() const;
};

/// `image` 8-bit BGR or grey. Stateless; thread-safe. At most one flight a picture: the most certain one.
DetectorResult detectStairs(const cv::Mat& image, const StairsDetectorOptions& options = {});

} // namespace farol::recognition
