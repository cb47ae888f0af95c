#pragma once
// One still picture from disk or memory, always as 8-bit BGR.

#include "core/base/error.h"

#include <opencv2/core.hpp>

#include <filesystem>
#include <string>

namespace farol::capture {

/// By the file name's end: jpg, jpeg, png, bmp, webp, tif, tiff in any case.
bool hasPictureName(const std::filesystem::path& path);

/// Grey, 16-bit and transparent pictures become 8-bit BGR; the camera's own rotation note is obeyed.
/// NotFound, Io, or Corrupt when the bytes are no picture.
Result<cv::Mat> readPicture(const std::filesystem::path& path);

/// `context` names the bytes in the error.
Result<cv::Mat> decodePicture(const std::string& bytes, const std::string& context);

} // namespace farol::capture
