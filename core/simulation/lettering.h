#pragma once
// Pictures that carry letters or signs.

#include <opencv2/core.hpp>

#include <cstdint>
#include <string>

namespace farol::simulation {

/// The file of the font that comes nearest to a fontconfig name such as "DejaVu Sans:bold"; empty where there
/// is none.
std::string fontFile(const char* name);

enum class Face { Sans, Bold, Condensed, Serif };

/// White letters on black, cut to their ink, about `pixels` tall; empty for a text without ink.
cv::Mat inkOf(const std::string& text, Face face, int pixels);
/// Paints the text into `box`, as large as fits, in BGR; lines are parted by '\n'.
void write(cv::Mat& picture, const std::string& text, Face face, const cv::Rect& box,
           const cv::Scalar& colour);

/// What hangs above a lift's door.
cv::Mat floorDisplay(const std::string& ref);

} // namespace farol::simulation
