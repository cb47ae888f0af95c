#include "core/recognition/other_features.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <dlib/assert.h> // with the next, all that reads dlib's configuration
#include <dlib/test_for_odr_violations.h>
#undef DLIB_USE_BLAS // a vector of 64 needs no library for that
#undef DLIB_USE_LAPACK
#include <dlib/array2d.h>
#include <dlib/image_keypoint.h>
#pragma GCC diagnostic pop

#include <opencv2/features2d.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace farol::recognition {

namespace {

/// OpenCV leaves the order of equally strong keypoints open.
void strongestFirst(std::vector<cv::KeyPoint>& keypoints, cv::Mat& descriptors, int most) {
    std::vector<std::size_t> order(keypoints.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    auto key = [&](std::size_t i) {
        const cv::KeyPoint& p = keypoints[i];
        return std::tuple(-p.response, p.octave, p.pt.y, p.pt.x, p.angle);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    if (order.size() > static_cast<std::size_t>(most)) order.resize(static_cast<std::size_t>(most));
    std::vector<cv::KeyPoint> points;
    cv::Mat rows(static_cast<int>(order.size()), descriptors.cols, CV_8U);
    for (std::size_t i = 0; i < order.size(); ++i) {
        points.push_back(keypoints[order[i]]);
        descriptors.row(static_cast<int>(order[i])).copyTo(rows.row(static_cast<int>(i)));
    }
    keypoints = std::move(points);
    descriptors = rows;
}

} // namespace

void surfFeatures(const cv::Mat& grey, int most, double threshold, std::vector<cv::KeyPoint>& keypoints,
                  cv::Mat& descriptors) {
    constexpr double kOfDlib = 1000.0; // dlib's own default, 30, is 0.03 of ours
    constexpr double kStep = 300.0;    // of a byte: components of the unit vector seldom pass 0.4
    dlib::array2d<unsigned char> picture(grey.rows, grey.cols);
    for (int y = 0; y < grey.rows; ++y)
        std::memcpy(&picture[y][0], grey.ptr(y), static_cast<std::size_t>(grey.cols));
    auto points = dlib::get_surf_points(picture, most, threshold * kOfDlib);
    keypoints.clear();
    descriptors.create(static_cast<int>(points.size()), kSurfBytes, CV_8U);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& point = points[i];
        auto degrees = static_cast<float>(std::fmod(point.angle * 180.0 / CV_PI + 360.0, 360.0));
        keypoints.emplace_back(static_cast<float>(point.p.center.x()), static_cast<float>(point.p.center.y()),
                               static_cast<float>(point.p.scale * 4.0), degrees,
                               static_cast<float>(point.p.score), 0);
        unsigned char* row = descriptors.ptr(static_cast<int>(i));
        for (int j = 0; j < kSurfBytes; ++j)
            row[j] = cv::saturate_cast<unsigned char>(128.0 + kStep * point.des(j));
    }
}

void orbFeatures(const cv::Mat& grey, int most, double threshold, std::vector<cv::KeyPoint>& keypoints,
                 cv::Mat& descriptors) {
    constexpr int kPatch = 31;
    keypoints.clear();
    descriptors.create(0, kOrbBytes, CV_8U);
    if (std::min(grey.rows, grey.cols) < 2 * kPatch) return;
    auto orb = cv::ORB::create(most, 1.2F, 8, kPatch, 0, 2, cv::ORB::HARRIS_SCORE, kPatch,
                               std::max(1, cvRound(threshold * 255.0)));
    orb->detectAndCompute(grey, cv::noArray(), keypoints, descriptors);
    strongestFirst(keypoints, descriptors, most);
}

void akazeFeatures(const cv::Mat& grey, int most, double threshold, std::vector<cv::KeyPoint>& keypoints,
                   cv::Mat& descriptors) {
    auto akaze = cv::AKAZE::create(cv::AKAZE::DESCRIPTOR_MLDB, 0, 3, static_cast<float>(threshold));
    descriptors.create(0, kAkazeBytes, CV_8U);
    akaze->detectAndCompute(grey, cv::noArray(), keypoints, descriptors);
    if (descriptors.empty()) descriptors.create(0, kAkazeBytes, CV_8U);
    strongestFirst(keypoints, descriptors, most);
    for (cv::KeyPoint& point : keypoints) point.angle = std::fmod(point.angle + 360.0F, 360.0F);
}

} // namespace farol::recognition
