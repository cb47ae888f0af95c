#pragma once
// Upright boxes as detectors that answer with boxes need them. Only this folder includes it.

#include "core/base/geometry.h"

#include <algorithm>

namespace farol::recognition {

/// How much of the smaller box lies in the other, 0 to 1.
inline double shareInside(const ImageBox& a, const ImageBox& b) {
    double width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
    double height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
    double least = std::min(a.width * a.height, b.width * b.height);
    return width > 0.0 && height > 0.0 && least > 0.0 ? width * height / least : 0.0;
}

} // namespace farol::recognition
