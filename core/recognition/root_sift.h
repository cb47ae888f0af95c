#pragma once
// Our own SIFT (Lowe 2004) with RootSIFT bytes (Arandjelovic and Zisserman 2012), without the doubled first
// octave: what it finds is blurred away in a walking person's frames and costs most of the time. The
// descriptor is sampled on a fixed turned grid, so its cost does not grow with the keypoint. Only this folder
// includes it.

#include "core/recognition/scale_space.h"

#include <opencv2/core.hpp>

#include <vector>

namespace farol::recognition {

inline constexpr int kDescriptorBytes = 128;

struct RootSiftOptions {
    int maxKeypoints = 800;
    double contrastThreshold = 0.005;
    double edgeThreshold = 10.0;
};

/// Keypoints in pixels of `grey` (pixel centres at whole numbers), strongest first; `size` is their diameter,
/// `angle` clockwise in degrees as OpenCV has it. `descriptors` CV_8U x 128, one row each.
void rootSift(const cv::Mat& grey, const RootSiftOptions& options, ScaleSpace& space,
              std::vector<cv::KeyPoint>& keypoints, cv::Mat& descriptors);

/// Square roots of the L1-normalised vector of 128, so that Euclidean distance compares as Hellinger's; as
/// bytes, whose rounding is far below the noise and which take a quarter of the room.
void rootBytes(const float* histogram, unsigned char* out);

} // namespace farol::recognition
