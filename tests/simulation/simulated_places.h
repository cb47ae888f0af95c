#pragma once
// Places that the tests of the simulated camera look at.

#include "core/building/building.h"
#include "core/simulation/simulated_camera.h"
#include "core/simulation/world.h"

#include <cstdint>
#include <memory>

namespace farol::test {

/// Without clutter and windows, doors as asked.
simulation::SceneOptions bareScene(simulation::DoorLeaves doors = simulation::DoorLeaves::Closed);
simulation::CameraPose standing(Point2 at, double level, double headingDegrees);
/// The world of a map that must give one.
simulation::World worldOf(building::BuildingData data, const simulation::SceneOptions& options = bareScene());
simulation::World worldOf(std::shared_ptr<const building::Building> building,
                          const simulation::SceneOptions& options = bareScene());
simulation::SimulatedCamera cameraIn(const simulation::World& world,
                                     const simulation::CameraOptions& options = {});
simulation::RenderedFrame look(simulation::SimulatedCamera& camera, const simulation::CameraPose& pose);

/// A landmark in the truth of a picture; null when it is not seen.
const simulation::SeenThing* find(const simulation::FrameTruth& truth, const char* landmark);

/// A corridor of 16 m x 2.4 m along x from (0, 0), a room of 6 m x 5 m north of it behind a door at x = 8,
/// and things of all kinds on the walls.
building::BuildingData corridorMap();
/// Two stairwells above each other, each with a corridor before it.
building::BuildingData stairsMap();

/// How bright a part of a picture is, and how much it varies.
double brightness(const cv::Mat& image, const cv::Rect& part);

} // namespace farol::test
