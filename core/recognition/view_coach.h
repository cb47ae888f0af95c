#pragma once
// How good a photograph is for training, and which one is wanted next (paper section 2: from about 2 m, from
// several sides).

#include "core/recognition/feature_extractor.h"
#include "core/recognition/landmark_library.h"

#include <opencv2/core.hpp>

#include <optional>
#include <vector>

namespace farol::recognition {

enum class Advice {
    TooDark,
    TooBright,
    Blurred,
    Nearer,      ///< too small in the picture
    FewFeatures, ///< too little detail
    BadOutline,  ///< the corners cross, or leave the picture
    Squarely,    ///< the next view: straight from the front
    FromLeft,
    FromRight,
    FromFarther,
    AnotherSpot, ///< of a place: a step aside or nearer
    Enough
};

struct CoachOptions {
    double darkest = 40.0;      ///< mean grey level of what counts
    double brightest = 228.0;   ///< the same
    double mostBurnt = 0.4;     ///< share of pixels that are white through and through
    double minSharpness = 6.0;  ///< see sharpness.h
    double minLongSide = 96.0;  ///< pixels in a picture 640 wide
    int minObjectFeatures = 30; ///< training takes half as many
    int minPlaceFeatures = 60;  ///< the same
    double asideRatio = 1.06;   ///< left edge to right edge of a view from aside
    double fartherShare = 0.6;  ///< longer side of the farthest view to that of the nearest
    int enoughPlaceViews = 3;

    Result<void> check() const;
};

struct PictureQuality {
    double brightness = 0.0;
    double burnt = 0.0; ///< share of pixels without any shade
    double sharpness = 0.0;
    double longSidePx = 0.0;           ///< as in a picture 640 wide
    std::vector<ImagePoint> keypoints; ///< that lie inside the outline
    std::vector<Advice> problems;      ///< worst first; empty: a good photograph
};

/// `outline` empty, or kind place: the whole picture.
PictureQuality judgePicture(const cv::Mat& image, Kind kind, const std::optional<Quad>& outline,
                            const ExtractorOptions& extractor, const CoachOptions& options = {});

/// What the views of a template still lack; Enough at the end.
Advice nextView(const std::vector<View>& views, Kind kind, const CoachOptions& options = {});

/// Where the object seems to be: found again by its earlier views, else the likeliest rectangle near the
/// middle. Empty: nothing is sure enough.
std::optional<Quad> findOutline(const cv::Mat& image, const LandmarkLibrary& library, const Template* known);

} // namespace farol::recognition
