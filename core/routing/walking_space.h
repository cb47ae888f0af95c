#pragma once
// Walking inside one region: shortest paths within its polygon, round corners and columns, never through
// walls.

#include "core/base/geometry.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace farol::routing {

/// The point itself, or its nearest point on the border when it lies outside.
Point2 nearestWithin(const Polygon& polygon, Point2 p);

/// A visibility graph over the corners one may have to walk round. Points outside the polygon (a door drawn
/// in the middle of a thick wall) are reached from their nearest point on its border.
class WalkingSpace {
public:
    explicit WalkingSpace(const Polygon& polygon);

    /// A corner one may have to walk round, with the ends of its two walls. Map coordinates.
    struct Corner {
        Point2 position;
        Point2 before;
        Point2 after;
        /// A shortest way bends here only where it touches: both walls on one side of the line from `other`.
        bool worthGoing(Point2 other) const;
    };

    /// The point itself, or its nearest point on the border when it lies outside.
    Point2 entryOf(Point2 p) const { return nearestWithin(m_polygon, p - m_origin) + m_origin; }
    /// Does the straight line between two points of the region stay in it?
    bool clear(Point2 a, Point2 b) const { return sees(a - m_origin, b - m_origin); }
    std::vector<Corner> corners() const;
    /// Is all of it seen from everywhere in it?
    bool open() const { return m_open; }

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
    struct Way {
        Point2 exit;
        std::size_t last = kNone; ///< the corner before `exit`
        double length = 0.0;
    };

    /// `blocker`: an edge that is tried first, and the one that was in the way.
    bool sees(Point2 a, Point2 b, std::size_t* blocker = nullptr) const;
    Way wayTo(const Tree& tree, Point2 target) const;

    Polygon m_polygon; ///< relative to m_origin, free space to the left of every edge
    Point2 m_origin;   ///< map coordinates in millions would eat the digits
    std::vector<std::pair<Point2, Point2>> m_edges; ///< of m_polygon
    std::vector<Corner> m_corners;                  ///< relative to m_origin
    std::vector<std::vector<std::size_t>> m_visible;
    bool m_open = false; ///< convex, without holes: from everywhere one sees everything
};

} // namespace farol::routing
