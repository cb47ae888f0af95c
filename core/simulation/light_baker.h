#pragma once
// The light on all surfaces, computed once: lamps and windows with their shadows, and what walls, floor and
// ceiling throw back (one bounce gathered, the rest estimated), which also darkens corners.

#include "core/simulation/scene_data.h"
#include "core/simulation/tracer.h"

namespace farol::simulation {

/// Lays the grids of all surfaces and fills scene.light.
Result<void> bakeLight(SceneData& scene, const std::shared_ptr<const TraceDevice>& device);

/// Light at a point of a surface, in metres along its axes.
inline Vec3 lightAt(const Surface& surface, const std::vector<Vec3>& light, float u, float v) {
    float x = (u - surface.lightU) * surface.cellsU, y = (v - surface.lightV) * surface.cellsV;
    float highX = static_cast<float>(surface.lightColumns - 1),
          highY = static_cast<float>(surface.lightRows - 1);
    x = x > 0.0F ? (x < highX ? x : highX) : 0.0F;
    y = y > 0.0F ? (y < highY ? y : highY) : 0.0F;
    auto left = static_cast<std::uint32_t>(x), top = static_cast<std::uint32_t>(y);
    std::uint32_t columns = surface.lightColumns;
    std::uint32_t right = left + 1 < columns ? left + 1 : left;
    std::uint32_t bottom = top + 1 < surface.lightRows ? top + 1 : top;
    float fx = x - static_cast<float>(left), fy = y - static_cast<float>(top);
    const Vec3* cells = light.data() + surface.light;
    Vec3 upper = cells[top * columns + left] * (1.0F - fx) + cells[top * columns + right] * fx;
    Vec3 lower = cells[bottom * columns + left] * (1.0F - fx) + cells[bottom * columns + right] * fx;
    return upper * (1.0F - fy) + lower * fy;
}

} // namespace farol::simulation
