#pragma once
// Where on the plan an object finds its wall.

#include "core/simulation/furniture.h"
#include "core/simulation/scene_data.h"

#include <optional>

namespace farol::simulation {

struct WallSpot {
    const PlanEdge* edge = nullptr;
    double metres = 0.0; ///< along it
    Point2 position;     ///< on the wall's face
    double gap = 0.0;    ///< how far the asked point was from it
};

/// The nearest wall of the region within `reach` that faces about that way (any way when empty), kept clear
/// of corners by half of `width`.
std::optional<WallSpot> wallSpot(const SceneData& scene, std::size_t region, Point2 at,
                                 std::optional<Radians> heading, double width, double reach);
/// Is the wall whole there, from `bottom` to `top` above the floor?
bool solidWall(const PlanEdge& edge, double from, double to, double bottom, double top);

} // namespace farol::simulation
