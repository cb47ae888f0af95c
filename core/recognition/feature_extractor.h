#pragma once
// Keypoints and descriptors. RootSIFT at reduced size is the measured best (see tests/bench/README.md); the
// extractor's identity is stored with every library, and another one is refused by name.

#include "core/base/error.h"
#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <memory>
#include <string>
#include <vector>

namespace farol::recognition {

struct ScaleSpace;

/// `workingLongSide`: the picture is reduced until its longer side is at most this many pixels (never
/// enlarged).
struct ExtractorOptions {
    std::string name = "rootsift";
    int version = 2; ///< of our own post-processing; a change makes old descriptors incomparable
    int workingLongSide = 640;
    int maxKeypoints = 800;
    double contrastThreshold = 0.01;

    Result<void> check() const;
    /// "rootsift v2 (640 px, 800 keypoints, contrast 0.01)"
    std::string description() const;
    friend bool operator==(const ExtractorOptions&, const ExtractorOptions&) = default;
};

/// Keypoints in pixels of the full picture; `descriptors` one row each, CV_8U x 128 for RootSIFT.
struct Features {
    std::vector<cv::KeyPoint> keypoints;
    cv::Mat descriptors;
};

/// One per thread.
class FeatureExtractor {
public:
    explicit FeatureExtractor(const ExtractorOptions& options);
    ~FeatureExtractor();
    FeatureExtractor(FeatureExtractor&&) noexcept;
    FeatureExtractor& operator=(FeatureExtractor&&) noexcept;
    /// `image` is 8-bit BGR or grey. No keypoints (a blank wall) is a normal answer.
    Features extract(const cv::Mat& image) const;
    const ExtractorOptions& options() const { return m_options; }

private:
    ExtractorOptions m_options;
    std::unique_ptr<ScaleSpace> m_space; ///< kept between pictures
};

} // namespace farol::recognition
