#pragma once
// The way one walks along a corridor: its long axis, whatever diagonal the shortest path takes through it.

#include "core/base/geometry.h"

#include <optional>

namespace farol::routing {

/// The unit vector along a corridor, of either sign. Empty for a region that is no corridor: not nearly a
/// rectangle, less than twice as long as wide, or wider than 4 m, so that nobody follows its walls.
std::optional<Point2> corridorAxis(const Polygon& polygon);

/// The walking direction in that region: along its axis when `path` is within 45 degrees of it, else `path`
/// itself.
Point2 walkingDirection(const Polygon& polygon, Point2 path);

} // namespace farol::routing
