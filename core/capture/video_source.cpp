#include "core/base/text.h"
#include "core/capture/sayings.h"
#include "core/capture/sources.h"

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdlib.h> // NOLINT: setenv is POSIX
#include <thread>

namespace farol::capture {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;
using Opener = std::function<bool(cv::VideoCapture&)>;

/// OpenCV throws for some damaged files and missing devices; here that is the same as "did not open".
bool tryOpen(const Opener& opener, cv::VideoCapture& capture) {
    try {
        return opener(capture) && capture.isOpened();
    } catch (const std::exception&) {
        return false;
    }
}

double property(const cv::VideoCapture& capture, int id) {
    try {
        double value = capture.get(id);
        return std::isfinite(value) ? value : 0.0;
    } catch (const std::exception&) {
        return 0.0;
    }
}

/// A new matrix each time: frames are shared with other threads, so the capture's buffer must not be written
/// again.
cv::Mat readFrame(cv::VideoCapture& capture) {
    try {
        cv::Mat image;
        if (!capture.read(image) || image.empty()) return {};
        if (image.depth() == CV_16U) image.convertTo(image, CV_8U, 1.0 / 257.0);
        if (image.depth() != CV_8U) return {};
        if (image.channels() == 1) cv::cvtColor(image, image, cv::COLOR_GRAY2BGR);
        if (image.channels() == 4) cv::cvtColor(image, image, cv::COLOR_BGRA2BGR);
        return image.channels() == 3 ? image : cv::Mat();
    } catch (const std::exception&) {
        return {};
    }
}

class VideoFileSource final : public FrameSource {
public:
    VideoFileSource(std::string name, cv::VideoCapture capture, double framesPerSecond)
        : m_name(std::move(name)), m_capture(std::move(capture)), m_ownClock(framesPerSecond <= 0.0) {
        double fps = m_ownClock ? property(m_capture, cv::CAP_PROP_FPS) : framesPerSecond;
        m_period = fps > 0.0 && fps <= 1000.0 ? 1.0 / fps : 1.0 / 25.0;
        double count = property(m_capture, cv::CAP_PROP_FRAME_COUNT);
        if (count >= 1.0 && count < 1e12) m_count = static_cast<std::uint64_t>(count);
    }

    std::optional<Frame> next() override {
        if (stopRequested() || m_ended) return std::nullopt;
        cv::Mat image = readFrame(m_capture);
        if (image.empty()) {
            m_ended = true;
            return std::nullopt;
        }
        Frame frame;
        frame.index = m_delivered++;
        frame.capturedAt = timeOfFrame(frame.index);
        frame.image = std::move(image);
        frame.arrivedAt = Clock::now();
        return frame;
    }

    bool live() const override { return false; }
    std::optional<std::uint64_t> frameCount() const override { return m_count; }
    double framePeriod() const override { return m_period; }
    std::string description() const override {
        return m_name + (m_count ? " (video, " + std::to_string(*m_count) + " frames)" : " (video)");
    }

private:
    /// Phones record with an uneven rate, so the file's own times are kept as long as they advance.
    double timeOfFrame(std::uint64_t index) {
        double even = static_cast<double>(index) * m_period;
        if (!m_ownClock) return even;
        double own = property(m_capture, cv::CAP_PROP_POS_MSEC) / 1000.0;
        if (index == 0) m_first = own;
        double time = own - m_first;
        if (index > 0 && (time <= m_last || time > m_last + 3600.0)) time = m_last + m_period;
        m_last = index == 0 ? 0.0 : time;
        return m_last;
    }

    std::string m_name;
    cv::VideoCapture m_capture;
    bool m_ownClock;
    double m_period = 0.04;
    std::optional<std::uint64_t> m_count;
    std::uint64_t m_delivered = 0;
    double m_first = 0.0, m_last = 0.0;
    bool m_ended = false;
};

/// A camera or a stream: its clock is ours, and it is tried again when it is lost.
class LiveSource final : public FrameSource {
public:
    LiveSource(std::string name, cv::VideoCapture capture, Opener opener, SourceOptions options)
        : m_name(std::move(name)),
          m_capture(std::move(capture)),
          m_opener(std::move(opener)),
          m_options(options),
          m_start(Clock::now()) {
        double fps = property(m_capture, cv::CAP_PROP_FPS);
        // Streams report their time base (90000 or so) where they know no rate.
        m_period = fps > 0.0 && fps <= 240.0 ? 1.0 / fps : 0.0;
    }

    std::optional<Frame> next() override {
        while (!stopRequested()) {
            cv::Mat image = readFrame(m_capture);
            if (stopRequested()) break;
            if (!image.empty()) {
                Frame frame;
                frame.index = m_delivered++;
                frame.arrivedAt = Clock::now();
                frame.capturedAt = std::chrono::duration<double>(frame.arrivedAt - m_start).count();
                frame.image = std::move(image);
                return frame;
            }
            if (!reconnect()) break;
        }
        return std::nullopt;
    }

    bool live() const override { return true; }
    double framePeriod() const override { return m_period; }
    std::string description() const override { return m_name; }

private:
    bool reconnect() {
        tell(SourceEventKind::ConnectionLost, said(Saying::StreamLost, {m_name}));
        m_capture.release();
        long long pause = m_options.reconnectDelayMs;
        for (int attempt = 1; m_options.reconnectAttempts < 0 || attempt <= m_options.reconnectAttempts;
             ++attempt) {
            if (!pauseFor(std::chrono::milliseconds(pause))) return false;
            tell(SourceEventKind::Reconnecting, said(Saying::StreamTried, {m_name, std::to_string(attempt)}));
            if (tryOpen(m_opener, m_capture)) {
                tell(SourceEventKind::Reconnected, said(Saying::StreamBack, {m_name}));
                return true;
            }
            if (attempt < 4) pause *= 2; // up to eight times the first pause
        }
        return false;
    }

    /// False as soon as a stop is asked for: nobody waits for the end of a long pause.
    bool pauseFor(std::chrono::milliseconds pause) const {
        auto end = Clock::now() + pause;
        while (!stopRequested()) {
            auto left = end - Clock::now();
            if (left <= Clock::duration::zero()) return true;
            std::this_thread::sleep_for(std::min<Clock::duration>(left, std::chrono::milliseconds(20)));
        }
        return false;
    }

    std::string m_name;
    cv::VideoCapture m_capture;
    Opener m_opener;
    SourceOptions m_options;
    Clock::time_point m_start;
    double m_period = 0.0;
    std::uint64_t m_delivered = 0;
};

/// A camera's password stands in its address; it is nothing for logs and screens.
std::string withoutPassword(const std::string& address) {
    std::size_t host = address.find("://");
    if (host == std::string::npos) return address;
    host += 3;
    std::size_t at = address.substr(0, address.find('/', host)).rfind('@');
    return at == std::string::npos || at < host ? address : address.substr(0, host) + address.substr(at + 1);
}

/// What went wrong stands in our own errors and events; OpenCV and FFmpeg would print it to stderr besides.
void quietOpenCv() {
    static std::once_flag once;
    std::call_once(once, [] {
        cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
        ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0); // OpenCV reads FFmpeg's level only from here
    });
}

} // namespace

Result<std::unique_ptr<FrameSource>> openVideoFile(const fs::path& path, const SourceOptions& options) {
    quietOpenCv();
    std::string file = path.string();
    cv::VideoCapture capture;
    bool opened = tryOpen([&](cv::VideoCapture& c) { return c.open(file, cv::CAP_FFMPEG); }, capture) ||
                  tryOpen([&](cv::VideoCapture& c) { return c.open(file, cv::CAP_GSTREAMER); }, capture);
    if (!opened) return Error{ErrorCode::UnsupportedFormat, said(Saying::NoVideo), file};
    return std::unique_ptr<FrameSource>(std::make_unique<VideoFileSource>(
        path.filename().string(), std::move(capture), options.framesPerSecond));
}

Result<std::unique_ptr<FrameSource>> openAddress(const std::string& address, const SourceOptions& options) {
    quietOpenCv();
    // Without these a silent server blocks a read for 30 s; they only count when passed to open() itself.
    std::vector<int> timeouts{cv::CAP_PROP_OPEN_TIMEOUT_MSEC, options.openTimeoutMs,
                              cv::CAP_PROP_READ_TIMEOUT_MSEC, options.readTimeoutMs};
    Opener opener = [address, timeouts](cv::VideoCapture& c) {
        return c.open(address, cv::CAP_FFMPEG, timeouts);
    };
    cv::VideoCapture capture;
    if (!tryOpen(opener, capture))
        return Error{ErrorCode::Unavailable,
                     said(Saying::AddressSilent, {formatNumber(options.openTimeoutMs / 1000.0)}),
                     withoutPassword(address)};
    // A recorded video behind an address knows its length, and its end is an end; a stream has none.
    double count = property(capture, cv::CAP_PROP_FRAME_COUNT);
    if (count >= 1.0)
        return std::unique_ptr<FrameSource>(std::make_unique<VideoFileSource>(
            withoutPassword(address), std::move(capture), options.framesPerSecond));
    return std::unique_ptr<FrameSource>(std::make_unique<LiveSource>(
        withoutPassword(address), std::move(capture), std::move(opener), options));
}

Result<std::unique_ptr<FrameSource>> openCamera(const std::string& device, const SourceOptions& options) {
    quietOpenCv();
    bool number = !device.empty() && device.size() <= 3 &&
                  std::all_of(device.begin(), device.end(), [](char c) { return c >= '0' && c <= '9'; });
    bool path = !device.empty() && device.front() == '/';
    if (!number && !path)
        return Error{ErrorCode::InvalidArgument, said(Saying::CameraUnnamed), "camera:" + device};
    std::string file = number ? "/dev/video" + device : device;
    Error missing{ErrorCode::Unavailable, said(Saying::CameraNotOpened, {file}), "camera:" + device};
    std::error_code failure;
    if (!fs::exists(file, failure)) return missing;
    Opener opener = [file](cv::VideoCapture& c) { return c.open(file, cv::CAP_V4L2); };
    cv::VideoCapture capture;
    if (!tryOpen(opener, capture)) return missing;
    return std::unique_ptr<FrameSource>(
        std::make_unique<LiveSource>("camera:" + device, std::move(capture), std::move(opener), options));
}

} // namespace farol::capture
