#include "core/simulation/door_leaves.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

Result<std::unique_ptr<DoorLeavesNow>> DoorLeavesNow::make(const World& world) {
    std::unique_ptr<DoorLeavesNow> leaves(new DoorLeavesNow(world.scene(), world.options().doors));
    leaves->m_open.assign(world.scene().leaves.size(), 0);
    auto tracer = Tracer::build(world.tracer().device(), leaves->m_mesh.vertices, leaves->m_mesh.quads, 1);
    if (!tracer) return tracer.error();
    leaves->m_tracer = std::move(*tracer);
    return leaves;
}

int DoorLeavesNow::stepsOpen(const Leaf& leaf, Vec3 eye, bool inLift) const {
    if (!leaf.opens || (inLift && leaf.lift)) return 0;
    switch (m_mode) {
    case DoorLeaves::Closed:
        return 0;
    case DoorLeaves::Open:
        return kSteps;
    case DoorLeaves::Ajar:
        return leaf.lift ? kSteps : kSteps / 2;
    case DoorLeaves::OpenWhenNear:
        break;
    }
    Vec3 way = leaf.middle - eye;
    if (std::abs(way.z) > 1.6F) return 0;
    float metres = std::sqrt(way.x * way.x + way.y * way.y);
    constexpr float kOpenM = 1.1F, kStartM = 2.0F;
    float share = std::clamp((kStartM - metres) / (kStartM - kOpenM), 0.0F, 1.0F);
    return static_cast<int>(std::lround(share * kSteps));
}

void DoorLeavesNow::place(std::size_t index, int steps) {
    const Leaf& leaf = m_scene.leaves[index];
    float share = static_cast<float>(steps) / kSteps;
    float angle = leaf.swing * share, c = std::cos(angle), s = std::sin(angle);
    auto turned = [&](Vec3 v) { return Vec3{c * v.x - s * v.y, s * v.x + c * v.y, v.z}; };
    auto moved = [&](Vec3 p) { return leaf.hinge + turned(p - leaf.hinge) + leaf.slide * share; };
    const Mesh& closed = m_scene.leafMesh;
    for (std::uint32_t quad = leaf.firstQuad; quad < leaf.lastQuad; ++quad)
        for (std::uint32_t vertex : closed.quads[quad])
            m_mesh.vertices[vertex] = moved(closed.vertices[vertex]);
    for (std::uint32_t i = leaf.firstSurface; i < leaf.lastSurface; ++i) {
        const Surface& from = closed.surfaces[i];
        Surface& to = m_mesh.surfaces[i];
        to.origin = moved(from.origin);
        to.uAxis = turned(from.uAxis);
        to.vAxis = turned(from.vAxis);
        to.normal = turned(from.normal);
    }
}

void DoorLeavesNow::update(Vec3 eye, bool inLift) {
    bool changed = false;
    for (std::size_t i = 0; i < m_open.size(); ++i) {
        int steps = stepsOpen(m_scene.leaves[i], eye, inLift);
        if (steps == m_open[i]) continue;
        place(i, steps);
        m_open[i] = steps;
        changed = true;
    }
    if (changed) m_tracer->move(m_mesh.vertices);
}

} // namespace farol::simulation
