#include "core/guidance/on_the_way.h"

#include "core/routing/door_count.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace farol::guidance {

using building::Access;
using building::Landmark;
using routing::Manoeuvre;
using routing::ManoeuvreKind;
using routing::Side;

namespace {

constexpr double kMostAsideM = 2.5;  // further from the way nobody touches a thing
constexpr double kLongestGapM = 3.0; // from the thing to the manoeuvre
constexpr double kLeastGapM = 0.4;   // below, "after" says nothing
constexpr double kLeastAheadM = 1.0; // and as much more as the position is vague
constexpr double kStraightAsideM = 0.5;
constexpr double kBesideM = 0.5; // a door this near beside one may be taken for passed or for the next
constexpr double kBehindM = 2.0; // a second one this near behind may be the one that is found

bool isFelt(Kind kind) {
    switch (kind) {
    case Kind::Extinguisher:
    case Kind::Fountain:
    case Kind::Hydrant:
    case Kind::VendingMachine:
    case Kind::Bin:
    case Kind::Plant:
    case Kind::Locker:
        return true;
    default:
        return false;
    }
}

/// Positions along and beside the straight line from the user to the manoeuvre.
struct Line {
    Point2 from;
    Point2 unit;
    double size = 0.0;

    double along(Point2 p) const { return dot(p - from, unit); }
    double aside(Point2 p) const { return cross(unit, p - from); } ///< left is positive
};

std::optional<Line> lineTo(const Manoeuvre& manoeuvre, Point2 here) {
    Point2 way = manoeuvre.position - here;
    double size = length(way);
    if (!(size > kLeastGapM)) return std::nullopt;
    return Line{here, way * (1.0 / size), size};
}

bool doorBetween(const building::Building& building, std::size_t region, const Manoeuvre& manoeuvre,
                 const Line& line, double after) {
    if (manoeuvre.kind == ManoeuvreKind::Turn) return false;
    for (std::size_t index : building.accessesOf(region)) {
        const Access& access = building.accesses()[index];
        if (access.id == manoeuvre.access || access.line.empty()) continue;
        double at = line.along(access.midpoint());
        if (at > after - kLeastGapM && at < line.size + kLeastGapM) return true;
    }
    return false;
}

} // namespace

int countedFrom(const building::Building& building, const Manoeuvre& manoeuvre, Point2 here, double sigmaM) {
    auto region = building.regionIndex(manoeuvre.from);
    const Access* access = building.access(manoeuvre.access);
    auto line = lineTo(manoeuvre, here);
    if (!region || access == nullptr || !line || manoeuvre.side == Side::None) return 0;
    int number = 0;
    for (double off : {0.0, -sigmaM - kBesideM, sigmaM}) {
        auto count = routing::countDoors(building, *region, *access, here + line->unit * off);
        if (!count) {
            if (off > 0.0) continue; // so near already that there is nothing to count
            return 0;
        }
        if (count->left != (manoeuvre.side == Side::Left)) return 0;
        if (number != 0 && count->number != number) return 0;
        number = count->number;
    }
    return number;
}

std::optional<Mark> markBefore(const building::Building& building, const Manoeuvre& manoeuvre, Point2 here,
                               double sigmaM) {
    auto region = building.regionIndex(manoeuvre.from);
    auto line = lineTo(manoeuvre, here);
    if (!region || !line || !std::isfinite(sigmaM)) return std::nullopt;
    const Landmark* best = nullptr;
    for (std::size_t index : building.landmarksOf(*region)) {
        const Landmark& landmark = building.landmarks()[index];
        if (!isFelt(landmark.kind) || landmark.level != manoeuvre.level) continue;
        double at = line->along(landmark.position), gap = line->size - at;
        bool fits = at >= kLeastAheadM + sigmaM && gap >= kLeastGapM && gap <= kLongestGapM &&
                    std::abs(line->aside(landmark.position)) <= kMostAsideM;
        if (fits && (best == nullptr || at > line->along(best->position))) best = &landmark;
    }
    if (best == nullptr || doorBetween(building, *region, manoeuvre, *line, line->along(best->position)))
        return std::nullopt;
    for (std::size_t index : building.landmarksOf(*region)) {
        const Landmark& other = building.landmarks()[index];
        double at = line->along(other.position);
        if (&other != best && other.kind == best->kind && at > -kBehindM && at < line->size + kLongestGapM)
            return std::nullopt;
    }
    double aside = line->aside(best->position);
    Side side = std::abs(aside) < kStraightAsideM ? Side::None : aside > 0.0 ? Side::Left : Side::Right;
    return Mark{best->kind, side == manoeuvre.side ? Side::None : side};
}

std::optional<Radians> wayDirection(const routing::Route& route, Point2 here, double level) {
    std::optional<Radians> direction;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < route.path.size(); ++i) {
        const routing::PathPoint &a = route.path[i - 1], &b = route.path[i];
        if (a.level != level || b.level != level || a.position == b.position) continue;
        double gap = distance(here, nearestOnSegment(here, a.position, b.position));
        if (gap >= nearest - 1e-9) continue;
        nearest = gap;
        direction = directionOf(b.position - a.position);
    }
    return direction;
}

} // namespace farol::guidance
