#pragma once
// What every detector does first with a picture. Only this folder includes it.

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace farol::recognition {

/// 8-bit grey of an 8- or 16-bit picture with 1, 3 or 4 channels; empty for anything else.
cv::Mat greyOf(const cv::Mat& image);
/// 8-bit BGR of the same; empty for anything else.
cv::Mat colourOf(const cv::Mat& image);
/// Reduced until the longer side is at most `longSide` (never enlarged); `scale` is new over old.
cv::Mat reduced(const cv::Mat& image, int longSide, double& scale);

} // namespace farol::recognition
