#include "core/recognition/view_poses.h"

#include "core/base/angle.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr double kPlaneLongSide = 400.0;

struct Pose {
    double distance; ///< metres, for a plane whose longer side looks `longSidePx` long from 1 m
    double yaw;      ///< degrees
    double pitch;
    double afterBlur;
};

constexpr std::array<Pose, kPoseCount> kPoses{{{2.4, 48, 0, 0.8},
                                               {2.4, -48, 0, 0.8},
                                               {2.4, 0, 45, 0.8},
                                               {2.4, 0, -45, 0.8},
                                               {3.0, 0, 0, 0.6},
                                               {1.4, 48, 0, 0.0},
                                               {1.4, -48, 0, 0.0},
                                               {3.0, 42, 0, 0.8},
                                               {3.0, -42, 0, 0.8},
                                               {3.0, 0, 40, 0.8},
                                               {3.0, 0, -40, 0.8},
                                               {2.2, 36, 0, 0.8},
                                               {2.2, -36, 0, 0.8}}};

double side(const Quad& quad, std::size_t from) {
    const ImagePoint& a = quad[from];
    const ImagePoint& b = quad[(from + 1) % 4];
    return std::hypot(b.x - a.x, b.y - a.y);
}

} // namespace

std::array<cv::Point2f, 4> Plane::corners() const {
    auto w = static_cast<float>(width);
    auto h = static_cast<float>(height);
    return {cv::Point2f(0, 0), cv::Point2f(w, 0), cv::Point2f(w, h), cv::Point2f(0, h)};
}

Plane planeOf(const Quad& outline, const std::optional<double>& widthM,
              const std::optional<double>& heightM) {
    double width = (side(outline, 0) + side(outline, 2)) / 2.0;
    double height = (side(outline, 1) + side(outline, 3)) / 2.0;
    if (widthM && heightM && *widthM > 0.0 && *heightM > 0.0) {
        width = *widthM;
        height = *heightM;
    }
    double longer = std::max({width, height, 1e-6});
    // A sliver would make every homography singular.
    return {std::max(width / longer, 0.02) * kPlaneLongSide,
            std::max(height / longer, 0.02) * kPlaneLongSide};
}

cv::Matx33d planeToQuad(const Plane& plane, const Quad& outline) {
    std::array<cv::Point2f, 4> to;
    for (std::size_t i = 0; i < 4; ++i)
        to[i] = cv::Point2f(static_cast<float>(outline[i].x), static_cast<float>(outline[i].y));
    return cv::getPerspectiveTransform(plane.corners().data(), to.data());
}

std::optional<PosedView> posedView(const Plane& plane, int pose, double longSidePx) {
    const Pose& p = kPoses.at(static_cast<std::size_t>(pose - 1));
    double yaw = fromDegrees(p.yaw).value;
    double pitch = fromDegrees(p.pitch).value;
    cv::Matx33d turn(std::cos(yaw), 0, std::sin(yaw), 0, 1, 0, -std::sin(yaw), 0, std::cos(yaw));
    cv::Matx33d nod(1, 0, 0, 0, std::cos(pitch), -std::sin(pitch), 0, std::sin(pitch), std::cos(pitch));
    cv::Matx33d r = nod * turn;
    // A camera whose focal length is 600 px, and a plane so large that it looks longSidePx long from 1 m.
    constexpr double kFocal = 600.0;
    double m = longSidePx / kFocal / std::max(plane.width, plane.height);
    cv::Matx33d place(r(0, 0) * m, r(0, 1) * m, 0, r(1, 0) * m, r(1, 1) * m, 0, r(2, 0) * m, r(2, 1) * m,
                      p.distance);
    cv::Matx33d centre(1, 0, -plane.width / 2, 0, 1, -plane.height / 2, 0, 0, 1);
    cv::Matx33d h = cv::Matx33d(kFocal, 0, 0, 0, kFocal, 0, 0, 0, 1) * place * centre;
    auto quad = mapped(h, plane.corners());
    cv::Rect box = cv::boundingRect(std::vector<cv::Point2f>(quad.begin(), quad.end()));
    if (box.width < 12 || box.height < 12 || box.width > 4000 || box.height > 4000) return std::nullopt;
    PosedView view;
    view.planeToPicture = cv::Matx33d(1, 0, -box.x, 0, 1, -box.y, 0, 0, 1) * h;
    view.size = box.size();
    view.blur = 0.45 * p.distance;
    view.afterBlur = p.afterBlur;
    return view;
}

cv::Matx33d seenFrom(const Plane& plane, double longSidePx, double yawDegrees, double focal, cv::Size frame) {
    double yaw = fromDegrees(yawDegrees).value;
    // The plane's longer side is one unit, as far away as it then looks that long.
    double m = 1.0 / std::max(plane.width, plane.height);
    cv::Matx33d place(std::cos(yaw) * m, 0, 0, 0, m, 0, -std::sin(yaw) * m, 0, focal / longSidePx);
    cv::Matx33d centre(1, 0, -plane.width / 2, 0, 1, -plane.height / 2, 0, 0, 1);
    return cv::Matx33d(focal, 0, frame.width / 2.0, 0, focal, frame.height / 2.0, 0, 0, 1) * place * centre;
}

double posedLongSide(const Quad& outline) {
    double longer = std::max({side(outline, 0), side(outline, 1), side(outline, 2), side(outline, 3)});
    return std::clamp(longer, 200.0, 600.0);
}

bool nearlyFrontal(const Quad& outline) {
    auto alike = [](double a, double b) { return std::min(a, b) > 0.88 * std::max(a, b); };
    if (!alike(side(outline, 0), side(outline, 2)) || !alike(side(outline, 1), side(outline, 3)))
        return false;
    for (std::size_t i = 0; i < 4; ++i) {
        const ImagePoint& a = outline[(i + 3) % 4];
        const ImagePoint& b = outline[i];
        const ImagePoint& c = outline[(i + 1) % 4];
        double dot = (a.x - b.x) * (c.x - b.x) + (a.y - b.y) * (c.y - b.y);
        double lengths = std::hypot(a.x - b.x, a.y - b.y) * std::hypot(c.x - b.x, c.y - b.y);
        if (std::abs(dot) > 0.2 * lengths) return false;
    }
    return true;
}

cv::Point2d mapped(const cv::Matx33d& homography, cv::Point2d point) {
    cv::Vec3d p = homography * cv::Vec3d(point.x, point.y, 1.0);
    double w = std::abs(p[2]) > 1e-12 ? p[2] : 1e-12;
    return {p[0] / w, p[1] / w};
}

std::array<cv::Point2f, 4> mapped(const cv::Matx33d& homography, const std::array<cv::Point2f, 4>& points) {
    std::array<cv::Point2f, 4> out;
    for (std::size_t i = 0; i < 4; ++i) out[i] = mapped(homography, cv::Point2d(points[i]));
    return out;
}

} // namespace farol::recognition
