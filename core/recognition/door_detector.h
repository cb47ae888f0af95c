#pragma once
// Frontal doors (paper section 3c): two long near-vertical edges at a door's proportions, joined by a lintel
// and a darker or differently textured leaf. A missed door is better than a false one.

#include "core/base/error.h"
#include "core/recognition/detection.h"

#include <opencv2/core.hpp>

namespace farol::recognition {

struct DoorDetectorOptions {
    double minHeightShare = 0.45; ///< of the frame's height
    double maxTiltDegrees = 8.0;  ///< of the jambs from the vertical
    double minAspect = 1.6;       ///< height over width
    double maxAspect = 3.2;
    double minScore = 0.55;

    Result<void> check() const;
};

/// `image` 8-bit BGR. Stateless; thread-safe.
DetectorResult detectDoors(const cv::Mat& image, const DoorDetectorOptions& options = {});

} // namespace farol::recognition
