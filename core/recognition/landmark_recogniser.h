#pragma once
// Finds trained templates in a frame: one index over all templates, ratio test against other templates, vote
// on centre, scale and angle, MAGSAC homography, sane quad, patch correlation. Kind place is a whole view,
// not a plane: candidates by votes of the k nearest, then epipolar geometry; at most one place a frame is
// told.

#include "core/recognition/detection.h"
#include "core/recognition/feature_extractor.h"
#include "core/recognition/landmark_library.h"

#include <memory>

namespace farol::recognition {

struct RecogniserOptions {
    double ratio = 0.90; ///< to the first neighbour of another template
    int neighbours = 8;
    int searchChecks = 400;  ///< rows compared with each of the frame's
    int minInliers = 6;      ///< of an object
    int minMatches = 3;      ///< of an object, that the index found among all templates and that fit
    double minLogOdds = 1.5; ///< that it is there, by all evidence together
    int minPlaceInliers = 12;
    double placeRatio = 0.8;
    int placeCandidates = 5; ///< verified one by one
    double reprojectionPx = 4.0;
    double minSharpness = 3.0; ///< of the blur gate; see sharpness.h. Blank walls score 1, dim corridors 6

    Result<void> check() const;
};

/// Immutable after construction; recognise() is const and may be called from one thread at a time.
class LandmarkRecogniser {
public:
    LandmarkRecogniser(std::shared_ptr<const LandmarkLibrary> library, RecogniserOptions options = {});
    /// For a library that differs from the one before in some templates: only these are taken out of the
    /// index and put in. Options and extractor of the one before; with another extractor everything is made
    /// anew. What did not change must have been copied from the library before, not read again.
    LandmarkRecogniser(std::shared_ptr<const LandmarkLibrary> library, const LandmarkRecogniser& before);
    ~LandmarkRecogniser();
    LandmarkRecogniser(LandmarkRecogniser&&) noexcept;
    LandmarkRecogniser& operator=(LandmarkRecogniser&&) noexcept;

    /// `image` 8-bit BGR or grey.
    DetectorResult recognise(const cv::Mat& image) const;
    const LandmarkLibrary& library() const;

private:
    struct Index;
    static std::unique_ptr<Index> made(const LandmarkLibrary& library, const RecogniserOptions& options);
    std::shared_ptr<const LandmarkLibrary> m_library;
    RecogniserOptions m_options;
    std::unique_ptr<Index> m_index;
};

} // namespace farol::recognition
