#pragma once
// Which frames belong to one visual scene (paper 3b, after Gargi et al.: colour-histogram correlation).

#include "core/base/error.h"

#include <opencv2/core.hpp>

namespace farol::localisation {

/// Correlations in [-1, 1] of hue-saturation-value histograms. A new scene begins when a frame is less alike
/// than these to the previous frame, or to the first frame of its scene (a slow pan changes little from frame
/// to frame). Calibrated on pictures a second apart: docs/scene-scores.svg, `farol-cli evaluate scenes`.
struct SceneOptions {
    double minCorrelationToPrevious = 0.62;
    double minCorrelationToFirst = 0.45;
    int hueBins = 8, saturationBins = 8, valueBins = 8;

    Result<void> check() const;
};

class SceneContext {
public:
    explicit SceneContext(SceneOptions options = {});

    /// The scene of this frame, counted from 0. `image` 8-bit BGR.
    int observe(const cv::Mat& image);
    double correlationToPrevious() const { return m_toPrevious; } ///< of the last frame; 1 for the first
    double correlationToFirst() const { return m_toFirst; }

private:
    SceneOptions m_options;
    cv::Mat m_previous, m_first;
    double m_toPrevious = 1.0, m_toFirst = 1.0;
    int m_scene = -1;
};

/// The histogram that is compared: CV_32F, one value a bin, summing to 1; of a picture reduced to a quarter.
cv::Mat sceneHistogram(const cv::Mat& image, const SceneOptions& options);
/// Of the square roots of the bins: else one large wall would outweigh everything before it.
double sceneCorrelation(const cv::Mat& a, const cv::Mat& b);

} // namespace farol::localisation
