#include "core/simulation/walk_source.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace farol::simulation {

Result<void> WalkSourceOptions::check() const {
    if (auto checked = walker.check(); !checked) return checked;
    if (auto checked = camera.check(); !checked) return checked;
    if (!(framesPerSecond >= 0.2 && framesPerSecond <= 120.0))
        return Error{ErrorCode::InvalidArgument, "a walk has 0.2 to 120 frames a second", "framesPerSecond"};
    if (!(mostSeconds > 0.0 && hearingSeconds >= 0.0 && afterArrivalS >= 0.0))
        return Error{ErrorCode::InvalidArgument, "times of a walk are not negative", "walk"};
    return {};
}

Result<std::unique_ptr<WalkSource>> WalkSource::create(const World& world, const building::Location& start,
                                                       const WalkSourceOptions& options) {
    if (auto checked = options.check(); !checked) return checked.error();
    auto solid = std::make_shared<const WalkWorld>(world.building());
    auto walker = Walker::create(solid, start, options.walker);
    if (!walker) return walker.error();
    auto camera = SimulatedCamera::create(world, options.camera);
    if (!camera) return camera.error();
    const building::Region* region = world.building()->region((*walker)->region());
    std::string description = "a simulated walk from " + building::spokenName(*region);
    return std::unique_ptr<WalkSource>(new WalkSource(std::move(walker).value(), std::move(camera).value(),
                                                      options, std::move(description)));
}

WalkSource::WalkSource(std::unique_ptr<Walker> walker, SimulatedCamera camera, WalkSourceOptions options,
                       std::string description)
    : m_options(std::move(options)),
      m_description(std::move(description)),
      m_camera(std::move(camera)),
      m_walker(std::move(walker)) {}

void WalkSource::waitForAnswer(std::unique_lock<std::mutex>& lock) {
    if (!m_options.waitsForAnswers || m_index == 0) return;
    // requestStop() wakes nobody, so it is looked for now and then.
    constexpr std::chrono::milliseconds kLookEvery{50};
    while (!stopRequested() && !(m_lastAnswer && *m_lastAnswer + 1 >= m_index))
        m_answered.wait_for(lock, kLookEvery);
}

std::optional<capture::Frame> WalkSource::next() {
    CameraPose pose;
    capture::Frame frame;
    {
        std::unique_lock lock(m_mutex);
        waitForAnswer(lock);
        double time = static_cast<double>(m_index) / m_options.framesPerSecond;
        bool over =
            time > m_options.mostSeconds || (m_arrivedAt && time > *m_arrivedAt + m_options.afterArrivalS);
        if (stopRequested() || over) return std::nullopt;
        for (auto& [when, instruction] : m_said) {
            if (when > time) continue;
            m_walker->walkUntil(std::max(m_walker->time(), when));
            m_walker->hear(instruction);
        }
        std::erase_if(m_said, [&](const auto& each) { return each.first <= time; });
        m_walker->walkUntil(time);
        if (m_walker->arrived() && !m_arrivedAt) m_arrivedAt = time;
        pose = m_walker->pose();
        frame.index = m_index++;
        frame.capturedAt = time;
    }
    auto picture = m_camera.render(pose);
    if (!picture) {
        tell(capture::SourceEventKind::FrameSkipped,
             "the simulated camera gave no picture: " + picture.error().text());
        return std::nullopt;
    }
    frame.image = picture->image;
    frame.arrivedAt = std::chrono::steady_clock::now();
    std::scoped_lock lock(m_mutex);
    m_truth = std::move(picture->truth);
    return frame;
}

void WalkSource::answer(std::uint64_t frame, const std::vector<guidance::Cue>& cues) {
    {
        std::scoped_lock lock(m_mutex);
        m_lastAnswer = std::max(frame, m_lastAnswer.value_or(0));
        for (const guidance::Cue& cue : cues)
            m_said.emplace_back(cue.time + m_options.hearingSeconds, instructionOf(cue));
    }
    m_answered.notify_all();
}

FrameTruth WalkSource::truth() const {
    std::scoped_lock lock(m_mutex);
    return m_truth;
}

bool WalkSource::arrived() const {
    std::scoped_lock lock(m_mutex);
    return m_walker->arrived();
}

} // namespace farol::simulation
