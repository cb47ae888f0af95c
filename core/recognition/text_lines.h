#pragma once
// Where single lines of text may stand: in rectified plates, and in the open picture. Only this folder
// includes it.

#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <vector>

namespace farol::recognition {

/// The picture inside the quad, seen squarely, `height` pixels high (and at most `widest` wide).
cv::Mat rectified(const cv::Mat& grey, const Quad& quad, int height, int widest = 1600);
/// The rows of dark ink in a plate of light ground: top and bottom of each line, in the plate's pixels.
std::vector<cv::Range> inkRows(const cv::Mat& plate);
/// Dark letters on light ground, whatever it was: by what lies along the border.
cv::Mat darkOnLight(const cv::Mat& grey);
/// Groups of letter-like regions that stand in a line, best first.
std::vector<Quad> lettersInLines(const cv::Mat& grey, int fewestLetters);

} // namespace farol::recognition
