#pragma once
// The blur gate: recognition and reading run on sharp frames only.

#include <opencv2/core.hpp>

namespace farol::recognition {

/// Root mean square of the Laplacian over a picture reduced to 320 px wide, in grey levels: blank walls and
/// smeared frames score low. 8-bit BGR or grey.
double sharpness(const cv::Mat& image);

} // namespace farol::recognition
