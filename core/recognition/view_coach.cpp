#include "core/recognition/view_coach.h"

#include "core/recognition/grey.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/rectangle_detector.h"
#include "core/recognition/sharpness.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr double kUsualWidth = 640.0;

double side(const Quad& quad, std::size_t from) {
    const ImagePoint& a = quad[from];
    const ImagePoint& b = quad[(from + 1) % 4];
    return std::hypot(b.x - a.x, b.y - a.y);
}

double longSide(const Quad& quad, int pictureWidth) {
    double longest = 0.0;
    for (std::size_t i = 0; i < 4; ++i) longest = std::max(longest, side(quad, i));
    return pictureWidth > 0 ? longest * kUsualWidth / pictureWidth : 0.0;
}

/// Clockwise and convex, with all corners in the picture.
bool sound(const Quad& quad, const cv::Mat& image) {
    for (std::size_t i = 0; i < 4; ++i) {
        const ImagePoint& a = quad[i];
        const ImagePoint& b = quad[(i + 1) % 4];
        const ImagePoint& c = quad[(i + 2) % 4];
        if (!((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) > 1e-6)) return false;
        if (a.x < -2.0 || a.y < -2.0 || a.x > image.cols + 2.0 || a.y > image.rows + 2.0) return false;
    }
    return true;
}

cv::Rect partOf(const std::optional<Quad>& outline, const cv::Mat& image) {
    const cv::Rect whole(0, 0, image.cols, image.rows);
    if (!outline) return whole;
    const ImageBox box = boundingBox(*outline);
    const cv::Rect part =
        cv::Rect(cv::Point(static_cast<int>(std::floor(box.x)), static_cast<int>(std::floor(box.y))),
                 cv::Size(static_cast<int>(std::ceil(box.width)), static_cast<int>(std::ceil(box.height)))) &
        whole;
    return part.area() > 0 ? part : whole;
}

std::vector<ImagePoint> keypointsInside(const cv::Mat& grey, const cv::Rect& part,
                                        const std::optional<Quad>& outline,
                                        const ExtractorOptions& extractor) {
    std::vector<ImagePoint> inside;
    std::vector<cv::Point2f> border;
    if (outline)
        for (const ImagePoint& p : *outline)
            border.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    constexpr int kMargin = 16; // so that the object's border has features too
    const cv::Rect wide =
        cv::Rect(part.x - kMargin, part.y - kMargin, part.width + 2 * kMargin, part.height + 2 * kMargin) &
        cv::Rect(0, 0, grey.cols, grey.rows);
    for (const cv::KeyPoint& point : FeatureExtractor(extractor).extract(grey(wide)).keypoints) {
        const cv::Point2f at = point.pt + cv::Point2f(static_cast<float>(wide.x), static_cast<float>(wide.y));
        if (border.empty() || cv::pointPolygonTest(border, at, false) >= 0.0) inside.push_back({at.x, at.y});
    }
    return inside;
}

double distanceFromMiddle(const Quad& quad, const cv::Mat& image) {
    const ImagePoint centre = boundingBox(quad).centre();
    return std::hypot(centre.x / image.cols - 0.5, centre.y / image.rows - 0.5);
}

/// The library with the one template alone: there is nothing to confuse it with.
std::optional<Quad> foundAgain(const cv::Mat& image, const LandmarkLibrary& library, const Template& known) {
    auto alone = std::make_shared<LandmarkLibrary>();
    alone->extractor = library.extractor;
    alone->templates = {known};
    std::optional<Quad> best;
    double score = 0.0;
    for (const Detection& detection : LandmarkRecogniser(alone).recognise(image).detections) {
        if (detection.score <= score || !sound(detection.quad, image)) continue;
        best = detection.quad;
        score = detection.score;
    }
    return best;
}

} // namespace

Result<void> CoachOptions::check() const {
    const bool fine = darkest >= 0.0 && darkest < brightest && brightest <= 255.0 && mostBurnt > 0.0 &&
                      minSharpness >= 0.0 && minLongSide > 0.0 && minObjectFeatures > 0 &&
                      minPlaceFeatures > 0 && asideRatio > 1.0 && fartherShare > 0.0 && fartherShare < 1.0 &&
                      enoughPlaceViews > 0;
    if (fine) return {};
    return Error{ErrorCode::InvalidArgument, "the coach's limits make no sense", "coach"};
}

PictureQuality judgePicture(const cv::Mat& image, Kind kind, const std::optional<Quad>& outline,
                            const ExtractorOptions& extractor, const CoachOptions& options) {
    PictureQuality quality;
    const bool place = kind == Kind::Place;
    const std::optional<Quad> border = place ? std::nullopt : outline;
    if (border && !sound(*border, image)) {
        quality.problems.push_back(Advice::BadOutline);
        return quality;
    }
    try {
        const cv::Mat grey = greyOf(image);
        const cv::Rect part = partOf(border, image);
        quality.brightness = cv::mean(grey(part))[0];
        quality.burnt = cv::countNonZero(grey(part) > 252) / (1.0 * part.area());
        quality.sharpness = sharpness(grey(part));
        quality.keypoints = keypointsInside(grey, part, border, extractor);
    } catch (const cv::Exception&) { // a sliver of a picture: there is nothing in it
        quality.keypoints.clear();
    }
    quality.longSidePx = border ? longSide(*border, image.cols) : kUsualWidth;
    const auto told = [&](bool wrong, Advice advice) {
        if (wrong) quality.problems.push_back(advice);
    };
    told(quality.brightness < options.darkest, Advice::TooDark);
    told(quality.brightness > options.brightest || quality.burnt > options.mostBurnt, Advice::TooBright);
    told(quality.longSidePx < options.minLongSide, Advice::Nearer);
    told(quality.sharpness < options.minSharpness, Advice::Blurred);
    const int enough = place ? options.minPlaceFeatures : options.minObjectFeatures;
    told(quality.keypoints.size() < static_cast<std::size_t>(enough), Advice::FewFeatures);
    return quality;
}

Advice nextView(const std::vector<View>& views, Kind kind, const CoachOptions& options) {
    if (kind == Kind::Place)
        return static_cast<int>(views.size()) < options.enoughPlaceViews ? Advice::AnotherSpot
                                                                         : Advice::Enough;
    bool square = false, left = false, right = false;
    double nearest = 0.0, farthest = 1e9;
    for (const View& view : views) {
        // Corners run clockwise from the top left: side 1 is the right edge, side 3 the left one.
        const double ratio = side(view.outline, 3) / std::max(1e-6, side(view.outline, 1));
        left = left || ratio > options.asideRatio;
        right = right || ratio < 1.0 / options.asideRatio;
        square = square || (ratio <= options.asideRatio && ratio >= 1.0 / options.asideRatio);
        const double length = longSide(view.outline, view.size.width);
        nearest = std::max(nearest, length);
        farthest = std::min(farthest, length);
    }
    if (!square) return Advice::Squarely;
    if (!left) return Advice::FromLeft;
    if (!right) return Advice::FromRight;
    return farthest > options.fartherShare * nearest ? Advice::FromFarther : Advice::Enough;
}

std::optional<Quad> findOutline(const cv::Mat& image, const LandmarkLibrary& library, const Template* known) {
    if (image.empty()) return std::nullopt;
    if (known != nullptr && !known->views.empty())
        if (auto again = foundAgain(image, library, *known)) return again;
    RectangleDetectorOptions options;
    options.minAreaShare = 0.01;
    options.maxAreaShare = 0.9;
    std::optional<Quad> best;
    double worth = 0.0;
    for (const Detection& detection : detectRectangles(image, options).detections) {
        if (!sound(detection.quad, image)) continue;
        const double size = std::sqrt(boundingBox(detection.quad).area() / (1.0 * image.cols * image.rows));
        const double here = size * std::max(0.0, 1.0 - 1.4 * distanceFromMiddle(detection.quad, image));
        if (here <= worth) continue;
        worth = here;
        best = detection.quad;
    }
    return best;
}

} // namespace farol::recognition
