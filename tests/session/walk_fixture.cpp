#include "tests/session/walk_fixture.h"

#include <opencv2/imgproc.hpp>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <sys/resource.h>
#include <thread>
#include <utility>

namespace farol::test {

void Gate::open() {
    {
        std::scoped_lock lock(m_mutex);
        m_open = true;
    }
    m_changed.notify_all();
}

void Gate::wait() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_open; });
}

std::optional<capture::Frame> ScriptedSource::next() {
    std::size_t index = m_next++;
    if (before) before(index);
    if (index >= m_frames || stopRequested()) return std::nullopt;
    capture::Frame frame;
    frame.index = index;
    frame.capturedAt = timeOf(index);
    frame.image = imageOf ? imageOf(index) : drawnFrame(index);
    frame.name = std::to_string(index) + ".png";
    frame.arrivedAt = std::chrono::steady_clock::now();
    return frame;
}

void ScriptedSource::say(capture::SourceEventKind kind, const std::string& message) {
    if (kind == capture::SourceEventKind::FrameSkipped) ++m_skipped;
    tell(kind, message);
}

void ScriptedSource::hang() const {
    while (!stopRequested()) std::this_thread::yield();
}

std::shared_ptr<const building::Building> threeRooms() {
    return asciiMap(R"(
        +---------+---------+---------+---+
        |         |         |         |   |
        | A   e   /  B   p  /  C   s  | D |
        |         |         |         |   |
        +---------+---------+---------+---+
    )",
                    {{'e', {Kind::Extinguisher, "", "extinguisher"}},
                     {'p', {Kind::Poster, "", "poster"}},
                     {'s', {Kind::Sign, "EXIT", "exit"}}});
}

cv::Mat drawnFrame(std::size_t index) {
    std::size_t room = index / 6;
    cv::Mat image(96, 128, CV_8UC3, cv::Scalar(40.0 + 60.0 * static_cast<double>(room % 3), 120, 200));
    int x = static_cast<int>(8 + 12 * (index % 6));
    cv::rectangle(image, cv::Rect(x, 30, 24, 40), cv::Scalar(20, 20, 180), cv::FILLED);
    return image;
}

recognition::Detection seen(Kind kind, const std::string& templateId, double x) {
    recognition::Detection detection;
    detection.kind = kind;
    detection.templateId = TemplateId(templateId);
    detection.quad = quadOf({x, 80.0, 60.0, 90.0});
    detection.image = {640, 480};
    detection.score = 0.9;
    return detection;
}

std::vector<session::Percept> walkThroughTheRooms() {
    std::vector<session::Percept> walk;
    for (std::size_t i = 0; i < 18; ++i) {
        session::Percept percept;
        percept.frame = i;
        percept.time = static_cast<double>(i) / 3.0;
        percept.name = std::to_string(i) + ".jpg";
        percept.size = {640, 480};
        percept.scene = static_cast<int>(i / 3);
        percept.sharpness = 20.0 + 1.0 / 3.0;
        double x = 100.0 + 7.1 * static_cast<double>(i % 3);
        if (i == 1 || i == 2) percept.detections.push_back(seen(Kind::Extinguisher, "extinguisher", x));
        if (i == 7 || i == 8) percept.detections.push_back(seen(Kind::Poster, "poster", x));
        if (i == 9) percept.detections.push_back(seen(Kind::Bin, "", 300.0));
        if (i == 13) {
            percept.detections.push_back(seen(Kind::Sign, "exit", x));
            percept.detections.back().text = "EXIT \"1\" \u00c7";
            percept.detections.back().rangeM = 2.0 / 3.0;
            percept.detections.back().bearing = Radians{-0.1};
        }
        if (i == 4)
            percept.rejections.push_back(
                {"landmarks", Kind::Poster, TemplateId("poster"), Quad{}, "few_inliers", 3.0});
        if (i == 5) percept.motion = {Radians{0.1 / 3.0}, 0.7, true, 1.8};
        walk.push_back(std::move(percept));
    }
    return walk;
}

void Lines::step(const session::NavigationStep& step) {
    for (std::string& line : session::linesOf(step, m_before ? &*m_before : nullptr))
        text.push_back(std::move(line));
    m_before = step.progress;
}

session::ReplayHandlers Lines::handlers() {
    session::ReplayHandlers handlers;
    handlers.step = [this](const session::NavigationStep& one) { step(one); };
    handlers.warning = [this](const guidance::Cue& cue) { warning(cue); };
    handlers.message = [this](double time, std::uint64_t frame, const std::string& words) {
        message(time, frame, words);
    };
    return handlers;
}

TemporaryFolder::TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "farol-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

SmallFilesOnly::SmallFilesOnly(unsigned long bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    m_before = limit.rlim_cur;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

SmallFilesOnly::~SmallFilesOnly() {
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = m_before;
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

} // namespace farol::test
