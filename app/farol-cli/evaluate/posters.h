#pragma once
// Drawn posters: templates of which there are as many as wanted, the same on every machine.

#include <opencv2/core.hpp>

namespace farol::cli {

/// Number `number` of the drawn posters, 8-bit BGR, 400 pixels on the longer side.
cv::Mat drawnPoster(int number);

} // namespace farol::cli
