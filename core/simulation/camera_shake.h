#pragma once
// How a camera on a chest or in a hand moves while its bearer walks.

#include "core/simulation/camera_pose.h"
#include "core/simulation/simulated_camera.h"

#include <cstdint>

namespace farol::simulation {

/// What the bearer adds to a pose. A function of the pose's time alone, so that any frame can be drawn again.
struct ShakeOffset {
    double rightM = 0.0, upM = 0.0;
    double yaw = 0.0, pitch = 0.0, roll = 0.0; ///< radians; left, up, clockwise
};

ShakeOffset shakeAt(Shake shake, double time, double speed, std::uint64_t seed);
CameraPose shaken(const CameraPose& pose, const ShakeOffset& offset);

} // namespace farol::simulation
