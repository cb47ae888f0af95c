#pragma once
// Keypoints and descriptors. RootSIFT is the measured best (see tests/bench/README.md); SURF, ORB and AKAZE
// can be chosen instead. The extractor's identity is stored with every library, and another one is refused by
// name.

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
    double contrastThreshold = 0.005;

    /// rootsift, surf, orb or akaze with its own usual options; InvalidArgument for another name.
    static Result<ExtractorOptions> named(const std::string& name);
    Result<void> check() const;
    /// "rootsift v2 (640 px, 800 keypoints, contrast 0.01)"
    std::string description() const;
    friend bool operator==(const ExtractorOptions&, const ExtractorOptions&) = default;
};

/// Names of the extractors, the usual one first.
const std::vector<std::string>& extractorNames();
/// Bytes of a stored descriptor; 0 for an unknown extractor.
int descriptorBytes(const std::string& extractor);
/// The descriptors as bytes whose squared Euclidean distance says how unlike they are: those of ORB and
/// AKAZE, which are bits, with a byte for each. What is so already comes back as it is.
cv::Mat comparable(const std::string& extractor, const cv::Mat& descriptors);
/// The greatest such distance of two descriptors that may be of one point whose place is foretold.
int likeEnough(const std::string& extractor);

/// Keypoints in pixels of the full picture; `descriptors` CV_8U, one row each, descriptorBytes() wide.
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
