#pragma once
// Does the truth of a picture agree with its own id picture?

#include "core/simulation/simulated_camera.h"

#include <vector>

namespace farol::test {

/// For each thing that is whole in view: by how many pixels its projected corners miss those of its pixels,
/// at worst (of a body that is not flat: the sides of the box about it). Made for a lens that keeps straight
/// lines straight.
struct CornerGap {
    Kind kind = Kind::Other;
    double pixels = 0.0;
};
std::vector<CornerGap> cornerGaps(const simulation::RenderedFrame& frame, const cv::Mat& ids);

} // namespace farol::test
