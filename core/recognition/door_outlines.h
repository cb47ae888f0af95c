#pragma once
// Outlines made of two jambs, a lintel and a foot, as they are met among a picture's edges. Only this folder
// includes it.

#include "core/recognition/door_cues.h"
#include "core/recognition/edge_lines.h"

namespace farol::recognition {

/// In the pixels of the reduced picture that the edges come from.
struct DoorOutline {
    std::array<cv::Point2d, 4> quad; ///< clockwise from the top left
    bool topSeen = true, footSeen = true;
    double leftJamb = 0.0, rightJamb = 0.0, lintel = 0.0, foot = 0.0; ///< shares that are really edge

    double width() const;
    double height() const;
    double outlined() const { return leftJamb + rightJamb + lintel + 0.5 * foot; }
};

/// The best outlined first, near copies removed.
std::vector<DoorOutline> doorOutlines(const EdgeField& field, const DoorCueOptions& options);

} // namespace farol::recognition
