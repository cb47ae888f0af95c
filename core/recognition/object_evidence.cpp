#include "core/recognition/object_evidence.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace farol::recognition {

namespace {

constexpr double kBias = -3.95;
constexpr std::array<double, kEvidenceTerms> kWeights{1.27, 1.04, 0.66, 1.35, 7.24, -2.26};

} // namespace

std::array<double, kEvidenceTerms> termsOf(const FitEvidence& e) {
    double inliers = std::max(e.inliers, 1);
    return {std::log(1.0 + e.unguided),
            std::log(0.2 + e.uniqueness),
            std::log(inliers / std::max(inliers, static_cast<double>(e.seen))),
            std::sqrt(std::clamp(e.spread, 0.0, 1.0)),
            e.correlation,
            e.strain};
}

double logOdds(const FitEvidence& evidence) {
    auto terms = termsOf(evidence);
    double sum = kBias;
    for (std::size_t i = 0; i < kEvidenceTerms; ++i) sum += kWeights[i] * terms[i];
    return sum;
}

double hullShare(const std::vector<cv::Point2f>& points, const cv::Point2f& planeSize) {
    if (points.size() < 3) return 0.0;
    std::vector<cv::Point2f> hull;
    cv::convexHull(points, hull);
    return hull.size() < 3 ? 0.0 : cv::contourArea(hull) / (planeSize.x * planeSize.y);
}

double strainOf(const cv::Matx33d& planeToFrame, cv::Size frame) {
    double longer = std::max(frame.width, frame.height);
    cv::Matx33d centred =
        cv::Matx33d(1, 0, -frame.width / 2.0, 0, 1, -frame.height / 2.0, 0, 0, 1) * planeToFrame;
    double least = std::numeric_limits<double>::max();
    for (double focal : {0.6, 0.8, 1.0, 1.25, 1.6}) {
        double f = focal * longer;
        cv::Vec3d a(centred(0, 0) / f, centred(1, 0) / f, centred(2, 0));
        cv::Vec3d b(centred(0, 1) / f, centred(1, 1) / f, centred(2, 1));
        double la = cv::norm(a), lb = cv::norm(b);
        if (!(la > 0.0 && lb > 0.0)) continue;
        double lengths = std::abs(std::log(la / lb));
        double angle = std::abs(a.dot(b)) / (la * lb);
        least = std::min(least, std::hypot(lengths, angle));
    }
    return std::min(least, 2.0);
}

} // namespace farol::recognition
