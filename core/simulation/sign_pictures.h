#pragma once
// What hangs on walls, drawn by rule: signs of our own after the usual standards, posters that differ with
// the seed.

#include <opencv2/core.hpp>

#include <cstdint>
#include <string>

namespace farol::simulation {

/// Green, after ISO 7010 E001/E002: a running figure, a door, an arrow. `arrow`: -1 left, 0 down, 1 right.
cv::Mat exitSign(int arrow);
/// Red, after ISO 7010 F001.
cv::Mat extinguisherSign();
cv::Mat hydrantSign();
cv::Mat extinguisherLabel(std::uint64_t seed);
/// A plate with the text, or with a pictogram where there is none.
cv::Mat textSign(const std::string& text, double widthOverHeight, std::uint64_t seed);
cv::Mat pictogram(std::uint64_t seed);
cv::Mat stairsSign();
cv::Mat liftSign();
cv::Mat poster(const std::string& title, double widthOverHeight, std::uint64_t seed);
cv::Mat paintedPicture(double widthOverHeight, std::uint64_t seed);
cv::Mat noticeBoard(double widthOverHeight, std::uint64_t seed);
cv::Mat lockerDoors(double widthM, std::uint64_t seed);
cv::Mat vendingFront(std::uint64_t seed);
/// A window that leads nowhere: sky behind bars.
cv::Mat windowView(double widthOverHeight);
cv::Mat buttonPanel(std::uint64_t seed);

} // namespace farol::simulation
