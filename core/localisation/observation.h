#pragma once
// A detection accepted into the navigation history.

#include "core/recognition/detection.h"

#include <cstdint>
#include <optional>

namespace farol::localisation {

/// `time` in seconds of the frame's own clock, `scene` the paper's frame identifier (section 3b).
struct Observation {
    recognition::Detection detection;
    double time = 0.0;
    std::uint64_t frame = 0;
    int scene = 0;
    /// The thing that is followed from frame to frame: observations of one track are one object seen again,
    /// not two pieces of evidence. Empty where nothing is followed (logs without it).
    std::optional<std::uint64_t> track = std::nullopt;
    int confirmations = 1; ///< how often recognition had seen it by then
};

} // namespace farol::localisation
