#include "core/routing/walking_space.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace farol::routing {

namespace {

constexpr double kTouch = 1e-6; // metres within which a point lies on a line
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Without repeated corners, free space on the left: counter-clockwise outside, clockwise round holes.
Ring prepared(const Ring& ring, Point2 origin, bool counterClockwise) {
    Ring points;
    for (Point2 p : ring)
        if (points.empty() || distance(points.back(), p - origin) > kTouch) points.push_back(p - origin);
    while (points.size() > 1 && distance(points.front(), points.back()) <= kTouch) points.pop_back();
    if ((signedArea(points) > 0.0) != counterClockwise) std::reverse(points.begin(), points.end());
    return points;
}

template <class Visit>
void forEachEdge(const Polygon& polygon, Visit visit) {
    auto around = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
    };
    around(polygon.outer);
    for (const Ring& hole : polygon.holes) around(hole);
}

/// Well within? Points near the border may be told either way.
bool surelyInside(const Polygon& polygon, Point2 p) {
    bool inside = false;
    forEachEdge(polygon, [&](Point2 a, Point2 b) {
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    });
    return inside;
}

/// Does a ring without a right turn go round once only? (A star of five points turns left throughout.)
bool simplyTurned(const Ring& ring) {
    double turned = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Point2 in = ring[(i + 1) % ring.size()] - ring[i];
        Point2 out = ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
        turned += std::atan2(cross(in, out), dot(in, out));
    }
    return turned < 3.0 * kPi;
}

} // namespace

Point2 nearestWithin(const Polygon& polygon, Point2 p) {
    if (surelyInside(polygon, p) || contains(polygon, p)) return p;
    Point2 best = p;
    double nearest = kInfinity;
    forEachEdge(polygon, [&](Point2 a, Point2 b) {
        Point2 candidate = nearestOnSegment(p, a, b);
        double gap = distance(p, candidate);
        if (gap >= nearest) return;
        nearest = gap;
        best = candidate;
    });
    return best;
}

WalkingSpace::WalkingSpace(const Polygon& polygon)
    : m_origin(polygon.outer.empty() ? Point2{} : polygon.outer[0]) {
    m_polygon.outer = prepared(polygon.outer, m_origin, true);
    for (const Ring& hole : polygon.holes) m_polygon.holes.push_back(prepared(hole, m_origin, false));
    auto collect = [&](const Ring& ring) {
        for (std::size_t i = 0; ring.size() > 2 && i < ring.size(); ++i) {
            Corner corner{ring[i], ring[(i + ring.size() - 1) % ring.size()], ring[(i + 1) % ring.size()]};
            if (cross(corner.position - corner.before, corner.after - corner.position) < 0.0)
                m_corners.push_back(corner);
        }
    };
    collect(m_polygon.outer);
    for (const Ring& hole : m_polygon.holes) collect(hole);
    forEachEdge(m_polygon, [&](Point2 a, Point2 b) { m_edges.emplace_back(a, b); });
    m_open = m_corners.empty() && m_polygon.holes.empty() && m_polygon.outer.size() > 2 &&
             simplyTurned(m_polygon.outer);
    m_visible.resize(m_corners.size());
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        std::size_t blocker = m_edges.size(); // corners side by side are mostly hidden by one edge
        for (std::size_t j = i + 1; j < m_corners.size(); ++j) {
            if (!m_corners[i].worthGoing(m_corners[j].position) ||
                !m_corners[j].worthGoing(m_corners[i].position) ||
                !sees(m_corners[i].position, m_corners[j].position, &blocker))
                continue;
            m_visible[i].push_back(j);
            m_visible[j].push_back(i);
        }
    }
}

bool WalkingSpace::Corner::worthGoing(Point2 other) const {
    Point2 way = position - other;
    double reach = kTouch * length(way);
    double sideBefore = cross(way, before - position);
    double sideAfter = cross(way, after - position);
    return !(sideBefore > reach && sideAfter < -reach) && !(sideBefore < -reach && sideAfter > reach);
}

std::vector<WalkingSpace::Corner> WalkingSpace::corners() const {
    std::vector<Corner> moved = m_corners;
    for (Corner& each : moved) {
        each.position = each.position + m_origin;
        each.before = each.before + m_origin;
        each.after = each.after + m_origin;
    }
    return moved;
}

namespace {

/// A straight line from `a`, and how an edge lies to it.
struct Line {
    Point2 a, b, direction;
    double whole;

    bool crossedBy(Point2 c, Point2 d) const {
        double sideC = cross(direction, c - a);
        double sideD = cross(direction, d - a);
        if (std::abs(sideC) <= kTouch || std::abs(sideD) <= kTouch || (sideC > 0.0) == (sideD > 0.0))
            return false;
        Point2 edge = d - c;
        double reach = kTouch * length(edge);
        double sideA = cross(edge, a - c);
        double sideB = cross(edge, b - c);
        return (sideA > reach && sideB < -reach) || (sideA < -reach && sideB > reach);
    }
    /// Where it touches the beginning of an edge, as metres from `a`; 0 where it does not.
    double touching(Point2 c) const {
        double along = dot(direction, c - a);
        return std::abs(cross(direction, c - a)) <= kTouch && along > 0.0 && along < whole ? along : 0.0;
    }
};

} // namespace

bool WalkingSpace::sees(Point2 a, Point2 b, std::size_t* blocker) const {
    double whole = distance(a, b);
    if (whole <= kTouch || m_open) return true;
    Point2 direction = (b - a) * (1.0 / whole);
    Line line{a, b, direction, whole};
    if (blocker != nullptr && *blocker < m_edges.size() &&
        line.crossedBy(m_edges[*blocker].first, m_edges[*blocker].second))
        return false;
    std::vector<double> touches; // seldom any
    for (std::size_t i = 0; i < m_edges.size(); ++i) {
        if (line.crossedBy(m_edges[i].first, m_edges[i].second)) {
            if (blocker != nullptr) *blocker = i;
            return false;
        }
        double along = line.touching(m_edges[i].first);
        if (along > 0.0) touches.push_back(along);
    }
    // Nothing is crossed, but corners may be touched: between two of them one is either inside or outside.
    std::sort(touches.begin(), touches.end());
    double before = 0.0;
    for (std::size_t i = 0; i <= touches.size(); ++i) {
        double next = i < touches.size() ? touches[i] : whole;
        double low = std::exchange(before, next);
        if (next - low <= 2.0 * kTouch) continue;
        Point2 middle = a + direction * ((low + next) / 2.0);
        if (!surelyInside(m_polygon, middle) && distanceToPolygon(m_polygon, middle) > kTouch) return false;
    }
    return true;
}

WalkingSpace::Tree WalkingSpace::from(Point2 source) const {
    Tree tree;
    tree.source = source - m_origin;
    tree.entry = nearestWithin(m_polygon, tree.source);
    tree.cost.assign(m_corners.size(), kInfinity);
    tree.previous.assign(m_corners.size(), kNone);
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        if (!m_corners[i].worthGoing(tree.entry) || !sees(tree.entry, m_corners[i].position)) continue;
        tree.cost[i] = distance(tree.entry, m_corners[i].position);
        open.emplace(tree.cost[i], i);
    }
    while (!open.empty()) {
        auto [cost, at] = open.top();
        open.pop();
        if (cost > tree.cost[at]) continue;
        for (std::size_t next : m_visible[at]) {
            double longer = cost + distance(m_corners[at].position, m_corners[next].position);
            if (longer >= tree.cost[next]) continue;
            tree.cost[next] = longer;
            tree.previous[next] = at;
            open.emplace(longer, next);
        }
    }
    return tree;
}

WalkingSpace::Way WalkingSpace::wayTo(const Tree& tree, Point2 target) const {
    Way best;
    best.exit = nearestWithin(m_polygon, target);
    best.length = distance(tree.entry, best.exit);
    double ends = distance(tree.source, tree.entry) + distance(best.exit, target);
    if (!sees(tree.entry, best.exit)) {
        double shortest = kInfinity;
        for (std::size_t i = 0; i < m_corners.size(); ++i) {
            double whole = tree.cost[i] + distance(m_corners[i].position, best.exit);
            if (whole >= shortest || !sees(m_corners[i].position, best.exit)) continue;
            shortest = whole;
            best.last = i;
        }
        if (best.last != kNone) best.length = shortest;
    }
    best.length += ends;
    return best;
}

double WalkingSpace::lengthTo(const Tree& tree, Point2 target) const {
    return wayTo(tree, target - m_origin).length;
}

Polyline WalkingSpace::pathTo(const Tree& tree, Point2 target) const {
    Point2 local = target - m_origin;
    Way way = wayTo(tree, local);
    Polyline backwards{local};
    auto add = [&](Point2 p) {
        if (distance(backwards.back(), p) > kTouch) backwards.push_back(p);
    };
    add(way.exit);
    for (std::size_t at = way.last; at != kNone; at = tree.previous[at]) add(m_corners[at].position);
    add(tree.entry);
    add(tree.source);
    std::reverse(backwards.begin(), backwards.end());
    for (Point2& p : backwards) p = p + m_origin;
    // The ends exactly as they were given, without the rounding of the shift.
    backwards.back() = target;
    if (backwards.size() > 1) backwards.front() = tree.source + m_origin;
    return backwards;
}

} // namespace farol::routing
