#pragma once
// Areas of lines that are walked along: strips of a width, for networks and steps that are drawn as lines.

#include "core/base/geometry.h"

#include <optional>
#include <utility>
#include <vector>

namespace farol::building {

Point2 unitVector(Point2 v); ///< the null vector stays
Polygon octagon(Point2 at, double radius);
/// The first half of the line, and the direction in which it is cut.
std::pair<Polyline, Point2> firstHalf(const Polyline& line);
/// Rectangles along the line and a joint at each inner vertex; the ends are straight.
void appendStrip(const Polyline& line, double halfWidth, std::vector<Polygon>& strips);
/// What the strips cover together; the largest part when they do not hang together.
std::optional<Polygon> joinedStrips(const std::vector<Polygon>& strips);

} // namespace farol::building
