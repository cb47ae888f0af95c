#include "core/simulation/walk_source.h"

#include "core/simulation/hash.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace farol::simulation {

namespace {

// requestStop() wakes nobody, so it is looked for now and then.
constexpr std::chrono::milliseconds kLookEvery{50};
constexpr std::size_t kTruthsKept = 64;

/// A palm on the lens: dark, reddish, with a little light from one side.
cv::Mat coveredPicture(cv::Size size, std::uint64_t seed) {
    cv::Mat light(1, 2, CV_8UC3);
    light.at<cv::Vec3b>(0, 0) = {14, 14, 26};
    light.at<cv::Vec3b>(0, 1) = {20, 22, 44};
    cv::Mat picture, noise(size, CV_8UC3);
    cv::resize(light, picture, size, 0, 0, cv::INTER_LINEAR);
    cv::RNG random(seed);
    random.fill(noise, cv::RNG::UNIFORM, 0, 5);
    picture += noise;
    return picture;
}

} // namespace

Result<void> WalkSourceOptions::check() const {
    if (auto checked = walker.check(); !checked) return checked;
    if (auto checked = camera.check(); !checked) return checked;
    if (!(framesPerSecond >= 0.2 && framesPerSecond <= 120.0))
        return Error{ErrorCode::InvalidArgument, "a walk has 0.2 to 120 frames a second", "framesPerSecond"};
    if (!(mostSeconds > 0.0 && hearingSeconds >= 0.0 && hearingSeconds <= 60.0 && afterArrivalS >= 0.0))
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
    : m_options(options),
      m_description(std::move(description)),
      m_camera(std::move(camera)),
      m_walker(std::move(walker)),
      m_lightsOut(m_options.camera.lightsOut) {}

/// What was said on a frame is done `hearingSeconds` later, so pictures may be drawn that much ahead.
void WalkSource::waitForAnswer(std::unique_lock<std::mutex>& lock) {
    auto ahead = static_cast<std::uint64_t>(
        std::max(1.0, std::floor(m_options.hearingSeconds * m_options.framesPerSecond + 1e-9)));
    while (!stopRequested() && m_index >= ahead && !(m_lastAnswer && *m_lastAnswer + ahead >= m_index))
        m_changed.wait_for(lock, kLookEvery);
}

void WalkSource::waitForTurn(std::unique_lock<std::mutex>& lock) {
    using Clock = std::chrono::steady_clock;
    auto due = [&] {
        return m_turn + std::chrono::duration_cast<Clock::duration>(
                            std::chrono::duration<double>(framePeriod() / m_speed));
    };
    while (m_speed > 0.0 && !stopRequested() && Clock::now() < due())
        m_changed.wait_until(lock, std::min(due(), Clock::now() + kLookEvery));
    // Who is late by more than a frame does not run to make up for it.
    m_turn = m_speed > 0.0 ? std::max(due(), Clock::now() - (due() - m_turn)) : Clock::now();
}

/// False when the walk is over.
bool WalkSource::walkTo(double time) {
    bool over = time > m_sentOffAt + m_options.mostSeconds ||
                (m_arrivedAt && time > *m_arrivedAt + m_options.afterArrivalS);
    if (stopRequested() || over) return false;
    for (auto& [when, instruction] : m_said) {
        if (when > time) continue;
        m_walker->walkUntil(std::max(m_walker->time(), when));
        m_walker->hear(instruction);
    }
    std::erase_if(m_said, [&](const auto& each) { return each.first <= time; });
    m_walker->walkUntil(time);
    if (m_walker->arrived() && !m_arrivedAt) m_arrivedAt = time;
    return true;
}

std::optional<capture::Frame> WalkSource::next() {
    CameraPose pose;
    capture::Frame frame;
    bool covered = false;
    {
        std::unique_lock lock(m_mutex);
        waitForAnswer(lock);
        double time = static_cast<double>(m_index) / m_options.framesPerSecond;
        if (!walkTo(time)) return std::nullopt;
        pose = m_walker->pose();
        frame.index = m_index++;
        frame.capturedAt = time;
        covered = m_covered;
        m_camera.setLightsOut(m_lightsOut);
    }
    auto picture = m_camera.render(pose);
    if (!picture) {
        tell(capture::SourceEventKind::FrameSkipped,
             "the simulated camera gave no picture: " + picture.error().text());
        return std::nullopt;
    }
    frame.image = covered ? coveredPicture(picture->image.size(), hashOf(m_options.camera.seed, frame.index))
                          : picture->image;
    std::unique_lock lock(m_mutex);
    waitForTurn(lock);
    frame.arrivedAt = std::chrono::steady_clock::now();
    m_truths.emplace_back(frame.index, std::move(picture->truth));
    if (m_truths.size() > kTruthsKept) m_truths.pop_front();
    return frame;
}

void WalkSource::setSpeed(double factor) {
    {
        std::scoped_lock lock(m_mutex);
        if (std::isfinite(factor) && factor > 0.0) m_speed = factor;
    }
    m_changed.notify_all();
}

void WalkSource::answer(std::uint64_t frame, const std::vector<guidance::Cue>& cues) {
    {
        std::scoped_lock lock(m_mutex);
        m_lastAnswer = std::max(frame, m_lastAnswer.value_or(0));
        for (const guidance::Cue& cue : cues)
            m_said.emplace_back(cue.time + m_options.hearingSeconds, instructionOf(cue));
    }
    m_changed.notify_all();
}

FrameTruth WalkSource::truth(std::uint64_t frame) const {
    std::scoped_lock lock(m_mutex);
    if (m_truths.empty()) return {};
    auto newer = std::find_if(m_truths.begin() + 1, m_truths.end(),
                              [&](const auto& each) { return each.first > frame; });
    return (newer - 1)->second;
}

bool WalkSource::arrived() const {
    std::scoped_lock lock(m_mutex);
    return m_walker->arrived();
}

void WalkSource::takeWrongTurn() {
    std::scoped_lock lock(m_mutex);
    m_walker->takeWrongTurn();
}

void WalkSource::setCovered(bool covered) {
    std::scoped_lock lock(m_mutex);
    m_covered = covered;
}

void WalkSource::setLightsOut(bool out) {
    std::scoped_lock lock(m_mutex);
    m_lightsOut = out;
}

void WalkSource::sendOff() {
    std::scoped_lock lock(m_mutex);
    m_said.clear(); // "you have arrived" of the way before would be the end of this one
    m_walker->forgetArrival();
    m_arrivedAt.reset();
    m_sentOffAt = m_walker->time();
}

} // namespace farol::simulation
