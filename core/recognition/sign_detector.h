#pragma once
// Pictogram signs: exits with a running man, and (when asked for) signs of extinguishers, toilets, stairs and
// lifts. A small convolutional network that is compiled in finds them at any size and angle; it was trained
// by tests/training/signs. A missed sign is better than a false one.

#include "core/base/error.h"
#include "core/recognition/detection.h"

#include <opencv2/core.hpp>

#include <memory>

namespace farol::recognition {

struct SignDetectorOptions {
    double minScore = 0.5;
    /// Signs of extinguishers, toilets, stairs and lifts too. Off: they were learnt from drawings alone.
    bool squareSigns = false;
    double minSquareScore = 0.5;
    int longestSide = 384; ///< of the picture that is searched; a larger one sees farther and takes longer
    double focalPx =
        0.0; ///< of the camera, in pixels of the picture given; 0: unknown, and no bearing is told

    Result<void> check() const;
};

/// Not for two threads at once: each has its own. An exit sign is a Kind::ExitSign; the others are Kind::Sign
/// whose text says what they show ("extinguisher", "toilet", "stairs", "lift").
class SignDetector {
public:
    explicit SignDetector(const SignDetectorOptions& options = {});
    ~SignDetector();
    SignDetector(SignDetector&&) noexcept;
    SignDetector& operator=(SignDetector&&) noexcept;

    /// `bgr` 8-bit, colour; any other picture has no signs. Best first.
    DetectorResult detect(const cv::Mat& bgr);

private:
    struct Network;
    SignDetectorOptions m_options;
    std::unique_ptr<Network> m_network;
};

} // namespace farol::recognition
