#include "core/simulation/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace farol::simulation {

namespace {

using building::Access;
using building::AccessKind;

/// The box of a polygon along two square axes.
struct TurnedBox {
    Point2 axis, across;
    double lowU = 1.0e9, highU = -1.0e9, lowV = 1.0e9, highV = -1.0e9;

    TurnedBox(const Polygon& polygon, Point2 along) : axis(along), across{-along.y, along.x} {
        for (Point2 p : polygon.outer) {
            lowU = std::min(lowU, dot(p, axis));
            highU = std::max(highU, dot(p, axis));
            lowV = std::min(lowV, dot(p, across));
            highV = std::max(highV, dot(p, across));
        }
    }
    double length() const { return highU - lowU; }
    double width() const { return highV - lowV; }
};

/// Where one comes in: the middle of the region's doors, of both levels.
std::optional<Point2> doorsOf(const SceneData& scene, std::size_t lower, std::size_t upper) {
    Point2 sum;
    int count = 0;
    for (const Portal& portal : scene.plan.portals) {
        bool leads =
            portal.into == lower || portal.outOf == lower || portal.into == upper || portal.outOf == upper;
        if (!leads || portal.kind == AccessKind::Window) continue;
        sum = sum + (portal.a + portal.b) * 0.5;
        ++count;
    }
    if (count == 0) return std::nullopt;
    return sum * (1.0 / count);
}

/// Makes steps of a usual depth fit, or finds that they do not.
bool fitSteps(StairsPlan& stairs, double length) {
    constexpr double kUsualTread = 0.28, kLeastTread = 0.17, kLanding = 1.25;
    int treads = std::max(stairs.firstSteps, stairs.secondSteps) - 1;
    double turn = std::clamp(stairs.width / 2, 0.8, 1.3);
    double room = length - turn - kLanding;
    stairs.tread = std::min(kUsualTread, room / treads);
    if (stairs.tread < 0.22) {
        turn = 0.75;
        stairs.tread = std::min(0.22, (length - turn - 0.9) / treads);
    }
    if (stairs.tread < kLeastTread) return false;
    stairs.far = length;
    stairs.landing = length - turn - treads * stairs.tread;
    return true;
}

std::optional<StairsPlan> planOf(const SceneData& scene, std::size_t accessIndex) {
    const building::Building& map = *scene.building;
    const Access& access = map.accesses()[accessIndex];
    auto a = map.regionIndex(access.regionA), b = map.regionIndex(access.regionB);
    if (!a || !b || *a == *b) return std::nullopt;
    StairsPlan stairs;
    stairs.access = accessIndex;
    bool up = map.regions()[*b].level > map.regions()[*a].level;
    stairs.lower = up ? *a : *b;
    stairs.upper = up ? *b : *a;
    const RegionPlan &low = scene.plan.regions[stairs.lower], &high = scene.plan.regions[stairs.upper];
    if (low.polygon.outer.empty() || high.polygon.outer.empty() || area(low.polygon) > 80.0)
        return std::nullopt;
    if (!contains(high.polygon, pointInside(low.polygon))) return std::nullopt; // not above each other
    stairs.lowZ = scene.plan.storeys.at(map.regions()[stairs.lower].level).floorZ;
    stairs.highZ = scene.plan.storeys.at(map.regions()[stairs.upper].level).floorZ;
    double rise = stairs.highZ - stairs.lowZ;
    if (rise < 1.0 || rise > 12.0) return std::nullopt;
    int steps = static_cast<int>(std::lround(rise / 0.17));
    if (access.steps && rise / *access.steps > 0.12 && rise / *access.steps < 0.23) steps = *access.steps;
    stairs.firstSteps = std::max(3, (steps + 1) / 2);
    stairs.secondSteps = std::max(3, steps - stairs.firstSteps);

    TurnedBox box(low.polygon, low.axis);
    if (box.width() > box.length()) box = TurnedBox(low.polygon, box.across);
    constexpr double kInset = 0.06;
    stairs.width = box.width() - 2 * kInset;
    if (stairs.width < 1.5) return std::nullopt;
    if (!fitSteps(stairs, box.length() - 2 * kInset)) return std::nullopt;

    Point2 centre = box.axis * ((box.lowU + box.highU) / 2) + box.across * ((box.lowV + box.highV) / 2);
    Point2 door = doorsOf(scene, stairs.lower, stairs.upper).value_or(centre - box.axis);
    double towards = dot(door - centre, box.axis) <= 0.0 ? 1.0 : -1.0; // flights lead away from the door
    stairs.along = box.axis * towards;
    // The first flight on the side where the map draws it; else on the right, as one keeps.
    Point2 drawn = access.midpoint() - scene.plan.origin;
    Point2 right{stairs.along.y, -stairs.along.x};
    double side = dot(drawn - centre, right) < -0.3 ? -1.0 : 1.0;
    stairs.across = right * -side;
    stairs.corner = centre - stairs.along * (box.length() / 2 - kInset) - stairs.across * (stairs.width / 2);
    return stairs;
}

class StairsMaker {
public:
    StairsMaker(SceneData& scene, const StairsPlan& stairs)
        : m_scene(scene), m_stairs(stairs), m_builder(scene.mesh), m_style(scene.styles[stairs.lower]) {
        m_half = stairs.width / 2;
        m_riser = (stairs.highZ - stairs.lowZ) / (stairs.firstSteps + stairs.secondSteps);
        m_tread = m_style.floor;
        m_side = paintOf(Material::Concrete, linearOf(220, 218, 212));
        m_edge =
            paintOf(Material::Plain, m_style.seed % 2 == 0 ? linearOf(60, 58, 56) : linearOf(230, 200, 80));
        m_rail = paintOf(Material::Metal, linearOf(110, 112, 116));
    }

    void make() {
        Thing thing;
        thing.stairs = true;
        thing.level = m_scene.building->regions()[m_stairs.lower].level;
        thing.centre = vecOf(m_stairs.at(m_stairs.landing + 0.6, m_half / 2), m_stairs.lowZ + 0.6);
        thing.facing = flatVec(m_stairs.along * -1.0);
        thing.access = m_stairs.access;
        m_builder.setThing(static_cast<std::int32_t>(m_scene.things.size()));
        m_scene.things.push_back(thing);
        double end = m_stairs.landing + m_stairs.tread * (m_stairs.firstSteps - 1);
        flight(m_stairs.landing, 1.0, 0.0, m_stairs.lowZ, m_stairs.firstSteps);
        m_builder.setThing(-1);
        flight(end, -1.0, m_half, m_stairs.middleZ(), m_stairs.secondSteps);
        halfLanding(end);
        slabEdge();
        rails(end);
    }

private:
    Vec3 at(double a, double c, double z) const { return vecOf(m_stairs.at(a, c), z); }

    /// Steps from `start`, up along the first axis times `way`, on the strip from `c0` to `c0` + half the
    /// width.
    void flight(double start, double way, double c0, double z, int risers) {
        constexpr double kGap = 0.05; ///< between the flights
        double left = c0 + (c0 > 0.0 ? kGap : 0.0), right = c0 + m_half - (c0 > 0.0 ? 0.0 : kGap);
        for (int i = 0; i < risers; ++i) {
            double a = start + way * i * m_stairs.tread, low = z + i * m_riser, high = low + m_riser;
            // Faces of a step that look down the flight, and up.
            Vec3 l = at(a, left, high), r = at(a, right, high),
                 down = kUp * static_cast<float>(-m_riser - 0.01);
            facing(l, r, down, m_side, flatVec(m_stairs.along * -way));
            if (i + 1 == risers) break;
            Vec3 deep = flatVec(m_stairs.along * (way * m_stairs.tread));
            flatTop(l, r, deep, m_tread);
            Vec3 lift = kUp * 0.002F;
            flatTop(l + lift, r + lift, flatVec(m_stairs.along * (way * 0.05)), m_edge);
            for (double c : {left, right}) { // the cheek of each step
                Vec3 top = at(a, c, high), foot = kUp * static_cast<float>(-(m_riser + 0.16));
                m_builder.flat(top, top + deep, top + deep + foot, top + foot, m_side);
            }
        }
        double run = m_stairs.tread * (risers - 1);
        Vec3 l = at(start, left, z - 0.14), r = at(start, right, z - 0.14);
        Vec3 rise = flatVec(m_stairs.along * (way * run)) + kUp * static_cast<float>(m_riser * (risers - 1));
        if (m_stairs.across.x * m_stairs.along.y - m_stairs.across.y * m_stairs.along.x > 0.0)
            std::swap(l, r);
        m_builder.flat(l, r, r + rise, l + rise, m_side); // the underside
    }

    /// A rectangle under the edge from l to r that faces `front`.
    void facing(Vec3 l, Vec3 r, Vec3 down, const Paint& paint, Vec3 front) {
        if (dot(cross(down, r - l), front) > 0.0F)
            m_builder.rect(l, r - l, down, paint);
        else
            m_builder.rect(r, l - r, down, paint);
    }
    void flatTop(Vec3 l, Vec3 r, Vec3 deep, const Paint& paint) {
        facing(l + deep, r + deep, deep * -1.0F, paint, kUp);
    }

    void halfLanding(double end) {
        double z = m_stairs.middleZ(), far = m_stairs.far + 0.05;
        Vec3 l = at(end, -0.05, z), r = at(end, m_stairs.width + 0.05, z);
        Vec3 deep = flatVec(m_stairs.along * (far - end)), under = kUp * -0.2F;
        flatTop(l, r, deep, m_tread);
        facing(l + under + deep, r + under + deep, deep * -1.0F, m_side, kUp * -1.0F);
        facing(l, r, under, m_side, flatVec(m_stairs.along * -1.0));
    }

    /// Where the upper floor ends above the flights, one sees how thick it is.
    void slabEdge() {
        const Storey& storey = m_scene.plan.storeys.at(m_scene.building->regions()[m_stairs.lower].level);
        double thick = m_stairs.highZ - (storey.floorZ + storey.ceilingM);
        Vec3 l = at(m_stairs.landing, -0.06, m_stairs.highZ),
             r = at(m_stairs.landing, m_stairs.width + 0.06, m_stairs.highZ);
        facing(l, r, kUp * static_cast<float>(-thick - 0.01), m_side, flatVec(m_stairs.along));
    }

    void railing(Vec3 from, Vec3 to) {
        constexpr float kTall = 0.92F;
        Vec3 way = to - from;
        m_builder.beam(from + kUp * kTall, to + kUp * kTall, 0.045F, m_rail);
        m_builder.beam(from + kUp * 0.5F, to + kUp * 0.5F, 0.02F, m_rail);
        int posts = std::max(1, static_cast<int>(std::lround(length(way) / 0.9F)));
        for (int i = 0; i <= posts; ++i) {
            Vec3 foot = from + way * (static_cast<float>(i) / static_cast<float>(posts));
            m_builder.beam(foot, foot + kUp * kTall, 0.03F, m_rail);
        }
    }

    void rails(double end) {
        double start = end - m_stairs.tread * (m_stairs.secondSteps - 1), z = m_stairs.middleZ();
        railing(at(m_stairs.landing, m_half - 0.04, m_stairs.lowZ + m_riser), at(end, m_half - 0.04, z));
        railing(at(end, m_half + 0.04, z), at(start, m_half + 0.04, m_stairs.highZ));
        // On the walls.
        Vec3 up = kUp * 0.95F;
        m_builder.beam(at(m_stairs.landing, 0.05, m_stairs.lowZ) + up, at(end, 0.05, z) + up, 0.045F, m_rail);
        m_builder.beam(at(end, m_stairs.width - 0.05, z) + up,
                       at(start, m_stairs.width - 0.05, m_stairs.highZ) + up, 0.045F, m_rail);
        // The upper floor needs a rail where no flight goes on upwards.
        if (!m_scene.plan.regions[m_stairs.upper].ceilingKept)
            railing(at(m_stairs.landing - 0.04, 0.0, m_stairs.highZ),
                    at(m_stairs.landing - 0.04, m_half - 0.04, m_stairs.highZ));
    }

    SceneData& m_scene;
    const StairsPlan& m_stairs;
    MeshBuilder m_builder;
    const RegionStyle& m_style;
    double m_half = 1.0, m_riser = 0.17;
    Paint m_tread, m_side, m_edge, m_rail;
};

} // namespace

void planStairs(SceneData& scene) {
    const building::Building& map = *scene.building;
    for (std::size_t i = 0; i < map.accesses().size(); ++i) {
        if (map.accesses()[i].kind != AccessKind::Stairs) continue;
        auto stairs = planOf(scene, i);
        if (!stairs) continue;
        RegionPlan &low = scene.plan.regions[stairs->lower], &high = scene.plan.regions[stairs->upper];
        if (low.ceilingKept || high.floorKept) continue; // one flight of stairs in one well
        HalfPlane kept{stairs->at(stairs->landing, 0.0), stairs->along * -1.0};
        low.ceilingKept = kept;
        high.floorKept = kept;
        scene.stairs.push_back(*stairs);
    }
}

void addStairs(SceneData& scene) {
    for (const StairsPlan& stairs : scene.stairs) StairsMaker(scene, stairs).make();
}

} // namespace farol::simulation
