#include "core/recognition/object_patch.h"

#include "core/capture/picture.h"
#include "core/recognition/grey.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace farol::recognition {

namespace {

constexpr int kPatch = 64;             // side of the compared patch
constexpr int kBlock = 16;             // compared block by block, so that a hidden part spoils only its own
constexpr std::size_t kBestBlocks = 8; // of 16: the other half may be hidden
constexpr int kMostOversampling = 5;

double blockCorrelation(const cv::Mat& a, const cv::Mat& b) {
    cv::Scalar meanA, meanB, deviationA, deviationB;
    cv::meanStdDev(a, meanA, deviationA);
    cv::meanStdDev(b, meanB, deviationB);
    double sum = 0.0;
    for (int y = 0; y < a.rows; ++y)
        for (int x = 0; x < a.cols; ++x)
            sum += (a.at<unsigned char>(y, x) - meanA[0]) * (b.at<unsigned char>(y, x) - meanB[0]);
    // The 3 grey levels keep two flat blocks from agreeing by their noise.
    return sum / static_cast<double>(a.total()) / ((deviationA[0] + 3.0) * (deviationB[0] + 3.0));
}

/// The square that holds the object's place in the frame, from so many samples that nothing aliases.
cv::Mat seenPatch(const cv::Point2f& planeSize, const cv::Mat& grey, const cv::Matx33d& planeToFrame) {
    Plane plane{planeSize.x, planeSize.y};
    auto corners = mapped(planeToFrame, plane.corners());
    double area = cv::contourArea(std::vector<cv::Point2f>(corners.begin(), corners.end()));
    int finer = std::clamp(static_cast<int>(std::lround(std::sqrt(area) / kPatch)), 1, kMostOversampling);
    int side = kPatch * finer;
    cv::Matx33d half(1, 0, -0.5, 0, 1, -0.5, 0, 0, 1);
    cv::Matx33d toPlane(plane.width / side, 0, 0, 0, plane.height / side, 0, 0, 0, 1);
    cv::Mat seen;
    cv::warpPerspective(grey, seen, half * planeToFrame * toPlane * half.inv(), cv::Size(side, side),
                        cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
    if (finer > 1) cv::resize(seen, seen, cv::Size(kPatch, kPatch), 0, 0, cv::INTER_AREA);
    return seen;
}

} // namespace

/// The object as the photograph shows it, on a small square.
cv::Mat patchOf(const View& view, const Plane& plane) {
    auto image = capture::decodePicture(view.jpeg, "");
    if (!image) return {};
    cv::Mat grey = greyOf(*image);
    ImageBox box = boundingBox(view.outline);
    double reduction = std::max(box.width, box.height) / kPatch;
    cv::GaussianBlur(grey, grey, cv::Size(), std::max(0.5, reduction * 0.225));
    cv::Matx33d half(1, 0, -0.5, 0, 1, -0.5, 0, 0, 1);
    cv::Matx33d toPlane(plane.width / kPatch, 0, 0, 0, plane.height / kPatch, 0, 0, 0, 1);
    cv::Mat patch;
    cv::warpPerspective(grey, patch, half * planeToQuad(plane, view.outline) * toPlane * half.inv(),
                        cv::Size(kPatch, kPatch), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                        cv::BORDER_REPLICATE);
    return patch;
}

double patchCorrelation(const cv::Mat& patch, const cv::Point2f& planeSize, const cv::Mat& grey,
                        const cv::Matx33d& planeToFrame) {
    if (patch.empty()) return 1.0; // the photograph is gone: geometry alone decides
    cv::Mat seen = seenPatch(planeSize, grey, planeToFrame);
    std::vector<double> blocks;
    for (int y = 0; y < kPatch; y += kBlock)
        for (int x = 0; x < kPatch; x += kBlock) {
            cv::Rect block(x, y, kBlock, kBlock);
            blocks.push_back(blockCorrelation(seen(block), patch(block)));
        }
    std::sort(blocks.begin(), blocks.end(), std::greater<>());
    return std::accumulate(blocks.begin(), blocks.begin() + kBestBlocks, 0.0) /
           static_cast<double>(kBestBlocks);
}

} // namespace farol::recognition
