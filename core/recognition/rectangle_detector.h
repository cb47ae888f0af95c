#pragma once
// Upright quadrilaterals (paper section 3e): boards, signs and plates; where the text reader looks.

#include "core/base/error.h"
#include "core/recognition/detection.h"

#include <opencv2/core.hpp>

namespace farol::recognition {

struct RectangleDetectorOptions {
    double minAreaShare = 0.0015; ///< of the frame
    double maxAreaShare = 0.5;
    double maxCornerCosine = 0.35; ///< how far a corner may be from a right angle
    double maxTiltDegrees = 20.0;

    Result<void> check() const;
};

/// `image` 8-bit BGR or grey. Detections of kind Rectangle, nested copies removed, best first.
DetectorResult detectRectangles(const cv::Mat& image, const RectangleDetectorOptions& options = {});

} // namespace farol::recognition
