#include "core/recognition/quad_flow.h"

#include "core/recognition/grey.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

const cv::Size kWindow(15, 15);
constexpr int kLevels = 3;
constexpr int kSamplesAcross = 24;
constexpr double kSampledMargin = 0.08; // what is around a thing shows when something comes before it

double areaOf(const Quad& quad) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const ImagePoint &a = quad[i], &b = quad[(i + 1) % 4];
        sum += a.x * b.y - b.x * a.y;
    }
    return 0.5 * sum;
}

ImagePoint centreOf(const Quad& quad) {
    ImagePoint sum;
    for (ImagePoint corner : quad) sum = {sum.x + corner.x / 4.0, sum.y + corner.y / 4.0};
    return sum;
}

bool isConvex(const Quad& quad) {
    int turns = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const ImagePoint &a = quad[i], &b = quad[(i + 1) % 4], &c = quad[(i + 2) % 4];
        turns += (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) > 0.0 ? 1 : -1;
    }
    return std::abs(turns) == 4;
}

cv::Point2f pointOf(ImagePoint p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

ImagePoint moved(const cv::Matx33d& model, ImagePoint p) {
    cv::Vec3d h = model * cv::Vec3d(p.x, p.y, 1.0);
    double w = std::abs(h[2]) > 1e-9 ? h[2] : 1e-9;
    return {h[0] / w, h[1] / w};
}

/// Corners inside the quad, made larger by `grow` about its centre.
std::vector<cv::Point2f> cornersIn(const cv::Mat& grey, const Quad& quad, double grow, int most) {
    ImagePoint centre = centreOf(quad);
    std::vector<cv::Point> outline;
    for (ImagePoint p : quad)
        outline.emplace_back(cvRound(centre.x + (p.x - centre.x) * grow),
                             cvRound(centre.y + (p.y - centre.y) * grow));
    cv::Rect box = cv::boundingRect(outline) & cv::Rect(0, 0, grey.cols, grey.rows);
    if (box.width < 8 || box.height < 8) return {};
    cv::Mat mask(box.size(), CV_8U, cv::Scalar(0));
    for (cv::Point& p : outline) p -= box.tl();
    cv::fillConvexPoly(mask, outline, cv::Scalar(255));
    std::vector<cv::Point2f> found, kept;
    double distance = std::clamp(std::sqrt(static_cast<double>(box.area())) / 8.0, 3.0, 16.0);
    cv::goodFeaturesToTrack(grey(box), found, most, 0.02, distance, mask);
    for (cv::Point2f p : found) {
        p += cv::Point2f(box.tl());
        // What is a corner in an even patch is noise.
        cv::Rect patch(cvRound(p.x) - 4, cvRound(p.y) - 4, 9, 9);
        cv::Scalar mean, deviation;
        cv::meanStdDev(grey(patch & cv::Rect(0, 0, grey.cols, grey.rows)), mean, deviation);
        if (deviation[0] >= 4.0) kept.push_back(p);
    }
    return kept;
}

/// Bilinear grey of a pyramid's level at a point of the working picture; negative outside.
float greyAt(const cv::Mat& level, float scale, cv::Point2f p) {
    float x = p.x * scale, y = p.y * scale;
    if (!(x >= 0.0F && y >= 0.0F && x < static_cast<float>(level.cols - 1) &&
          y < static_cast<float>(level.rows - 1)))
        return -1.0F;
    int column = static_cast<int>(x), row = static_cast<int>(y);
    float u = x - static_cast<float>(column), v = y - static_cast<float>(row);
    const unsigned char* upper = level.ptr<unsigned char>(row) + column;
    const unsigned char* lower = level.ptr<unsigned char>(row + 1) + column;
    return (1.0F - v) * ((1.0F - u) * float(upper[0]) + u * float(upper[1])) +
           v * ((1.0F - u) * float(lower[0]) + u * float(lower[1]));
}

/// The greys at these points, taken from a level of the pyramid that shows no finer detail than they do.
std::vector<float> lookOf(const FlowPicture& picture, int level, const std::vector<cv::Point2f>& points) {
    const cv::Mat& grey = picture.pyramid()[static_cast<std::size_t>(2 * level)];
    float scale = 1.0F / static_cast<float>(1 << level);
    std::vector<float> look;
    look.reserve(points.size());
    for (cv::Point2f p : points) look.push_back(greyAt(grey, scale, p));
    return look;
}

struct Likeness {
    double correlation = 1.0, share = 0.0; ///< of samples that are inside the picture now
};

Likeness likeness(const std::vector<float>& before, const std::vector<float>& now) {
    double n = 0.0, a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0, wanted = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] < 0.0F) continue;
        wanted += 1.0;
        if (now[i] < 0.0F) continue;
        double x = double(before[i]), y = double(now[i]);
        n += 1.0;
        a += x;
        b += y;
        aa += x * x;
        bb += y * y;
        ab += x * y;
    }
    Likeness result;
    result.share = wanted > 0.0 ? n / wanted : 0.0;
    if (n < 16.0) return result;
    double varianceA = aa / n - a * a / (n * n), varianceB = bb / n - b * b / (n * n);
    result.correlation = (ab / n - a * b / (n * n)) / std::sqrt(std::max(1.0, varianceA * varianceB));
    return result;
}

/// Do the points lie all over the quad? Only then four corners follow from them by a homography.
bool spreadOver(const std::vector<cv::Point2f>& points, const Quad& quad) {
    std::vector<cv::Point2f> hull;
    cv::convexHull(points, hull);
    return hull.size() >= 4 && cv::contourArea(hull) > 0.4 * std::abs(areaOf(quad));
}

/// The plane's motion that most points share: no more free than they can bear.
std::optional<cv::Matx33d> commonMotion(const std::vector<cv::Point2f>& before,
                                        const std::vector<cv::Point2f>& now, const Quad& quad, double fitPx,
                                        cv::Mat& inliers) {
    constexpr std::size_t kForHomography = 14, kForAffine = 6;
    if (before.size() >= kForHomography && spreadOver(before, quad)) {
        cv::Mat model = cv::findHomography(before, now, cv::RANSAC, fitPx, inliers, 300, 0.99);
        if (!model.empty()) return cv::Matx33d(model);
    }
    constexpr std::size_t kMostRounds = 200, kRefinements = 10;
    cv::Mat model =
        before.size() >= kForAffine
            ? cv::estimateAffine2D(before, now, inliers, cv::RANSAC, fitPx, kMostRounds, 0.99, kRefinements)
            : cv::estimateAffinePartial2D(before, now, inliers, cv::RANSAC, fitPx, kMostRounds, 0.99,
                                          kRefinements);
    if (model.empty()) return std::nullopt;
    cv::Matx23d rows(model);
    return cv::Matx33d(rows(0, 0), rows(0, 1), rows(0, 2), rows(1, 0), rows(1, 1), rows(1, 2), 0.0, 0.0, 1.0);
}

struct Step {
    std::vector<cv::Point2f> origins, now;
    std::vector<int> indices;
};

/// The points that are found in the next frame, and from there where they came from.
Step follow(const QuadAnchor& anchor, const QuadState& state, const FlowPicture& from, const FlowPicture& to,
            double maxBackErrorPx) {
    Step step;
    if (state.points.empty()) return step;
    std::vector<cv::Point2f> there, back;
    std::vector<unsigned char> found, foundBack;
    std::vector<float> errors;
    const cv::TermCriteria stop(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.02);
    cv::calcOpticalFlowPyrLK(from.pyramid(), to.pyramid(), state.points, there, found, errors, kWindow,
                             kLevels, stop);
    cv::calcOpticalFlowPyrLK(to.pyramid(), from.pyramid(), there, back, foundBack, errors, kWindow, kLevels,
                             stop);
    for (std::size_t i = 0; i < there.size(); ++i) {
        cv::Point2f miss = back[i] - state.points[i];
        if (!found[i] || !foundBack[i] || cv::norm(miss) > maxBackErrorPx) continue;
        step.now.push_back(there[i]);
        step.indices.push_back(state.origins[i]);
        step.origins.push_back(anchor.points[static_cast<std::size_t>(state.origins[i])]);
    }
    return step;
}

bool plausible(const Quad& now, const Quad& before) {
    constexpr double kMostGrowth = 1.5; // of the area from one frame to the next
    double areaNow = areaOf(now), areaBefore = areaOf(before);
    if (!isConvex(now) || areaNow * areaBefore <= 0.0) return false;
    double ratio = areaNow / areaBefore;
    return std::abs(areaNow) > 16.0 && ratio < kMostGrowth && ratio > 1.0 / kMostGrowth;
}

} // namespace

Result<void> QuadFlowOptions::check() const {
    auto wrong = [](const char* what, const char* which) {
        return Error{ErrorCode::InvalidArgument, what, which};
    };
    auto isShare = [](double value) { return value >= 0.0 && value <= 1.0; };
    if (workingLongSide < 64 || workingLongSide > 4096)
        return wrong("the working size is not from 64 to 4096 pixels", "workingLongSide");
    if (minPoints < 4 || maxPoints < minPoints || maxPoints > 1000)
        return wrong("4 to 1000 points are followed", "minPoints, maxPoints");
    if (!(maxBackErrorPx > 0.0 && fitPx > 0.0))
        return wrong("must be above 0 pixels", "maxBackErrorPx, fitPx");
    if (!isShare(minInlierShare) || !isShare(minPointShare) || !isShare(minInView))
        return wrong("a share lies between 0 and 1", "minInlierShare, minPointShare, minInView");
    if (!(minCorrelation >= -1.0 && minCorrelation <= 1.0))
        return wrong("a correlation lies between -1 and 1", "minCorrelation");
    return {};
}

FlowPicture::FlowPicture(const cv::Mat& image, const QuadFlowOptions& options) {
    cv::Mat grey = greyOf(image);
    if (grey.empty() || std::min(grey.cols, grey.rows) < 32) return;
    m_grey = reduced(grey, options.workingLongSide, m_scale);
}

const std::vector<cv::Mat>& FlowPicture::pyramid() const {
    // As many levels as asked for, also where the picture is small: a level may be of a few pixels only.
    if (m_pyramid.empty() && !m_grey.empty())
        cv::buildOpticalFlowPyramid(m_grey, m_pyramid, kWindow, kLevels, true);
    return m_pyramid;
}

Quad FlowPicture::toWorking(const Quad& full) const {
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i) quad[i] = {full[i].x * m_scale - 0.5, full[i].y * m_scale - 0.5};
    return quad;
}

Quad FlowPicture::toFull(const Quad& working) const {
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i)
        quad[i] = {(working[i].x + 0.5) / m_scale, (working[i].y + 0.5) / m_scale};
    return quad;
}

const char* flowEndName(FlowEnd end) {
    switch (end) {
    case FlowEnd::PointsLost:
        return "points_lost";
    case FlowEnd::Inconsistent:
        return "inconsistent_motion";
    case FlowEnd::LooksDifferent:
        return "looks_different";
    case FlowEnd::LeftView:
        return "left_view";
    case FlowEnd::None:
        break;
    }
    return "none";
}

QuadAnchor anchorAt(const FlowPicture& picture, const Quad& quad, const QuadFlowOptions& options) {
    QuadAnchor anchor;
    anchor.quad = picture.toWorking(quad);
    if (picture.empty()) return anchor;
    // A smooth door has its corners in its frame, and some things only in what hangs around them.
    for (double grow : {1.1, 1.6}) {
        anchor.points = cornersIn(picture.grey(), anchor.quad, grow, options.maxPoints);
        if (static_cast<int>(anchor.points.size()) >= options.minPoints + 3) break;
    }
    double size = std::sqrt(std::abs(areaOf(anchor.quad)));
    while (anchor.level < 2 && size / (2 << anchor.level) > kSamplesAcross) ++anchor.level;
    auto levels = static_cast<int>(picture.pyramid().size() / 2);
    anchor.level = std::min(anchor.level, std::max(0, levels - 1));
    std::array<cv::Point2f, 4> unit{cv::Point2f(0, 0), {1, 0}, {1, 1}, {0, 1}}, corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = pointOf(anchor.quad[i]);
    if (size < 4.0 || !isConvex(anchor.quad)) return anchor;
    cv::Matx33d toPicture(cv::getPerspectiveTransform(unit.data(), corners.data()));
    for (int row = 0; row < kSamplesAcross; ++row)
        for (int column = 0; column < kSamplesAcross; ++column) {
            auto along = [](int i) {
                return -kSampledMargin + (1.0 + 2.0 * kSampledMargin) * (i + 0.5) / kSamplesAcross;
            };
            anchor.samples.push_back(pointOf(moved(toPicture, {along(column), along(row)})));
        }
    std::vector<float> look = lookOf(picture, anchor.level, anchor.samples);
    cv::Scalar mean, deviation;
    cv::meanStdDev(look, mean, deviation);
    constexpr double kEven = 6.0;
    if (deviation[0] >= kEven) anchor.look = std::move(look);
    return anchor;
}

QuadState stateAt(const QuadAnchor& anchor) {
    QuadState state{anchor.quad, anchor.points, {}};
    for (std::size_t i = 0; i < anchor.points.size(); ++i) state.origins.push_back(static_cast<int>(i));
    return state;
}

std::optional<QuadState> carried(const QuadAnchor& anchor, const QuadState& state, const FlowPicture& from,
                                 const FlowPicture& to, const QuadFlowOptions& options, FlowEnd& end) {
    auto give = [&](FlowEnd why) {
        end = why;
        return std::nullopt;
    };
    end = FlowEnd::None;
    auto fewest = std::max<std::size_t>(
        static_cast<std::size_t>(options.minPoints),
        static_cast<std::size_t>(options.minPointShare * static_cast<double>(anchor.points.size())));
    if (from.empty() || to.empty() || from.grey().size() != to.grey().size())
        return give(FlowEnd::PointsLost);
    Step step = follow(anchor, state, from, to, options.maxBackErrorPx);
    if (step.now.size() < fewest) return give(FlowEnd::PointsLost);
    cv::Mat inliers;
    auto model = commonMotion(step.origins, step.now, anchor.quad, options.fitPx, inliers);
    if (!model) return give(FlowEnd::Inconsistent);
    QuadState next;
    for (std::size_t i = 0; i < 4; ++i) next.quad[i] = moved(*model, anchor.quad[i]);
    for (std::size_t i = 0; i < step.now.size(); ++i) {
        if (inliers.at<unsigned char>(static_cast<int>(i)) == 0) continue;
        next.points.push_back(step.now[i]);
        next.origins.push_back(step.indices[i]);
    }
    auto agreeing = static_cast<double>(next.points.size());
    if (agreeing < options.minInlierShare * static_cast<double>(step.now.size()) ||
        next.points.size() < fewest || !plausible(next.quad, state.quad))
        return give(FlowEnd::Inconsistent);
    ImagePoint centre = centreOf(next.quad);
    if (!(centre.x >= 0.0 && centre.y >= 0.0 && centre.x < to.grey().cols && centre.y < to.grey().rows))
        return give(FlowEnd::LeftView);
    if (anchor.look.empty()) return next;
    std::vector<cv::Point2f> samples;
    samples.reserve(anchor.samples.size());
    for (cv::Point2f p : anchor.samples) samples.push_back(pointOf(moved(*model, {p.x, p.y})));
    Likeness alike = likeness(anchor.look, lookOf(to, anchor.level, samples));
    if (alike.share < options.minInView) return give(FlowEnd::LeftView);
    if (alike.correlation < options.minCorrelation) return give(FlowEnd::LooksDifferent);
    return next;
}

} // namespace farol::recognition
