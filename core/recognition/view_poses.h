#pragma once
// The poses from which a photographed plane is seen again by computation: oblique, nodding and far, so that
// one frontal photograph is recognised from more sides (recognition.md: +0.2 recall on hard views). Only this
// folder includes it.

#include "core/base/geometry.h"
#include "core/recognition/landmark_library.h"

#include <opencv2/core.hpp>

#include <array>
#include <optional>

namespace farol::recognition {

/// Keypoints carry in class_id the pose they were seen from: 0 is the photograph itself, 1 to kPoseCount
/// these.
inline constexpr int kPoseCount = 13;

/// The plane's own coordinates: its rectangle from (0, 0), the longer side 400 units.
struct Plane {
    double width = 0.0;
    double height = 0.0;

    std::array<cv::Point2f, 4> corners() const;
};

/// From the real size where both sides are known, else from the outline's mean sides.
Plane planeOf(const Quad& outline, const std::optional<double>& widthM, const std::optional<double>& heightM);
/// Plane to photograph.
cv::Matx33d planeToQuad(const Plane& plane, const Quad& outline);
/// Plane to the picture of pose 1 to kPoseCount, and the picture's size. `longSidePx`: how long the plane's
/// longer side would be in a picture from 1 m.
struct PosedView {
    cv::Matx33d planeToPicture;
    cv::Size size;
    double blur = 0.0;      ///< of the photograph before it is warped, as a share of the reduction
    double afterBlur = 0.0; ///< pixels, of the finished picture
};
std::optional<PosedView> posedView(const Plane& plane, int pose, double longSidePx);
/// Plane to the middle of a frame, its longer side `longSidePx` long when seen squarely, turned about the
/// upright.
cv::Matx33d seenFrom(const Plane& plane, double longSidePx, double yawDegrees, double focal, cv::Size frame);
/// The length of the longer side at which the poses of a photograph are made.
double posedLongSide(const Quad& outline);
/// Is the plane seen so squarely that other views can be made from this photograph?
bool nearlyFrontal(const Quad& outline);

cv::Point2d mapped(const cv::Matx33d& homography, cv::Point2d point);
std::array<cv::Point2f, 4> mapped(const cv::Matx33d& homography, const std::array<cv::Point2f, 4>& points);

} // namespace farol::recognition
