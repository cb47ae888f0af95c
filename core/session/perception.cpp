#include "core/session/perception.h"

#include "core/recognition/sharpness.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

namespace farol::session {

namespace {

/// Adds the time since construction, or since the last lap, to a hop.
class StopWatch {
public:
    void lap(double& hopMs) {
        auto now = std::chrono::steady_clock::now();
        hopMs += std::chrono::duration<double, std::milli>(now - m_since).count();
        m_since = now;
    }

private:
    std::chrono::steady_clock::time_point m_since = std::chrono::steady_clock::now();
};

bool isFinite(const Quad& quad) {
    return std::all_of(quad.begin(), quad.end(),
                       [](ImagePoint p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

/// Whatever a detector's arithmetic did, a percept holds finite numbers only: history, voting and files rely
/// on it.
void keepFinite(Percept& percept) {
    std::vector<recognition::Detection> kept;
    for (recognition::Detection& detection : percept.detections) {
        if (detection.rangeM && !std::isfinite(*detection.rangeM)) detection.rangeM.reset();
        if (detection.bearing && !std::isfinite(detection.bearing->value)) detection.bearing.reset();
        if (isFinite(detection.quad) && std::isfinite(detection.score)) {
            kept.push_back(std::move(detection));
        } else {
            percept.rejections.push_back(
                {"landmarks", detection.kind, detection.templateId, Quad{}, "not_finite", 0.0});
        }
    }
    percept.detections = std::move(kept);
    for (recognition::Rejection& rejection : percept.rejections) {
        if (!isFinite(rejection.quad)) rejection.quad = Quad{};
        if (!std::isfinite(rejection.value)) rejection.value = 0.0;
    }
    if (percept.motion.turn && !std::isfinite(percept.motion.turn->value)) percept.motion.turn.reset();
    if (percept.motion.speed && !std::isfinite(*percept.motion.speed)) percept.motion.speed.reset();
    if (percept.motion.stepsPerSecond && !std::isfinite(*percept.motion.stepsPerSecond))
        percept.motion.stepsPerSecond.reset();
    if (!std::isfinite(percept.sharpness)) percept.sharpness = 0.0;
}

void append(Percept& percept, recognition::DetectorResult result) {
    std::move(result.detections.begin(), result.detections.end(), std::back_inserter(percept.detections));
    std::move(result.rejections.begin(), result.rejections.end(), std::back_inserter(percept.rejections));
}

bool hasViews(const recognition::LandmarkLibrary* library) {
    return library != nullptr && library->viewCount() > 0;
}

} // namespace

Result<void> PerceptionOptions::check() const {
    for (const Result<void>& checked :
         {recogniser.check(), doorDetector.check(), stairsDetector.check(), rectangleDetector.check(),
          textReader.check(), visualMotion.check(), scene.check()})
        if (!checked) return checked;
    if (!std::isfinite(secondsBetweenReadings) || secondsBetweenReadings < 0.0)
        return Error{ErrorCode::InvalidArgument,
                     "the time between two readings is not a number of seconds from 0 on",
                     "secondsBetweenReadings"};
    return {};
}

Perception::Perception(std::shared_ptr<const recognition::LandmarkLibrary> library, PerceptionOptions options,
                       std::vector<std::string>& warnings)
    : m_options(std::move(options)), m_motion(m_options.visualMotion), m_scene(m_options.scene) {
    if (m_options.landmarks && hasViews(library.get())) {
        m_recogniser.emplace(std::move(library), m_options.recogniser);
    } else if (m_options.landmarks) {
        warnings.emplace_back("no trained landmarks: only doors and texts are recognised; open a library "
                              "of landmarks to recognise more");
    }
    if (!m_options.text) return;
    auto reader = recognition::TextReader::create(m_options.textReader);
    if (reader) {
        m_reader.emplace(std::move(reader).value());
    } else {
        warnings.push_back("signs are not read: " + reader.error().text());
    }
}

Percept Perception::look(const capture::Frame& frame, HopTimes* times) {
    HopTimes unused;
    HopTimes& spent = times != nullptr ? *times : unused;
    StopWatch watch;
    Percept percept;
    percept.frame = frame.index;
    percept.time = frame.capturedAt;
    percept.name = frame.name;
    percept.size = frame.size();
    if (frame.image.empty()) return percept;
    percept.scene = m_scene.observe(frame.image);
    percept.sharpness = recognition::sharpness(frame.image);
    watch.lap(spent.sceneMs);
    if (m_options.motion) percept.motion = m_motion.observe(frame.image, frame.capturedAt);
    watch.lap(spent.motionMs);
    if (m_recogniser) append(percept, m_recogniser->recognise(frame.image));
    watch.lap(spent.landmarksMs);
    if (m_options.doors) append(percept, recognition::detectDoors(frame.image, m_options.doorDetector));
    if (m_options.stairs) append(percept, recognition::detectStairs(frame.image, m_options.stairsDetector));
    watch.lap(spent.doorsMs);
    bool backwards = m_lastReading && frame.capturedAt < *m_lastReading;
    bool due =
        !m_lastReading || backwards || frame.capturedAt - *m_lastReading >= m_options.secondsBetweenReadings;
    bool read = m_reader && due && percept.sharpness >= m_options.textReader.minSharpness;
    recognition::DetectorResult boards;
    if (read || m_options.rectangles)
        boards = recognition::detectRectangles(frame.image, m_options.rectangleDetector);
    watch.lap(spent.rectanglesMs);
    if (read) {
        m_lastReading = frame.capturedAt;
        readText(frame, boards, percept, spent);
    }
    if (m_options.rectangles) append(percept, std::move(boards));
    keepFinite(percept);
    return percept;
}

void Perception::readText(const capture::Frame& frame, const recognition::DetectorResult& boards,
                          Percept& percept, HopTimes& times) {
    StopWatch watch;
    std::vector<Quad> plates;
    for (const recognition::Detection& board : boards.detections) plates.push_back(board.quad);
    append(percept, m_reader->read(frame.image, plates));
    watch.lap(times.textMs);
}

} // namespace farol::session
