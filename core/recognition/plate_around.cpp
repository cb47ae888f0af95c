#include "core/recognition/plate_around.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace farol::recognition {

namespace {

constexpr double kWorkingHeight = 32.0; // pixels of a line while its plate is looked for
/// Of the step from ink to ground: how far a plate's ground may differ from itself. Light that falls unevenly
/// asks for more, a table of nearly the same white behind the plate for less.
constexpr std::array<double, 3> kEven{0.3, 0.15, 0.45};
constexpr double kFill = 0.88; // of the quadrilateral that the ground, its letters filled in, must cover

struct Patch {
    cv::Mat grey; ///< dark ink on light ground
    cv::Rect line;
    double scale = 1.0; ///< patch pixels for one of the picture
    cv::Point at;       ///< of the patch in the picture
};

std::optional<Patch> patchAround(const cv::Mat& grey, const Quad& quad, bool lightInk) {
    ImageBox box = boundingBox(quad);
    double beside = 3.0 * box.height, above = 2.0 * box.height;
    cv::Rect wanted(static_cast<int>(box.x - beside), static_cast<int>(box.y - above),
                    static_cast<int>(box.width + 2.0 * beside), static_cast<int>(box.height + 2.0 * above));
    wanted &= cv::Rect(0, 0, grey.cols, grey.rows);
    if (box.height < 6.0 || wanted.width < 16 || wanted.height < 12) return std::nullopt;
    Patch patch;
    patch.scale = std::min(1.0, kWorkingHeight / box.height);
    patch.at = wanted.tl();
    cv::resize(grey(wanted), patch.grey, cv::Size(), patch.scale, patch.scale, cv::INTER_AREA);
    cv::medianBlur(patch.grey, patch.grey, 3);
    if (lightInk) cv::bitwise_not(patch.grey, patch.grey);
    patch.line =
        cv::Rect(static_cast<int>((box.x - wanted.x) * patch.scale),
                 static_cast<int>((box.y - wanted.y) * patch.scale),
                 static_cast<int>(box.width * patch.scale), static_cast<int>(box.height * patch.scale)) &
        cv::Rect(0, 0, patch.grey.cols, patch.grey.rows);
    return patch.line.area() > 0 ? std::optional(patch) : std::nullopt;
}

/// 255 where the patch is as bright as the ground between the letters, as one piece.
cv::Mat groundOf(const Patch& patch, double tolerance) {
    cv::Mat ink, ground;
    cv::threshold(patch.grey(patch.line), ink, 0.0, 255.0, cv::THRESH_BINARY_INV | cv::THRESH_OTSU);
    double light = cv::mean(patch.grey(patch.line), ink == 0)[0];
    double dark = cv::mean(patch.grey(patch.line), ink)[0];
    double even = tolerance * (light - dark);
    if (even < 4.0) return {};
    cv::inRange(patch.grey, light - even, 255.0, ground);
    cv::Mat labels;
    cv::connectedComponents(ground, labels, 4, CV_32S);
    std::map<int, int> share; // ordered, so that the same picture always gives the same piece
    cv::Mat there = labels(patch.line);
    for (int y = 0; y < there.rows; ++y)
        for (int x = 0; x < there.cols; ++x)
            if (int label = there.at<int>(y, x); label > 0) ++share[label];
    if (share.empty()) return {};
    auto most = std::max_element(share.begin(), share.end(),
                                 [](const auto& a, const auto& b) { return a.second < b.second; });
    return labels == most->first;
}

/// Four corners of a hull, clockwise from the upper left; empty when it is no quadrilateral.
std::optional<std::array<cv::Point2f, 4>> cornersOf(const std::vector<cv::Point>& hull) {
    std::vector<cv::Point> polygon;
    double length = cv::arcLength(hull, true);
    for (double tolerance : {0.015, 0.025, 0.04}) {
        cv::approxPolyDP(hull, polygon, tolerance * length, true);
        if (polygon.size() <= 4) break;
    }
    if (polygon.size() != 4) return std::nullopt;
    std::array<cv::Point2f, 4> corners;
    auto first = std::min_element(polygon.begin(), polygon.end(),
                                  [](cv::Point a, cv::Point b) { return a.x + a.y < b.x + b.y; });
    auto start = static_cast<std::size_t>(first - polygon.begin());
    bool clockwise = cv::contourArea(polygon, true) > 0.0;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = polygon[(start + (clockwise ? i : 4 - i)) % 4];
    return corners;
}

std::optional<Quad> outlineOf(const Patch& patch, const cv::Mat& ground) {
    std::vector<std::vector<cv::Point>> contours;
    cv::findContours(ground, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_SIMPLE);
    if (contours.empty()) return std::nullopt;
    std::vector<cv::Point> hull;
    cv::convexHull(contours.front(), hull);
    cv::Rect box = cv::boundingRect(hull);
    bool ends = box.x > 0 && box.y > 0 && box.br().x < ground.cols && box.br().y < ground.rows;
    if (!ends || 2 * box.height < patch.line.height) return std::nullopt;
    auto corners = cornersOf(hull);
    if (!corners) return std::nullopt;
    std::vector<cv::Point2f> quadrilateral(corners->begin(), corners->end());
    if (cv::contourArea(contours.front()) < kFill * cv::contourArea(quadrilateral)) return std::nullopt;
    Quad plate;
    for (std::size_t i = 0; i < 4; ++i)
        plate[i] = {((*corners)[i].x + 0.5) / patch.scale + patch.at.x,
                    ((*corners)[i].y + 0.5) / patch.scale + patch.at.y};
    return plate;
}

} // namespace

std::optional<Quad> plateAround(const cv::Mat& grey, const Quad& line, bool lightInk) {
    auto patch = patchAround(grey, line, lightInk);
    if (!patch) return std::nullopt;
    for (double tolerance : kEven) {
        cv::Mat ground = groundOf(*patch, tolerance);
        if (ground.empty()) continue;
        if (auto plate = outlineOf(*patch, ground)) return plate;
    }
    return std::nullopt;
}

} // namespace farol::recognition
