#pragma once
// Pictures with known truth: posters drawn from a seed, hung by a known homography into a drawn room.

#include "core/base/geometry.h"
#include "core/recognition/training.h"

#include <opencv2/core.hpp>

#include <cstdint>
#include <string>

namespace farol::recognition::test {

/// 400 x 300, full of shapes that differ from seed to seed.
cv::Mat poster(std::uint64_t seed);
/// A wall with weak texture and a few edges.
cv::Mat room(std::uint64_t seed, cv::Size size = {640, 480});
/// The poster on the wall, its corners at the quad (clockwise from the top left).
void hang(cv::Mat& picture, const cv::Mat& poster, const Quad& quad);
/// As a camera's file.
std::string jpeg(const cv::Mat& picture, int quality = 92);
std::string png(const cv::Mat& picture);
/// Intersection over union of two convex quads.
double sharedArea(const Quad& a, const Quad& b);
/// Trains the poster of the seed, photographed squarely, as "poster-<seed>".
void trainPoster(LandmarkLibrary& library, std::uint64_t seed, Kind kind = Kind::Poster);

} // namespace farol::recognition::test
