#pragma once
// Doors (paper section 3c): outlines of two jambs and a lintel, whole or cut by the picture's border, told
// from refrigerators, cupboards and boards by a classifier over colours, edges and proportions. A missed door
// is better than a false one.

#include "core/base/error.h"
#include "core/recognition/detection.h"

#include <opencv2/core.hpp>

namespace farol::recognition {

struct DoorDetectorOptions {
    double minHeightShare = 0.40; ///< of the frame's height
    double maxTiltDegrees = 16.0; ///< of the jambs from the vertical
    double minAspect = 1.3;       ///< height over width in the picture
    double maxAspect = 4.0;
    double minScore = 0.75;
    double focalPx = 0.0; ///< of the camera, in pixels of the picture given; 0: unknown, and no range is told
    double focalSpread = 0.0;  ///< one standard deviation, as a share of it
    double leafHeightM = 2.05; ///< the usual door
    double leafSpreadM = 0.10; ///< how much doors differ

    Result<void> check() const;
};

/// `image` 8-bit BGR. Stateless; thread-safe. Best first. With a known focal length a door that is seen whole
/// has a range and a bearing.
DetectorResult detectDoors(const cv::Mat& image, const DoorDetectorOptions& options = {});

struct RangeEstimate {
    double metres = 0.0;
    double spread = 0.0; ///< one standard deviation
};

/// How far a door of the usual height is whose outline is seen whole: the mean of its two jambs.
RangeEstimate doorRange(const Quad& quad, const DoorDetectorOptions& options);

} // namespace farol::recognition
