#pragma once

#include "core/recognition/detection.h"

#include <optional>

namespace farol::recognition {

/// One thing that is followed from frame to frame, as it is now (landmark_tracker.h).
struct Track {
    Detection now; ///< with `track` and `confirmations`; quad, bearing and range carried to this frame
    double firstTime = 0.0, confirmedTime = 0.0; ///< of the frames recognition first and last saw it in
    std::optional<double> growth; ///< of its size in the picture, per second: positive when it comes nearer
};

} // namespace farol::recognition
