#pragma once
// A small building, percepts made by hand, and a source whose every step the test decides.

#include "core/capture/frame_source.h"
#include "core/session/json_lines.h"
#include "core/session/recorder.h"
#include "tests/support/ascii_map.h"

#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace farol::test {

/// Opens once, for all who wait.
class Gate {
public:
    void open();
    void wait();

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_open = false;
};

/// Frames 0, 1, 2... of a given number; before each, `before(index)` runs on the capture thread and may wait
/// on gates, or tell() something. `index == frames` is the call that answers the end.
class ScriptedSource final : public capture::FrameSource {
public:
    explicit ScriptedSource(std::size_t frames, bool live = false) : m_frames(frames), m_live(live) {}

    std::function<void(std::size_t)> before;
    std::function<double(std::size_t)> timeOf = [](std::size_t index) {
        return 0.5 * static_cast<double>(index);
    };
    std::function<cv::Mat(std::size_t)> imageOf;

    std::optional<capture::Frame> next() override;
    bool live() const override { return m_live; }
    std::string description() const override { return "a scripted source"; }
    std::uint64_t skippedFrames() const override { return m_skipped; }

    void say(capture::SourceEventKind kind, const std::string& message);
    /// Until requestStop(), as a camera that hangs does.
    void hang() const;

private:
    std::size_t m_frames;
    bool m_live;
    std::size_t m_next = 0;
    std::uint64_t m_skipped = 0;
};

/// Rooms A, B and C in a row, D apart from all; an extinguisher in A, a poster in B, a sign "EXIT" in C.
std::shared_ptr<const building::Building> threeRooms();
/// A drawn picture, different in each room.
cv::Mat drawnFrame(std::size_t index);
recognition::Detection seen(Kind kind, const std::string& templateId, double x = 100.0);
/// From room A to room C, two frames a second, with things nobody mapped and figures that do not end.
std::vector<session::Percept> walkThroughTheRooms();

/// What a program prints of a walk, in order.
class Lines {
public:
    void step(const session::NavigationStep& step);
    void warning(const guidance::Cue& cue) { text.push_back(session::cueLine(cue)); }
    void message(double time, std::uint64_t frame, const std::string& words) {
        text.push_back(session::warningLine(time, frame, words));
    }
    session::ReplayHandlers handlers();

    std::vector<std::string> text;

private:
    std::optional<guidance::Progress> m_before;
};

/// A folder of its own, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path path;
};

/// While it lives, no file of this process may grow beyond so many bytes: what a full disk looks like to a
/// writer.
class SmallFilesOnly {
public:
    explicit SmallFilesOnly(unsigned long bytes);
    ~SmallFilesOnly();
    SmallFilesOnly(const SmallFilesOnly&) = delete;
    SmallFilesOnly& operator=(const SmallFilesOnly&) = delete;

private:
    unsigned long m_before;
};

} // namespace farol::test
