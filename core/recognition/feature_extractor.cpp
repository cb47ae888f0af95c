#include "core/recognition/feature_extractor.h"

#include "core/base/text.h"
#include "core/recognition/grey.h"

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr int kDescriptorBytes = 128;
constexpr int kSmallestSide = 16; // below, SIFT's pyramid has nothing to work on

/// Square roots of the L1-normalised SIFT vector, so that Euclidean distance compares as Hellinger's; as
/// bytes, whose rounding is far below the noise and which take a quarter of the room.
cv::Mat rootBytes(const cv::Mat& sift) {
    cv::Mat bytes(sift.rows, kDescriptorBytes, CV_8U);
    for (int row = 0; row < sift.rows; ++row) {
        const float* in = sift.ptr<float>(row);
        unsigned char* out = bytes.ptr<unsigned char>(row);
        float sum = 1e-6F;
        for (int i = 0; i < kDescriptorBytes; ++i) sum += in[i];
        for (int i = 0; i < kDescriptorBytes; ++i)
            out[i] = cv::saturate_cast<unsigned char>(512.0F * std::sqrt(in[i] / sum));
    }
    return bytes;
}

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
    : m_options(options),
      m_feature(cv::SIFT::create(options.maxKeypoints, 3, options.contrastThreshold, 10.0, 1.6)) {}

Features FeatureExtractor::extract(const cv::Mat& image) const {
    Features features;
    features.descriptors = cv::Mat(0, kDescriptorBytes, CV_8U);
    cv::Mat grey = greyOf(image);
    if (grey.empty()) return features;
    double scale = 1.0;
    cv::Mat small = reduced(grey, m_options.workingLongSide, scale);
    if (std::min(small.cols, small.rows) < kSmallestSide) return features;
    cv::Mat sift;
    try {
        m_feature->detectAndCompute(small, cv::noArray(), features.keypoints, sift);
    } catch (const cv::Exception&) { // a picture SIFT cannot take has no features
        features.keypoints.clear();
        return features;
    }
    // Exact, not the requested factor: both sides are rounded to whole pixels.
    double scaleX = static_cast<double>(small.cols) / grey.cols;
    double scaleY = static_cast<double>(small.rows) / grey.rows;
    for (cv::KeyPoint& point : features.keypoints) {
        point.pt.x = static_cast<float>((point.pt.x + 0.5) / scaleX);
        point.pt.y = static_cast<float>((point.pt.y + 0.5) / scaleY);
        point.size = static_cast<float>(point.size / scale);
        point.class_id = 0;
    }
    if (!features.keypoints.empty()) features.descriptors = rootBytes(sift);
    return features;
}

} // namespace farol::recognition
