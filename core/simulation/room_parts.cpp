#include "core/simulation/hash.h"
#include "core/simulation/scene_parts.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

namespace {

using building::RegionKind;

constexpr double kSeam = 0.02; ///< pieces reach so far under their neighbours

struct Storey3 { ///< heights of one region
    double floor = 0.0, ceiling = 0.0, wallTop = 0.0;
};

Storey3 heightsOf(const SceneData& scene, const RegionPlan& plan) {
    const building::Region& region = scene.building->regions()[plan.region];
    const Storey& storey = scene.plan.storeys.at(region.level);
    Storey3 heights;
    heights.floor = storey.floorZ + plan.floorLift;
    heights.ceiling = storey.floorZ + storey.ceilingM;
    // Walls about a flight of stairs reach up to the next floor.
    heights.wallTop = plan.ceilingKept ? storey.floorZ + storey.riseM : heights.ceiling + kSeam;
    return heights;
}

Polygon keptOf(const RegionPlan& plan, const std::optional<HalfPlane>& kept) {
    return kept ? clipped(plan.polygon, kept->onLine, kept->keep) : plan.polygon;
}

void addFlat(SceneData& scene, const Polygon& polygon, Point2 axis, double z, const Paint& paint, bool up) {
    std::vector<Band> bands = bandsOf(polygon, axis, 0.004);
    if (bands.empty()) return;
    MeshBuilder builder(scene.mesh);
    Point2 across{-axis.y, axis.x};
    // Seen from above v runs against the second axis, from below along it.
    std::uint32_t plane = builder.surface(vecOf(polygon.outer.front(), z), flatVec(axis),
                                          flatVec(across * (up ? -1.0 : 1.0)), paint);
    for (const Band& band : bands)
        builder.quad(plane, vecOf(band[0], z), vecOf(band[1], z), vecOf(band[2], z), vecOf(band[3], z));
}

/// The solid parts of a wall between its cuts: rectangles in metres along and heights above the floor.
std::vector<Cut> solidParts(const PlanEdge& edge, double top) {
    std::vector<double> stops{edge.from, edge.to};
    for (const Cut& cut : edge.cuts) {
        stops.push_back(std::clamp(cut.from, edge.from, edge.to));
        stops.push_back(std::clamp(cut.to, edge.from, edge.to));
    }
    std::sort(stops.begin(), stops.end());
    std::vector<Cut> parts;
    for (std::size_t i = 1; i < stops.size(); ++i) {
        double from = stops[i - 1], to = stops[i], middle = (from + to) / 2;
        if (to - from < 1.0e-4) continue;
        std::vector<std::pair<double, double>> open;
        for (const Cut& cut : edge.cuts)
            if (cut.from < middle && cut.to > middle) open.emplace_back(cut.bottom, cut.top);
        std::sort(open.begin(), open.end());
        double z = 0.0;
        for (const auto& [bottom, high] : open) {
            if (bottom > z + 1.0e-4) parts.push_back({from, to, z, std::min(bottom, top)});
            z = std::max(z, high);
        }
        if (z < top - 1.0e-4) parts.push_back({from, to, z, top});
    }
    return parts;
}

class WallMaker {
public:
    WallMaker(SceneData& scene, const RegionPlan& plan, const RegionStyle& style)
        : m_builder(scene.mesh), m_plan(plan), m_style(style), m_heights(heightsOf(scene, plan)) {}

    void inner(const PlanEdge& edge) {
        if (edge.to - edge.from < 1.0e-3) return;
        double top = m_heights.wallTop - m_heights.floor;
        std::vector<Cut> parts = solidParts(edge, top);
        if (parts.empty()) return;
        double dado = m_style.dadoM;
        if (dado > 0.0) {
            paint(edge, parts, -kSeam, dado, m_style.lowerWall);
            paint(edge, parts, dado, top, m_style.wall);
        } else {
            paint(edge, parts, -kSeam, top, m_style.wall);
        }
        for (const Cut& part : parts)
            if (part.bottom < 0.01) skirting(edge, onFloor(edge, part));
    }

    /// The building's skin, seen from the street and through windows of other wings.
    void outer(const PlanEdge& edge, double from, double to) {
        constexpr double kSkinM = 0.2;
        double top = m_heights.ceiling - m_heights.floor + 0.45;
        Paint skin =
            paintOf(m_style.seed % 3 == 0 ? Material::Brick : Material::Plaster, linearOf(226, 216, 200));
        PlanEdge outside = edge;
        outside.from = from;
        outside.to = to;
        Vec3 origin = vecOf(edge.at(outside.from, -kSkinM), m_heights.floor + top);
        std::uint32_t plane = m_builder.surface(origin, flatVec(edge.along), kUp * -1.0F, skin);
        for (const Cut& part : solidParts(outside, top)) {
            double bottom = part.bottom < 0.01 ? -0.35 : part.bottom;
            quad(plane, edge, part.from, part.to, bottom, part.top, -kSkinM);
        }
    }

private:
    void quad(std::uint32_t plane, const PlanEdge& edge, double left, double right, double low, double high,
              double depth) {
        double z = m_heights.floor;
        Point2 l = edge.at(left, depth), r = edge.at(right, depth);
        m_builder.quad(plane, vecOf(l, z + high), vecOf(r, z + high), vecOf(r, z + low), vecOf(l, z + low));
    }

    void paint(const PlanEdge& edge, const std::vector<Cut>& parts, double low, double high,
               const Paint& look) {
        // From inside one looks against `inward`: right is the other way along.
        Vec3 origin = vecOf(edge.at(edge.to, edge.inset), m_heights.wallTop);
        std::uint32_t plane = m_builder.surface(origin, flatVec(edge.along * -1.0), kUp * -1.0F, look);
        for (const Cut& part : parts) {
            double bottom = std::max(low, part.bottom < 0.01 ? -kSeam : part.bottom),
                   top = std::min(high, part.top);
            if (top - bottom > 1.0e-4) quad(plane, edge, part.to, part.from, bottom, top, edge.inset);
        }
    }

    /// Above a flight of stairs there is no floor for a skirting to stand on.
    Cut onFloor(const PlanEdge& edge, Cut part) const {
        if (!m_plan.floorKept) return part;
        auto depthAt = [&](double metres) {
            return dot(edge.at(metres, edge.inset) - m_plan.floorKept->onLine, m_plan.floorKept->keep);
        };
        double first = depthAt(part.from), last = depthAt(part.to);
        if (first <= 0.0 && last <= 0.0) return {part.from, part.from, 0.0, 0.0};
        double crossing = part.from + (part.to - part.from) * first / (first - last);
        if (first < 0.0) part.from = crossing;
        if (last < 0.0) part.to = crossing;
        return part;
    }

    void skirting(const PlanEdge& edge, const Cut& part) {
        if (part.to - part.from < 1.0e-3) return;
        constexpr double kTallM = 0.09, kThickM = 0.012;
        double depth = edge.inset + kThickM, z = m_heights.floor;
        Point2 left = edge.at(part.to, depth), right = edge.at(part.from, depth);
        Vec3 along = flatVec(right - left);
        m_builder.rect(vecOf(left, z + kTallM), along, kUp * static_cast<float>(-kTallM - kSeam),
                       m_style.skirting);
        m_builder.rect(vecOf(edge.at(part.to, edge.inset), z + kTallM), along, flatVec(edge.inward * kThickM),
                       m_style.skirting);
    }

    MeshBuilder m_builder;
    const RegionPlan& m_plan;
    const RegionStyle& m_style;
    Storey3 m_heights;
};

/// A region as large as a town is lit sparsely rather than for hours.
int lampsAlong(double metres, double step) {
    return static_cast<int>(std::lround(std::clamp(metres / step, 1.0, 60.0)));
}

/// Parts of a line that run through the open floor of a region, clear of its borders and doors.
void addDrawnWall(SceneData& scene, std::size_t region, Point2 a, Point2 b, double floor, double top) {
    const RegionPlan& plan = scene.plan.regions[region];
    constexpr double kStep = 0.1, kClear = 0.35, kHalfThick = 0.05;
    double whole = distance(a, b);
    int count = static_cast<int>(whole / kStep);
    if (count < 2 || count > 100000) return;
    Point2 along = (b - a) * (1.0 / whole), side = Point2{-along.y, along.x} * kHalfThick;
    std::vector<const Portal*> portals;
    for (const Portal& portal : scene.plan.portals)
        if (portal.into == region || portal.outOf == region) portals.push_back(&portal);
    auto free = [&](Point2 p) {
        if (!contains(plan.polygon, p)) return false;
        for (const PlanEdge& edge : plan.edges)
            if (distanceToSegment(p, edge.a, edge.b) < kClear) return false;
        for (const Portal* portal : portals)
            if (distanceToSegment(p, portal->a, portal->b) < 1.0) return false;
        return true;
    };
    MeshBuilder builder(scene.mesh);
    int start = -1;
    for (int i = 0; i <= count + 1; ++i) {
        bool open = i <= count && free(a + along * (i * kStep));
        if (open && start < 0) start = i;
        if (open || start < 0) continue;
        if (i - 1 - start >= 3) {
            Point2 from = a + along * (start * kStep), to = a + along * ((i - 1) * kStep);
            builder.box(vecOf(from - side, floor), flatVec(to - from), flatVec(side * 2.0),
                        kUp * static_cast<float>(top - floor), scene.styles[region].wall, 0b110000U);
        }
        start = -1;
    }
}

} // namespace

void addRooms(SceneData& scene) {
    for (const RegionPlan& plan : scene.plan.regions) {
        if (plan.polygon.outer.empty()) continue;
        const RegionStyle& style = scene.styles[plan.region];
        Storey3 heights = heightsOf(scene, plan);
        addFlat(scene, keptOf(plan, plan.floorKept), plan.axis, heights.floor, style.floor, true);
        if (plan.outside) continue;
        addFlat(scene, keptOf(plan, plan.ceilingKept), plan.axis, heights.ceiling, style.ceiling, false);
        WallMaker walls(scene, plan, style);
        for (const PlanEdge& edge : plan.edges) {
            walls.inner(edge);
            for (const auto& [from, to] : edge.outer) walls.outer(edge, from, to);
        }
    }
}

void addDrawnWalls(SceneData& scene) {
    const building::Building& building = *scene.building;
    for (const building::Wall& wall : building.data().walls) {
        for (std::size_t i = 1; i < wall.line.size(); ++i) {
            Point2 a = wall.line[i - 1], b = wall.line[i];
            if (!isFinite(a) || !isFinite(b)) continue;
            // A partition stands within one region: the one in its middle.
            auto region = building.regionAt((a + b) * 0.5, wall.level);
            if (!region || scene.plan.regions[*region].outside) continue;
            Storey3 heights = heightsOf(scene, scene.plan.regions[*region]);
            addDrawnWall(scene, *region, a - scene.plan.origin, b - scene.plan.origin, heights.floor,
                         heights.ceiling);
        }
    }
}

void addGround(SceneData& scene) {
    // At the lowest floor that is not a basement.
    double z = scene.plan.storeys.all().back().floorZ;
    for (const Storey& storey : scene.plan.storeys.all())
        if (storey.ordinal >= 0.0) z = std::min(z, storey.floorZ);
    Polygon ground;
    double reach = 60.0;
    for (const RegionPlan& plan : scene.plan.regions)
        for (Point2 p : plan.polygon.outer)
            reach = std::max({reach, std::abs(p.x) + 60.0, std::abs(p.y) + 60.0});
    reach *= 2.0;
    ground.outer = {{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}};
    for (const RegionPlan& plan : scene.plan.regions) {
        const building::Region& region = scene.building->regions()[plan.region];
        bool through = scene.plan.storeys.at(region.level).floorZ < z - 0.5 && plan.ceilingKept.has_value();
        if (through && !plan.polygon.outer.empty()) ground.holes.push_back(plan.polygon.outer);
    }
    addFlat(scene, ground, {1.0, 0.0}, z - 0.03, paintOf(Material::Grass, linearOf(236, 226, 200)), true);
}

void addLamps(SceneData& scene) {
    scene.lampsOf.assign(scene.plan.regions.size(), {0, 0});
    for (const RegionPlan& plan : scene.plan.regions) {
        if (plan.polygon.outer.empty() || plan.outside) continue;
        const building::Region& region = scene.building->regions()[plan.region];
        const RegionStyle& style = scene.styles[plan.region];
        Polygon roof = keptOf(plan, plan.ceilingKept);
        if (roof.outer.empty()) continue;
        Storey3 heights = heightsOf(scene, plan);
        Point2 axis = plan.axis, across{-axis.y, axis.x};
        double lowU = 1e9, highU = -1e9, lowV = 1e9, highV = -1e9;
        for (Point2 p : roof.outer) {
            lowU = std::min(lowU, dot(p, axis));
            highU = std::max(highU, dot(p, axis));
            lowV = std::min(lowV, dot(p, across));
            highV = std::max(highV, dot(p, across));
        }
        bool corridor = region.kind == RegionKind::Corridor;
        double step = corridor ? 2.9 : 2.6;
        double half = style.lampKind == 1 ? 0.6 : 0.3, narrow = style.lampKind == 1 ? 0.15 : 0.3;
        int columns = lampsAlong(highU - lowU, step);
        int rows = lampsAlong(highV - lowV, step);
        std::size_t firstLamp = scene.lamps.size();
        int placed = 0;
        auto place = [&](Point2 at) {
            Vec3 corner = vecOf(at - axis * half + across * narrow, heights.ceiling - 0.03);
            MeshBuilder builder(scene.mesh);
            Paint lamp = paintOf(Material::LampPrism, style.lampColour);
            lamp.glow = 4.0F;
            Vec3 u = flatVec(axis * (2 * half)), v = flatVec(across * (-2 * narrow));
            builder.rect(corner + v, u, v * -1.0F, lamp);
            Paint rim = paintOf(Material::Plain, linearOf(200, 200, 200));
            Vec3 deep{0.0F, 0.0F, 0.03F};
            builder.box(corner + v, u, v * -1.0F, deep, rim, 0b110000U);
            float strength = static_cast<float>(1.15 * std::sqrt(half * narrow / 0.09));
            scene.lamps.push_back(
                {vecOf(at, heights.ceiling - 0.06), kUp * -1.0F, style.lampColour * strength});
            ++placed;
        };
        for (int i = 0; i < columns; ++i) {
            for (int k = 0; k < rows; ++k) {
                Point2 at = axis * (lowU + (i + 0.5) * (highU - lowU) / columns) +
                            across * (lowV + (k + 0.5) * (highV - lowV) / rows);
                double clear = 1.0e9;
                for (const PlanEdge& edge : plan.edges)
                    clear = std::min(clear, distanceToSegment(at, edge.a, edge.b));
                if (contains(roof, at) && clear > half * 0.75) place(at);
            }
        }
        if (placed == 0) place(pointInside(roof)); // narrow or bent: at least one
        scene.lampsOf[plan.region] = {firstLamp, scene.lamps.size()};
    }
}

} // namespace farol::simulation
