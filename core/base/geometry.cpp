#include "core/base/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace farol {

double dot(Point2 a, Point2 b) {
    return a.x * b.x + a.y * b.y;
}
double cross(Point2 a, Point2 b) {
    return a.x * b.y - a.y * b.x;
}
double length(Point2 v) {
    return std::hypot(v.x, v.y);
}
double distance(Point2 a, Point2 b) {
    return length(b - a);
}
Radians directionOf(Point2 v) {
    return {v == Point2{} ? 0.0 : std::atan2(v.y, v.x)};
}
bool isFinite(Point2 p) {
    return std::isfinite(p.x) && std::isfinite(p.y);
}

double length(const Polyline& line) {
    double sum = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
    return sum;
}

double signedArea(const Ring& ring) {
    // Relative to the first vertex: map coordinates in millions would eat the digits otherwise.
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    return twice / 2.0;
}

double area(const Polygon& polygon) {
    double sum = std::abs(signedArea(polygon.outer));
    for (const Ring& hole : polygon.holes) sum -= std::abs(signedArea(hole));
    return sum;
}

namespace {

/// Adds the first moment of a ring relative to `origin`, weighted by `sign` times its absolute area.
void addMoment(const Ring& ring, Point2 origin, double sign, Point2& moment, double& weight) {
    double orientation = signedArea(ring) < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        Point2 a = ring[0] - origin;
        Point2 b = ring[i] - origin;
        Point2 c = ring[i + 1] - origin;
        double share = sign * orientation * cross(b - a, c - a) / 2.0;
        moment = moment + (a + b + c) * (share / 3.0);
        weight += share;
    }
}

template <class Visit>
void forEachEdge(const Ring& ring, Visit visit) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
}

bool onBorder(const Ring& ring, Point2 p) {
    constexpr double kOn = 1e-9;
    auto off = [](double at, double one, double other) {
        return at < std::min(one, other) - kOn || at > std::max(one, other) + kOn;
    };
    bool touches = false;
    forEachEdge(ring, [&](Point2 a, Point2 b) {
        // Most edges are far away, and there are many of them in a real plan.
        if (touches || off(p.x, a.x, b.x) || off(p.y, a.y, b.y)) return;
        touches = distanceToSegment(p, a, b) < kOn;
    });
    return touches;
}

bool insideRing(const Ring& ring, Point2 p) {
    bool inside = false;
    forEachEdge(ring, [&](Point2 a, Point2 b) {
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    });
    return inside;
}

/// The middle of the widest inside chord at height y, with the chord's width; width 0 when there is none.
std::pair<Point2, double> widestChord(const Polygon& polygon, double y) {
    std::vector<double> crossings;
    auto collect = [&](Point2 a, Point2 b) {
        if ((a.y > y) != (b.y > y)) crossings.push_back((b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x);
    };
    forEachEdge(polygon.outer, collect);
    for (const Ring& hole : polygon.holes) forEachEdge(hole, collect);
    std::sort(crossings.begin(), crossings.end());
    std::pair<Point2, double> best{{0.0, y}, 0.0};
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        double width = crossings[i + 1] - crossings[i];
        if (width > best.second) best = {{(crossings[i] + crossings[i + 1]) / 2.0, y}, width};
    }
    return best;
}

} // namespace

Point2 centroid(const Polygon& polygon) {
    if (polygon.outer.empty()) return {};
    Point2 origin = polygon.outer.front();
    Point2 moment;
    double weight = 0.0;
    addMoment(polygon.outer, origin, 1.0, moment, weight);
    for (const Ring& hole : polygon.holes) addMoment(hole, origin, -1.0, moment, weight);
    if (std::abs(weight) > 1e-12) return origin + moment * (1.0 / weight);
    Point2 sum; // a degenerate ring: the mean of its vertices
    for (Point2 p : polygon.outer) sum = sum + (p - origin);
    return origin + sum * (1.0 / static_cast<double>(polygon.outer.size()));
}

bool contains(const Polygon& polygon, Point2 p) {
    if (onBorder(polygon.outer, p)) return true;
    if (!insideRing(polygon.outer, p)) return false;
    return std::none_of(polygon.holes.begin(), polygon.holes.end(),
                        [&](const Ring& hole) { return insideRing(hole, p) && !onBorder(hole, p); });
}

Point2 pointInside(const Polygon& polygon) {
    Point2 centre = centroid(polygon);
    if (contains(polygon, centre)) return centre;
    auto box = boundingBox(polygon.outer);
    if (!box) return centre;
    std::pair<Point2, double> best = widestChord(polygon, centre.y);
    for (int step = 1; step < 8; ++step) {
        auto chord = widestChord(polygon, box->low.y + box->height() * (step - 0.5) / 7.0);
        if (chord.second > best.second) best = chord;
    }
    return best.second > 0.0 ? best.first : centre;
}

Point2 nearestOnSegment(Point2 p, Point2 a, Point2 b) {
    Point2 d = b - a;
    double squared = dot(d, d);
    if (squared <= 0.0) return a;
    return a + d * std::clamp(dot(p - a, d) / squared, 0.0, 1.0);
}

double distanceToSegment(Point2 p, Point2 a, Point2 b) {
    return distance(p, nearestOnSegment(p, a, b));
}

double distanceToPolygon(const Polygon& polygon, Point2 p) {
    if (contains(polygon, p)) return 0.0;
    double best = std::numeric_limits<double>::infinity();
    auto measure = [&](Point2 a, Point2 b) { best = std::min(best, distanceToSegment(p, a, b)); };
    forEachEdge(polygon.outer, measure);
    for (const Ring& hole : polygon.holes) forEachEdge(hole, measure);
    return best;
}

std::optional<Box2> boundingBox(const Ring& points) {
    if (points.empty()) return std::nullopt;
    Box2 box{points.front(), points.front()};
    for (Point2 p : points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
}

bool segmentsCross(Point2 a, Point2 b, Point2 c, Point2 d) {
    auto side = [](Point2 p, Point2 q, Point2 r) { return cross(q - p, r - p); };
    double s1 = side(a, b, c);
    double s2 = side(a, b, d);
    double s3 = side(c, d, a);
    double s4 = side(c, d, b);
    return ((s1 > 0.0 && s2 < 0.0) || (s1 < 0.0 && s2 > 0.0)) &&
           ((s3 > 0.0 && s4 < 0.0) || (s3 < 0.0 && s4 > 0.0));
}

ImageBox boundingBox(const Quad& quad) {
    ImagePoint low = quad[0];
    ImagePoint high = quad[0];
    for (ImagePoint p : quad) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return {low.x, low.y, high.x - low.x, high.y - low.y};
}

Quad quadOf(const ImageBox& box) {
    return {ImagePoint{box.x, box.y}, ImagePoint{box.x + box.width, box.y},
            ImagePoint{box.x + box.width, box.y + box.height}, ImagePoint{box.x, box.y + box.height}};
}

double overlap(const ImageBox& a, const ImageBox& b) {
    double width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
    double height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
    if (width <= 0.0 || height <= 0.0) return 0.0;
    double common = width * height;
    return common / (a.area() + b.area() - common);
}

} // namespace farol
