#pragma once
// The camera's turn and advance between two pictures from how points moved: a robust fit of the instantaneous
// motion field (Longuet-Higgins and Prazdny 1980) of a person who walks about where the camera looks.

#include <opencv2/core.hpp>

#include <optional>
#include <vector>

namespace farol::recognition {

/// One point in two pictures, in normalised camera coordinates: (pixel - principal point) / focal length,
/// x to the right, y down.
struct PointFlow {
    cv::Point2d before, after;
};

struct FlowModelOptions {
    int minPoints = 14;
    double minInlierShare = 0.72;
    /// A point fits when it is this close to the model, in normalised units (about half a pixel at 320 px).
    double inlierDistance = 0.0025;
    /// How far from the optical axis people walk, as a standard deviation (tangent of the angle). It decides
    /// where the picture alone cannot: a wall filling the view looks alike when it slides by and when the
    /// camera turns.
    double headingSpreadX = 0.22, headingSpreadY = 0.12;
    double maxHeadingX = 0.55;
    /// Directions of walking that explain the points nearly as well may disagree about the turn by this much.
    double maxTurnDoubtRad = 0.03;
};

/// Camera frame: x right, y down, z forward.
struct FlowFit {
    cv::Vec3d rotation;        ///< rotation vector of the camera, radians, later frame in the earlier one
    cv::Point2d heading;       ///< where the camera moves to, in normalised coordinates (focus of expansion)
    double advance = 0.0;      ///< metres if walls, floor and ceiling were 1 m from the line of walking
    double advanceNoise = 0.0; ///< standard error of `advance`
    double inlierShare = 0.0;
};

/// Empty when there are too few points, when too many move on their own, or when the turn is in doubt.
std::optional<FlowFit> fitFlow(const std::vector<PointFlow>& points, const FlowModelOptions& options = {});

} // namespace farol::recognition
