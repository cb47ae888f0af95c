#pragma once
// One line of text made ready for reading: rectified, dark on light, without what does not belong to it.
// Only this folder includes it.

#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <optional>
#include <string>
#include <vector>

namespace farol::recognition {

struct LinePicture {
    Quad quad{};                            ///< of the line in the full picture
    cv::Mat picture;                        ///< 8-bit, dark letters on white, a white margin all around
    cv::Mat soft;                           ///< the same with grey edges: a second opinion for the reader
    int glyphs = 0;                         ///< letters and digits that stand apart, dots not counted
    int dots = 0;                           ///< points on the line's foot
    bool cutLeft = false, cutRight = false; ///< more ink of the line reaches the plate's side
    bool gap = false;                       ///< somewhere between the letters is room for a space
    double fill = 0.0;                      ///< share of the line's box that is ink
    int holes = 0;                          ///< closed rings of ink, as in 0, 4, 6, 8, 9
    double middle = 0.0;                    ///< share of ink in the innermost part of the box
    bool besideEdge = false;                ///< a post or frame that may hide a letter stands at an end
    bool alone = true;                      ///< nothing else is written or drawn beside the line
    double aspect = 0.0;                    ///< width over height
    double sharpness = 0.0; ///< steepness of the letters' edges against their contrast, see the source
    double contrast = 0.0;  ///< grey levels between ink and ground
    double letterPx = 0.0;  ///< the letters' height in the full picture
};

/// The lines of a plate, from top to bottom; `height` is that of the letters in the pictures made. A plate
/// without ink has none; ink that touches the plate's border (its frame, a shadow) is left out.
std::vector<LinePicture> linesOfPlate(const cv::Mat& grey, const Quad& plate, int height);

/// The line of letters at `quad`, which need not hold all of it: it is followed to both sides until its end,
/// and not beyond the plate where that is known. Empty where it is no line.
std::optional<LinePicture> wholeLine(const cv::Mat& grey, const Quad& quad, bool lightInk, int height,
                                     const std::optional<Quad>& plate = std::nullopt);

/// The quad drawn in (or out, for negative shares) by shares of its width and height on every side.
Quad drawnIn(const Quad& quad, double x, double y);

} // namespace farol::recognition
