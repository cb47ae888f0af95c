#pragma once
// What the truth says of one picture.

#include "core/simulation/shader.h"
#include "core/simulation/simulated_camera.h"

#include <functional>
#include <vector>

namespace farol::simulation {

/// `ids`: by pixel, 1 + index of a thing or 0.
std::vector<SeenThing> seenThings(const SceneData& scene, const Shader& shader, const Lens& lens,
                                  const Sight& sight, const cv::Mat& ids);

} // namespace farol::simulation
