#pragma once
// All pixels of one picture: light, depth and what they belong to.

#include "core/simulation/shader.h"

#include <opencv2/core.hpp>

#include <vector>

namespace farol::simulation {

/// Kept from picture to picture, so that nothing is allocated for each.
struct PictureBuffers {
    std::vector<Light> light;
    std::vector<float> depth;    ///< forward metres
    std::vector<RayHit> hits;    ///< of pixel centres
    std::vector<Light> mirrored; ///< half as wide and high; `spare` is 1 where there is something
    std::vector<Light> polished; ///< the same, softened
    cv::Mat ids;                 ///< 16-bit, 1 + thing or 0
};

void drawPicture(const Shader& shader, const Lens& lens, const Sight& sight, int raysPerPixel, int threads,
                 PictureBuffers& buffers);

} // namespace farol::simulation
