#pragma once
// Door plates of 30 x 12 cm drawn by ourselves and seen by a camera of 640 x 480 pixels with a focal length
// of 600: the truth is known, and no picture of anybody is needed. Used by `evaluate text` and by the tests.

#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace farol::cli {

struct SignPose {
    double distanceM = 1.0;
    double yawDegrees = 0.0, pitchDegrees = 0.0, rollDegrees = 0.0;
    cv::Point2d offset{}; ///< of the plate's middle from the picture's, in pixels
};

struct SignLook {
    std::string text;
    std::string font; ///< file of the font; empty: strokes that are always there
    bool lightOnDark = false;
    bool frameLine = false;
    double letterShare = 0.5; ///< of the plate's height
};

struct RenderedSign {
    cv::Mat picture;
    Quad plate{};
    std::string text;
};

/// Files of the fonts that signs are drawn with, as far as this machine has them; by name, without repeats.
std::vector<std::string> signFonts();
/// Texts of door plates: numbers of rooms and words in Portuguese and English.
std::string signText(std::uint64_t seed);
/// The plate alone, 1200 x 480 pixels.
cv::Mat drawnPlate(const SignLook& look);
/// Hangs the plate into a picture of 640 x 480; then blur (sigma in pixels) and noise (standard deviation).
RenderedSign renderSign(const cv::Mat& background, const SignLook& look, const SignPose& pose, double blurPx,
                        double noise, std::uint64_t seed);
/// A wall with weak texture and a few edges.
cv::Mat drawnWall(std::uint64_t seed);
/// Everything by chance from the seed: text, font, colours, up to 30 degrees of yaw, light blur and noise.
RenderedSign randomSign(double distanceM, const cv::Mat& background, std::uint64_t seed);

} // namespace farol::cli
