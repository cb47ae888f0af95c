#include "core/simulation/walk_world.h"

#include "core/routing/walking_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace farol::simulation {

using building::Access;
using building::AccessKind;
using building::Building;

namespace {

/// An opening drawn this near to a region's side is a gap in it.
constexpr double kOnSideM = 0.35;
constexpr double kDoorM = 0.9, kOpeningM = 1.4;
/// How far behind a door one comes to a stand.
constexpr double kBehindM = 0.45;

double widthOf(const Access& access) {
    if (access.line.size() > 1 && length(access.line) > 0.3) return length(access.line);
    return access.widthM.value_or(access.kind == AccessKind::Opening ? kOpeningM : kDoorM);
}

std::vector<Segment> sidesOf(const Polygon& polygon) {
    std::vector<Segment> sides;
    auto add = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (!(ring[i] == ring[(i + 1) % ring.size()]))
                sides.push_back({ring[i], ring[(i + 1) % ring.size()]});
    };
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
    return sides;
}

Point2 unit(Point2 v) {
    double size = length(v);
    return size > 0.0 ? v * (1.0 / size) : Point2{};
}

/// Along the ray, where the side is met; empty where it is not.
std::optional<double> meets(Point2 from, Point2 direction, const Segment& side) {
    Point2 along = side.b - side.a;
    double turn = cross(direction, along);
    if (std::abs(turn) < 1e-12) return std::nullopt;
    Point2 to = side.a - from;
    double distance = cross(to, along) / turn, share = cross(to, direction) / turn;
    if (distance < 0.0 || share < -1e-9 || share > 1.0 + 1e-9) return std::nullopt;
    return distance;
}

} // namespace

bool Passage::changesLevel() const {
    return kind == AccessKind::Stairs || kind == AccessKind::Elevator || kind == AccessKind::Escalator ||
           climb != 0.0;
}

WalkWorld::WalkWorld(std::shared_ptr<const Building> building)
    : m_building(std::move(building)), m_rooms(m_building->regions().size()) {
    for (std::size_t region = 0; region < m_rooms.size(); ++region) {
        m_rooms[region].solid = sidesOf(m_building->regions()[region].polygon);
        for (std::size_t access : m_building->accessesOf(region))
            if (auto found = passage(access, region)) m_rooms[region].passages.push_back(*found);
        cutOpenings(region);
    }
}

std::optional<Passage> WalkWorld::passage(std::size_t index, std::size_t region) const {
    const Access& access = m_building->accesses()[index];
    auto into = m_building->otherSide(access, region);
    if (!into || !access.passable() || access.line.empty() || *into == region) return std::nullopt;
    bool fromA = m_building->regions()[region].id == access.regionA;
    bool wrongWay = (access.oneWay == building::OneWay::AToB && !fromA) ||
                    (access.oneWay == building::OneWay::BToA && fromA);
    if (wrongWay) return std::nullopt;
    Passage passage;
    passage.access = index;
    passage.from = region;
    passage.into = *into;
    passage.kind = access.kind;
    passage.climb = m_building->regions()[*into].level - m_building->regions()[region].level;
    Point2 middle = access.midpoint();
    if (passage.changesLevel()) {
        passage.gap = access.line.size() > 1 ? Segment{access.line.front(), access.line.back()}
                                             : Segment{middle, middle};
        return passage;
    }
    // The side of the region that it stands in tells which way is through, and how a point lies.
    const std::vector<Segment> sides = sidesOf(m_building->regions()[region].polygon);
    if (sides.empty()) return std::nullopt;
    const Segment& side =
        *std::min_element(sides.begin(), sides.end(), [&](const Segment& a, const Segment& b) {
            return distanceToSegment(middle, a.a, a.b) < distanceToSegment(middle, b.a, b.b);
        });
    Point2 along = unit(side.b - side.a);
    bool drawn = access.line.size() > 1 && length(access.line) > 0.3;
    if (drawn) along = unit(access.line.back() - access.line.front());
    Point2 half = along * (widthOf(access) / 2.0);
    passage.gap = {middle - half, middle + half};
    passage.outward = {-along.y, along.x};
    const Polygon& polygon = m_building->regions()[region].polygon;
    double ahead = distanceToPolygon(polygon, middle + passage.outward * 0.4),
           back = distanceToPolygon(polygon, middle - passage.outward * 0.4);
    if (ahead < back) passage.outward = passage.outward * -1.0;
    for (Point2 p : {passage.gap.a, middle, passage.gap.b})
        passage.behindM = std::max(passage.behindM, distanceToPolygon(polygon, p));
    return passage;
}

/// Openings are gaps in the sides along which they lie.
void WalkWorld::cutOpenings(std::size_t region) {
    Room& room = m_rooms[region];
    for (const Passage& passage : room.passages) {
        if (passage.kind != AccessKind::Opening || passage.changesLevel()) continue;
        std::vector<Segment> left;
        for (const Segment& side : room.solid) {
            Point2 along = unit(side.b - side.a);
            double size = distance(side.a, side.b);
            double s = dot(passage.gap.a - side.a, along), t = dot(passage.gap.b - side.a, along);
            if (s > t) std::swap(s, t);
            Point2 middle = (passage.gap.a + passage.gap.b) * 0.5;
            bool parallel = std::abs(cross(unit(passage.gap.b - passage.gap.a), along)) < 0.3;
            if (!parallel || distanceToSegment(middle, side.a, side.b) > kOnSideM || t < 0.0 || s > size) {
                left.push_back(side);
                continue;
            }
            if (s > 0.01) left.push_back({side.a, side.a + along * s});
            if (t < size - 0.01) left.push_back({side.a + along * t, side.b});
        }
        room.solid = std::move(left);
    }
}

bool WalkWorld::inside(std::size_t region, Point2 p) const {
    return contains(m_building->regions()[region].polygon, p);
}

std::optional<WalkWorld::Hit> WalkWorld::hit(std::size_t region, Point2 from, Radians direction,
                                             double reach) const {
    Point2 ahead{std::cos(direction.value), std::sin(direction.value)};
    std::optional<Hit> nearest;
    for (const Segment& side : m_rooms[region].solid) {
        auto at = meets(from, ahead, side);
        if (!at || *at > reach || (nearest && *at >= nearest->distance)) continue;
        double along = wrapped(directionOf(side.b - side.a) - direction).value;
        if (along > kPi / 2.0) along -= kPi;
        if (along <= -kPi / 2.0) along += kPi;
        nearest = Hit{*at, Radians{along}};
    }
    return nearest;
}

double WalkWorld::free(std::size_t region, Point2 from, Radians direction, double reach) const {
    auto met = hit(region, from, direction, reach);
    return met ? met->distance : reach;
}

bool WalkWorld::blocked(std::size_t region, Point2 from, Point2 to) const {
    Point2 way = to - from;
    double size = length(way);
    if (size < 1e-9) return false;
    for (const Segment& side : m_rooms[region].solid) {
        auto at = meets(from, way * (1.0 / size), side);
        if (at && *at <= size + 1e-6) return true;
    }
    return false;
}

/// Off the walls that are nearer than a body's radius.
Point2 WalkWorld::pushedOff(std::size_t region, Point2 p) const {
    for (int round = 0; round < 3; ++round) {
        double nearest = kBodyM;
        Point2 away{};
        for (const Segment& side : m_rooms[region].solid) {
            Point2 at = nearestOnSegment(p, side.a, side.b);
            double gap = distance(p, at);
            if (gap >= nearest || gap < 1e-9) continue;
            nearest = gap;
            away = (p - at) * (1.0 / gap);
        }
        if (away == Point2{}) return p;
        p = p + away * (kBodyM - nearest + 1e-4);
    }
    return p;
}

Point2 WalkWorld::moved(std::size_t region, Point2 from, Point2 to) const {
    auto fits = [&](Point2 p) { return inside(region, p) && !blocked(region, from, p); };
    Point2 off = pushedOff(region, to);
    if (fits(off)) return off;
    if (fits(to)) return to;
    // Along what is in the way instead of into it.
    Point2 half = from + (off - from) * 0.3;
    return fits(half) ? half : from;
}

const Passage* WalkWorld::crossed(std::size_t region, Point2 from, Point2 to) const {
    if (inside(region, to)) return nullptr;
    const Passage* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Passage& passage : m_rooms[region].passages) {
        if (passage.kind != AccessKind::Opening || passage.changesLevel()) continue;
        if (blocked(region, from, to)) continue;
        double gap = distanceToSegment(to, passage.gap.a, passage.gap.b);
        if (gap < least && gap < kOnSideM + distance(from, to)) {
            least = gap;
            nearest = &passage;
        }
    }
    return nearest;
}

Point2 WalkWorld::standing(std::size_t region, Point2 near) const {
    const Polygon& polygon = m_building->regions()[region].polygon;
    Point2 p = inside(region, near) ? near : routing::nearestWithin(polygon, near);
    Point2 off = pushedOff(region, p);
    if (inside(region, off)) return off;
    // On a side the way off it is not known: towards the middle.
    Point2 in = p + unit(pointInside(polygon) - p) * (kBodyM + 0.05);
    return inside(region, in) ? in : inside(region, p) ? p : pointInside(polygon);
}

Point2 WalkWorld::landing(const Passage& passage, Point2 at) const {
    if (passage.changesLevel()) return standing(passage.into, at);
    for (double beyond : {kBehindM, 0.7, 1.0, 0.3, 0.15}) {
        Point2 p = at + passage.outward * beyond;
        if (!inside(passage.into, p)) continue;
        Point2 off = pushedOff(passage.into, p);
        return inside(passage.into, off) ? off : p;
    }
    return standing(passage.into, at + passage.outward * kBehindM);
}

} // namespace farol::simulation
