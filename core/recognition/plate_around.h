#pragma once
// The plate that a line of letters stands on, by its ground: what has the ground's brightness around the
// letters and ends on all sides in a quadrilateral. Only this folder includes it.

#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <optional>

namespace farol::recognition {

/// `line` holds letters with a margin. Empty where the ground goes on (letters on a wall or on glass), where
/// it is no quadrilateral, or where it leaves the picture. Corners clockwise from the upper left.
std::optional<Quad> plateAround(const cv::Mat& grey, const Quad& line, bool lightInk);

} // namespace farol::recognition
