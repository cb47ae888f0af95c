#include "core/simulation/hash.h"
#include "core/simulation/lettering.h"
#include "core/simulation/scene_parts.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

namespace {

using building::AccessKind;
using building::RegionKind;

constexpr double kLeafM = 0.042, kGapM = 0.006, kCasingM = 0.065, kProudM = 0.018;

/// Points of a portal: metres along it, metres along its normal, height above the floor.
class PortalFrame {
public:
    PortalFrame(const Portal& portal, double floor) : m_portal(portal), m_floor(floor) {}
    Vec3 at(double s, double d, double z) const {
        return vecOf(m_portal.a + m_portal.along * s + m_portal.normal * d, m_floor + z);
    }
    Vec3 along(double metres = 1.0) const { return flatVec(m_portal.along * metres); }
    Vec3 normal(double metres = 1.0) const { return flatVec(m_portal.normal * metres); }
    static Vec3 up(double metres = 1.0) { return kUp * static_cast<float>(metres); }

    /// A box between two corners; its faces look outwards.
    void box(MeshBuilder& builder, double s0, double s1, double d0, double d1, double z0, double z1,
             const Paint& paint, unsigned omit = 0) const {
        builder.box(at(s0, d0, z0), along(s1 - s0), normal(d1 - d0), up(z1 - z0), paint, omit);
    }
    /// A rectangle that faces along the normal (front) or against it.
    void face(MeshBuilder& builder, double s0, double s1, double d, double z0, double z1, const Paint& paint,
              bool front, bool once = false) const {
        Vec3 left = front ? at(s1, d, z1) : at(s0, d, z1);
        Vec3 right = along(front ? s0 - s1 : s1 - s0);
        if (once)
            builder.picture(left, right, up(z0 - z1), paint);
        else
            builder.rect(left, right, up(z0 - z1), paint);
    }

private:
    const Portal& m_portal;
    double m_floor;
};

struct DoorLook {
    Paint leaf, frame, kick, glass, handle;
    bool kickPlate = false, closer = false;
    int window = 0; ///< 0 none, 1 slit, 2 upper half, 3 nearly all
    bool sliding = false;
};

class DoorMaker {
public:
    DoorMaker(SceneData& scene, const SceneOptions& options, const Portal& portal)
        : m_scene(scene),
          m_options(options),
          m_portal(portal),
          m_fixed(scene.mesh),
          m_moving(scene.leafMesh),
          m_frame(portal, floorOf(scene, portal)) {
        const building::Building& building = *scene.building;
        bool seeded = portal.access >= building.accesses().size();
        m_access = seeded ? nullptr : &building.accesses()[portal.access];
        m_seed = hashOf(options.seed, seeded ? "window" : m_access->id.value);
        m_style = &scene.styles[portal.into ? *portal.into : *portal.outOf];
    }

    void make() {
        if (m_portal.kind == AccessKind::Window) {
            window();
        } else if (m_portal.kind == AccessKind::Opening || m_portal.kind == AccessKind::Ramp) {
            jambs(m_style->wall, !m_portal.fullHeight);
            wallFeet();
            if (m_portal.fullHeight) ceilingStrip();
        } else {
            addThing();
            if (m_portal.lift)
                liftDoor();
            else
                door();
        }
        if (m_portal.sill < 0.01) threshold();
    }

private:
    static double floorOf(const SceneData& scene, const Portal& portal) {
        std::size_t region = portal.into ? *portal.into : *portal.outOf;
        return scene.plan.storeys.at(scene.building->regions()[region].level).floorZ;
    }
    RegionKind kindOf(const std::optional<std::size_t>& region) const {
        return region ? m_scene.building->regions()[*region].kind : RegionKind::Outside;
    }
    static bool isWay(RegionKind kind) {
        return kind == RegionKind::Corridor || kind == RegionKind::Hall || kind == RegionKind::Outside ||
               kind == RegionKind::Stairwell;
    }

    void jambs(const Paint& paint, bool head) {
        double w = m_portal.width, d0 = m_portal.back, d1 = m_portal.front, z0 = m_portal.sill - 0.02,
               z1 = m_portal.head;
        Vec3 deep = PortalFrame::up(z0 - z1);
        // Each looks into the opening.
        m_fixed.rect(m_frame.at(0.0, d0, z1), m_frame.normal(d1 - d0), deep, paint);
        m_fixed.rect(m_frame.at(w, d1, z1), m_frame.normal(d0 - d1), deep, paint);
        if (head) m_fixed.rect(m_frame.at(0.0, d0, z1), m_frame.along(w), m_frame.normal(d1 - d0), paint);
        if (m_portal.sill > 0.01)
            m_fixed.rect(m_frame.at(0.0, d1, m_portal.sill), m_frame.along(w), m_frame.normal(d0 - d1),
                         paint);
    }

    /// The lower paint and the skirting of the walls go round into the opening.
    void wallFeet() {
        double w = m_portal.width, d0 = m_portal.back, d1 = m_portal.front;
        auto strip = [&](double out, double z0, double z1, const Paint& paint) {
            Vec3 deep = PortalFrame::up(z0 - z1);
            m_fixed.rect(m_frame.at(out, d0, z1), m_frame.normal(d1 - d0), deep, paint);
            m_fixed.rect(m_frame.at(w - out, d1, z1), m_frame.normal(d0 - d1), deep, paint);
        };
        if (m_style->dadoM > 0.0) strip(0.001, 0.0, m_style->dadoM, m_style->lowerWall);
        strip(0.012, 0.0, 0.09, m_style->skirting);
    }

    void ceilingStrip() {
        double z = m_portal.head, w = m_portal.width, reach = 0.01;
        m_fixed.rect(m_frame.at(0.0, m_portal.back - reach, z - 0.003), m_frame.along(w),
                     m_frame.normal(m_portal.front - m_portal.back + 2 * reach), m_style->ceiling);
    }

    void threshold() {
        bool plain = m_portal.kind == AccessKind::Opening || m_portal.kind == AccessKind::Ramp;
        double thick = m_portal.front - m_portal.back;
        if (plain && thick < 0.15) return; // the floors meet
        Paint paint = plain           ? m_style->floor
                      : m_portal.lift ? paintOf(Material::Metal, linearOf(190, 190, 190))
                                      : paintOf(Material::Plain, linearOf(120, 112, 104));
        double z = 0.022;
        m_fixed.rect(m_frame.at(0.0, m_portal.front, z), m_frame.along(m_portal.width),
                     m_frame.normal(-thick), paint);
        for (bool front : {true, false})
            m_frame.face(m_fixed, 0.0, m_portal.width, front ? m_portal.front : m_portal.back, -0.03, z,
                         paint, front);
    }

    void addThing() {
        Thing thing;
        thing.access = m_portal.access;
        thing.level = m_access->level;
        thing.opening = true;
        thing.lift = m_portal.lift;
        double d = (m_portal.front + m_portal.back) / 2, w = m_portal.width, h = m_portal.head;
        thing.centre = m_frame.at(w / 2, d, h / 2);
        thing.facing = m_frame.normal();
        // As seen from where the normal points to.
        thing.corners = std::array<Vec3, 4>{m_frame.at(w, d, h), m_frame.at(0.0, d, h),
                                            m_frame.at(0.0, d, 0.0), m_frame.at(w, d, 0.0)};
        m_thing = static_cast<std::int32_t>(m_scene.things.size());
        m_scene.things.push_back(thing);
        m_fixed.setThing(m_thing);
        m_moving.setThing(m_thing);
    }

    void casing(const Paint& paint, double wide) {
        double w = m_portal.width, h = m_portal.head;
        for (bool front : {true, false}) {
            if (!(front ? m_portal.into : m_portal.outOf)) continue;
            double d0 = front ? m_portal.front : m_portal.back - kProudM;
            double d1 = front ? m_portal.front + kProudM : m_portal.back;
            m_frame.box(m_fixed, -wide, 0.0, d0, d1, 0.0, h + wide, paint, 0b010000U);
            m_frame.box(m_fixed, w, w + wide, d0, d1, 0.0, h + wide, paint, 0b010000U);
            m_frame.box(m_fixed, 0.0, w, d0, d1, h, h + wide, paint, 0b000011U);
        }
    }

    DoorLook lookOf() const {
        DoorLook look;
        Draw draw(m_seed);
        bool main = isWay(kindOf(m_portal.into)) && isWay(kindOf(m_portal.outOf));
        look.leaf = paintOf(m_style->doorMaterial, m_style->doorTint);
        Vec3 grey = linearOf(150 + draw.below(60), 150 + draw.below(50), 150 + draw.below(40));
        look.frame = draw.chance(0.5) ? paintOf(Material::Plain, grey) : look.leaf;
        look.frame.tint = look.frame.tint * (draw.chance(0.5) ? 0.8F : 1.0F);
        look.kick = paintOf(Material::Metal);
        look.handle = paintOf(Material::Metal, linearOf(200, 200, 204));
        look.handle.gloss = 0.2F;
        look.glass = paintOf(Material::Plain, linearOf(232, 242, 240));
        look.glass.glass = true;
        look.glass.gloss = 0.10F;
        look.kickPlate = draw.chance(main ? 0.8 : 0.35);
        look.closer = draw.chance(0.5);
        double choice = draw.unit();
        look.window = main ? (choice < 0.5 ? 2 : 3) : choice < 0.62 ? 0 : choice < 0.88 ? 1 : 2;
        const std::string& type = m_access->doorType;
        look.sliding = m_access->automatic || type.find("slid") != std::string::npos;
        if (look.sliding) look.window = 3;
        bool outer =
            kindOf(m_portal.into) == RegionKind::Outside || kindOf(m_portal.outOf) == RegionKind::Outside;
        if (outer) look.window = 3;
        return look;
    }

    void door() {
        DoorLook look = lookOf();
        jambs(look.frame, true);
        casing(look.frame, kCasingM);
        bool swingFront = !isWay(kindOf(m_portal.into)) || isWay(kindOf(m_portal.outOf));
        bool pair = m_portal.width > 1.35;
        double middle = m_portal.width / 2;
        Draw draw(m_seed + 1);
        if (pair) {
            leaf(look, kGapM, middle - 0.003, swingFront, true);
            leaf(look, middle + 0.003, m_portal.width - kGapM, swingFront, false);
        } else {
            leaf(look, kGapM, m_portal.width - kGapM, swingFront, draw.chance(0.5));
        }
    }

    /// One leaf between s0 and s1, hinged at s0 (`hingeFirst`) or s1.
    void leaf(const DoorLook& look, double s0, double s1, bool swingFront, bool hingeFirst) {
        double thick = m_portal.front - m_portal.back;
        double d1 = swingFront ? m_portal.front - std::min(0.01, thick / 4) : m_portal.back + kLeafM;
        if (look.sliding || thick < kLeafM) d1 = (m_portal.front + m_portal.back + kLeafM) / 2;
        double d0 = d1 - kLeafM;
        Leaf part;
        part.firstQuad = static_cast<std::uint32_t>(m_scene.leafMesh.quads.size());
        part.firstSurface = static_cast<std::uint32_t>(m_scene.leafMesh.surfaces.size());
        double hinge = hingeFirst ? s0 : s1;
        part.hinge = m_frame.at(hinge, swingFront ? d1 : d0, 0.0);
        part.middle = m_frame.at((s0 + s1) / 2, (d0 + d1) / 2, 1.0);
        bool opens = m_access->passable();
        part.opens = opens;
        if (look.sliding)
            part.slide = m_frame.along((hingeFirst ? -1.0 : 1.0) * (s1 - s0) * 0.95);
        else
            part.swing = (hingeFirst == swingFront ? 1.0F : -1.0F) * 1.52F;
        leafBody(look, s0, s1, d0, d1);
        if (!look.sliding) handles(look, hingeFirst ? s1 - 0.07 : s0 + 0.07, hingeFirst ? -1.0 : 1.0, d0, d1);
        part.lastQuad = static_cast<std::uint32_t>(m_scene.leafMesh.quads.size());
        part.lastSurface = static_cast<std::uint32_t>(m_scene.leafMesh.surfaces.size());
        m_scene.leaves.push_back(part);
    }

    void leafBody(const DoorLook& look, double s0, double s1, double d0, double d1) {
        double z0 = 0.028, z1 = m_portal.head - 0.012, w = s1 - s0;
        double g0 = s0 + 0.16, g1 = s1 - 0.16, gz0 = 1.05, gz1 = z1 - 0.2; // glass
        if (look.window == 1) {
            g0 = s0 + w * 0.64;
            g1 = std::min(s1 - 0.12, g0 + 0.18);
        } else if (look.window == 3) {
            g0 = s0 + 0.1;
            g1 = s1 - 0.1;
            gz0 = 0.35;
            gz1 = z1 - 0.12;
        }
        bool glazed = look.window > 0 && g1 - g0 > 0.06;
        for (bool front : {true, false}) {
            double d = front ? d1 : d0;
            if (!glazed) {
                m_frame.face(m_moving, s0, s1, d, z0, z1, look.leaf, front);
            } else {
                m_frame.face(m_moving, s0, g0, d, z0, z1, look.leaf, front);
                m_frame.face(m_moving, g1, s1, d, z0, z1, look.leaf, front);
                m_frame.face(m_moving, g0, g1, d, z0, gz0, look.leaf, front);
                m_frame.face(m_moving, g0, g1, d, gz1, z1, look.leaf, front);
            }
            double out = front ? d1 + 0.002 : d0 - 0.002;
            if (look.kickPlate)
                m_frame.face(m_moving, s0 + 0.03, s1 - 0.03, out, z0 + 0.02, 0.28, look.kick, front);
        }
        if (glazed) m_frame.face(m_moving, g0, g1, (d0 + d1) / 2, gz0, gz1, look.glass, true);
        m_frame.box(m_moving, s0, s1, d0, d1, z0, z1, look.leaf, 0b001100U); // edges only
        if (look.closer)
            m_frame.box(m_moving, s0 + 0.08, s0 + 0.34, d1, d1 + 0.05, z1 - 0.1, z1 - 0.04, look.handle);
    }

    void handles(const DoorLook& look, double s, double towardsHinge, double d0, double d1) {
        for (bool front : {true, false}) {
            double from = front ? d1 : d0 - 0.008, to = front ? d1 + 0.008 : d0;
            m_frame.box(m_moving, s - 0.02, s + 0.02, from, to, 0.94, 1.14, look.handle);
            double grip = front ? d1 + 0.05 : d0 - 0.05;
            double low = std::min(s, s + towardsHinge * 0.12), high = std::max(s, s + towardsHinge * 0.12);
            m_frame.box(m_moving, low, high, grip - 0.009, grip + 0.009, 1.05, 1.07, look.handle);
            m_frame.box(m_moving, s - 0.009, s + 0.009, std::min(grip, to), std::max(grip, from), 1.05, 1.07,
                        look.handle);
        }
    }

    void liftDoor() {
        Paint metal = paintOf(Material::Metal, linearOf(214, 214, 218));
        metal.gloss = 0.18F;
        Paint frame = paintOf(Material::Metal, linearOf(160, 160, 166));
        jambs(frame, true);
        casing(frame, 0.11);
        double d = (m_portal.front + m_portal.back) / 2, middle = m_portal.width / 2;
        for (bool first : {true, false}) {
            Leaf part;
            part.firstQuad = static_cast<std::uint32_t>(m_scene.leafMesh.quads.size());
            part.firstSurface = static_cast<std::uint32_t>(m_scene.leafMesh.surfaces.size());
            double s0 = first ? 0.0 : middle + 0.002, s1 = first ? middle - 0.002 : m_portal.width;
            m_frame.box(m_moving, s0, s1, d - 0.015, d + 0.015, 0.024, m_portal.head, metal, 0b110000U);
            part.slide = m_frame.along(first ? -middle * 0.98 : middle * 0.98);
            part.middle = m_frame.at(middle, d, 1.0);
            part.hinge = part.middle;
            part.lift = true;
            part.opens = m_access->passable();
            part.lastQuad = static_cast<std::uint32_t>(m_scene.leafMesh.quads.size());
            part.lastSurface = static_cast<std::uint32_t>(m_scene.leafMesh.surfaces.size());
            m_scene.leaves.push_back(part);
        }
        bool frontIsCar = kindOf(m_portal.into) == RegionKind::Elevator;
        callPanel(!frontIsCar);
    }

    /// Button beside the lift and the floor's name above it, on the landing.
    void callPanel(bool front) {
        double out = front ? m_portal.front : m_portal.back, sign = front ? 1.0 : -1.0;
        double s = m_portal.width + 0.32;
        Paint plate = paintOf(Material::Metal, linearOf(190, 190, 194));
        m_frame.box(m_fixed, s - 0.05, s + 0.05, std::min(out, out + sign * 0.015),
                    std::max(out, out + sign * 0.015), 0.98, 1.22, plate);
        Paint button = paintOf(Material::Plain, linearOf(255, 190, 90));
        button.glow = 0.6F;
        for (double z : {1.06, 1.14})
            m_frame.face(m_fixed, s - 0.018, s + 0.018, out + sign * 0.017, z - 0.018, z + 0.018, button,
                         front);
        const building::Level* level = m_scene.building->level(m_access->level);
        Paint display;
        display.texture = static_cast<std::uint32_t>(m_scene.textures.size());
        m_scene.textures.emplace_back(floorDisplay(level ? level->ref : std::string()), false);
        display.glow = 0.5F;
        double mid = m_portal.width / 2, z = m_portal.head + 0.2;
        m_frame.face(m_fixed, mid - 0.13, mid + 0.13, out + sign * 0.012, z - 0.05, z + 0.06, display, front,
                     true);
    }

    void window() {
        Paint frame = paintOf(Material::Plain, linearOf(236, 236, 234));
        jambs(m_style->wall, true);
        double w = m_portal.width, z0 = m_portal.sill, z1 = m_portal.head,
               d = (m_portal.front + m_portal.back) / 2;
        Paint glass = paintOf(Material::Plain, linearOf(238, 246, 246));
        glass.glass = true;
        glass.gloss = 0.06F;
        if (m_portal.landmark) {
            Thing thing;
            thing.landmark = m_portal.landmark;
            thing.level = m_scene.building->landmarks()[*m_portal.landmark].level;
            thing.centre = m_frame.at(w / 2, d, (z0 + z1) / 2);
            thing.facing = m_frame.normal();
            thing.corners = std::array<Vec3, 4>{m_frame.at(w, d, z1), m_frame.at(0.0, d, z1),
                                                m_frame.at(0.0, d, z0), m_frame.at(w, d, z0)};
            m_fixed.setThing(static_cast<std::int32_t>(m_scene.things.size()));
            m_scene.things.push_back(thing);
        }
        constexpr double kBar = 0.055;
        auto bar = [&](double s0, double s1, double low, double high) {
            m_frame.box(m_fixed, s0, s1, d - 0.03, d + 0.03, low, high, frame);
        };
        bar(0.0, w, z0, z0 + kBar);
        bar(0.0, w, z1 - kBar, z1);
        bar(0.0, kBar, z0 + kBar, z1 - kBar);
        bar(w - kBar, w, z0 + kBar, z1 - kBar);
        if (w > 1.0) bar(w / 2 - kBar / 2, w / 2 + kBar / 2, z0 + kBar, z1 - kBar);
        m_frame.face(m_fixed, 0.0, w, d, z0, z1, glass, true);
        m_fixed.setThing(-1);
        m_frame.box(m_fixed, -0.06, w + 0.06, m_portal.front - 0.02, m_portal.front + 0.14, z0 - 0.03, z0,
                    frame);
        if (m_portal.into && m_portal.outOf) return; // between two rooms: no daylight of its own
        double strength = 1.5 * w * (z1 - z0);
        Vec3 sky{0.95F, 1.0F, 1.06F};
        Vec3 inward = m_portal.into ? m_frame.normal() : m_frame.normal(-1.0);
        m_scene.lamps.push_back(
            {m_frame.at(w / 2, m_portal.into ? m_portal.front + 0.05 : m_portal.back - 0.05, (z0 + z1) / 2),
             inward, sky * static_cast<float>(strength)});
    }

    SceneData& m_scene;
    const SceneOptions& m_options;
    const Portal& m_portal;
    MeshBuilder m_fixed, m_moving;
    PortalFrame m_frame;
    const building::Access* m_access = nullptr;
    const RegionStyle* m_style = nullptr;
    std::uint64_t m_seed = 0;
    std::int32_t m_thing = -1;
};

} // namespace

void addPortals(SceneData& scene, const SceneOptions& options) {
    for (const Portal& portal : scene.plan.portals) {
        const building::Building& building = *scene.building;
        std::size_t region = portal.into ? *portal.into : *portal.outOf;
        bool open = building.regions()[region].kind == RegionKind::Outside &&
                    (!portal.outOf || building.regions()[*portal.outOf].kind == RegionKind::Outside);
        if (open) continue; // a gate between two open spaces has no wall to stand in
        DoorMaker(scene, options, portal).make();
    }
}

} // namespace farol::simulation
