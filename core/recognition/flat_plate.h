#pragma once
// Plates made flat and dark on light. Only this folder includes it.

#include "core/base/geometry.h"

#include <opencv2/core.hpp>

namespace farol::recognition {

/// The picture inside the quad, seen squarely, `height` pixels high (and at most `widest` wide).
cv::Mat rectified(const cv::Mat& grey, const Quad& quad, int height, int widest = 1600);
/// Dark letters on light ground, whatever it was: by what covers more of it.
cv::Mat darkOnLight(const cv::Mat& grey);

} // namespace farol::recognition
