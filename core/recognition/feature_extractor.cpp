#include "core/recognition/feature_extractor.h"

#include "core/base/text.h"
#include "core/recognition/grey.h"
#include "core/recognition/other_features.h"
#include "core/recognition/root_sift.h"
#include "core/recognition/sayings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr int kSmallestSide = 16; // below, the pyramid has nothing to work on
constexpr int kBitStep = 16;      // of a bit as a byte: 256 of it are one unit of distance
constexpr int kBitDistance = kBitStep * kBitStep;

struct Extractor {
    const char* name;
    int version; ///< of what we make of it; a change makes old descriptors incomparable
    double threshold;
    int bytes;
    bool bits;
    int likeEnough;
    void (*extract)(const cv::Mat& grey, int most, double threshold, std::vector<cv::KeyPoint>& keypoints,
                    cv::Mat& descriptors);
};

constexpr std::array<Extractor, 4> kExtractors{
    {{"rootsift", 2, 0.005, kDescriptorBytes, false, 42000, nullptr},
     {"surf", 1, 0.01, kSurfBytes, false, 30000, surfFeatures},
     {"orb", 1, 0.04, kOrbBytes, true, 70 * kBitDistance, orbFeatures},
     {"akaze", 1, 0.0005, kAkazeBytes, true, 130 * kBitDistance, akazeFeatures}}};

const Extractor* extractorOf(const std::string& name) {
    auto found = std::find_if(kExtractors.begin(), kExtractors.end(),
                              [&](const Extractor& one) { return name == one.name; });
    return found == kExtractors.end() ? nullptr : &*found;
}

Error unknownExtractor(const std::string& name) {
    std::string all;
    for (const Extractor& one : kExtractors) all += (all.empty() ? "" : ", ") + std::string(one.name);
    return {ErrorCode::InvalidArgument, said(Saying::ExtractorUnknown, {name, all}), "extractor"};
}

} // namespace

Result<void> ExtractorOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    const Extractor* known = extractorOf(name);
    if (known == nullptr) return unknownExtractor(name);
    if (version != known->version)
        return wrong(
            said(Saying::ExtractorVersion, {std::to_string(version), name, std::to_string(known->version)}),
            "extractor");
    if (workingLongSide < 64 || workingLongSide > 4096)
        return wrong(said(Saying::ExtractorSize), "workingLongSide");
    if (maxKeypoints < 10 || maxKeypoints > 20000)
        return wrong(said(Saying::ExtractorKeypoints), "maxKeypoints");
    if (!(contrastThreshold > 0.0 && contrastThreshold < 1.0))
        return wrong(said(Saying::ExtractorContrast), "contrastThreshold");
    return {};
}

Result<ExtractorOptions> ExtractorOptions::named(const std::string& name) {
    const Extractor* known = extractorOf(name);
    if (known == nullptr) return unknownExtractor(name);
    ExtractorOptions options;
    options.name = known->name;
    options.version = known->version;
    options.contrastThreshold = known->threshold;
    return options;
}

const std::vector<std::string>& extractorNames() {
    static const std::vector<std::string> kNames = [] {
        std::vector<std::string> names;
        for (const Extractor& one : kExtractors) names.emplace_back(one.name);
        return names;
    }();
    return kNames;
}

int descriptorBytes(const std::string& extractor) {
    const Extractor* known = extractorOf(extractor);
    return known == nullptr ? 0 : known->bytes;
}

int likeEnough(const std::string& extractor) {
    const Extractor* known = extractorOf(extractor);
    return known == nullptr ? 0 : known->likeEnough;
}

cv::Mat comparable(const std::string& extractor, const cv::Mat& descriptors) {
    const Extractor* known = extractorOf(extractor);
    if (known == nullptr || !known->bits || descriptors.cols != known->bytes) return descriptors;
    cv::Mat spread(descriptors.rows, descriptors.cols * 8, CV_8U);
    for (int y = 0; y < descriptors.rows; ++y) {
        const unsigned char* from = descriptors.ptr(y);
        unsigned char* to = spread.ptr(y);
        for (int x = 0; x < spread.cols; ++x)
            to[x] = static_cast<unsigned char>(((from[x / 8] >> (x % 8)) & 1) * kBitStep);
    }
    return spread;
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
    const Extractor* known = extractorOf(m_options.name);
    if (known == nullptr) return features;
    features.descriptors = cv::Mat(0, known->bytes, CV_8U);
    cv::Mat grey = greyOf(image);
    if (grey.empty()) return features;
    double scale = 1.0;
    cv::Mat small = reduced(grey, m_options.workingLongSide, scale);
    if (std::min(small.cols, small.rows) < kSmallestSide) return features;
    if (known->extract == nullptr)
        rootSift(small, {m_options.maxKeypoints, m_options.contrastThreshold}, *m_space, features.keypoints,
                 features.descriptors);
    else
        known->extract(small, m_options.maxKeypoints, m_options.contrastThreshold, features.keypoints,
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
