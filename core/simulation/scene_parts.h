#pragma once
// The hands of the scene builder; each adds one sort of part to the scene.

#include "core/recognition/landmark_library.h"
#include "core/simulation/scene_data.h"
#include "core/simulation/world.h"

namespace farol::simulation {

Paint paintOf(Material material, Vec3 tint = {1.0F, 1.0F, 1.0F});

std::vector<RegionStyle> makeStyles(const building::Building& building, std::uint64_t seed);
/// Floors, ceilings, walls and skirting of all regions.
void addRooms(SceneData& scene);
/// Walls that the map draws within regions.
void addDrawnWalls(SceneData& scene);
/// The ground about the building, and the sky's light.
void addGround(SceneData& scene);
void addLamps(SceneData& scene);
/// Frames, jambs, thresholds, leaves, glass: all that stands in openings.
void addPortals(SceneData& scene, const SceneOptions& options);
/// Finds room for the flights of all stairs between stairwells, and takes floors and ceilings out of their
/// way; before the rooms are built.
void planStairs(SceneData& scene);
/// Steps, landings and handrails.
void addStairs(SceneData& scene);
void addLifts(SceneData& scene);
void addLandmarks(SceneData& scene, const SceneOptions& options, const recognition::LandmarkLibrary* library);
void addClutter(SceneData& scene, const SceneOptions& options);

} // namespace farol::simulation
