#include "core/base/text.h"
#include "core/capture/picture.h"
#include "core/capture/sayings.h"
#include "core/capture/sources.h"

#include <algorithm>
#include <vector>

namespace farol::capture {

namespace fs = std::filesystem;

namespace {

class FolderSource final : public FrameSource {
public:
    FolderSource(fs::path folder, std::vector<fs::path> pictures, double framesPerSecond)
        : m_folder(std::move(folder)),
          m_pictures(std::move(pictures)),
          m_period(framesPerSecond > 0.0 ? 1.0 / framesPerSecond : 1.0) {}

    std::optional<Frame> next() override {
        while (m_position < m_pictures.size() && !stopRequested()) {
            std::size_t position = m_position++;
            const fs::path& path = m_pictures[position];
            auto image = readPicture(path);
            if (!image) {
                ++m_skipped;
                tell(SourceEventKind::FrameSkipped,
                     said(Saying::PictureSkipped, {path.filename().string() + " " + image.error().message,
                                                   std::to_string(m_skipped)}));
                continue;
            }
            Frame frame;
            frame.index = m_delivered++;
            // By its place in the folder: a picture that is missing leaves a gap in time, as a dropped frame
            // would.
            frame.capturedAt = static_cast<double>(position) * m_period;
            frame.image = std::move(*image);
            frame.name = path.filename().string();
            frame.arrivedAt = std::chrono::steady_clock::now();
            return frame;
        }
        return std::nullopt;
    }

    bool live() const override { return false; }
    std::optional<std::uint64_t> frameCount() const override { return m_pictures.size(); }
    double framePeriod() const override { return m_period; }
    std::uint64_t skippedFrames() const override { return m_skipped; }
    std::string description() const override {
        fs::path name = m_folder.filename().empty() ? m_folder.parent_path().filename() : m_folder.filename();
        return (name.empty() ? m_folder : name).string() + " (" + std::to_string(m_pictures.size()) +
               (m_pictures.size() == 1 ? " picture)" : " pictures)");
    }

private:
    fs::path m_folder;
    std::vector<fs::path> m_pictures;
    double m_period;
    std::size_t m_position = 0;
    std::uint64_t m_delivered = 0;
    std::uint64_t m_skipped = 0;
};

} // namespace

Result<std::unique_ptr<FrameSource>> openPictures(const fs::path& path, const SourceOptions& options) {
    std::error_code failure;
    std::vector<fs::path> pictures;
    if (!fs::is_directory(path, failure)) {
        pictures.push_back(path);
        return std::unique_ptr<FrameSource>(
            std::make_unique<FolderSource>(path, std::move(pictures), options.framesPerSecond));
    }
    fs::directory_iterator entries(path, failure);
    if (failure)
        return Error{ErrorCode::Io, said(Saying::FolderNotRead) + ": " + failure.message(), path.string()};
    for (; !failure && entries != fs::directory_iterator(); entries.increment(failure)) {
        std::error_code ignored;
        if (hasPictureName(entries->path()) && !entries->is_directory(ignored))
            pictures.push_back(entries->path());
    }
    if (failure)
        return Error{ErrorCode::Io, said(Saying::FolderNotRead) + ": " + failure.message(), path.string()};
    if (pictures.empty()) return Error{ErrorCode::NotFound, said(Saying::FolderEmpty), path.string()};
    std::sort(pictures.begin(), pictures.end(), [](const fs::path& a, const fs::path& b) {
        return naturalLess(a.filename().string(), b.filename().string());
    });
    return std::unique_ptr<FrameSource>(
        std::make_unique<FolderSource>(path, std::move(pictures), options.framesPerSecond));
}

} // namespace farol::capture
