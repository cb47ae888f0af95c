#include "core/simulation/plan_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace farol::simulation {

namespace {

constexpr double kSame = 1.0e-3;

Ring tidiedRing(const Ring& ring, bool counterClockwise) {
    Ring out;
    for (Point2 p : ring)
        if (isFinite(p) && (out.empty() || distance(out.back(), p) > kSame)) out.push_back(p);
    while (out.size() > 1 && distance(out.front(), out.back()) <= kSame) out.pop_back();
    if (out.size() < 3 || std::abs(signedArea(out)) < 1.0e-4) return {};
    if ((signedArea(out) > 0.0) != counterClockwise) std::reverse(out.begin(), out.end());
    return out;
}

template <class Visit>
void eachEdge(const Polygon& polygon, const Visit& visit) {
    auto walk = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
    };
    walk(polygon.outer);
    for (const Ring& hole : polygon.holes) walk(hole);
}

Ring clippedRing(const Ring& ring, Point2 onLine, Point2 keep) {
    Ring out;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
        double da = dot(a - onLine, keep), db = dot(b - onLine, keep);
        if (da >= 0.0) out.push_back(a);
        if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) out.push_back(a + (b - a) * (da / (da - db)));
    }
    return out;
}

struct Crossing {
    double low = 0.0, high = 0.0; ///< x at the lower and the upper line of the band
};

} // namespace

Polygon tidied(const Polygon& polygon) {
    Polygon out{tidiedRing(polygon.outer, true), {}};
    if (out.outer.empty()) return {};
    for (const Ring& hole : polygon.holes) {
        Ring tidy = tidiedRing(hole, false);
        if (!tidy.empty()) out.holes.push_back(std::move(tidy));
    }
    return out;
}

Point2 mainDirection(const Polygon& polygon) {
    // Directions that differ by a right angle count as one: both are walls of one room.
    std::map<int, double> metres;
    constexpr double kQuarter = 1.57079632679489662;
    constexpr int kBins = 90;
    eachEdge(polygon, [&](Point2 a, Point2 b) {
        double angle = std::atan2(b.y - a.y, b.x - a.x);
        double share = angle / kQuarter - std::floor(angle / kQuarter);
        metres[static_cast<int>(std::lround(share * kBins)) % kBins] += distance(a, b);
    });
    int best = 0;
    for (const auto& [bin, sum] : metres)
        if (sum > metres[best] + 1.0e-9) best = bin;
    // The exact direction of the longest edge of that bin; of two square ones the longer.
    Point2 direction{1.0, 0.0};
    double longest = 0.0;
    eachEdge(polygon, [&](Point2 a, Point2 b) {
        double angle = std::atan2(b.y - a.y, b.x - a.x);
        double share = angle / kQuarter - std::floor(angle / kQuarter);
        double size = distance(a, b);
        if (static_cast<int>(std::lround(share * kBins)) % kBins != best || size <= longest + 1.0e-6) return;
        longest = size;
        direction = (b - a) * (1.0 / size);
    });
    return direction.x < -1.0e-9 || (std::abs(direction.x) <= 1.0e-9 && direction.y < 0.0) ? direction * -1.0
                                                                                           : direction;
}

std::vector<Band> bandsOf(const Polygon& polygon, Point2 axis, double overlap) {
    Point2 up{-axis.y, axis.x};
    auto turned = [&](Point2 p) { return Point2{dot(p, axis), dot(p, up)}; };
    auto back = [&](double x, double y) { return axis * x + up * y; };
    std::vector<std::pair<Point2, Point2>> edges;
    std::vector<double> lines;
    eachEdge(polygon, [&](Point2 a, Point2 b) {
        Point2 p = turned(a), q = turned(b);
        if (p.y > q.y) std::swap(p, q);
        edges.emplace_back(p, q);
        lines.push_back(p.y);
        lines.push_back(q.y);
    });
    std::sort(lines.begin(), lines.end());
    lines.erase(std::unique(lines.begin(), lines.end(), [](double a, double b) { return b - a < kSame; }),
                lines.end());
    std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first.y < b.first.y; });
    std::vector<Band> bands;
    std::vector<std::size_t> active; // edges that reach into the band
    std::size_t next = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        double low = lines[i - 1], high = lines[i], middle = (low + high) / 2;
        while (next < edges.size() && edges[next].first.y <= middle) active.push_back(next++);
        std::erase_if(active, [&](std::size_t edge) { return edges[edge].second.y < middle; });
        std::vector<Crossing> crossings;
        for (std::size_t edge : active) {
            const auto& [p, q] = edges[edge];
            if (q.y - p.y < kSame / 2) continue;
            double slope = (q.x - p.x) / (q.y - p.y);
            crossings.push_back({p.x + (low - p.y) * slope, p.x + (high - p.y) * slope});
        }
        std::sort(crossings.begin(), crossings.end(),
                  [](const Crossing& a, const Crossing& b) { return a.low + a.high < b.low + b.high; });
        for (std::size_t k = 1; k < crossings.size(); k += 2) {
            const Crossing &left = crossings[k - 1], &right = crossings[k];
            bands.push_back(
                {back(left.high - overlap, high + overlap), back(right.high + overlap, high + overlap),
                 back(right.low + overlap, low - overlap), back(left.low - overlap, low - overlap)});
        }
    }
    return bands;
}

Polygon clipped(const Polygon& polygon, Point2 onLine, Point2 keep) {
    Polygon out{clippedRing(polygon.outer, onLine, keep), {}};
    for (const Ring& hole : polygon.holes) out.holes.push_back(clippedRing(hole, onLine, keep));
    return tidied(out);
}

std::vector<BorderEdge> bordersOf(const Polygon& tidy, double inset) {
    std::vector<BorderEdge> edges;
    auto add = [&](const Ring& ring) {
        std::size_t count = ring.size();
        auto alongOf = [&](std::size_t i) {
            Point2 step = ring[(i + 1) % count] - ring[i];
            return step * (1.0 / length(step));
        };
        for (std::size_t i = 0; i < count; ++i) {
            BorderEdge edge;
            edge.a = ring[i];
            edge.b = ring[(i + 1) % count];
            edge.length = distance(edge.a, edge.b);
            edge.along = alongOf(i);
            edge.inward = {-edge.along.y, edge.along.x};
            edge.inset = inset;
            // Walls meet where both faces do: tan of half the turn, times the inset.
            auto mitre = [&](Point2 before, Point2 after) {
                double turn = std::atan2(cross(before, after), dot(before, after));
                return inset * std::tan(std::clamp(turn, -2.6, 2.6) / 2);
            };
            edge.from = mitre(alongOf((i + count - 1) % count), edge.along);
            edge.to = edge.length - mitre(edge.along, alongOf((i + 1) % count));
            edges.push_back(edge);
        }
    };
    add(tidy.outer);
    for (const Ring& hole : tidy.holes) add(hole);
    return edges;
}

} // namespace farol::simulation
