#pragma once
// The poses of somebody who knows the way: along a planned route, at walking speed, the camera swaying.

#include "core/localisation/random.h"
#include "core/routing/route.h"
#include "core/simulation/camera_pose.h"
#include "core/simulation/walk_body.h"

#include <vector>

namespace farol::simulation {

/// From its first to its last point, one pose each 1/framesPerSecond. Stairs and lifts take their time.
std::vector<CameraPose> posesAlong(const routing::Route& route, const WalkerOptions& options,
                                   double framesPerSecond);

} // namespace farol::simulation
