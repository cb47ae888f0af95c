#include "core/session/perception.h"

#include "core/recognition/sharpness.h"
#include "core/session/sayings.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <set>
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

bool isFinite(const recognition::Detection& detection) {
    return isFinite(detection.quad) && std::isfinite(detection.score);
}

/// Whatever a detector's arithmetic did, a percept holds finite numbers only: tracks, history, voting and
/// files rely on it.
void keepFinite(recognition::DetectorResult& result) {
    std::vector<recognition::Detection> kept;
    for (recognition::Detection& detection : result.detections) {
        if (detection.rangeM && !std::isfinite(*detection.rangeM)) detection.rangeM.reset();
        if (!detection.rangeM || !std::isfinite(detection.rangeSpread.value_or(0.0)))
            detection.rangeSpread.reset();
        if (detection.bearing && !std::isfinite(detection.bearing->value)) detection.bearing.reset();
        if (isFinite(detection)) {
            kept.push_back(std::move(detection));
        } else {
            result.rejections.push_back(
                {"landmarks", detection.kind, detection.templateId, Quad{}, "not_finite", 0.0});
        }
    }
    result.detections = std::move(kept);
    for (recognition::Rejection& rejection : result.rejections) {
        if (!isFinite(rejection.quad)) rejection.quad = Quad{};
        if (!std::isfinite(rejection.value)) rejection.value = 0.0;
    }
}

void keepFinite(Percept& percept) {
    recognition::DetectorResult told{std::move(percept.detections), std::move(percept.rejections)};
    keepFinite(told);
    percept.detections = std::move(told.detections);
    percept.rejections = std::move(told.rejections);
    std::erase_if(percept.tracks, [](const recognition::Track& track) { return !isFinite(track.now); });
    if (percept.motion.turn && !std::isfinite(percept.motion.turn->value)) percept.motion.turn.reset();
    if (percept.motion.speed && !std::isfinite(*percept.motion.speed)) percept.motion.speed.reset();
    if (percept.motion.stepsPerSecond && !std::isfinite(*percept.motion.stepsPerSecond))
        percept.motion.stepsPerSecond.reset();
    if (!std::isfinite(percept.sharpness)) percept.sharpness = 0.0;
}

bool hasViews(const recognition::LandmarkLibrary* library) {
    return library != nullptr && library->viewCount() > 0;
}

/// Nothing was looked for: what was not found may be there.
bool wasBlurred(const recognition::DetectorResult& result) {
    return result.detections.empty() &&
           std::any_of(result.rejections.begin(), result.rejections.end(), [](const auto& rejection) {
               return rejection.detector == "landmarks" && rejection.reason == "blurred";
           });
}

/// Tesseract was asked about this line, and the answer was worth nothing.
bool wasReadInVain(const recognition::Rejection& rejection) {
    static const std::set<std::string> kCheap{"low_contrast", "too_small", "blurred", "not_agreed_yet"};
    return rejection.detector == "text" && kCheap.count(rejection.reason) == 0;
}

/// The finer letters of a map's word are told apart in frames that are sharper than the reader demands.
constexpr double kSharpTimes = 2.0;
constexpr double kReadAgainSeconds = 3.0;    ///< a plate that is settled is looked at again after this
constexpr double kTryAgainSeconds = 2.0;     ///< a line that could not be read
constexpr double kPlateMemorySeconds = 30.0; ///< what was read of a plate
constexpr double kTimeSlack = 0.002;         ///< frame times are not exact multiples of their period

/// A look that fails tells why and finds nothing.
template <class Find>
Look guarded(const capture::Frame& frame, double sharpness, Find find) {
    Sight blank{frame.index, frame.capturedAt, sharpness, frame.arrivedAt, {}, {}, {}};
    return [image = frame.image, blank = std::move(blank), find = std::move(find)] {
        Sight sight = blank;
        try {
            find(image, sight);
        } catch (const std::exception& exception) {
            sight.trouble = exception.what();
        }
        keepFinite(sight.result);
        return sight;
    };
}

} // namespace

void PerceptionOptions::useCamera(const recognition::CameraModel& calibrated) {
    camera = calibrated;
    visualMotion.horizontalViewDegrees = tracker.horizontalViewDegrees = calibrated.horizontalViewDegrees();
}

void PerceptionOptions::useView(double degrees) {
    camera.reset();
    viewDegrees = degrees;
    visualMotion.horizontalViewDegrees = tracker.horizontalViewDegrees = degrees;
}

Result<void> PerceptionOptions::check() const {
    if (camera)
        if (auto checked = camera->check(); !checked) return checked;
    if (!(viewDegrees >= 20.0 && viewDegrees <= 140.0))
        return Error{ErrorCode::InvalidArgument, "a camera sees 20 to 140 degrees across", "viewDegrees"};
    for (const Result<void>& checked : {recogniser.check(), doorDetector.check(), stairsDetector.check(),
                                        signDetector.check(), rectangleDetector.check(), textReader.check(),
                                        visualMotion.check(), tracker.check(), scene.check()})
        if (!checked) return checked;
    for (auto [seconds, name] : {std::pair{secondsBetweenLooks, "secondsBetweenLooks"},
                                 {secondsBetweenDoors, "secondsBetweenDoors"},
                                 {secondsBetweenReadings, "secondsBetweenReadings"}})
        if (!std::isfinite(seconds) || seconds < 0.0)
            return Error{ErrorCode::InvalidArgument,
                         "the time between two looks is not a number of seconds from 0 on", name};
    if (linesPerReading < 1 || linesPerReading > 1000)
        return Error{ErrorCode::InvalidArgument, "between 1 and 1000 lines are read at once",
                     "linesPerReading"};
    if (confirmations < 1 || confirmations > 100)
        return Error{ErrorCode::InvalidArgument, "between 1 and 100 looks have to see a thing",
                     "confirmations"};
    return {};
}

Perception::Perception(std::shared_ptr<const recognition::LandmarkLibrary> library, PerceptionOptions options,
                       std::vector<std::string>& warnings, const LookoutMaker& makeLookout)
    : m_options(std::move(options)),
      m_motion(m_options.visualMotion),
      m_scene(m_options.scene),
      m_tracker(m_options.tracker),
      m_plates(m_options.textReader.words) {
    if (m_options.landmarks && hasViews(library.get())) {
        m_recogniser.emplace(std::move(library), m_options.recogniser);
    } else if (m_options.landmarks) {
        warnings.emplace_back(kNoTrainedLandmarks);
    }
    if (m_options.text) {
        auto reader = recognition::TextReader::create(m_options.textReader);
        if (reader) {
            m_reader.emplace(std::move(reader).value());
        } else {
            warnings.push_back("signs are not read: " + reader.error().text());
        }
    }
    using recognition::Sense;
    if (m_options.signs) m_signs.emplace(m_options.signDetector);
    bool structures = m_options.doors || m_options.stairs || m_options.signs || m_options.ownDetector ||
                      m_options.rectangles;
    m_posts = {Post{Sense::Landmarks, m_options.secondsBetweenLooks, m_recogniser.has_value(), nullptr, {}},
               Post{Sense::Structures, m_options.secondsBetweenDoors, structures, nullptr, {}},
               Post{Sense::Text, m_options.secondsBetweenReadings, m_reader.has_value(), nullptr, {}}};
    for (Post& post : m_posts)
        if (post.wanted) post.lookout = makeLookout();
}

void Perception::lookQuickly(const capture::Frame& frame, Percept& percept, HopTimes& times) {
    StopWatch watch;
    int before = m_sceneNow;
    percept.scene = m_sceneNow = m_scene.observe(frame.image);
    percept.sharpness = recognition::sharpness(frame.image);
    watch.lap(times.sceneMs);
    if (m_options.motion) percept.motion = m_motion.observe(frame.image, frame.capturedAt);
    watch.lap(times.motionMs);
    // A slow pan comes to another scene too, with everything in view; at a cut the frame before is no guide.
    bool cut =
        percept.scene != before && m_scene.correlationToPrevious() < m_options.scene.minCorrelationToPrevious;
    std::uint64_t oldest = frame.index;
    for (const Post& post : m_posts) oldest = std::min(oldest, post.underWay.value_or(oldest));
    m_tracker.advance(frame.image, frame.index, frame.capturedAt, percept.scene, cut, oldest);
    watch.lap(times.tracksMs);
}

bool Perception::due(const Post& post, const Percept& percept) const {
    if (!post.wanted || !post.lookout->free()) return false;
    // Nothing is lost with a smeared frame: the next one may be sharp.
    if (post.sense == recognition::Sense::Text && percept.sharpness < m_options.textReader.minSharpness)
        return false;
    if (!post.lastBegun || percept.time < *post.lastBegun) return true;
    return percept.time - *post.lastBegun >= post.secondsBetween - kTimeSlack;
}

recognition::CameraModel Perception::cameraFor(const cv::Mat& image) const {
    const ImageSize size{image.cols, image.rows};
    if (m_options.camera)
        if (auto scaled = m_options.camera->forPictures(size)) return *scaled;
    return recognition::CameraModel::assumed(size, m_options.viewDegrees);
}

recognition::DetectorResult Perception::findLandmarks(const cv::Mat& image) const {
    recognition::DetectorResult result = m_recogniser->recognise(image);
    const recognition::CameraModel camera = cameraFor(image);
    for (recognition::Detection& detection : result.detections) {
        if (detection.kind == Kind::Place) continue;
        if (const recognition::Template* entry = m_recogniser->library().find(detection.templateId))
            recognition::place(detection, camera, entry->widthM, entry->heightM);
    }
    return result;
}

recognition::DetectorResult Perception::findDoors(const cv::Mat& image) const {
    const recognition::CameraModel camera = cameraFor(image);
    recognition::DoorDetectorOptions options = m_options.doorDetector;
    if (options.focalPx == 0.0) {
        options.focalPx = camera.focalPx();
        options.focalSpread = camera.focalSpread;
    }
    recognition::DetectorResult result = recognition::detectDoors(image, options);
    for (recognition::Detection& door : result.detections) {
        // An assumed camera knows a bearing no better than the zone does.
        door.bearing.reset();
        recognition::place(door, camera, {}, {});
    }
    return result;
}

recognition::DetectorResult Perception::findStructures(const cv::Mat& image) {
    recognition::DetectorResult result;
    if (m_options.doors) result.append(findDoors(image));
    if (m_options.stairs) result.append(recognition::detectStairs(image, m_options.stairsDetector));
    if (m_signs) result.append(m_signs->detect(image));
    if (m_options.ownDetector) result.append(m_options.ownDetector->detect(image));
    if (m_options.rectangles)
        result.append(recognition::detectRectangles(image, m_options.rectangleDetector));
    return result;
}

/// Plates that are settled and lines that could not be read a moment ago are left out.
recognition::TextPlaces Perception::placesToRead(double time) {
    recognition::TextPlaces places;
    places.maxLines = m_options.linesPerReading;
    for (const recognition::Track& track : m_tracker.tracks()) {
        bool settled = track.now.kind == Kind::Text && m_plates.agreed(track.now.track) != nullptr;
        if (settled && time - track.confirmedTime < kReadAgainSeconds) places.known.push_back(track.now.quad);
    }
    std::erase_if(m_unread, [time](const Unread& one) { return one.until <= time; });
    for (const Unread& one : m_unread) places.known.push_back(one.quad);
    return places;
}

Look Perception::lookFor(const Post& post, const capture::Frame& frame, double sharpness) {
    switch (post.sense) {
    case recognition::Sense::Landmarks:
        return guarded(frame, sharpness, [this](const cv::Mat& image, Sight& sight) {
            StopWatch watch;
            sight.result = findLandmarks(image);
            watch.lap(sight.times.landmarksMs);
        });
    case recognition::Sense::Structures:
        return guarded(frame, sharpness, [this](const cv::Mat& image, Sight& sight) {
            StopWatch watch;
            sight.result = findStructures(image);
            watch.lap(sight.times.doorsMs);
        });
    case recognition::Sense::Text:
        break;
    }
    return guarded(frame, sharpness,
                   [this, places = placesToRead(frame.capturedAt)](const cv::Mat& image, Sight& sight) {
                       StopWatch watch;
                       recognition::TextPlaces here = places;
                       auto boards = recognition::detectRectangles(image, m_options.rectangleDetector);
                       here.plates.emplace();
                       for (const auto& board : boards.detections) here.plates->push_back(board.quad);
                       watch.lap(sight.times.rectanglesMs);
                       sight.result = m_reader->readAt(image, here);
                       watch.lap(sight.times.textMs);
                   });
}

void Perception::fetch(Post& post, Percept& percept, HopTimes& times) {
    if (!post.lookout) return;
    std::optional<Sight> sight = post.lookout->finished();
    if (!sight) return;
    post.underWay.reset();
    times.landmarksMs += sight->times.landmarksMs;
    times.doorsMs += sight->times.doorsMs;
    times.rectanglesMs += sight->times.rectanglesMs;
    times.textMs += sight->times.textMs;
    if (!sight->trouble.empty()) {
        m_messages.push_back(said(Saying::FrameNotLookedAt, {std::to_string(sight->frame), sight->trouble}));
        return;
    }
    if (post.sense == recognition::Sense::Landmarks) times.landmarksArrivedAt = sight->arrivedAt;
    StopWatch watch;
    tell(post, std::move(*sight), percept);
    watch.lap(times.tracksMs);
}

/// False: the readings of this plate do not agree yet.
bool Perception::tellText(const Sight& sight, recognition::Detection& read, Percept& percept) {
    if (read.track != 0) {
        bool sharp = sight.sharpness >= kSharpTimes * m_options.textReader.minSharpness;
        m_plates.add(read.track, read.text, sharp, sight.time);
        if (const std::string* agreed = m_plates.agreed(read.track)) {
            read.text = *agreed;
            return true;
        }
    }
    percept.rejections.push_back({"text", Kind::Text, {}, read.quad, "not_agreed_yet", read.score});
    return false;
}

/// A door or a sign that is recognised as a trained one at the same time is one object, not two.
bool Perception::knownByItsLook(const recognition::Detection& detection) const {
    constexpr double kSameOverlap = 0.5;
    if (!detection.templateId.empty()) return false;
    for (const recognition::Track& track : m_tracker.tracks())
        if (track.now.kind == detection.kind && !track.now.templateId.empty() &&
            overlap(boundingBox(track.now.quad), boundingBox(detection.quad)) > kSameOverlap)
            return true;
    return false;
}

/// A calibrated camera tells where each thing lies, also one whose size nobody knows.
void Perception::tellBearings(std::vector<recognition::Detection>& detections) const {
    for (recognition::Detection& detection : detections) {
        if (detection.bearing || detection.kind == Kind::Place) continue;
        if (auto camera = m_options.camera->forPictures(detection.image))
            recognition::place(detection, *camera, {}, {});
    }
}

void Perception::tell(const Post& post, Sight sight, Percept& percept) {
    bool isText = post.sense == recognition::Sense::Text;
    bool complete = !isText && !wasBlurred(sight.result);
    bool dense = !m_tracker.sparse(sight.frame);
    if (m_options.camera) tellBearings(sight.result.detections);
    for (const recognition::Rejection& rejection : sight.result.rejections)
        if (isText && wasReadInVain(rejection))
            m_unread.push_back({rejection.quad, sight.time + kTryAgainSeconds});
    std::move(sight.result.rejections.begin(), sight.result.rejections.end(),
              std::back_inserter(percept.rejections));
    auto joined = m_tracker.join(post.sense, sight.frame, std::move(sight.result.detections), complete);
    for (recognition::Detection& detection : joined) {
        if (isText) {
            if (tellText(sight, detection, percept)) percept.detections.push_back(std::move(detection));
        } else if (knownByItsLook(detection)) {
            percept.rejections.push_back(
                {"tracks", detection.kind, {}, detection.quad, "known_by_its_look", detection.score});
        } else if (dense && detection.confirmations < m_options.confirmations) {
            percept.rejections.push_back({"tracks", detection.kind, detection.templateId, detection.quad,
                                          "seen_once", static_cast<double>(detection.confirmations)});
        } else {
            percept.detections.push_back(std::move(detection));
        }
    }
}

void Perception::tellTracks(Percept& percept) {
    for (recognition::Track& track : m_tracker.tracks()) {
        if (track.now.kind == Kind::Text) {
            const std::string* agreed = m_plates.agreed(track.now.track);
            if (agreed == nullptr) continue;
            track.now.text = *agreed;
        }
        percept.tracks.push_back(std::move(track));
    }
    for (recognition::Rejection& ended : m_tracker.takeEnded())
        percept.rejections.push_back(std::move(ended));
    m_plates.forgetBefore(percept.time - kPlateMemorySeconds);
}

Percept Perception::look(const capture::Frame& frame, HopTimes* times) {
    HopTimes unused;
    HopTimes& spent = times != nullptr ? *times : unused;
    Percept percept;
    percept.frame = frame.index;
    percept.time = frame.capturedAt;
    percept.name = frame.name;
    percept.size = frame.size();
    if (frame.image.empty()) return percept;
    lookQuickly(frame, percept, spent);
    // What is ready first, so that who has just finished may take this frame; then what was done on the spot.
    for (Post& post : m_posts) fetch(post, percept, spent);
    for (Post& post : m_posts) {
        if (!due(post, percept)) continue;
        post.lastBegun = frame.capturedAt;
        post.underWay = frame.index;
        post.lookout->begin(lookFor(post, frame, percept.sharpness));
    }
    // Where the next frame comes late anyhow, an answer that waited for it would be old.
    bool sparse = m_tracker.sparse(frame.index) && m_framesSeen++ > 0;
    for (Post& post : m_posts) {
        if (sparse && post.lookout) post.lookout->wait();
        fetch(post, percept, spent);
    }
    tellTracks(percept);
    keepFinite(percept);
    return percept;
}

std::vector<std::string> Perception::takeMessages() {
    return std::exchange(m_messages, {});
}

} // namespace farol::session
