#pragma once
// The pictures a classifier is trained on, with the boxes of what is to be found. Of every set only the
// development half is read (by the file name's hash, as `farol-cli evaluate` splits them) and of the corridor
// walk the first lap.

#include "core/base/error.h"
#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace farol::training {

struct TrainingPicture {
    std::string set;
    std::filesystem::path file; ///< empty for a drawn one
    std::vector<ImageBox> boxes;
    double weight = 1.0;
};

bool inDevelopmentHalf(const std::string& fileName);

/// Doors: office_like, indoor_home and no_door pictures, the corridor's first lap (boxes in
/// corridor_doors.csv), stairs.
Result<std::vector<TrainingPicture>> doorPictures(const std::filesystem::path& data,
                                                  const std::filesystem::path& here);

/// A slightly turned, moved, scaled, lighter or darker, blurred picture with its boxes; the picture itself
/// for 0.
cv::Mat varied(const cv::Mat& picture, int variant, std::vector<ImageBox>& boxes, cv::RNG& random);

} // namespace farol::training
