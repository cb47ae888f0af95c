#include "core/session/recorder.h"

#include "core/base/base_sayings.h"
#include "core/base/file.h"
#include "core/building/geopackage.h"
#include "core/session/recording_json.h"
#include "core/session/sayings.h"

#include <opencv2/imgcodecs.hpp>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace farol::session {

namespace fs = std::filesystem;

namespace {

Result<void> writeAll(int descriptor, const char* bytes, std::size_t count, const std::string& context) {
    while (count > 0) {
        ssize_t written = ::write(descriptor, bytes, count);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0)
            return systemError(written < 0 ? errno : EIO, said(BaseSaying::NotWritten), context);
        bytes += written;
        count -= static_cast<std::size_t>(written);
    }
    return {};
}

Result<void> writeWhole(const fs::path& path, const char* bytes, std::size_t count) {
    int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) return systemError(errno, said(Saying::NotCreated), path.string());
    auto written = writeAll(descriptor, bytes, count, path.string());
    if (::close(descriptor) != 0 && written)
        return systemError(errno, said(BaseSaying::NotWritten), path.string());
    return written;
}

Result<void> prepareFolder(const fs::path& folder) {
    std::error_code failure;
    if (fs::exists(folder, failure) && !fs::is_directory(folder, failure))
        return Error{ErrorCode::Conflict, said(Saying::FolderIsFile), folder.string()};
    if (fs::is_directory(folder, failure) && !fs::is_empty(folder, failure) && !failure)
        return Error{ErrorCode::Conflict, said(Saying::FolderNotEmpty), folder.string()};
    fs::create_directories(folder / "frames", failure);
    if (failure) return systemError(failure.value(), said(Saying::RecordingNotCreated), folder.string());
    return {};
}

std::string pictureName(std::uint64_t frame) {
    std::string digits = std::to_string(frame);
    std::string zeros(digits.size() < 6 ? 6 - digits.size() : 0, '0');
    return "frames/" + zeros + digits + ".jpg";
}

} // namespace

Recorder::Recorder(fs::path folder, int walk) : m_folder(std::move(folder)), m_walk(walk) {}

Recorder::~Recorder() {
    ::close(m_walk);
}

Result<std::unique_ptr<Recorder>> Recorder::create(const fs::path& folder, const RecordingHeader& header,
                                                   const building::Building& building) {
    if (auto prepared = prepareFolder(folder); !prepared) return prepared.error();
    if (auto saved = building::saveBuilding(building, (folder / "map.gpkg").string()); !saved)
        return saved.error();
    std::string text = headerJson(header).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (auto written = writeWhole(folder / "recording.json", text.data(), text.size()); !written)
        return written.error();
    fs::path path = folder / "walk.jsonl";
    int walk = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
    if (walk < 0) return systemError(errno, said(Saying::NotCreated), path.string());
    return std::unique_ptr<Recorder>(new Recorder(folder, walk));
}

Result<void> Recorder::giveUp(Error error) {
    m_failed = true;
    return error;
}

Result<void> Recorder::writeLine(const std::string& line) {
    std::string whole = line + "\n";
    if (auto written = writeAll(m_walk, whole.data(), whole.size(), (m_folder / "walk.jsonl").string());
        !written)
        return giveUp(written.error());
    return {};
}

Result<void> Recorder::writePicture(const std::string& name, const cv::Mat& image) {
    std::vector<unsigned char> bytes;
    fs::path path = m_folder / name;
    try {
        if (!cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, 90}))
            return giveUp({ErrorCode::Internal, said(Saying::PictureNotEncoded), path.string()});
    } catch (const cv::Exception& exception) {
        return giveUp(
            {ErrorCode::Internal, said(Saying::PictureNotEncoded) + ": " + exception.what(), path.string()});
    }
    auto written = writeWhole(path, reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!written) {
        std::error_code ignored;
        fs::remove(path, ignored); // half a picture helps nobody
        return giveUp(written.error());
    }
    return {};
}

Result<void> Recorder::write(const Percept& percept, const cv::Mat& image) {
    if (m_failed) return {};
    std::string picture = image.empty() ? std::string() : pictureName(percept.frame);
    if (!picture.empty())
        if (auto written = writePicture(picture, image); !written) return written;
    return writeLine(dumped(perceptLineJson(percept, picture)));
}

Result<void> Recorder::write(const Command& command) {
    if (m_failed) return {};
    return writeLine(dumped(commandJson(command)));
}

} // namespace farol::session
