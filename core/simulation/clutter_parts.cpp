#include "core/simulation/furniture.h"
#include "core/simulation/hash.h"
#include "core/simulation/scene_parts.h"
#include "core/simulation/sign_pictures.h"
#include "core/simulation/wall_spots.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

namespace {

using building::RegionKind;

/// Things that no map has. What stands on the floor keeps to the walls and off the doors.
class ClutterMaker {
public:
    ClutterMaker(SceneData& scene, const SceneOptions& options, std::size_t region)
        : m_scene(scene),
          m_options(options),
          m_region(region),
          m_plan(scene.plan.regions[region]),
          m_builder(scene.mesh),
          m_draw(hashOf(hashOf(options.seed, 31), scene.building->regions()[region].id.value)),
          m_floor(scene.plan.storeys.at(scene.building->regions()[region].level).floorZ + m_plan.floorLift),
          m_ceiling(scene.plan.storeys.at(scene.building->regions()[region].level).ceilingM) {
        for (const PlanEdge& edge : m_plan.edges) m_around += edge.length;
    }

    void fixtures() {
        for (const Portal& portal : m_scene.plan.portals) {
            if (portal.kind == building::AccessKind::Window && portal.into == m_region) radiatorUnder(portal);
            bool door = portal.kind == building::AccessKind::Door && !portal.lift;
            if (door && (portal.into == m_region || portal.outOf == m_region)) switchBeside(portal);
        }
        for (const PlanEdge& edge : m_plan.edges) sockets(edge);
        ceilingThings();
    }

    void clutter() {
        const building::Region& region = m_scene.building->regions()[m_region];
        double size = area(m_plan.polygon);
        double expected = m_options.clutter * std::min(size, 400.0) / 5.0;
        int count = static_cast<int>(expected + m_draw.unit());
        double breadth = 2.0 * size / std::max(m_around, 1.0); // of a corridor: its width
        bool tight =
            breadth < 1.9 || region.kind == RegionKind::Stairwell || region.kind == RegionKind::Toilet;
        for (int i = 0; i < count; ++i) {
            double choice = m_draw.unit();
            if (tight || choice < 0.42)
                flat(choice / (tight ? 1.0 : 0.42));
            else if (choice < 0.62)
                standing(0.5, 0.35, [&](const Spot& spot) { addBag(m_builder, spot, m_draw.bits()); });
            else if (choice < 0.74 && breadth > 2.2)
                standing(0.6, 0.6, [&](const Spot& spot) { addPerson(m_builder, spot, m_draw.bits()); });
            else if (choice < 0.86)
                standing(1.2, 0.5, [&](const Spot& spot) {
                    double tall = m_draw.chance(0.5) ? 0.8 : m_draw.between(1.2, 1.9);
                    addFurniture(m_builder, spot, {m_draw.between(0.7, 1.2), tall, 0.4}, m_draw.bits());
                });
            else if (choice < 0.93)
                standing(0.6, 0.5, [&](const Spot& spot) {
                    addPlant(m_builder, spot, {0.6, m_draw.between(0.9, 1.6), 0.5}, m_draw.bits());
                });
            else
                standing(0.5, 0.45, [&](const Spot& spot) {
                    addBin(m_builder, spot, {0.36, m_draw.between(0.5, 0.8), 0.36}, m_draw.bits());
                });
        }
    }

private:
    /// A whole piece of wall of that width, away from doors and from what the map has.
    std::optional<WallSpot> freeWall(double width, double bottom, double top, double clear) {
        for (int attempt = 0; attempt < 6; ++attempt) {
            double place = m_draw.unit() * m_around;
            for (const PlanEdge& edge : m_plan.edges) {
                if (place > edge.length) {
                    place -= edge.length;
                    continue;
                }
                double from = place - width / 2, to = place + width / 2;
                if (!solidWall(edge, from - 0.1, to + 0.1, bottom, top)) break;
                WallSpot spot{&edge, place, edge.at(place, edge.inset), 0.0};
                if (!taken(spot.position, width / 2 + clear)) return spot;
                break;
            }
        }
        return std::nullopt;
    }

    bool taken(Point2 p, double radius) {
        const building::Building& map = *m_scene.building;
        for (std::size_t i : map.landmarksOf(m_region)) {
            const building::Landmark& landmark = map.landmarks()[i];
            double own = landmark.widthM.value_or(0.6) / 2;
            if (distance(landmark.position - m_scene.plan.origin, p) < radius + own) return true;
        }
        for (const auto& [at, own] : m_taken)
            if (distance(at, p) < radius + own) return true;
        for (const Portal& portal : m_scene.plan.portals) {
            bool ours = portal.into == m_region || portal.outOf == m_region;
            if (ours && portal.sill < 0.5 && distanceToSegment(p, portal.a, portal.b) < radius + 0.25)
                return true;
        }
        return false;
    }

    Spot spotOn(const WallSpot& wall, double z) const {
        return spotAt(vecOf(wall.position + wall.edge->inward * 0.001, m_floor + z), wall.edge->inward);
    }

    template <class Add>
    void standing(double width, double deep, const Add& add) {
        auto wall = freeWall(width, 0.0, 1.0, 0.5);
        if (!wall) return;
        // Not where the room is too narrow to pass.
        Point2 across = wall->edge->at(wall->metres, wall->edge->inset + deep + 0.9);
        if (!contains(m_plan.polygon, across)) return;
        m_taken.emplace_back(wall->position, width / 2);
        add(spotOn(*wall, 0.0));
    }

    /// Posters that nobody mapped, notices, and things that look like landmarks.
    void flat(double choice) {
        double width = m_draw.between(0.25, 0.75), tall = width * m_draw.between(0.7, 1.45),
               z = m_draw.between(1.3, 1.65);
        tall = std::min(tall, 2.0 * (m_ceiling - z - 0.05));
        auto wall = freeWall(width, z - tall / 2, z + tall / 2, 0.12);
        if (!wall) return;
        m_taken.emplace_back(wall->position, width / 2);
        std::uint64_t seed = m_draw.bits();
        if (choice > 0.92) { // the same red cylinder that the map has elsewhere
            Spot spot = spotOn(*wall, 0.95);
            addExtinguisher(m_scene, m_builder, spot, {0.17, 0.55, 0.2}, seed);
            return;
        }
        cv::Mat picture = choice < 0.2    ? noticeBoard(width / tall, seed)
                          : choice < 0.35 ? paintedPicture(width / tall, seed)
                                          : poster("", width / tall, seed);
        addBoard(m_builder, spotOn(*wall, z), {width, tall, 0.006}, addTexture(m_scene, picture),
                 linearOf(180, 180, 180));
    }

    void radiatorUnder(const Portal& portal) {
        Point2 middle = (portal.a + portal.b) * 0.5;
        auto wall = wallSpot(m_scene, m_region, middle, std::nullopt, portal.width, 0.6);
        if (!wall || !solidWall(*wall->edge, wall->metres - 0.5, wall->metres + 0.5, 0.1, 0.8)) return;
        if (taken(wall->position, 0.5)) return;
        m_taken.emplace_back(wall->position, 0.6);
        addRadiator(m_builder, spotOn(*wall, 0.0), std::min(1.0, portal.width * 0.8));
    }

    void switchBeside(const Portal& portal) {
        Draw draw(hashOf(m_scene.building->accesses().size(), static_cast<std::uint64_t>(portal.access)));
        Point2 at = draw.chance(0.5) ? portal.a - portal.along * 0.22 : portal.b + portal.along * 0.22;
        auto wall = wallSpot(m_scene, m_region, at, std::nullopt, 0.1, 0.25);
        if (!wall || !solidWall(*wall->edge, wall->metres - 0.06, wall->metres + 0.06, 1.0, 1.2)) return;
        plate(spotOn(*wall, 1.1), 0.085, 0.085, linearOf(242, 242, 238), linearOf(222, 222, 218));
    }

    void sockets(const PlanEdge& edge) {
        int count = static_cast<int>(std::min(edge.length / 3.5, 100.0));
        for (int i = 0; i < count; ++i) {
            double at = (i + m_draw.between(0.2, 0.8)) * edge.length / count;
            if (m_plan.floorKept || !solidWall(edge, at - 0.1, at + 0.1, 0.1, 0.5)) continue;
            Spot spot = spotAt(vecOf(edge.at(at, edge.inset + 0.001), m_floor + 0.32), edge.inward);
            plate(spot, m_draw.chance(0.5) ? 0.16 : 0.085, 0.085, linearOf(240, 240, 236),
                  linearOf(90, 90, 90));
        }
    }

    void plate(const Spot& spot, double width, double tall, Vec3 colour, Vec3 inner) {
        m_builder.box(spot.at(-width / 2, -tall / 2, 0.01), spot.right * static_cast<float>(width),
                      spot.front * -0.01F, kUp * static_cast<float>(tall), paintOf(Material::Plain, colour));
        m_builder.rect(spot.at(-width * 0.28, tall * 0.28, 0.0115),
                       spot.right * static_cast<float>(width * 0.56), kUp * static_cast<float>(-tall * 0.56),
                       paintOf(Material::Plain, inner));
    }

    /// Smoke detectors and air outlets.
    void ceilingThings() {
        int count = std::clamp(static_cast<int>(area(m_plan.polygon) / 14.0 + m_draw.unit()), 0, 30);
        auto box = boundingBox(m_plan.polygon.outer);
        Paint white = paintOf(Material::Plain, linearOf(240, 240, 236)),
              dark = paintOf(Material::Plain, linearOf(120, 122, 124));
        for (int i = 0; i < count; ++i) {
            Point2 p{m_draw.between(box->low.x, box->high.x), m_draw.between(box->low.y, box->high.y)};
            bool inside = contains(m_plan.polygon, p);
            for (const PlanEdge& edge : m_plan.edges)
                inside = inside && distanceToSegment(p, edge.a, edge.b) > 0.45;
            if (m_plan.ceilingKept && dot(p - m_plan.ceilingKept->onLine, m_plan.ceilingKept->keep) < 0.3)
                inside = false;
            auto [first, behind] = m_scene.lampsOf[m_region];
            for (std::size_t k = first; k < behind; ++k) {
                const Lamp& lamp = m_scene.lamps[k];
                Vec3 way = lamp.position - vecOf(p, m_floor + m_ceiling);
                if (inside && way.x * way.x + way.y * way.y < 0.8F && std::abs(way.z) < 0.5F) inside = false;
            }
            if (!inside) continue;
            auto top = static_cast<float>(m_floor + m_ceiling);
            if (m_draw.chance(0.65)) {
                Vec3 foot = vecOf(p, 0.0);
                m_builder.lathe({foot.x, foot.y, top},
                                {{0.0F, -0.055F}, {0.035F, -0.05F}, {0.055F, -0.02F}, {0.055F, 0.0F}}, 12,
                                white);
            } else {
                Vec3 a = flatVec(m_plan.axis * 0.4), b = flatVec(Point2{-m_plan.axis.y, m_plan.axis.x} * 0.4);
                Vec3 corner = vecOf(p, 0.0) - a * 0.5F - b * 0.5F;
                corner.z = top - 0.012F;
                m_builder.rect(corner, a, b, white);
                for (int k = 1; k < 6; ++k)
                    m_builder.rect(corner + b * (static_cast<float>(k) / 6.0F) + a * 0.08F + kUp * -0.001F,
                                   a * 0.84F, b * 0.06F, dark);
            }
        }
    }

    SceneData& m_scene;
    const SceneOptions& m_options;
    std::size_t m_region;
    const RegionPlan& m_plan;
    MeshBuilder m_builder;
    Draw m_draw;
    double m_floor, m_ceiling, m_around = 0.0;
    std::vector<std::pair<Point2, double>> m_taken;
};

/// Buttons beside the door and a rail on the walls that have none.
void addCar(SceneData& scene, std::size_t region) {
    const RegionPlan& plan = scene.plan.regions[region];
    const Storey& storey = scene.plan.storeys.at(scene.building->regions()[region].level);
    MeshBuilder builder(scene.mesh);
    Paint rail = paintOf(Material::Metal, linearOf(120, 122, 126));
    bool panel = false;
    for (const PlanEdge& edge : plan.edges) {
        double middle = (edge.from + edge.to) / 2, room = edge.to - edge.from;
        if (room < 0.5) continue;
        if (edge.cuts.empty()) {
            Vec3 from = vecOf(edge.at(edge.from + 0.1, edge.inset + 0.06), storey.floorZ + 0.9);
            Vec3 to = vecOf(edge.at(edge.to - 0.1, edge.inset + 0.06), storey.floorZ + 0.9);
            builder.beam(from, to, 0.035F, rail);
        }
        if (!panel && edge.cuts.empty() && room > 0.8) {
            panel = true;
            Spot spot = spotAt(vecOf(edge.at(middle + room * 0.22, edge.inset + 0.001), storey.floorZ + 1.25),
                               edge.inward);
            addBoard(builder, spot, {0.16, 0.6, 0.015}, addTexture(scene, buttonPanel(hashOf(9, region))),
                     linearOf(150, 150, 150));
        }
    }
}

} // namespace

void addLifts(SceneData& scene) {
    for (const RegionPlan& plan : scene.plan.regions)
        if (!plan.polygon.outer.empty() &&
            scene.building->regions()[plan.region].kind == RegionKind::Elevator)
            addCar(scene, plan.region);
}

void addClutter(SceneData& scene, const SceneOptions& options) {
    for (const RegionPlan& plan : scene.plan.regions) {
        RegionKind kind = scene.building->regions()[plan.region].kind;
        if (plan.polygon.outer.empty() || plan.outside || kind == RegionKind::Elevator) continue;
        ClutterMaker maker(scene, options, plan.region);
        maker.fixtures();
        maker.clutter();
    }
}

} // namespace farol::simulation
