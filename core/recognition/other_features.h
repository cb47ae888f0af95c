#pragma once
// The feature extractors one may choose instead of our own SIFT: SURF (the paper's, from dlib), ORB and AKAZE
// (OpenCV's). Only this folder includes it.

#include <opencv2/core.hpp>

#include <vector>

namespace farol::recognition {

inline constexpr int kSurfBytes = 64;
inline constexpr int kOrbBytes = 32;   ///< 256 bits
inline constexpr int kAkazeBytes = 61; ///< 486 bits

/// All three: keypoints in pixels of `grey` (pixel centres at whole numbers), strongest first and at most
/// `most`; `angle` clockwise in degrees; `descriptors` CV_8U, one row each. The thresholds are between 0
/// and 1 and mean to each extractor what it makes of them: the larger, the fewer keypoints.
void surfFeatures(const cv::Mat& grey, int most, double threshold, std::vector<cv::KeyPoint>& keypoints,
                  cv::Mat& descriptors);
void orbFeatures(const cv::Mat& grey, int most, double threshold, std::vector<cv::KeyPoint>& keypoints,
                 cv::Mat& descriptors);
void akazeFeatures(const cv::Mat& grey, int most, double threshold, std::vector<cv::KeyPoint>& keypoints,
                   cv::Mat& descriptors);

} // namespace farol::recognition
