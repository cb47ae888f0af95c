#pragma once
// Lines of letters anywhere in a picture, dark on light or light on dark, by what stands out of its
// surroundings. Only this folder includes it.

#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <vector>

namespace farol::recognition {

struct InkLine {
    Quad quad{};
    int glyphs = 0;
    bool lightInk = false;
    double score = 0.0; ///< better lines first: contrast, evenness, length
};

/// A stencil's halves are one glyph. Best first; a single glyph is a line when nothing else stands near it.
std::vector<InkLine> inkLines(const cv::Mat& grey);

/// Boxes of the pieces of `ink` (8-bit, 0 or not), halves of stencilled letters joined, from left to right.
std::vector<cv::Rect> glyphBoxes(const cv::Mat& ink, int smallestArea);

} // namespace farol::recognition
