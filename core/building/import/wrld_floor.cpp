#include "core/building/import/wrld_floor.h"

#include "core/base/ogr.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace farol::building {

namespace {

// Walls, doors and windows are drawn to meet, but miss each other by millimetres: wider gaps would be
// passages.
constexpr double kClosingM = 0.02;
constexpr double kLeastDrawnM2 = 0.2; ///< cupboards behind doors are drawn, and matter to what a door is
constexpr double kLeastClosedM2 = 0.5;
constexpr double kNarrowM = 0.15; ///< half the width of a space that is more than a slit between walls
constexpr double kHallM2 = 300.0;
constexpr std::size_t kCorridorDoors = 5;

struct NamedKind {
    const char* type;
    RegionKind kind;
    bool restricted;
};

const NamedKind kNamed[] = {
    {"room", RegionKind::Room, false},
    {"unit", RegionKind::Room, false},
    {"hallway", RegionKind::Corridor, false},
    {"bathroom", RegionKind::Toilet, false},
    {"stairs", RegionKind::Stairwell, false},
    {"elevator", RegionKind::Elevator, false},
    {"escalator", RegionKind::Other, false},
    {"garden", RegionKind::Outside, false},
    {"inaccessible_space", RegionKind::Other, true},
};

const NamedKind* namedKind(const TaggedFeature& feature) {
    const std::string& type = feature.tag("type");
    auto found = std::find_if(std::begin(kNamed), std::end(kNamed),
                              [&type](const NamedKind& one) { return type == one.type; });
    return found == std::end(kNamed) ? nullptr : found;
}

/// The middle line of a thin polygon, along its longest edge.
Polyline middleLine(const Polygon& polygon) {
    const Ring& ring = polygon.outer;
    Point2 along{};
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Point2 edge = ring[(i + 1) % ring.size()] - ring[i];
        if (length(edge) > length(along)) along = edge;
    }
    if (length(along) <= 0.0) return {};
    along = along * (1.0 / length(along));
    Point2 across{-along.y, along.x};
    double low = 1e9, high = -1e9, near = 1e9, far = -1e9;
    for (Point2 point : ring) {
        low = std::min(low, dot(point, along));
        high = std::max(high, dot(point, along));
        near = std::min(near, dot(point, across));
        far = std::max(far, dot(point, across));
    }
    Point2 middle = across * ((near + far) / 2);
    return {middle + along * low, middle + along * high};
}

Polygon inMetres(const Polygon& degrees, const LocalPlane& plane) {
    Polygon polygon = degrees;
    for (Point2& point : polygon.outer) point = plane.toMetres(point);
    for (Ring& hole : polygon.holes)
        for (Point2& point : hole) point = plane.toMetres(point);
    return polygon;
}

} // namespace

WrldFloor::WrldFloor(std::vector<TaggedFeature> features, const LocalPlane& plane, double level,
                     std::string name)
    : m_features(std::move(features)), m_level(level), m_name(std::move(name)) {
    for (TaggedFeature& feature : m_features)
        for (Polygon& polygon : feature.polygons) polygon = inMetres(polygon, plane);
}

void WrldFloor::build() {
    GdalMessages quiet;
    closeBarrier();
    addNamed();
    addClosedSpaces();
    addDoors();
    addWalls();
    nameKinds();
}

GeometryPtr WrldFloor::unionOfTypes(const std::vector<std::string>& types, double grow) const {
    std::vector<GeometryPtr> parts;
    for (const TaggedFeature& feature : m_features) {
        if (std::find(types.begin(), types.end(), feature.tag("type")) == types.end()) continue;
        for (const Polygon& polygon : feature.polygons) {
            GeometryPtr part = ogrPolygon(polygon);
            if (part != nullptr && grow > 0.0) part.reset(part->Buffer(grow, 2));
            if (part != nullptr) parts.push_back(std::move(part));
        }
    }
    return unionOf(parts);
}

void WrldFloor::closeBarrier() {
    m_barrier = unionOfTypes({"wall", "door", "window", "floor_opening"}, kClosingM);
    if (m_barrier != nullptr) m_barrier.reset(m_barrier->Buffer(0.001 - kClosingM, 2));
}

/// Rooms, stairs and lifts that the source draws, without the walls that they overlap.
void WrldFloor::addNamed() {
    std::set<std::string> ids;
    for (const TaggedFeature& feature : m_features) {
        const NamedKind* kind = namedKind(feature);
        if (kind == nullptr) continue;
        std::vector<GeometryPtr> drawn;
        for (const Polygon& polygon : feature.polygons)
            if (auto part = ogrPolygon(polygon)) drawn.push_back(std::move(part));
        GeometryPtr shape = unionOf(drawn);
        if (shape != nullptr && m_barrier != nullptr) shape.reset(shape->Difference(m_barrier.get()));
        for (Polygon& polygon : polygonsOf(shape.get(), kLeastDrawnM2)) {
            Region region;
            std::string id = idOf(feature);
            for (int number = 2; !ids.insert(id).second; ++number)
                id = idOf(feature) + "#" + std::to_string(number);
            region.id = RegionId(id);
            region.level = m_level;
            region.kind = kind->kind;
            if (region.kind == RegionKind::Other) region.kindText = kind->type;
            region.restricted = kind->restricted;
            region.name = feature.tag("name");
            region.ref = feature.tag("roomnumber");
            region.polygon = std::move(polygon);
            region.extra = attributesOf(feature.tags);
            regions.push_back(std::move(region));
        }
    }
}

void WrldFloor::addClosedSpaces() {
    GeometryPtr free = unionOfTypes({"building_outline"}, 0.0);
    std::vector<GeometryPtr> named;
    for (const Region& region : regions)
        if (auto polygon = ogrPolygon(region.polygon)) named.push_back(std::move(polygon));
    GeometryPtr taken = unionOf(named);
    for (const GeometryPtr* off : {&m_barrier, &taken})
        if (free != nullptr && *off != nullptr) free.reset(free->Difference(off->get()));
    std::vector<Polygon> spaces = polygonsOf(free.get(), kLeastClosedM2);
    std::stable_sort(spaces.begin(), spaces.end(),
                     [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
    for (std::size_t i = 0; i < spaces.size(); ++i) {
        Region region;
        region.id = RegionId(m_name + "/space-" + std::to_string(i + 1));
        GeometryPtr shape = ogrPolygon(spaces[i]);
        GeometryPtr heart(shape == nullptr ? nullptr : shape->Buffer(-kNarrowM, 2));
        if (heart == nullptr || heart->IsEmpty() != FALSE) {
            narrow.push_back(region.id.value);
            continue;
        }
        region.level = m_level;
        region.kind = RegionKind::Room;
        region.polygon = std::move(spaces[i]);
        regions.push_back(std::move(region));
        ++closedSpaces;
    }
}

/// The smallest region within arm's reach of a door's middle, on one side.
std::optional<std::size_t> WrldFloor::regionBeside(Point2 from, Point2 direction) const {
    for (double reach : {0.3, 0.5, 0.8}) {
        Point2 at = from + direction * reach;
        std::optional<std::size_t> best;
        for (std::size_t i = 0; i < regions.size(); ++i) {
            if (!contains(regions[i].polygon, at)) continue;
            if (!best || area(regions[i].polygon) < area(regions[*best].polygon)) best = i;
        }
        if (best) return best;
    }
    return std::nullopt;
}

void WrldFloor::addDoors() {
    std::set<std::string> ids;
    for (const TaggedFeature& feature : m_features) {
        bool window = feature.is("type", "window");
        if (!window && !feature.is("type", "door")) continue;
        for (const Polygon& polygon : feature.polygons) {
            Polyline line = middleLine(polygon);
            if (line.size() < 2 || !(length(line) > 0.0)) continue;
            Point2 along = (line[1] - line[0]) * (1.0 / length(line)), middle = (line[0] + line[1]) * 0.5;
            auto left = regionBeside(middle, {-along.y, along.x}),
                 right = regionBeside(middle, {along.y, -along.x});
            bool between = left && right && left != right;
            if (window && !between) continue; // a window to the outside is part of the wall
            Access access;
            std::string id = idOf(feature);
            for (int number = 2; !ids.insert(id).second; ++number)
                id = idOf(feature) + "#" + std::to_string(number);
            access.id = AccessId(id);
            access.kind = window ? AccessKind::Window : AccessKind::Door;
            access.level = m_level;
            access.widthM = std::round(length(line) * 100.0) / 100.0;
            if (left) access.regionA = regions[*left].id;
            if (right && left != right) access.regionB = regions[*right].id;
            access.line = std::move(line);
            access.extra = attributesOf(feature.tags);
            accesses.push_back(std::move(access));
        }
    }
}

void WrldFloor::addWalls() {
    for (const TaggedFeature& feature : m_features) {
        if (!feature.is("type", "wall") && !feature.is("type", "window")) continue;
        for (const Polygon& polygon : feature.polygons) {
            Polyline line = polygon.outer;
            line.push_back(line.front());
            walls.push_back({m_level, std::move(line), {{"type", feature.tag("type")}}});
        }
    }
}

/// What the source does not say of a closed space is guessed from its doors and size, and told as a guess.
void WrldFloor::nameKinds() {
    std::map<RegionId, std::size_t> doors;
    for (const Access& access : accesses)
        for (const RegionId& side : {access.regionA, access.regionB})
            if (!side.empty() && access.kind == AccessKind::Door) ++doors[side];
    for (Region& region : regions) {
        if (!region.extra.empty() || region.kind != RegionKind::Room) continue;
        if (area(region.polygon) >= kHallM2)
            region.kind = RegionKind::Hall;
        else if (doors[region.id] >= kCorridorDoors)
            region.kind = RegionKind::Corridor;
    }
}

} // namespace farol::building
