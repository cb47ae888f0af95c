#pragma once
// The concrete sources behind openSource(). Only this folder includes it.

#include "core/capture/frame_source.h"

#include <filesystem>

namespace farol::capture {

/// A folder of pictures in natural order, or one picture.
Result<std::unique_ptr<FrameSource>> openPictures(const std::filesystem::path& path,
                                                  const SourceOptions& options);
Result<std::unique_ptr<FrameSource>> openVideoFile(const std::filesystem::path& path,
                                                   const SourceOptions& options);
Result<std::unique_ptr<FrameSource>> openAddress(const std::string& address, const SourceOptions& options);
/// `device`: a number, or a path such as /dev/video0.
Result<std::unique_ptr<FrameSource>> openCamera(const std::string& device, const SourceOptions& options);

} // namespace farol::capture
