#pragma once
// What a moving camera smears while its shutter is open.

#include "core/simulation/lens.h"
#include "core/simulation/shader.h"

#include <vector>

namespace farol::simulation {

/// How the camera moves, in its own axes (right, down, forward): metres and radians a second.
struct CameraMotion {
    Vec3 velocity;
    Vec3 rotation;
};

/// `depth`: forward metres by pixel. Leaves `picture` as it is where nothing moves by a pixel.
void blurByMotion(std::vector<Light>& picture, const std::vector<float>& depth, const Lens& lens,
                  const CameraMotion& motion, double seconds, int threads);

} // namespace farol::simulation
