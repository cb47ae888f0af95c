#include "core/routing/corridor_axis.h"

#include <algorithm>
#include <cmath>

namespace farol::routing {

namespace {

constexpr double kLeastElongation = 2.0;
constexpr double kWidestM = 4.0;
constexpr double kLeastFilled = 0.85; // of the enclosing rectangle: door niches and columns are let pass
const double kAlong = std::cos(kPi / 4.0);

} // namespace

std::optional<Point2> corridorAxis(const Polygon& polygon) {
    const Ring& ring = polygon.outer;
    Point2 longest;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Point2 edge = ring[(i + 1) % ring.size()] - ring[i];
        if (length(edge) > length(longest)) longest = edge;
    }
    if (length(longest) <= 0.0) return std::nullopt;
    Point2 axis = longest * (1.0 / length(longest));
    Point2 across{-axis.y, axis.x};
    double low = 0.0, high = 0.0, left = 0.0, right = 0.0;
    for (Point2 p : ring) {
        Point2 d = p - ring.front();
        low = std::min(low, dot(d, axis));
        high = std::max(high, dot(d, axis));
        right = std::min(right, dot(d, across));
        left = std::max(left, dot(d, across));
    }
    double along = high - low, width = left - right;
    bool filled = std::abs(signedArea(ring)) >= kLeastFilled * along * width;
    if (!filled || width > kWidestM || along < kLeastElongation * width) return std::nullopt;
    return axis;
}

Point2 walkingDirection(const Polygon& polygon, Point2 path) {
    auto axis = corridorAxis(polygon);
    if (!axis) return path;
    double along = dot(path, *axis);
    if (std::abs(along) < kAlong * length(path)) return path;
    return along > 0.0 ? *axis : *axis * -1.0;
}

} // namespace farol::routing
