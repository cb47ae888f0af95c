#include "core/routing/wide_opening.h"

#include <algorithm>

namespace farol::routing {

using building::Access;
using building::AccessKind;

namespace {

constexpr double kWideOpeningM = 1.2;   // from here on one does not aim for the middle
constexpr double kOpeningMarginM = 0.4; // half a person, kept from the ends of a wide opening
constexpr double kOnBorderM = 0.3;      // a point with a width belongs to a border this near
constexpr double kStraightM = 1e-3;
constexpr double kTouch = 2e-6;

/// From one jamb to the other. An opening drawn as a point with a width lies along the border it stands on,
/// as far as that border goes.
Polyline widthLine(const Access& access, const Polygon& polygon) {
    if (access.line.size() != 1 || !access.widthM || *access.widthM < kWideOpeningM) return access.line;
    Polyline best = access.line;
    double nearest = kOnBorderM;
    auto visit = [&](Point2 a, Point2 b) {
        Point2 middle = access.line[0];
        double gap = distanceToSegment(middle, a, b);
        double whole = distance(a, b);
        if (gap >= nearest || whole < kWideOpeningM) return;
        nearest = gap;
        Point2 half = (b - a) * (*access.widthM / 2.0 / whole);
        Point2 shift = middle - nearestOnSegment(middle, a, b);
        best = {nearestOnSegment(middle - half, a, b) + shift, nearestOnSegment(middle + half, a, b) + shift};
    };
    auto around = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
    };
    around(polygon.outer);
    for (const Ring& hole : polygon.holes) around(hole);
    return best;
}

bool straight(const Polyline& line) {
    return std::all_of(line.begin(), line.end(), [&](Point2 p) {
        return distanceToSegment(p, line.front(), line.back()) <= kStraightM;
    });
}

} // namespace

Polyline walkableWidth(const Access& access, const Polygon& polygon) {
    if (access.kind != AccessKind::Opening) return {};
    Polyline line = widthLine(access, polygon);
    if (line.size() < 2 || !straight(line)) return {};
    double width = distance(line.front(), line.back());
    if (!(width >= kWideOpeningM)) return {};
    Point2 inset = (line.back() - line.front()) * (kOpeningMarginM / width);
    return {line.front() + inset, line.back() - inset};
}

std::optional<WideOpening> wideOpening(const Access& access, const Polygon& polygonA,
                                       const WalkingSpace& spaceA, const WalkingSpace& spaceB) {
    Polyline line = walkableWidth(access, polygonA);
    if (line.empty() || !isFinite(line[0]) || !isFinite(line[1])) return std::nullopt;
    WideOpening opening;
    for (std::size_t i = 0; i < 2; ++i) {
        opening.inFirst[i] = spaceA.entryOf(line[i]);
        opening.inSecond[i] = spaceB.entryOf(line[i]);
        opening.touching = opening.touching && distance(opening.inFirst[i], opening.inSecond[i]) <= kTouch;
    }
    Point2 along = line[1] - line[0];
    for (const Point2* side : {opening.inFirst, opening.inSecond})
        if (dot(side[1] - side[0], along) < 0.5 * dot(along, along)) return std::nullopt;
    return opening;
}

} // namespace farol::routing
