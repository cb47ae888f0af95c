#pragma once
// The object's own grey values, compared with what stands in the frame: the last word on a geometric fit.
// Only this folder includes it.

#include "core/recognition/landmark_library.h"
#include "core/recognition/view_poses.h"

#include <opencv2/core.hpp>

namespace farol::recognition {

/// The object as the photograph shows it, on a small grey square; empty where the photograph is gone.
cv::Mat patchOf(const View& view, const Plane& plane);

/// Mean correlation of the best half of the patch's blocks (the other half may be hidden). -1 to 1; 1 without
/// a patch.
double patchCorrelation(const cv::Mat& patch, const cv::Point2f& planeSize, const cv::Mat& grey,
                        const cv::Matx33d& planeToFrame);

} // namespace farol::recognition
