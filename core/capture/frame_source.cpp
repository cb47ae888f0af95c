#include "core/capture/frame_source.h"

#include "core/capture/picture.h"
#include "core/capture/sayings.h"
#include "core/capture/sources.h"

#include <cmath>
#include <filesystem>

namespace farol::capture {

namespace fs = std::filesystem;

Result<void> SourceOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    if (!std::isfinite(framesPerSecond) || framesPerSecond < 0.0 || framesPerSecond > 1000.0)
        return wrong("frames per second must be between 0 (the source's own) and 1000", "framesPerSecond");
    if (openTimeoutMs <= 0) return wrong("the time to wait for a source must be positive", "openTimeoutMs");
    if (readTimeoutMs <= 0) return wrong("the time to wait for a frame must be positive", "readTimeoutMs");
    if (reconnectDelayMs <= 0)
        return wrong("the pause before a new try must be positive", "reconnectDelayMs");
    if (reconnectAttempts < -1)
        return wrong("the number of tries must be -1 (for ever) or more", "reconnectAttempts");
    return {};
}

namespace {

bool startsWith(const std::string& text, const std::string& start) {
    return text.rfind(start, 0) == 0;
}

bool isAddress(const std::string& source) {
    for (const char* scheme : {"http://", "https://", "rtsp://", "rtsps://", "rtmp://", "udp://", "tcp://"})
        if (startsWith(source, scheme)) return true;
    return false;
}

} // namespace

Result<std::unique_ptr<FrameSource>> openSource(const std::string& source, const SourceOptions& options) {
    if (auto checked = options.check(); !checked) return checked.error();
    if (source.empty()) return Error{ErrorCode::InvalidArgument, said(Saying::SourceUnnamed), "source"};
    if (startsWith(source, "camera:")) return openCamera(source.substr(7), options);
    if (isAddress(source)) return openAddress(source, options);
    std::error_code failure;
    fs::file_status status = fs::status(source, failure);
    if (!fs::exists(status)) return Error{ErrorCode::NotFound, said(Saying::SourceMissing), source};
    if (fs::is_directory(status) || hasPictureName(source)) return openPictures(source, options);
    return openVideoFile(source, options);
}

} // namespace farol::capture
