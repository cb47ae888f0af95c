#include "tests/bench/walk_bench.h"

#include "core/building/geopackage.h"
#include "core/session/map_words.h"
#include "core/session/navigation_session.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace farol::bench {

namespace {

constexpr int kWantedFrames = 300;
constexpr double kTooOldMs = 200.0;

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The same material over and over, as one long walk.
class LoopedSource final : public capture::FrameSource {
public:
    LoopedSource(std::string source, const capture::SourceOptions& options, int laps)
        : m_source(std::move(source)), m_options(options), m_laps(laps) {}

    std::optional<capture::Frame> next() override {
        while (!stopRequested()) {
            if (!m_inner) {
                if (m_lap == m_laps) return std::nullopt;
                auto opened = capture::openSource(m_source, m_options);
                if (!opened) return std::nullopt;
                m_inner = std::move(opened).value();
                ++m_lap;
            }
            auto frame = m_inner->next();
            if (frame) {
                frame->index = m_index++;
                frame->capturedAt += m_offset;
                m_last = frame->capturedAt;
                return frame;
            }
            m_offset = m_last + (m_inner->framePeriod() > 0.0 ? m_inner->framePeriod() : 1.0);
            m_inner.reset();
        }
        return std::nullopt;
    }

    bool live() const override { return false; }
    std::string description() const override { return m_source; }

private:
    std::string m_source;
    capture::SourceOptions m_options;
    int m_laps;
    int m_lap = 0;
    std::unique_ptr<capture::FrameSource> m_inner;
    std::uint64_t m_index = 0;
    double m_offset = 0.0, m_last = 0.0;
};

/// Nearest rank, so that a figure is one that was measured.
double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
    return values[std::min(values.size() - 1, rank > 0 ? rank - 1 : 0)];
}

struct Material {
    std::shared_ptr<const building::Building> building;
    std::shared_ptr<const recognition::LandmarkLibrary> library;
    capture::SourceOptions source;
    int laps = 1;
};

Result<Material> openMaterial(const WalkBenchOptions& options) {
    Material material;
    auto map = building::loadBuilding(options.map);
    if (!map) return map.error();
    material.building = map->building;
    auto library = recognition::loadLibrary(options.library);
    if (!library) return library.error();
    material.library = std::make_shared<const recognition::LandmarkLibrary>(std::move(library).value());
    material.source.framesPerSecond = options.framesPerSecond;
    auto source = capture::openSource(options.frames, material.source);
    if (!source) return source.error();
    auto count = (*source)->frameCount().value_or(kWantedFrames);
    material.laps =
        options.laps > 0
            ? options.laps
            : std::max(1, static_cast<int>(std::ceil(kWantedFrames / std::max(1.0, double(count)))));
    return material;
}

struct Hop {
    const char* name;
    std::vector<double> ms;
};

void printHops(const std::vector<Hop>& hops) {
    std::printf("| hop | median ms | 95th percentile ms | frames |\n|---|---:|---:|---:|\n");
    for (const Hop& hop : hops)
        std::printf("| %s | %.2f | %.2f | %zu |\n", hop.name, percentile(hop.ms, 0.5),
                    percentile(hop.ms, 0.95), hop.ms.size());
}

/// Hop after hop on one thread; nothing waits, nothing is dropped.
int benchHops(const WalkBenchOptions& options, const Material& material) {
    std::vector<std::string> warnings;
    session::PerceptionOptions seeing;
    seeing.textReader.words = session::wordsOf(*material.building);
    session::Perception perception(material.library, seeing, warnings);
    for (const std::string& warning : warnings)
        std::fprintf(stderr, "farol-bench: warning: %s\n", warning.c_str());
    auto navigator = session::Navigator::create(material.building);
    if (!navigator) {
        std::fprintf(stderr, "farol-bench: %s\n", navigator.error().text().c_str());
        return 1;
    }
    LoopedSource source(options.frames, material.source, material.laps);
    std::clock_t processorStart = std::clock();
    std::vector<Hop> hops{{"1 read the picture", {}},
                          {"3 scene and sharpness", {}},
                          {"2 turn and pace", {}},
                          {"2 following", {}},
                          {"2 trained landmarks, in frames that are looked at", {}},
                          {"2 doors and stairs, in frames that are looked at", {}},
                          {"2 boards, in frames that are read", {}},
                          {"2 text, in frames that are read", {}},
                          {"3 to 6 history, vote, route, cues", {}},
                          {"2 to 6 together", {}}};
    for (;;) {
        auto start = std::chrono::steady_clock::now();
        auto frame = source.next();
        if (!frame) break;
        double readMs = millisecondsSince(start);
        start = std::chrono::steady_clock::now();
        session::HopTimes times;
        session::Percept percept = perception.look(*frame, &times);
        auto navigating = std::chrono::steady_clock::now();
        (void)(*navigator)->advance(std::move(percept));
        times.navigateMs = millisecondsSince(navigating);
        hops[0].ms.push_back(readMs);
        hops[1].ms.push_back(times.sceneMs);
        hops[2].ms.push_back(times.motionMs);
        hops[3].ms.push_back(times.tracksMs);
        if (times.landmarksMs > 0.0) hops[4].ms.push_back(times.landmarksMs);
        if (times.doorsMs > 0.0) hops[5].ms.push_back(times.doorsMs);
        if (times.textMs > 0.0) {
            hops[6].ms.push_back(times.rectanglesMs);
            hops[7].ms.push_back(times.textMs);
        }
        hops[8].ms.push_back(times.navigateMs);
        hops[9].ms.push_back(millisecondsSince(start));
    }
    std::printf("Milliseconds a frame, one thread, %zu pictures of `%s`, %d time(s):\n\n", hops[0].ms.size(),
                options.frames.c_str(), material.laps);
    printHops(hops);
    double processorMs = 1000.0 * static_cast<double>(std::clock() - processorStart) / CLOCKS_PER_SEC;
    if (!hops[0].ms.empty())
        std::printf("\nProcessor time of all threads, reading included: %.1f ms a frame on average.\n",
                    processorMs / static_cast<double>(hops[0].ms.size()));
    return hops[0].ms.empty() ? 1 : 0;
}

/// The wall time of one call.
struct Timed {
    std::vector<double> ms;
    void print(const char* name) const {
        std::printf("| %s | %.2f | %.2f | %.2f | %.2f |\n", name, percentile(ms, 0.5), percentile(ms, 0.95),
                    percentile(ms, 0.99), percentile(ms, 1.0));
    }
};

/// Measures how long reading a frame takes.
class TimedSource final : public capture::FrameSource {
public:
    TimedSource(std::unique_ptr<capture::FrameSource> inner, Timed& reading)
        : m_inner(std::move(inner)), m_reading(reading) {}

    std::optional<capture::Frame> next() override {
        if (stopRequested()) return std::nullopt;
        auto start = std::chrono::steady_clock::now();
        auto frame = m_inner->next();
        if (frame) m_reading.ms.push_back(millisecondsSince(start));
        return frame;
    }
    bool live() const override { return m_inner->live(); }
    std::string description() const override { return m_inner->description(); }

private:
    std::unique_ptr<capture::FrameSource> m_inner;
    Timed& m_reading;
};

/// Of the thread that asks, in milliseconds: what the machine does besides does not count.
double threadProcessorMs() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Pace {
    Timed reading, loop, loopProcessor, ages, landmarkAges;
    double threadMs = 0.0; ///< of the session's thread so far
    std::vector<double> trackCounts;
    std::uint64_t dropped = 0;
    double wallMs = 0.0, processorMs = 0.0;
};

void printPace(const WalkBenchOptions& options, const Pace& pace) {
    auto walked = static_cast<double>(pace.ages.ms.size());
    double all = walked + static_cast<double>(pace.dropped);
    auto third = static_cast<std::ptrdiff_t>(pace.ages.ms.size() / 3);
    std::vector<double> early(pace.ages.ms.begin(), pace.ages.ms.begin() + third);
    std::vector<double> late(pace.ages.ms.end() - third, pace.ages.ms.end());
    auto old =
        std::count_if(pace.ages.ms.begin(), pace.ages.ms.end(), [](double age) { return age > kTooOldMs; });
    std::printf(
        "\nThe whole session at %.0f frames a second, slow looks on threads: %.0f frames, %llu dropped "
        "(%.1f %%), %lld older than %.0f ms.\nMedian age in the first third %.1f ms, in the last "
        "third %.1f ms; %.2f cores in use; %.1f things followed on average; %zu looks for "
        "landmarks.\n\n",
        options.framesPerSecond, all, static_cast<unsigned long long>(pace.dropped),
        all > 0.0 ? 100.0 * static_cast<double>(pace.dropped) / all : 0.0, static_cast<long long>(old),
        kTooOldMs, percentile(early, 0.5), percentile(late, 0.5),
        pace.wallMs > 0.0 ? pace.processorMs / pace.wallMs : 0.0,
        std::accumulate(pace.trackCounts.begin(), pace.trackCounts.end(), 0.0) / std::max(1.0, walked),
        pace.landmarkAges.ms.size());
    std::printf("| ms | median | 95th percentile | 99th | most |\n|---|---:|---:|---:|---:|\n");
    pace.reading.print("reading a frame");
    pace.loop.print("loop that carries a frame through the chain");
    pace.loopProcessor.print("the same, processor time of its thread");
    pace.ages.print("age of a frame at the end of the chain");
    pace.landmarkAges.print("age of what was looked for landmarks");
}

/// As in use: frames at their own pace, slow looks on threads, what nobody could take is dropped.
int benchPace(const WalkBenchOptions& options, const Material& material) {
    Pace pace;
    session::SessionHandlers handlers;
    handlers.step = [&](const session::NavigationStep& step, const session::HopTimes& times) {
        pace.ages.ms.push_back(times.ageMs);
        pace.loop.ms.push_back(times.loopMs);
        double now = threadProcessorMs();
        if (pace.ages.ms.size() > 1) pace.loopProcessor.ms.push_back(now - pace.threadMs);
        pace.threadMs = now;
        pace.trackCounts.push_back(static_cast<double>(step.percept.tracks.size()));
        if (times.landmarkAgeMs) pace.landmarkAges.ms.push_back(*times.landmarkAgeMs);
    };
    session::SessionOptions sessionOptions;
    sessionOptions.pace = session::Pace::RealTime;
    if (!options.localiser.empty()) sessionOptions.navigator.localiser = options.localiser;
    if (!options.record.empty()) sessionOptions.recordFolder = options.record;
    auto looped = std::make_unique<LoopedSource>(options.frames, material.source, material.laps);
    auto session = session::NavigationSession::create(
        material.building, material.library, std::make_unique<TimedSource>(std::move(looped), pace.reading),
        sessionOptions, std::move(handlers));
    if (!session) {
        std::fprintf(stderr, "farol-bench: %s\n", session.error().text().c_str());
        return 1;
    }
    auto start = std::chrono::steady_clock::now();
    std::clock_t processorStart = std::clock();
    (*session)->start();
    (*session)->wait();
    pace.wallMs = millisecondsSince(start);
    pace.processorMs = 1000.0 * static_cast<double>(std::clock() - processorStart) / CLOCKS_PER_SEC;
    (*session)->stop();
    auto last = (*session)->snapshot();
    pace.dropped = last ? last->framesDropped : 0;
    printPace(options, pace);
    return 0;
}

} // namespace

int benchWalk(const WalkBenchOptions& options) {
    auto material = openMaterial(options);
    if (!material) {
        std::fprintf(stderr, "farol-bench: %s\n", material.error().text().c_str());
        return 1;
    }
    if (int failed = benchHops(options, *material); failed != 0) return failed;
    return benchPace(options, *material);
}

} // namespace farol::bench
