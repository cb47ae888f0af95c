#pragma once
// A detection accepted into the navigation history.

#include "core/recognition/detection.h"

#include <cstdint>

namespace farol::localisation {

/// `time` in seconds of the frame's own clock, `scene` the paper's frame identifier (section 3b).
struct Observation {
    recognition::Detection detection;
    double time = 0.0;
    std::uint64_t frame = 0;
    int scene = 0;
};

} // namespace farol::localisation
