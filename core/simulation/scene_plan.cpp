#include "core/simulation/scene_plan.h"

#include "core/building/box_index.h"
#include "core/building/level_regions.h"
#include "core/simulation/hash.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

namespace {

using building::AccessKind;
using building::RegionKind;

constexpr double kWallM = 0.05; ///< half of the thinnest wall
constexpr std::size_t kSeededWindow = static_cast<std::size_t>(-1);

Point2 originOf(const building::Building& building) {
    Ring points;
    for (const building::Region& region : building.regions())
        for (Point2 p : region.polygon.outer)
            if (isFinite(p)) points.push_back(p);
    auto box = boundingBox(points);
    if (!box) return {};
    return {std::floor((box->low.x + box->high.x) / 2), std::floor((box->low.y + box->high.y) / 2)};
}

Polygon moved(Polygon polygon, Point2 by) {
    for (Point2& p : polygon.outer) p = p - by;
    for (Ring& hole : polygon.holes)
        for (Point2& p : hole) p = p - by;
    return polygon;
}

class Planner {
public:
    Planner(const building::Building& building, std::uint64_t seed, bool windows)
        : m_building(building), m_seed(seed), m_seededWindows(windows), m_regions(building.regions()) {}

    ScenePlan plan() {
        m_plan.origin = originOf(m_building);
        m_plan.storeys = Storeys(m_building);
        for (std::size_t i = 0; i < m_building.regions().size(); ++i) m_plan.regions.push_back(regionPlan(i));
        liftOverlaps();
        for (std::size_t i = 0; i < m_building.accesses().size(); ++i) addAccess(i);
        addWindows();
        return std::move(m_plan);
    }

private:
    RegionPlan regionPlan(std::size_t index) const {
        const building::Region& region = m_building.regions()[index];
        RegionPlan plan;
        plan.region = index;
        plan.polygon = tidied(moved(region.polygon, m_plan.origin));
        plan.outside = region.kind == RegionKind::Outside;
        if (plan.polygon.outer.empty()) return plan;
        plan.axis = mainDirection(plan.polygon);
        double around = length(plan.polygon.outer) + 1.0e-6;
        double inset = std::min(kWallM, area(plan.polygon) / around * 0.4);
        for (const BorderEdge& border : bordersOf(plan.polygon, inset)) {
            PlanEdge edge;
            static_cast<BorderEdge&>(edge) = border;
            if (!plan.outside) edge.outer = outerParts(border, index);
            plan.edges.push_back(edge);
        }
        return plan;
    }

    /// Nothing indoors behind the wall at that place, to the depth of a thick wall?
    bool outdoorsBehind(const BorderEdge& edge, double metres, double level) const {
        for (double depth : {0.15, 0.5, 1.0}) {
            auto other = m_regions.at(level, edge.at(metres, -depth) + m_plan.origin);
            if (other && m_building.regions()[*other].kind != RegionKind::Outside) return false;
        }
        return true;
    }

    std::vector<std::pair<double, double>> outerParts(const BorderEdge& edge, std::size_t self) const {
        std::vector<std::pair<double, double>> parts;
        double level = m_building.regions()[self].level;
        int count = std::clamp(static_cast<int>(std::ceil(edge.length / 0.25)), 1, 400);
        double step = edge.length / count;
        for (int i = 0; i < count; ++i) {
            if (!outdoorsBehind(edge, (i + 0.5) * step, level)) continue;
            if (!parts.empty() && parts.back().second > (i - 0.5) * step)
                parts.back().second = (i + 1) * step;
            else
                parts.emplace_back(i * step, (i + 1) * step);
        }
        // Round an outer corner the skin meets that of the next wall; into a neighbour's room it must not
        // reach.
        constexpr double kSkinM = 0.2;
        if (!parts.empty() && parts.front().first <= 0.0 && outdoorsBehind(edge, -kSkinM / 2, level))
            parts.front().first = -kSkinM;
        if (!parts.empty() && parts.back().second >= edge.length - 1.0e-6 &&
            outdoorsBehind(edge, edge.length + kSkinM / 2, level))
            parts.back().second = edge.length + kSkinM;
        return parts;
    }

    /// Floors that lie in one plane would flicker; a smaller region lies on top, as regionAt() sees it.
    void liftOverlaps() {
        for (RegionPlan& plan : m_plan.regions) {
            if (plan.polygon.outer.empty()) continue;
            double level = m_building.regions()[plan.region].level, own = area(plan.polygon);
            auto box = boundingBox(plan.polygon.outer);
            int below = 0;
            for (std::size_t other :
                 m_regions.meeting(level, {box->low + m_plan.origin, box->high + m_plan.origin})) {
                const Polygon& outline = m_plan.regions[other].polygon;
                if (other == plan.region || outline.outer.empty()) continue;
                bool larger = area(outline) > own || (area(outline) == own && other < plan.region);
                if (larger && contains(outline, pointInside(plan.polygon))) ++below;
            }
            plan.floorLift = 0.003 * std::min(below, 6);
        }
    }

    bool usable(std::size_t region) const { return !m_plan.regions[region].polygon.outer.empty(); }

    /// The regions on either side that have walls on the access's level.
    std::vector<std::size_t> sidesOf(const building::Access& access) const {
        std::vector<std::size_t> sides;
        for (const RegionId& id : {access.regionA, access.regionB}) {
            auto index = m_building.regionIndex(id);
            if (index && m_building.regions()[*index].level == access.level && usable(*index))
                sides.push_back(*index);
        }
        if (!sides.empty()) return sides;
        Point2 middle = access.midpoint();
        std::vector<std::pair<double, std::size_t>> near;
        for (std::size_t i : m_regions.meeting(access.level, building::grown({middle, middle}, 0.5))) {
            if (!usable(i)) continue;
            double gap = distanceToPolygon(m_plan.regions[i].polygon, middle - m_plan.origin);
            if (gap <= 0.5) near.emplace_back(gap, i);
        }
        std::sort(near.begin(), near.end());
        for (std::size_t i = 0; i < near.size() && i < 2; ++i) sides.push_back(near[i].second);
        return sides;
    }

    static double defaultWidth(AccessKind kind) {
        if (kind == AccessKind::Opening || kind == AccessKind::Ramp) return 1.6;
        if (kind == AccessKind::Window || kind == AccessKind::Stairs || kind == AccessKind::Escalator)
            return 1.4;
        return kind == AccessKind::Elevator ? 1.0 : 0.95;
    }

    void addAccess(std::size_t index) {
        const building::Access& access = m_building.accesses()[index];
        if (access.line.empty() || !std::all_of(access.line.begin(), access.line.end(), isFinite)) return;
        if (access.changesLevel()) return; // no hole in a wall
        std::vector<std::size_t> sides = sidesOf(access);
        if (sides.empty()) return;
        // A bent opening is cut piece by piece, a door from end to end.
        if (access.kind == AccessKind::Opening && access.line.size() > 2) {
            for (std::size_t i = 1; i < access.line.size(); ++i)
                addPortal(index, sides, access.line[i - 1] - m_plan.origin, access.line[i] - m_plan.origin);
        } else {
            addPortal(index, sides, access.line.front() - m_plan.origin, access.line.back() - m_plan.origin);
        }
    }

    const PlanEdge* nearestEdge(std::size_t region, Point2 p) const {
        const PlanEdge* best = nullptr;
        double least = 2.5;
        for (const PlanEdge& edge : m_plan.regions[region].edges) {
            double gap = distanceToSegment(p, edge.a, edge.b);
            if (gap < least - 1.0e-9) {
                least = gap;
                best = &edge;
            }
        }
        return best;
    }

    void addPortal(std::size_t index, const std::vector<std::size_t>& sides, Point2 a, Point2 b) {
        const building::Access& access = m_building.accesses()[index];
        Portal portal;
        portal.access = index;
        portal.kind = access.kind;
        double drawn = distance(a, b);
        double width = access.widthM && *access.widthM > 0.3 ? *access.widthM : defaultWidth(access.kind);
        if (drawn < 0.3) { // a point: as wide as it says, along the nearest wall
            Point2 middle = (a + b) * 0.5;
            const PlanEdge* edge = nearestEdge(sides.front(), middle);
            if (!edge && sides.size() > 1) edge = nearestEdge(sides.back(), middle);
            if (!edge) return;
            width = std::clamp(width, 0.3, std::max(0.3, edge->length - 0.05));
            double at =
                std::clamp(edge->metresOf(middle), width / 2, std::max(width / 2, edge->length - width / 2));
            Point2 on = edge->at(at, 0.0);
            double depth = dot(middle - on, edge->inward);
            a = edge->at(at - width / 2, depth);
            b = edge->at(at + width / 2, depth);
        }
        portal.a = a;
        portal.b = b;
        portal.width = distance(a, b);
        if (portal.width < 0.05) return;
        portal.along = (b - a) * (1.0 / portal.width);
        portal.normal = {-portal.along.y, portal.along.x};
        finishPortal(portal, sides);
    }

    void finishPortal(Portal portal, const std::vector<std::size_t>& sides) {
        orient(portal, sides);
        fitBetweenWalls(portal);
        const building::Region* into = portal.into ? &m_building.regions()[*portal.into] : nullptr;
        const building::Region* outOf = portal.outOf ? &m_building.regions()[*portal.outOf] : nullptr;
        for (const building::Region* region : {into, outOf})
            portal.lift |= region && region->kind == RegionKind::Elevator;
        double level = (into ? into : outOf)->level;
        double ceiling = m_plan.storeys.at(level).ceilingM;
        setHeights(portal, ceiling);
        if (portal.into)
            if (auto face = cut(m_plan.regions[*portal.into], portal, portal.normal)) portal.front = *face;
        if (portal.outOf)
            if (auto face = cut(m_plan.regions[*portal.outOf], portal, portal.normal * -1.0))
                portal.back = -*face;
        if (!portal.into || !portal.outOf) { // the far side of an outer door is the building's skin
            if (!portal.into) portal.front = std::max(portal.front, portal.back + 0.2);
            if (!portal.outOf) portal.back = std::min(portal.back, portal.front - 0.2);
        }
        if (portal.front < portal.back + 0.02) portal.front = portal.back + 0.02;
        m_plan.portals.push_back(portal);
    }

    /// Which region lies where the normal points.
    void orient(Portal& portal, const std::vector<std::size_t>& sides) const {
        Point2 middle = (portal.a + portal.b) * 0.5;
        auto score = [&](std::size_t region) { // nearer to the point before than to the one behind: positive
            const Polygon& outline = m_plan.regions[region].polygon;
            return distanceToPolygon(outline, middle - portal.normal * 0.4) -
                   distanceToPolygon(outline, middle + portal.normal * 0.4);
        };
        if (sides.size() == 1 || sides[0] == sides[1]) {
            (score(sides[0]) >= 0.0 ? portal.into : portal.outOf) = sides[0];
            return;
        }
        bool firstBefore = score(sides[0]) >= score(sides[1]);
        portal.into = sides[firstBefore ? 0 : 1];
        portal.outOf = sides[firstBefore ? 1 : 0];
    }

    /// An opening as wide as its corridor ends where the corridor's walls stand, which is inside its border.
    void fitBetweenWalls(Portal& portal) const {
        constexpr double kMostM = 0.12;
        Point2 middle = (portal.a + portal.b) * 0.5;
        double from = 0.0, to = portal.width;
        for (const auto& side : {portal.into, portal.outOf}) {
            if (!side) continue;
            for (const PlanEdge& edge : m_plan.regions[*side].edges) {
                if (std::abs(dot(edge.along, portal.along)) < 0.94 ||
                    std::abs(dot(middle - edge.a, edge.inward)) > 0.45)
                    continue;
                for (double metres : {edge.from, edge.to}) {
                    double at = dot(edge.at(metres, 0.0) - portal.a, portal.along);
                    if (std::abs(at) < kMostM) from = std::max(from, at);
                    if (std::abs(at - portal.width) < kMostM) to = std::min(to, at);
                }
            }
        }
        if (to - from < 0.3) return;
        portal.b = portal.a + portal.along * to;
        portal.a = portal.a + portal.along * from;
        portal.width = to - from;
    }

    static void setHeights(Portal& portal, double ceiling) {
        portal.head = std::min(portal.lift ? 2.1 : 2.05, ceiling - 0.1);
        if (portal.kind == AccessKind::Window) {
            portal.sill = 0.9;
            portal.head = std::min(2.15, ceiling - 0.2);
        } else if (portal.kind == AccessKind::Opening || portal.kind == AccessKind::Ramp) {
            portal.fullHeight = portal.width > 1.9;
            portal.head = portal.fullHeight ? ceiling : std::min(2.4, ceiling - 0.1);
        }
    }

    /// Opens the walls of one region along the portal; the farthest face from the portal's line, along
    /// `inward`.
    std::optional<double> cut(RegionPlan& region, const Portal& portal, Point2 inward) const {
        std::optional<double> face;
        Point2 middle = (portal.a + portal.b) * 0.5;
        auto open = [&](PlanEdge& edge) {
            double from = std::clamp(edge.metresOf(portal.a), 0.0, edge.length);
            double to = std::clamp(edge.metresOf(portal.b), 0.0, edge.length);
            if (from > to) std::swap(from, to);
            if (to - from < 0.02) return;
            bool full = portal.fullHeight;
            edge.cuts.push_back({from, to, portal.sill, full ? 1.0e3 : portal.head});
            double depth = dot(edge.at((from + to) / 2, edge.inset) - middle, inward);
            face = face ? std::max(*face, depth) : depth;
        };
        for (double reach : {0.45, 1.2}) {
            for (PlanEdge& edge : region.edges) {
                bool parallel = std::abs(dot(edge.along, portal.along)) > 0.94;
                if (parallel && std::abs(dot(middle - edge.a, edge.inward)) <= reach &&
                    dot(edge.inward, inward) > 0.0)
                    open(edge);
            }
            if (face) return face;
        }
        // Drawn askew: the wall that is nearest opens where the door falls on it.
        PlanEdge* best = nullptr;
        double least = 1.5;
        for (PlanEdge& edge : region.edges) {
            double gap = distanceToSegment(middle, edge.a, edge.b);
            if (gap < least) {
                least = gap;
                best = &edge;
            }
        }
        if (!best) return face;
        double at = std::clamp(best->metresOf(middle), 0.0, best->length), half = portal.width / 2;
        best->cuts.push_back({std::max(0.0, at - half), std::min(best->length, at + half), portal.sill,
                              portal.fullHeight ? 1.0e3 : portal.head});
        return face;
    }

    void addWindows() {
        std::vector<bool> drawn(m_plan.regions.size(), false);
        const auto& landmarks = m_building.landmarks();
        for (std::size_t i = 0; i < landmarks.size(); ++i) {
            if (landmarks[i].kind != Kind::Window || !isFinite(landmarks[i].position)) continue;
            auto region = m_building.regionIndex(landmarks[i].region);
            if (!region) region = m_building.regionAt(landmarks[i].position, landmarks[i].level);
            if (!region) continue;
            drawn[*region] = true;
            addMappedWindow(i, *region);
        }
        if (!m_seededWindows) return;
        for (RegionPlan& plan : m_plan.regions) {
            const building::Region& region = m_building.regions()[plan.region];
            bool lit = region.kind == RegionKind::Room || region.kind == RegionKind::Hall ||
                       region.kind == RegionKind::Corridor;
            if (!lit || region.level < 0.0 || drawn[plan.region]) continue;
            for (PlanEdge& edge : plan.edges)
                for (const auto& [from, to] : edge.outer)
                    if (to - from > 2.2) addWindowsAlong(plan, edge, region, from, to);
        }
    }

    static bool outerAt(const PlanEdge& edge, double from, double to) {
        return std::any_of(edge.outer.begin(), edge.outer.end(),
                           [&](const auto& part) { return part.first <= from && part.second >= to; });
    }
    static bool taken(const PlanEdge& edge, double from, double to) {
        return std::any_of(edge.cuts.begin(), edge.cuts.end(),
                           [&](const Cut& cut) { return cut.from < to && cut.to > from; });
    }

    /// A window that the map has as a landmark is a hole in the outer wall, where there is one.
    void addMappedWindow(std::size_t index, std::size_t region) {
        const building::Landmark& landmark = m_building.landmarks()[index];
        Point2 at = landmark.position - m_plan.origin;
        auto measure = [](const std::optional<double>& given, double usual) {
            return given && *given > 0.2 && *given < 8.0 ? *given : usual;
        };
        double width = measure(landmark.widthM, 1.2), tall = measure(landmark.tallM, 1.2);
        double ceiling = m_plan.storeys.at(m_building.regions()[region].level).ceilingM;
        double top = std::min(measure(landmark.heightM, 1.55) + tall / 2, ceiling - 0.06);
        for (PlanEdge& edge : m_plan.regions[region].edges) {
            double metres = edge.metresOf(at), from = metres - width / 2, to = metres + width / 2;
            if (distanceToSegment(at, edge.a, edge.b) > 0.5 || from < edge.from || to > edge.to) continue;
            if (landmark.heading) {
                Point2 faces{std::cos(landmark.heading->value), std::sin(landmark.heading->value)};
                if (dot(faces, edge.inward) < 0.7) continue;
            }
            if (!outerAt(edge, from, to) || taken(edge, from, to)) continue;
            addWindow(m_plan.regions[region], edge, {from, to, std::max(0.1, top - tall), top});
            m_plan.portals.back().landmark = index;
            return;
        }
    }

    void addWindow(const RegionPlan& plan, PlanEdge& edge, const Cut& hole) {
        edge.cuts.push_back(hole);
        Portal portal;
        portal.access = kSeededWindow;
        portal.kind = AccessKind::Window;
        portal.a = edge.at(hole.from, 0.0);
        portal.b = edge.at(hole.to, 0.0);
        portal.width = hole.to - hole.from;
        portal.along = edge.along;
        portal.normal = edge.inward;
        portal.sill = hole.bottom;
        portal.head = hole.top;
        portal.front = edge.inset;
        portal.back = -0.2;
        portal.into = plan.region;
        m_plan.portals.push_back(portal);
    }

    void addWindowsAlong(RegionPlan& plan, PlanEdge& edge, const building::Region& region, double from,
                         double to) {
        constexpr double kWindowM = 1.3, kStepM = 2.4;
        int count = static_cast<int>(std::min((to - from - 0.6) / kStepM, 100.0));
        double ceiling = m_plan.storeys.at(region.level).ceilingM;
        for (int i = 0; i < count; ++i) {
            Draw draw(hashOf(hashOf(m_seed, region.id.value), static_cast<std::uint64_t>(i) + 7));
            if (draw.chance(0.2)) continue;
            double at = (from + to) / 2 + (i - (count - 1) / 2.0) * kStepM;
            Cut hole{at - kWindowM / 2, at + kWindowM / 2, 0.95, std::min(2.2, ceiling - 0.2)};
            std::span<const std::size_t> landmarks = m_building.landmarksOf(plan.region);
            bool hung = std::any_of(landmarks.begin(), landmarks.end(), [&](std::size_t landmark) {
                Point2 p = m_building.landmarks()[landmark].position - m_plan.origin;
                return distanceToSegment(p, edge.at(hole.from, 0.0), edge.at(hole.to, 0.0)) < 0.8;
            });
            if (!hung && !taken(edge, hole.from - 0.2, hole.to + 0.2)) addWindow(plan, edge, hole);
        }
    }

    const building::Building& m_building;
    std::uint64_t m_seed;
    bool m_seededWindows;
    building::LevelRegions m_regions;
    ScenePlan m_plan;
};

} // namespace

ScenePlan planScene(const building::Building& building, std::uint64_t seed, bool windows) {
    return Planner(building, seed, windows).plan();
}

} // namespace farol::simulation
