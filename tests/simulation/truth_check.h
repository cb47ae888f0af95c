#pragma once
// Does the truth of a picture agree with its own id picture?

#include "core/simulation/simulated_camera.h"

#include <vector>

namespace farol::test {

/// For each thing that is whole in view: by how many pixels the box of its projected corners misses the box
/// of its pixels, at the worst of the four sides.
struct CornerGap {
    Kind kind = Kind::Other;
    double pixels = 0.0;
};
std::vector<CornerGap> cornerGaps(const simulation::RenderedFrame& frame, const cv::Mat& ids);

} // namespace farol::test
