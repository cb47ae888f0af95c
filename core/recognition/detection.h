#pragma once
// What was found in one frame, and what was nearly found.

#include "core/base/angle.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/kind.h"
#include "core/base/zone.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace farol::recognition {

/// A trained place that the view fits too.
struct LookAlike {
    TemplateId templateId;
    double strength = 0.0; ///< of the geometry found, comparable with Detection::strength
};

/// Found in a frame. `quad` in pixels of the full frame. `bearing` from the optical axis, left positive.
struct Detection {
    Kind kind = Kind::Other;
    TemplateId templateId; ///< the trained object or place; empty for generic doors, stairs, rectangles, text
    std::string text;      ///< what was read; empty when nothing
    Quad quad{};
    ImageSize image;
    double score = 0.0; ///< 0 to 1, comparable within a kind
    int inliers = 0;    ///< matched keypoints that fit; 0 where that has no meaning
    /// Of a place: how much of the view its geometry explains, and what it would explain of others. Of
    /// another trained object: the logarithm of the odds that it is there, by its match alone. 0: not told.
    double strength = 0.0;
    std::vector<LookAlike> lookAlikes;
    std::optional<double> rangeM;
    std::optional<double> rangeSpread; ///< one standard deviation, as a share of the range
    std::optional<Radians> bearing;
    /// Which of the things that are followed from frame to frame it is (landmark_tracker.h); 0: not followed.
    std::uint64_t track = 0;
    int confirmations = 1; ///< how often recognition has seen this thing, this time included

    Zone zone() const { return zoneOf(boundingBox(quad).centre(), image); }
};

/// A candidate that was not accepted. `reason` is a stable word such as "few_inliers", "folded_quad",
/// "low_patch_correlation".
struct Rejection {
    std::string detector; ///< "landmarks", "doors", "text", "rectangles"
    Kind kind = Kind::Other;
    TemplateId templateId;
    Quad quad{};
    std::string reason;
    double value = 0.0; ///< the figure that fell short
};

/// What the picture's own flow tells since the frame before: empty where it cannot tell.
struct Motion {
    std::optional<Radians> turn; ///< left positive
    std::optional<double> speed; ///< relative units, 0 standing
    std::optional<bool> walking;
    std::optional<double> stepsPerSecond;
};

struct DetectorResult {
    std::vector<Detection> detections;
    std::vector<Rejection> rejections;

    void append(DetectorResult other);
};

} // namespace farol::recognition
