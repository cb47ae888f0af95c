#pragma once
// Polygons of the plan in pieces that a renderer takes: flat bands for floors and ceilings, and straight
// walls a little inside the border, so that two regions on either side of one line each have a wall of their
// own.

#include "core/base/geometry.h"

#include <array>
#include <vector>

namespace farol::simulation {

/// Without repeated points; the outer ring counter-clockwise, holes clockwise: free space to the left of each
/// edge.
Polygon tidied(const Polygon& polygon);
/// The direction along which most of the border runs.
Point2 mainDirection(const Polygon& polygon);

/// Convex quads (clockwise from above) that together cover the polygon, holes left out; any polygon will do,
/// also one that crosses itself. `axis`: of unit length; bands run along it. Each is `overlap` larger all
/// round.
using Band = std::array<Point2, 4>;
std::vector<Band> bandsOf(const Polygon& polygon, Point2 axis, double overlap);

/// What lies on the side of the line that `keep` points to.
Polygon clipped(const Polygon& polygon, Point2 onLine, Point2 keep);

/// A straight piece of border and the wall in front of it.
struct BorderEdge {
    Point2 a, b;   ///< of the polygon
    Point2 along;  ///< unit, from a to b
    Point2 inward; ///< unit, into the region
    double length = 0.0;
    double from = 0.0, to = 0.0; ///< metres along, where the wall begins and ends; corners are mitred
    double inset = 0.0;          ///< of the wall's face from the border

    Point2 at(double metres, double depth) const { return a + along * metres + inward * depth; }
    double metresOf(Point2 p) const { return dot(p - a, along); }
};
std::vector<BorderEdge> bordersOf(const Polygon& tidy, double inset);

} // namespace farol::simulation
