#include "core/recognition/landmark_recogniser.h"

#include "core/recognition/grey.h"
#include "core/recognition/object_matcher.h"
#include "core/recognition/place_matcher.h"
#include "core/recognition/sharpness.h"

namespace farol::recognition {

Result<void> RecogniserOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    if (!(ratio > 0.0 && ratio <= 1.0)) return wrong("the ratio must be above 0 and at most 1", "ratio");
    if (!(placeRatio > 0.0 && placeRatio <= 1.0))
        return wrong("the ratio must be above 0 and at most 1", "placeRatio");
    if (neighbours < 2 || neighbours > 64)
        return wrong("between 2 and 64 neighbours are looked at", "neighbours");
    if (searchChecks < 1 || searchChecks > 100000)
        return wrong("between 1 and 100000 rows are compared", "searchChecks");
    if (minInliers < 4) return wrong("a homography needs at least 4 inliers", "minInliers");
    if (minPlaceInliers < 8) return wrong("epipolar geometry needs at least 8 inliers", "minPlaceInliers");
    if (minMatches < 0) return wrong("the fewest matches cannot be negative", "minMatches");
    if (!(minLogOdds >= -50.0 && minLogOdds <= 50.0))
        return wrong("log-odds lie between -50 and 50", "minLogOdds");
    if (placeCandidates < 1 || placeCandidates > 1000)
        return wrong("between 1 and 1000 candidates", "placeCandidates");
    if (!(reprojectionPx > 0.0 && reprojectionPx < 100.0))
        return wrong("between 0 and 100 pixels", "reprojectionPx");
    if (!(minSharpness >= 0.0 && minSharpness < 1000.0))
        return wrong("between 0 and 1000 grey levels", "minSharpness");
    return {};
}

struct LandmarkRecogniser::Index {
    FeatureExtractor extractor;
    ObjectMatcher objects;
    PlaceMatcher places;
};

LandmarkRecogniser::LandmarkRecogniser(std::shared_ptr<const LandmarkLibrary> library,
                                       RecogniserOptions options)
    : m_library(std::move(library)), m_options(options), m_index(made(*m_library, options)) {}

LandmarkRecogniser::LandmarkRecogniser(std::shared_ptr<const LandmarkLibrary> library,
                                       const LandmarkRecogniser& before)
    : m_library(std::move(library)), m_options(before.m_options) {
    if (m_library->extractor == before.m_library->extractor) {
        m_index.reset(new Index{FeatureExtractor(m_library->extractor),
                                ObjectMatcher(before.m_index->objects, *m_library),
                                PlaceMatcher(before.m_index->places, *m_library)});
        if (!m_index->objects.outworn() && !m_index->places.outworn()) return;
    }
    m_index = made(*m_library, m_options);
}

std::unique_ptr<LandmarkRecogniser::Index> LandmarkRecogniser::made(const LandmarkLibrary& library,
                                                                    const RecogniserOptions& options) {
    return std::unique_ptr<Index>(new Index{FeatureExtractor(library.extractor),
                                            ObjectMatcher(library, options), PlaceMatcher(library, options)});
}

LandmarkRecogniser::~LandmarkRecogniser() = default;
LandmarkRecogniser::LandmarkRecogniser(LandmarkRecogniser&&) noexcept = default;
LandmarkRecogniser& LandmarkRecogniser::operator=(LandmarkRecogniser&&) noexcept = default;

DetectorResult LandmarkRecogniser::recognise(const cv::Mat& image) const {
    DetectorResult result;
    cv::Mat grey = greyOf(image);
    if (grey.empty() || (m_index->objects.empty() && m_index->places.empty())) return result;
    double sharp = sharpness(grey);
    if (sharp < m_options.minSharpness) {
        result.rejections.push_back({"landmarks", Kind::Other, {}, {}, "blurred", sharp});
        return result;
    }
    Features features = m_index->extractor.extract(grey);
    result.append(m_index->objects.match(grey, features));
    result.append(m_index->places.match({grey.cols, grey.rows}, features));
    return result;
}

const LandmarkLibrary& LandmarkRecogniser::library() const {
    return *m_library;
}

} // namespace farol::recognition
