#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/import/osm_builder.h"
#include "core/building/import/strips.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

namespace farol::building {

namespace {

constexpr std::size_t kMaxAccesses = 50000;
constexpr double kDoorWidthM = 1.0, kStairsWidthM = 1.2;
constexpr double kReachM = 0.7; ///< how far a line's end may miss the area it leads to

Box2 boxOf(const Polyline& line) {
    return boundingBox(line).value_or(Box2{});
}

bool meet(const Box2& a, const Box2& b) {
    return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

Polyline around(Point2 at, Point2 direction, double width) {
    double size = length(direction);
    if (size <= 0.0) return {at};
    Point2 half = direction * (width / 2 / size);
    return {at - half, at + half};
}

void collectPoints(const OGRGeometry* geometry, std::vector<Point2>& points) {
    if (geometry == nullptr) return;
    OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
    if (type == wkbPoint && geometry->IsEmpty() == FALSE)
        points.push_back({geometry->toPoint()->getX(), geometry->toPoint()->getY()});
    else if (type == wkbMultiPoint || type == wkbGeometryCollection)
        for (const OGRGeometry* part : *geometry->toGeometryCollection()) collectPoints(part, points);
}

} // namespace

std::optional<std::size_t> OsmBuilder::regionAt(Point2 metres, double level, double reach,
                                                std::optional<std::size_t> except) const {
    auto found = m_onLevel.find(level);
    if (found == m_onLevel.end()) return std::nullopt;
    std::optional<std::size_t> best;
    double bestGap = reach, bestArea = 0.0;
    for (std::size_t index : found->second) {
        const Box2& box = m_boxes[index];
        bool near = metres.x >= box.low.x - reach && metres.x <= box.high.x + reach &&
                    metres.y >= box.low.y - reach && metres.y <= box.high.y + reach;
        if (!near || index == except || index >= m_stairsFrom) continue;
        double gap = distanceToPolygon(m_map.data.regions[index].polygon, metres);
        if (gap > bestGap) continue;
        double size = area(m_map.data.regions[index].polygon);
        if (best && gap == bestGap && size >= bestArea) continue;
        best = index;
        bestGap = gap;
        bestArea = size;
    }
    return best;
}

std::string OsmBuilder::accessId(const std::string& base) {
    std::string id = base;
    for (int number = 2; !m_accessIds.insert(id).second; ++number) id = base + "#" + std::to_string(number);
    return id;
}

bool OsmBuilder::doorNear(const RegionId& region, Point2 at, double reach) const {
    auto found = m_accessesOf.find(region);
    if (found == m_accessesOf.end()) return false;
    return std::any_of(found->second.begin(), found->second.end(), [&](std::size_t index) {
        return distance(m_map.data.accesses[index].midpoint(), at) <= reach;
    });
}

/// A door's width of the outline around the place.
Polyline OsmBuilder::acrossOutline(std::size_t region, Point2 at, double width) const {
    const Ring& ring = m_map.data.regions[region].polygon.outer;
    Point2 direction{};
    double nearest = 1e9;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
        double gap = distanceToSegment(at, a, b);
        if (gap >= nearest || a == b) continue;
        nearest = gap;
        direction = b - a;
    }
    return around(at, direction, width);
}

void OsmBuilder::addDoors() {
    for (const TaggedFeature& feature : m_features) {
        if (!isOsmDoor(feature) || (!feature.polygons.empty() && osmRegionRole(feature))) continue;
        for (Point2 at : feature.points) addDoorsOf(feature, at);
        for (Polyline line : feature.lines) {
            if (feature.has("highway")) continue;
            for (Point2& point : line) point = m_plane.toMetres(point);
            for (double level : levelsOrGround(feature)) addDoor(feature, level, line, {});
        }
    }
}

void OsmBuilder::addDoorsOf(const TaggedFeature& feature, Point2 degrees) {
    Point2 at = m_plane.toMetres(degrees);
    std::map<double, std::vector<Corner>> onOutlines;
    for (auto [it, end] = m_corners.equal_range(keyOf(degrees)); it != end; ++it)
        onOutlines[m_map.data.regions[it->second.region].level].push_back(it->second);
    std::vector<double> levels = levelsOf(feature);
    if (levels.empty())
        for (const auto& [level, corners] : onOutlines) levels.push_back(level);
    if (levels.empty()) {
        note(Severity::Warning, "osm-door-level", Sentence::OsmDoorLevel, feature.id);
        return;
    }
    double width = std::clamp(plainNumber(feature.tag("width")).value_or(kDoorWidthM), 0.5, 10.0);
    for (double level : levels) {
        std::vector<std::size_t> sides;
        Polyline line{at};
        for (const Corner& corner : onOutlines[level]) {
            if (std::find(sides.begin(), sides.end(), corner.region) == sides.end())
                sides.push_back(corner.region);
            if (line.size() == 1) line = around(at, corner.after - corner.before, width);
        }
        if (sides.empty())
            if (auto near = regionAt(at, level, 0.3); near && sides.empty())
                line = acrossOutline(*near, at, width);
        // Two outlines share the node: these are the sides. More: geometry decides, at finishing.
        if (sides.size() > 2) sides.clear();
        if (sides.size() == 1)
            if (auto other = regionAt(at, level, 0.3, sides.front())) sides.push_back(*other);
        addDoor(feature, level, std::move(line), sides);
    }
}

void OsmBuilder::addDoor(const TaggedFeature& feature, double level, Polyline line,
                         const std::vector<std::size_t>& sides) {
    if (m_map.data.accesses.size() >= kMaxAccesses) return;
    Access access;
    access.id =
        AccessId(accessId(feature.id + (levelsOf(feature).size() > 1 ? "@" + formatNumber(level) : "")));
    access.kind = feature.is("door", "no") ? AccessKind::Opening : AccessKind::Door;
    access.level = level;
    access.doorType = feature.is("door", "yes") || feature.is("door", "no") ? "" : feature.tag("door");
    access.automatic = feature.has("automatic_door") && !feature.is("automatic_door", "no");
    access.widthM = plainNumber(feature.tag("width"));
    access.closed =
        isOsmEmergencyDoor(feature) || feature.is("access", "no") || feature.is("access", "private");
    access.line = std::move(line);
    access.extra = attributesOf(feature.tags);
    if (!sides.empty()) access.regionA = m_map.data.regions[sides.front()].id;
    if (sides.size() > 1) access.regionB = m_map.data.regions[sides[1]].id;
    for (std::size_t side : sides)
        m_accessesOf[m_map.data.regions[side].id].push_back(m_map.data.accesses.size());
    m_map.data.accesses.push_back(std::move(access));
}

/// A walked line that leads through the outline of a room enters it there, also where nobody drew the door.
void OsmBuilder::addRoomOpenings() {
    GdalMessages quiet;
    for (const WalkLine& walk : m_walks) {
        Box2 box = boxOf(walk.line);
        GeometryPtr line = ogrLine(walk.line);
        for (std::size_t room : m_onLevel[walk.level]) {
            if (!m_walled[room] || !meet(box, m_boxes[room])) continue;
            if (!mayMeet()) return;
            Polyline outline = m_map.data.regions[room].polygon.outer;
            outline.push_back(outline.front());
            GeometryPtr border = ogrLine(outline);
            GeometryPtr shared(border->Intersection(line.get()));
            std::vector<Point2> points;
            collectPoints(shared.get(), points);
            for (Point2 at : points) addOpening(walk, room, at);
        }
    }
}

void OsmBuilder::addOpening(const WalkLine& walk, std::size_t room, Point2 at) {
    const Region& region = m_map.data.regions[room];
    if (doorNear(region.id, at, 1.0) || m_map.data.accesses.size() >= kMaxAccesses) return;
    auto other = regionAt(at, walk.level, 0.3, room);
    if (!other) return;
    Access access;
    access.id = AccessId(accessId(walk.feature->id + "/" + region.id.value));
    access.kind = region.kind == RegionKind::Elevator ? AccessKind::Door : AccessKind::Opening;
    access.level = walk.level;
    access.regionA = region.id;
    access.regionB = m_map.data.regions[*other].id;
    access.line = acrossOutline(room, at, kDoorWidthM);
    for (const RegionId& side : {access.regionA, access.regionB})
        m_accessesOf[side].push_back(m_map.data.accesses.size());
    m_map.data.accesses.push_back(std::move(access));
    note(Severity::Note, "osm-entrance-by-way", Sentence::OsmEntranceByWay, region.id.value);
}

void OsmBuilder::addSteps() {
    m_stairsFrom =
        m_map.data.regions.size(); // other steps are no place to arrive at, unless there is nothing else
    for (const TaggedFeature& feature : m_features) {
        if (!isOsmSteps(feature) || levelsOf(feature).size() < 2) continue;
        for (Polyline line : feature.lines) {
            for (Point2& point : line) point = m_plane.toMetres(point);
            if (m_map.data.accesses.size() < kMaxAccesses && !m_tooMuch) addFlight(feature, line);
        }
    }
}

void OsmBuilder::addFlight(const TaggedFeature& feature, const Polyline& line) {
    std::vector<double> levels = levelsOf(feature);
    double low = levels.front(), high = levels.back();
    auto sidesFor = [&](double first, double last) {
        return std::pair{regionAt(line.front(), first, kReachM), regionAt(line.back(), last, kReachM)};
    };
    auto up = sidesFor(low, high), down = sidesFor(high, low);
    auto score = [](const auto& sides) { return (sides.first ? 1.0 : 0.0) + (sides.second ? 1.0 : 0.0); };
    // The incline is believed unless no region at all lies where it says and two do the other way round.
    double upScore = score(up) + (feature.is("incline", "up") ? 1.5 : 0.0);
    double downScore = score(down) + (feature.is("incline", "down") ? 1.5 : 0.0);
    bool rises = upScore >= downScore;
    auto [first, last] = rises ? up : down;
    if (!feature.is("incline", "up") && !feature.is("incline", "down") && upScore == downScore)
        note(Severity::Warning, "osm-steps-incline", Sentence::OsmStepsIncline, feature.id);
    if (!first || !last) note(Severity::Warning, "osm-steps-end", Sentence::OsmStepsEnd, feature.id);
    Polyline climb = line;
    if (!rises) {
        std::reverse(climb.begin(), climb.end());
        std::swap(first, last);
    }
    addStairs(feature, climb, {low, high}, {first, last}, rises);
}

/// The lower half of the steps is a region of the lower level and the upper half one of the upper level: so
/// the place where they join lies in both, and foot and head lead on where they really are. `climb` runs
/// upwards.
void OsmBuilder::addStairs(const TaggedFeature& feature, const Polyline& climb,
                           std::pair<double, double> levels,
                           std::pair<std::optional<std::size_t>, std::optional<std::size_t>> ends,
                           bool rises) {
    double width = std::clamp(plainNumber(feature.tag("width")).value_or(kStairsWidthM), 0.6, 10.0);
    Polyline fall(climb.rbegin(), climb.rend());
    auto [lower, along] = firstHalf(climb);
    auto upper = firstHalf(fall).first;
    auto foot = addStairsHalf(feature, lower, levels.first, width, ends.first);
    auto head = addStairsHalf(feature, upper, levels.second, width, ends.second);
    if (!foot || !head) {
        note(Severity::Warning, "osm-steps-short", Sentence::OsmStepsShort, feature.id);
        return;
    }
    bool moving = feature.has("conveying") && !feature.is("conveying", "no");
    Access access;
    access.id = AccessId(accessId(feature.id));
    access.kind = moving ? AccessKind::Escalator : AccessKind::Stairs;
    access.level = levels.first;
    access.regionA = m_map.data.regions[*foot].id;
    access.regionB = m_map.data.regions[*head].id;
    // The way's own direction is told; ours is upwards.
    if (OneWay way = osmConveying(feature); way != OneWay::No)
        access.oneWay = (way == OneWay::AToB) == rises ? OneWay::AToB : OneWay::BToA;
    access.widthM = plainNumber(feature.tag("width"));
    if (auto steps = plainNumber(feature.tag("step_count")); steps && *steps > 0 && *steps < 10000)
        access.steps = static_cast<int>(*steps);
    access.closed = isOsmRestricted(feature);
    access.shaft = ShaftId(feature.id);
    access.line = around(lower.back(), {-along.y, along.x}, width);
    access.extra = attributesOf(feature.tags);
    m_map.data.accesses.push_back(std::move(access));
}

/// One half, from its outer end, with the opening to the region there.
std::optional<std::size_t> OsmBuilder::addStairsHalf(const TaggedFeature& feature, const Polyline& half,
                                                     double level, double width,
                                                     std::optional<std::size_t> end) {
    auto strip = addStrip(feature, half, level, width, RegionKind::Stairwell);
    if (!strip) return strip;
    Region& region = m_map.data.regions[*strip];
    if (region.name.empty() && feature.has("conveying") && !feature.is("conveying", "no"))
        region.name = "Escalator " + std::to_string(++m_escalators[level]);
    if (end) addStripEnd(*strip, {half.rbegin(), half.rend()}, width, *end, OneWay::No);
    return strip;
}

/// A region along a line, with walls along its sides.
std::optional<std::size_t> OsmBuilder::addStrip(const TaggedFeature& feature, const Polyline& line,
                                                double level, double width, RegionKind kind) {
    std::vector<Polygon> strips;
    appendStrip(line, width / 2, strips);
    auto shape = joinedStrips(strips);
    if (!shape) return std::nullopt;
    Region region;
    std::string id = feature.id + "@" + formatNumber(level);
    region.id = RegionId(id);
    for (int number = 2; !m_stairIds.insert(region.id.value).second; ++number)
        region.id = RegionId(id + "#" + std::to_string(number));
    region.level = level;
    region.kind = kind;
    region.name = nameOf(feature, m_language);
    region.ref = feature.tag("ref");
    region.restricted = isOsmRestricted(feature);
    region.polygon = std::move(*shape);
    region.extra = attributesOf(feature.tags);
    Point2 along = unitVector(line[1] - line[0]);
    Point2 side = Point2{-along.y, along.x} * (width / 2);
    for (Point2 edge : {side, side * -1.0}) {
        Polyline wall = line;
        for (Point2& point : wall) point = point + edge;
        m_map.data.walls.push_back({level, std::move(wall), {}});
    }
    return addRegion(std::move(region), false);
}

/// The opening between a strip and what lies at the end of the line `outwards`. `way`: from there into the
/// strip.
void OsmBuilder::addStripEnd(std::size_t strip, const Polyline& outwards, double width, std::size_t end,
                             OneWay way) {
    const Region& region = m_map.data.regions[strip];
    Access access;
    access.id = AccessId(accessId(region.id.value + "/end"));
    access.kind = AccessKind::Opening;
    access.level = region.level;
    access.regionA = m_map.data.regions[end].id;
    access.regionB = region.id;
    access.oneWay = way;
    Point2 along = unitVector(outwards.back() - outwards[outwards.size() - 2]);
    Point2 side = Point2{-along.y, along.x} * (width / 2);
    access.line = {outwards.back() + side, outwards.back() - side};
    for (const RegionId& each : {access.regionA, access.regionB})
        m_accessesOf[each].push_back(m_map.data.accesses.size());
    m_map.data.accesses.push_back(std::move(access));
}

/// Moving walkways: a region of its own each, entered at one end and left at the other, the way it runs.
void OsmBuilder::addWalkways() {
    for (const TaggedFeature& feature : m_features) {
        if (!isOsmMovingWalkway(feature) || !feature.polygons.empty()) continue;
        for (Polyline line : feature.lines) {
            for (Point2& point : line) point = m_plane.toMetres(point);
            for (double level : levelsOrGround(feature))
                if (m_map.data.accesses.size() < kMaxAccesses && !m_tooMuch) addWalkway(feature, line, level);
        }
    }
}

void OsmBuilder::addWalkway(const TaggedFeature& feature, const Polyline& line, double level) {
    double width = std::clamp(plainNumber(feature.tag("width")).value_or(kStairsWidthM), 0.6, 10.0);
    auto strip = length(line) > 0.0 ? addStrip(feature, line, level, width, RegionKind::Other) : std::nullopt;
    if (!strip) {
        note(Severity::Warning, "osm-steps-short", Sentence::OsmStepsShort, feature.id);
        return;
    }
    Region& region = m_map.data.regions[*strip];
    region.kindText = "moving_walkway";
    if (region.name.empty()) region.name = "Moving walkway " + std::to_string(++m_walkways[level]);
    OneWay way = osmConveying(feature);
    if (way == OneWay::No && !feature.is("conveying", "reversible"))
        note(Severity::Warning, "osm-walkway-direction", Sentence::OsmWalkwayDirection, feature.id);
    OneWay against = way == OneWay::No ? OneWay::No : way == OneWay::AToB ? OneWay::BToA : OneWay::AToB;
    auto first = regionAt(line.front(), level, kReachM), last = regionAt(line.back(), level, kReachM);
    if (first) addStripEnd(*strip, {line.rbegin(), line.rend()}, width, *first, way);
    if (last) addStripEnd(*strip, line, width, *last, against);
    if (!first || !last) note(Severity::Warning, "osm-walkway-end", Sentence::OsmWalkwayEnd, feature.id);
}

/// A lift that stands in an area and has no drawn door is still entered from there; on which side is not
/// known.
void OsmBuilder::joinLonelyLifts() {
    for (std::size_t i = 0; i < m_map.data.regions.size(); ++i) {
        const Region& lift = m_map.data.regions[i];
        if (lift.kind != RegionKind::Elevator || m_accessesOf.count(lift.id) != 0) continue;
        const Ring& ring = lift.polygon.outer;
        std::optional<std::size_t> around;
        Polyline door;
        for (std::size_t k = 0; k < ring.size(); ++k) {
            Point2 middle = (ring[k] + ring[(k + 1) % ring.size()]) * 0.5;
            auto other = regionAt(middle, lift.level, 0.3, i);
            double edge = distance(ring[k], ring[(k + 1) % ring.size()]);
            if (!other || m_map.data.regions[*other].kind == RegionKind::Elevator || edge < 0.5) continue;
            if (around && m_walled[*other]) continue;
            around = other;
            door = acrossOutline(i, middle, std::min(edge, kDoorWidthM));
            if (!m_walled[*other]) break;
        }
        if (!around || m_walled[*around]) continue; // a wall without a door stays a wall
        Access access;
        access.id = AccessId(accessId("door/" + lift.id.value));
        access.level = lift.level;
        access.regionA = lift.id;
        access.regionB = m_map.data.regions[*around].id;
        access.line = door;
        note(Severity::Warning, "osm-lift-door", Sentence::OsmLiftDoor, lift.id.value);
        for (const RegionId& side : {access.regionA, access.regionB})
            m_accessesOf[side].push_back(m_map.data.accesses.size());
        m_map.data.accesses.push_back(std::move(access));
    }
}

} // namespace farol::building
