#pragma once
// The closed loop through real pictures: what the walker's camera shows is rendered, and looked at by the
// same perception as any other frame.

#include "core/session/closed_loop.h"
#include "core/session/perception.h"
#include "core/simulation/simulated_camera.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace farol::session {

using PictureWatcher =
    std::function<Result<void>(std::uint64_t frame, const simulation::RenderedFrame& picture)>;

/// The camera is known to perception as if it had been calibrated, unless options name one.
/// `library` may be null: no trained landmarks. `watcher` may be empty; its error ends the walk. `warnings`:
/// what perception has to do without.
Result<ClosedLoop::Eye> pictureEye(const simulation::World& world, const simulation::CameraOptions& camera,
                                   std::shared_ptr<const recognition::LandmarkLibrary> library,
                                   const PerceptionOptions& perception, PictureWatcher watcher,
                                   std::vector<std::string>& warnings);

} // namespace farol::session
