#include "truth_check.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace farol::test {

namespace {

bool hasOwnPixels(Kind kind) {
    switch (kind) {
    case Kind::Poster:
    case Kind::Text:
    case Kind::Sign:
    case Kind::ExitSign:
    case Kind::Picture:
    case Kind::Extinguisher:
        return true;
    default:
        return false;
    }
}

/// The box of the pixels of one number, searched near `near`.
ImageBox boxOfPixels(const cv::Mat& ids, std::uint16_t id, const ImageBox& near) {
    constexpr int kMargin = 8;
    int left = ids.cols, top = ids.rows, right = 0, bottom = 0;
    for (int y = std::max(0, static_cast<int>(near.y) - kMargin);
         y < std::min(ids.rows, static_cast<int>(near.y + near.height) + kMargin); ++y) {
        for (int x = std::max(0, static_cast<int>(near.x) - kMargin);
             x < std::min(ids.cols, static_cast<int>(near.x + near.width) + kMargin); ++x) {
            if (ids.at<std::uint16_t>(y, x) != id) continue;
            left = std::min(left, x);
            right = std::max(right, x + 1);
            top = std::min(top, y);
            bottom = std::max(bottom, y + 1);
        }
    }
    return {static_cast<double>(left), static_cast<double>(top), static_cast<double>(right - left),
            static_cast<double>(bottom - top)};
}

/// By how many pixels a pixel near one of the corners lies on the wrong side of the outline, at worst.
double gapAtCorners(const cv::Mat& ids, std::uint16_t id, const Quad& quad) {
    std::vector<cv::Point2f> outline;
    for (ImagePoint p : quad) outline.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    double worst = 0.0;
    constexpr int kAround = 6;
    for (ImagePoint corner : quad) {
        auto column = static_cast<int>(corner.x), row = static_cast<int>(corner.y);
        for (int y = std::max(0, row - kAround); y <= std::min(ids.rows - 1, row + kAround); ++y) {
            for (int x = std::max(0, column - kAround); x <= std::min(ids.cols - 1, column + kAround); ++x) {
                cv::Point2f middle(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                double inside = cv::pointPolygonTest(outline, middle, true);
                bool thing = ids.at<std::uint16_t>(y, x) == id;
                if (thing == (inside < 0.0)) worst = std::max(worst, std::abs(inside));
            }
        }
    }
    return worst;
}

} // namespace

std::vector<CornerGap> cornerGaps(const simulation::RenderedFrame& frame, const cv::Mat& ids) {
    std::vector<CornerGap> gaps;
    for (const simulation::SeenThing& thing : frame.truth.things) {
        ImageBox box = boundingBox(thing.quad);
        bool whole = box.x > 2.0 && box.y > 2.0 && box.x + box.width < ids.cols - 2.0 &&
                     box.y + box.height < ids.rows - 2.0;
        // A thing of few pixels never has exactly the share that it should.
        double least = box.area() > 3000.0 ? 0.985 : 0.95;
        if (!whole || !hasOwnPixels(thing.kind) || thing.visibleShare < least ||
            std::min(box.width, box.height) < 8.0)
            continue;
        std::uint16_t id =
            ids.at<std::uint16_t>(static_cast<int>(box.centre().y), static_cast<int>(box.centre().x));
        if (id == 0) continue;
        if (thing.kind != Kind::Extinguisher) {
            gaps.push_back({thing.kind, gapAtCorners(ids, id, thing.quad)});
            continue;
        }
        ImageBox pixels = boxOfPixels(ids, id, box);
        double gap = std::max({std::abs(pixels.x - box.x), std::abs(pixels.y - box.y),
                               std::abs(pixels.x + pixels.width - box.x - box.width),
                               std::abs(pixels.y + pixels.height - box.y - box.height)});
        gaps.push_back({thing.kind, gap});
    }
    return gaps;
}

} // namespace farol::test
