#pragma once
// Walking inside one region: shortest paths within its polygon, round corners and columns, never through
// walls.

#include "core/base/geometry.h"

#include <cstddef>
#include <vector>

namespace farol::routing {

/// A visibility graph over the corners one may have to walk round. Points outside the polygon (a door drawn
/// in the middle of a thick wall) are reached from their nearest point on its border.
class WalkingSpace {
public:
    explicit WalkingSpace(const Polygon& polygon);

    /// Shortest ways from one point to every corner.
    struct Tree {
        Point2 source;
        Point2 entry; ///< `source`, or its nearest point on the border
        std::vector<double> cost;
        std::vector<std::size_t> previous; ///< kNone: straight from `entry`
    };

    Tree from(Point2 source) const;
    double lengthTo(const Tree& tree, Point2 target) const;
    /// From the source to the target, both included. A straight line where the polygon is broken.
    Polyline pathTo(const Tree& tree, Point2 target) const;

    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

private:
    struct Corner {
        Point2 position;
        Point2 before;
        Point2 after;
    };
    struct Way {
        Point2 exit;
        std::size_t last = kNone; ///< the corner before `exit`
        double length = 0.0;
    };

    bool sees(Point2 a, Point2 b) const;
    bool worthGoing(const Corner& corner, Point2 other) const;
    Point2 inside(Point2 p) const;
    Way wayTo(const Tree& tree, Point2 target) const;

    Polygon m_polygon; ///< relative to m_origin, free space to the left of every edge
    Point2 m_origin;   ///< map coordinates in millions would eat the digits
    std::vector<Corner> m_corners;
    std::vector<std::vector<std::size_t>> m_visible;
};

} // namespace farol::routing
