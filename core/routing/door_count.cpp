#include "core/routing/door_count.h"

#include <cmath>
#include <utility>

namespace farol::routing {

using building::Access;
using building::AccessKind;

namespace {

constexpr double kOnWallM = 0.35;       // a door stands in a wall this near, which may be thick
constexpr double kLeastWayM = 1.5;      // shorter, nobody walks along a wall
constexpr double kFurthestAsideM = 3.0; // from a wall further off, its doors are not noticed
constexpr double kAlongWall = 0.7;      // cosine: a line that lies in its wall, about
constexpr double kHereM = 0.5;          // what is this near to where one sets out is behind one already

struct Wall {
    Point2 start;
    Point2 along; ///< free space to its left
};

/// The wall of the region that the access stands in.
std::optional<Wall> wallOf(const Polygon& polygon, const Access& access) {
    std::optional<Wall> best;
    double nearest = kOnWallM;
    Point2 middle = access.midpoint();
    auto around = [&](const Ring& ring, bool counterClockwise) {
        bool turned = (signedArea(ring) > 0.0) != counterClockwise;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
            double gap = distanceToSegment(middle, a, b);
            double size = distance(a, b);
            if (gap >= nearest || size <= 0.0) continue;
            nearest = gap;
            best = turned ? Wall{b, (a - b) * (1.0 / size)} : Wall{a, (b - a) * (1.0 / size)};
        }
    };
    around(polygon.outer, true);
    for (const Ring& hole : polygon.holes) around(hole, false);
    return best;
}

} // namespace

std::optional<DoorCount> countDoors(const building::Building& building, std::size_t region,
                                    const Access& access, Point2 from) {
    if (access.kind != AccessKind::Door && access.kind != AccessKind::Opening) return std::nullopt;
    auto wall = wallOf(building.regions()[region].polygon, access);
    if (!wall) return std::nullopt;
    auto along = [&](Point2 p) { return dot(p - wall->start, wall->along); };
    auto aside = [&](Point2 p) { return cross(wall->along, p - wall->start); };
    double way = along(access.midpoint()) - along(from);
    // Straight ahead, or across the room: no wall is followed.
    if (std::abs(way) < kLeastWayM || aside(from) > std::abs(way) || aside(from) > kFurthestAsideM)
        return std::nullopt;
    DoorCount count;
    count.left = way < 0.0; // with the free space to its left the wall is to one's right
    for (std::size_t index : building.accessesOf(region)) {
        const Access& other = building.accesses()[index];
        if (other.kind != access.kind || other.id == access.id || other.line.empty()) continue;
        Point2 middle = other.midpoint();
        double gone = (along(middle) - along(from)) * (way < 0.0 ? -1.0 : 1.0);
        if (std::abs(aside(middle)) <= kOnWallM && gone > kHereM && gone < std::abs(way) - 1e-6)
            ++count.number;
    }
    return count;
}

std::optional<Point2> directionThrough(const Polygon& region, const Access& access) {
    auto wall = wallOf(region, access);
    if (!wall) return std::nullopt;
    Point2 out{wall->along.y, -wall->along.x};
    if (access.line.size() < 2) return out;
    Point2 line = access.line.back() - access.line.front();
    if (length(line) < 1e-6) return out;
    Point2 across = Point2{-line.y, line.x} * (1.0 / length(line));
    // A door drawn across its wall instead of in it says nothing of the way through.
    if (std::abs(dot(across, out)) < kAlongWall) return out;
    return dot(across, out) > 0.0 ? across : across * -1.0;
}

} // namespace farol::routing
