#pragma once
// A camera in an endless textured corridor, ray-cast, so that its motion is known exactly.

#include <opencv2/core.hpp>

namespace farol::recognition::test {

/// Metres and radians. The corridor runs along x; y is to the left, z up. `yaw` left positive from +x,
/// `pitch` up positive, `roll` clockwise as seen by the camera.
struct CameraPose {
    double x = 0.0, y = 0.0, z = 1.4;
    double yaw = 0.0, pitch = 0.0, roll = 0.0;
};

struct CorridorLook {
    double halfWidth = 1.1, height = 2.6, length = 60.0; ///< the ends are walls at 0 and `length`
    double contrast = 1.0;                               ///< 0: all blank
    int seed = 1;
    double horizontalViewDegrees = 60.0;
};

/// 8-bit grey.
cv::Mat corridorView(const CameraPose& pose, const CorridorLook& look = {}, cv::Size size = {320, 240});

} // namespace farol::recognition::test
