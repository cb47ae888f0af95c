#include "core/recognition/rectangle_detector.h"

#include "core/recognition/grey.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr int kWorkingSide = 800;

using Corners = std::array<cv::Point2f, 4>;

/// Clockwise from the top left, as the object stands upright in the picture.
Corners ordered(const std::vector<cv::Point>& polygon) {
    std::vector<cv::Point2f> points(polygon.begin(), polygon.end());
    std::sort(points.begin(), points.end(),
              [](const auto& a, const auto& b) { return a.x + a.y < b.x + b.y; });
    cv::Point2f topLeft = points.front();
    cv::Point2f bottomRight = points.back();
    cv::Point2f a = points[1];
    cv::Point2f b = points[2];
    if (a.x - a.y < b.x - b.y) std::swap(a, b);
    return {topLeft, a, bottomRight, b};
}

double cosineAt(const Corners& q, std::size_t i) {
    cv::Point2f a = q[(i + 3) % 4] - q[i];
    cv::Point2f b = q[(i + 1) % 4] - q[i];
    double lengths = cv::norm(a) * cv::norm(b);
    return lengths > 0.0 ? std::abs(a.dot(b)) / lengths : 1.0;
}

/// How far the side edges lean from the vertical, in degrees.
double tilt(const Corners& q) {
    auto lean = [](cv::Point2f from, cv::Point2f to) {
        return std::abs(std::atan2(to.x - from.x, std::abs(to.y - from.y))) * 180.0 / kPi;
    };
    return std::max(lean(q[0], q[3]), lean(q[1], q[2]));
}

struct Found {
    Corners quad;
    double score = 0.0;
};

void addQuads(const cv::Mat& binary, const RectangleDetectorOptions& options, std::vector<Found>& found) {
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(binary, contours, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
    double whole = static_cast<double>(binary.total());
    for (const auto& contour : contours) {
        if (contour.size() < 4) continue;
        cv::Rect box = cv::boundingRect(contour);
        if (box.area() < options.minAreaShare * whole) continue;
        std::vector<cv::Point> polygon;
        cv::approxPolyDP(contour, polygon, 0.025 * cv::arcLength(contour, true), true);
        if (polygon.size() != 4 || !cv::isContourConvex(polygon)) continue;
        Corners quad = ordered(polygon);
        double area = cv::contourArea(std::vector<cv::Point2f>(quad.begin(), quad.end()));
        if (area < options.minAreaShare * whole || area > options.maxAreaShare * whole) continue;
        double worst = 0.0;
        for (std::size_t i = 0; i < 4; ++i) worst = std::max(worst, cosineAt(quad, i));
        if (worst > options.maxCornerCosine || tilt(quad) > options.maxTiltDegrees) continue;
        // A contour that hugs its four corners is a better rectangle than one that bulges between them.
        double fill = std::min(1.0, cv::contourArea(contour) / area);
        found.push_back({quad, fill * (1.0 - 0.5 * worst)});
    }
}

Quad inFullPicture(const Corners& corners, double scale) {
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i)
        quad[i] = {(corners[i].x + 0.5) / scale, (corners[i].y + 0.5) / scale};
    return quad;
}

} // namespace

Result<void> RectangleDetectorOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    if (!(minAreaShare > 0.0 && minAreaShare < 1.0))
        return wrong("a share lies between 0 and 1", "minAreaShare");
    if (!(maxAreaShare > minAreaShare && maxAreaShare <= 1.0))
        return wrong("must be above the least share", "maxAreaShare");
    if (!(maxCornerCosine > 0.0 && maxCornerCosine < 1.0))
        return wrong("a cosine lies between 0 and 1", "maxCornerCosine");
    if (!(maxTiltDegrees > 0.0 && maxTiltDegrees < 90.0))
        return wrong("a tilt lies between 0 and 90 degrees", "maxTiltDegrees");
    return {};
}

DetectorResult detectRectangles(const cv::Mat& image, const RectangleDetectorOptions& options) {
    DetectorResult result;
    cv::Mat grey = greyOf(image);
    if (grey.empty() || std::min(grey.cols, grey.rows) < 16) return result;
    double scale = 1.0;
    cv::Mat small = reduced(grey, kWorkingSide, scale);
    std::vector<Found> found;
    cv::Mat smooth, edges, light;
    cv::GaussianBlur(small, smooth, cv::Size(5, 5), 0.0);
    cv::Canny(smooth, edges, 40.0, 120.0);
    cv::dilate(edges, edges, cv::Mat()); // closes the gaps at corners
    addQuads(edges, options, found);
    cv::adaptiveThreshold(smooth, light, 255.0, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY, 31, 5.0);
    addQuads(light, options, found);
    cv::bitwise_not(light, light);
    addQuads(light, options, found);
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.score > b.score; });
    for (const Found& one : found) {
        Quad quad = inFullPicture(one.quad, scale);
        // The inner and the outer border of one frame, and the same border found twice, are one rectangle.
        bool copy =
            std::any_of(result.detections.begin(), result.detections.end(), [&](const Detection& kept) {
                return overlap(boundingBox(kept.quad), boundingBox(quad)) > 0.65;
            });
        if (copy) continue;
        Detection detection;
        detection.kind = Kind::Rectangle;
        detection.quad = quad;
        detection.image = {image.cols, image.rows};
        detection.score = one.score;
        result.detections.push_back(std::move(detection));
    }
    return result;
}

} // namespace farol::recognition
