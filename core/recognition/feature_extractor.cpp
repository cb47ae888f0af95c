#include "core/recognition/feature_extractor.h"

#include "core/base/text.h"
#include "core/recognition/grey.h"
#include "core/recognition/root_sift.h"

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr int kSmallestSide = 16; // below, the pyramid has nothing to work on

} // namespace

Result<void> ExtractorOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    if (name != "rootsift")
        return wrong("the only feature extractor is rootsift, not \"" + name + "\"", "extractor");
    if (workingLongSide < 64 || workingLongSide > 4096)
        return wrong("the working size must be between 64 and 4096 pixels", "workingLongSide");
    if (maxKeypoints < 10 || maxKeypoints > 20000)
        return wrong("the number of keypoints must be between 10 and 20000", "maxKeypoints");
    if (!(contrastThreshold > 0.0 && contrastThreshold < 1.0))
        return wrong("the contrast threshold must be between 0 and 1", "contrastThreshold");
    return {};
}

std::string ExtractorOptions::description() const {
    return name + " v" + std::to_string(version) + " (" + std::to_string(workingLongSide) + " px, " +
           std::to_string(maxKeypoints) + " keypoints, contrast " + formatNumber(contrastThreshold) + ")";
}

FeatureExtractor::FeatureExtractor(const ExtractorOptions& options)
    : m_options(options), m_space(std::make_unique<ScaleSpace>()) {}

FeatureExtractor::~FeatureExtractor() = default;
FeatureExtractor::FeatureExtractor(FeatureExtractor&&) noexcept = default;
FeatureExtractor& FeatureExtractor::operator=(FeatureExtractor&&) noexcept = default;

Features FeatureExtractor::extract(const cv::Mat& image) const {
    Features features;
    features.descriptors = cv::Mat(0, kDescriptorBytes, CV_8U);
    cv::Mat grey = greyOf(image);
    if (grey.empty()) return features;
    double scale = 1.0;
    cv::Mat small = reduced(grey, m_options.workingLongSide, scale);
    if (std::min(small.cols, small.rows) < kSmallestSide) return features;
    rootSift(small, {m_options.maxKeypoints, m_options.contrastThreshold}, *m_space, features.keypoints,
             features.descriptors);
    // Exact, not the requested factor: both sides are rounded to whole pixels.
    double scaleX = static_cast<double>(small.cols) / grey.cols;
    double scaleY = static_cast<double>(small.rows) / grey.rows;
    for (cv::KeyPoint& point : features.keypoints) {
        point.pt.x = static_cast<float>((point.pt.x + 0.5) / scaleX);
        point.pt.y = static_cast<float>((point.pt.y + 0.5) / scaleY);
        point.size = static_cast<float>(point.size / scale);
        point.class_id = 0;
    }
    return features;
}

} // namespace farol::recognition
