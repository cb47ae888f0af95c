#pragma once
// Frames and where they come from: camera, video file, folder of pictures, network address.

#include "core/base/error.h"
#include "core/base/geometry.h"

#include <opencv2/core.hpp>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace farol::capture {

/// One picture with its time. `image` is 8-bit BGR and shared: nobody writes into it.
struct Frame {
    std::uint64_t index = 0; ///< counts every frame the source delivered, from 0
    double capturedAt = 0.0; ///< seconds since the source's start, by the source's own clock
    cv::Mat image;
    std::string name; ///< file name in a folder; empty otherwise
    /// When it entered the program, only to measure its age; core never decides by it.
    std::chrono::steady_clock::time_point arrivedAt;

    ImageSize size() const { return {image.cols, image.rows}; }
};

enum class SourceEventKind { FrameSkipped, ConnectionLost, Reconnecting, Reconnected };

struct SourceEvent {
    SourceEventKind kind = SourceEventKind::FrameSkipped;
    std::string message; ///< "7.jpg cannot be read as a picture; skipped (1 so far)"
};

struct SourceOptions {
    double framesPerSecond =
        0.0; ///< time between pictures of a folder; 0: 1 a second for folders, the file's own for videos
    int openTimeoutMs = 5000;
    int readTimeoutMs = 5000;
    int reconnectDelayMs = 1000; ///< first pause before a lost camera is tried again; doubles up to 8 times
    int reconnectAttempts = -1;  ///< -1: for ever

    Result<void> check() const;
};

/// Blocking reader, used from one thread; requestStop() may come from any. A source never throws.
class FrameSource {
public:
    virtual ~FrameSource() = default;

    /// The next frame; empty at the end of the material, or after requestStop(). A picture that cannot be
    /// read is skipped, counted and told by an event; a lost camera or address is told and tried again.
    virtual std::optional<Frame> next() = 0;
    /// A camera or stream goes on without us, so late frames are dropped; files wait.
    virtual bool live() const = 0;
    /// Waits for those who look, and keeps to a pace of its own (a simulation): nothing is dropped.
    virtual bool keepsPace() const { return false; }
    /// The pace of such a source, 1 as in life. From any thread.
    virtual void setSpeed(double) {}
    /// Frames in all, where that is known beforehand.
    virtual std::optional<std::uint64_t> frameCount() const { return std::nullopt; }
    /// Seconds between frames in the nominal case (for paced playing); 0 when unknown.
    virtual double framePeriod() const { return 0.0; }
    /// For people: "corridor_walk (40 pictures)".
    virtual std::string description() const = 0;
    virtual std::uint64_t skippedFrames() const { return 0; }

    void onEvent(std::function<void(const SourceEvent&)> handler) { m_handler = std::move(handler); }
    virtual void requestStop() { m_stop = true; }
    bool stopRequested() const { return m_stop; }

protected:
    void tell(SourceEventKind kind, std::string message) const {
        if (m_handler) m_handler({kind, std::move(message)});
    }

private:
    std::function<void(const SourceEvent&)> m_handler;
    std::atomic<bool> m_stop{false};
};

/// SOURCE of the command line: "camera:0", a video file, a folder of pictures (natural order), an http(s) or
/// rtsp address. The error names the source and says what was tried.
Result<std::unique_ptr<FrameSource>> openSource(const std::string& source, const SourceOptions& options = {});

} // namespace farol::capture
