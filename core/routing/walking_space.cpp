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
    if (contains(polygon, p)) return p;
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
    m_open = m_corners.empty() && m_polygon.holes.empty() && m_polygon.outer.size() > 2 &&
             simplyTurned(m_polygon.outer);
    m_visible.resize(m_corners.size());
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        for (std::size_t j = i + 1; j < m_corners.size(); ++j) {
            if (!m_corners[i].worthGoing(m_corners[j].position) ||
                !m_corners[j].worthGoing(m_corners[i].position) ||
                !sees(m_corners[i].position, m_corners[j].position))
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

bool WalkingSpace::sees(Point2 a, Point2 b) const {
    Point2 way = b - a;
    double whole = length(way);
    if (whole <= kTouch || m_open) return true;
    Point2 direction = way * (1.0 / whole);
    std::vector<double> touches{0.0, whole};
    bool crossed = false;
    forEachEdge(m_polygon, [&](Point2 c, Point2 d) {
        if (crossed) return;
        double sideC = cross(direction, c - a);
        double sideD = cross(direction, d - a);
        double along = dot(direction, c - a);
        if (std::abs(sideC) <= kTouch) {
            if (along > 0.0 && along < whole) touches.push_back(along);
            return;
        }
        if (std::abs(sideD) <= kTouch || (sideC > 0.0) == (sideD > 0.0)) return;
        Point2 edge = d - c;
        double size = length(edge);
        double sideA = cross(edge, a - c) / size;
        double sideB = cross(edge, b - c) / size;
        crossed = (sideA > kTouch && sideB < -kTouch) || (sideA < -kTouch && sideB > kTouch);
    });
    if (crossed) return false;
    // Nothing is crossed, but corners may be touched: between two of them one is either inside or outside.
    std::sort(touches.begin(), touches.end());
    for (std::size_t i = 1; i < touches.size(); ++i) {
        if (touches[i] - touches[i - 1] <= 2.0 * kTouch) continue;
        Point2 middle = a + direction * ((touches[i] + touches[i - 1]) / 2.0);
        if (distanceToPolygon(m_polygon, middle) > kTouch) return false;
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
