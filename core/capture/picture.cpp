#include "core/capture/picture.h"

#include "core/base/file.h"
#include "core/capture/sayings.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>

namespace farol::capture {

bool hasPictureName(const std::filesystem::path& path) {
    static constexpr std::array<std::string_view, 7> kEnds{".jpg",  ".jpeg", ".png", ".bmp",
                                                           ".webp", ".tif",  ".tiff"};
    std::string end = path.extension().string();
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(kEnds.begin(), kEnds.end(), end) != kEnds.end();
}

Result<cv::Mat> decodePicture(const std::string& bytes, const std::string& context) {
    Error damaged{ErrorCode::Corrupt, said(Saying::NoPicture), context};
    if (bytes.empty() || bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        return damaged;
    try {
        // imdecode only reads, but its matrix header wants a mutable pointer.
        cv::Mat buffer(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
        cv::Mat image = cv::imdecode(buffer, cv::IMREAD_COLOR);
        if (image.empty()) return damaged;
        return image;
    } catch (const std::exception& problem) {
        damaged.message += std::string(" (") + problem.what() + ")";
        return damaged;
    }
}

Result<cv::Mat> readPicture(const std::filesystem::path& path) {
    auto bytes = readFile(path);
    if (!bytes) return bytes.error();
    return decodePicture(*bytes, path.string());
}

} // namespace farol::capture
