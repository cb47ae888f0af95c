#pragma once
// What speaks for and against a trained object at a fitted place, weighed into one figure. Only this folder
// and the fit of the weights (tests/bench) include it.

#include <opencv2/core.hpp>

#include <array>
#include <vector>

namespace farol::recognition {

struct FitEvidence {
    int inliers = 0;           ///< of matches guided by the fitted place
    int unguided = 0;          ///< matches that the index found among all templates and that fit
    double uniqueness = 0.0;   ///< sum over these of how far the nearest rival lay, 0 to 1 each
    int seen = 0;              ///< the frame's keypoints inside the outline
    double spread = 0.0;       ///< share of the plane that the inliers' hull covers
    double correlation = -1.0; ///< of grey values, best half of the blocks
    double strain = 0.0;       ///< how badly a camera of ordinary focal length could see the plane so
};

inline constexpr std::size_t kEvidenceTerms = 6;
/// What the weights apply to.
std::array<double, kEvidenceTerms> termsOf(const FitEvidence& evidence);
/// Logarithm of the odds that the object is there, fitted on composed frames (tests/bench/README.md).
double logOdds(const FitEvidence& evidence);

/// Share of a width x height plane that the hull of the points covers.
double hullShare(const std::vector<cv::Point2f>& points, const cv::Point2f& planeSize);
/// 0 where a pinhole camera with a focal length between 0.6 and 1.6 of the frame's longer side sees the plane
/// through this homography; grows with the relative misfit of its two axes' lengths and right angle.
double strainOf(const cv::Matx33d& planeToFrame, cv::Size frame);

} // namespace farol::recognition
