#pragma once
// The Gaussian scale space under our SIFT. Only this folder includes it.

#include <opencv2/core.hpp>

#include <array>
#include <vector>

namespace farol::recognition {

inline constexpr int kScaleLayers = 3; ///< scales in which a keypoint may lie, of one octave
/// Blur of the first layer. Lowe doubles the picture and begins at 1.6 of its pixels, 0.8 of ours: small
/// things far away need nearly that, and 1.1 needs no doubling.
inline constexpr double kBaseSigma = 1.1;
inline constexpr double kPictureSigma = 0.5; ///< what a sharp picture has already

struct Octave {
    std::array<cv::Mat, kScaleLayers + 3> blurred;     ///< CV_32F, grey levels 0 to 255
    std::array<cv::Mat, kScaleLayers + 2> differences; ///< of neighbours in `blurred`
};

/// Kept between pictures, so that a frame allocates nothing.
struct ScaleSpace {
    std::vector<Octave> octaves;
    cv::Mat input;
    std::vector<float> row;

    /// Builds the octaves of `grey` (CV_8U); the first has its size, each further one half.
    void build(const cv::Mat& grey);
};

} // namespace farol::recognition
