#pragma once
// Hop 2 and the scene part of hop 3: one frame in, one Percept out. Cheap steps (scene, motion, tracks) are
// made for each frame; slow looks (landmarks; doors and stairs; text) now and then, each at its own lookout.
// What a look found is carried to the present by the tracks, so that tracks are the same whether a look is
// taken on the spot or on a thread. Deterministic when looks are taken on the spot.

#include "core/localisation/scene_context.h"
#include "core/recognition/camera_model.h"
#include "core/recognition/door_detector.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/landmark_tracker.h"
#include "core/recognition/network_detector.h"
#include "core/recognition/rectangle_detector.h"
#include "core/recognition/sign_detector.h"
#include "core/recognition/stairs_detector.h"
#include "core/recognition/text_reader.h"
#include "core/recognition/visual_motion.h"
#include "core/session/lookout.h"
#include "core/session/percept.h"
#include "core/session/plate_readings.h"

#include <array>
#include <memory>
#include <optional>

namespace farol::session {

struct PerceptionOptions {
    bool landmarks = true, doors = true, stairs = true, signs = true, text = true, motion = true;
    /// Generic boards as detections too. Off: they only say where the text reader looks, and would fill the
    /// short history with things that nearly every wall has.
    bool rectangles = false;
    recognition::RecogniserOptions recogniser;
    recognition::DoorDetectorOptions doorDetector;
    recognition::StairsDetectorOptions stairsDetector;
    recognition::SignDetectorOptions signDetector;
    /// The user's own; empty: none. It serves one perception at a time.
    std::shared_ptr<recognition::NetworkDetector> ownDetector;
    recognition::RectangleDetectorOptions rectangleDetector;
    recognition::TextReaderOptions textReader;
    recognition::VisualMotionOptions visualMotion;
    recognition::TrackerOptions tracker;
    localisation::SceneOptions scene;
    /// Of the calibrated camera; without one the view is assumed, and ranges are less sure.
    std::optional<recognition::CameraModel> camera;
    double viewDegrees = 60.0; ///< of the assumed one, along the longer side
    /// At most one look in this time of the frames' own clock.
    double secondsBetweenLooks = 0.1, secondsBetweenDoors = 0.2, secondsBetweenReadings = 0.3;
    int linesPerReading = 3; ///< reading is the slowest look
    /// Looks that have to see a thing before it is told, where frames come densely: a false hit is rarely
    /// repeated.
    int confirmations = 2;

    void useCamera(const recognition::CameraModel& calibrated);
    void useView(double degrees);
    Result<void> check() const;
};

/// The remark on a walk without trained landmarks; compared with by who says it in another language.
inline constexpr const char* kNoTrainedLandmarks =
    "no trained landmarks: only doors and texts are recognised; open a library of landmarks to recognise "
    "more";

class Perception {
public:
    /// `library` may be null: no trained landmarks. `warnings` tells what had to be left out (no landmarks,
    /// no tessdata).
    Perception(std::shared_ptr<const recognition::LandmarkLibrary> library, PerceptionOptions options,
               std::vector<std::string>& warnings, const LookoutMaker& makeLookout = lookOnTheSpot);
    Percept look(const capture::Frame& frame, HopTimes* times = nullptr);
    /// What went wrong in looks since the last call.
    std::vector<std::string> takeMessages();

private:
    struct Post {
        recognition::Sense sense = recognition::Sense::Landmarks;
        double secondsBetween = 0.0;
        bool wanted = false;
        std::unique_ptr<Lookout> lookout;
        std::optional<double> lastBegun;         ///< frame time
        std::optional<std::uint64_t> underWay{}; ///< frame
    };
    /// A line that could not be read: not tried again at once.
    struct Unread {
        Quad quad{};
        double until = 0.0;
    };

    void lookQuickly(const capture::Frame& frame, Percept& percept, HopTimes& times);
    bool due(const Post& post, const Percept& percept) const;
    Look lookFor(const Post& post, const capture::Frame& frame, double sharpness);
    recognition::CameraModel cameraFor(const cv::Mat& image) const;
    recognition::DetectorResult findLandmarks(const cv::Mat& image) const;
    recognition::DetectorResult findDoors(const cv::Mat& image) const;
    recognition::DetectorResult findStructures(const cv::Mat& image);
    recognition::TextPlaces placesToRead(double time);
    void fetch(Post& post, Percept& percept, HopTimes& times);
    bool knownByItsLook(const recognition::Detection& detection) const;
    void tellBearings(std::vector<recognition::Detection>& detections) const;
    void tell(const Post& post, Sight sight, Percept& percept);
    bool tellText(const Sight& sight, recognition::Detection& read, Percept& percept);
    void tellTracks(Percept& percept);

    PerceptionOptions m_options;
    std::optional<recognition::LandmarkRecogniser> m_recogniser;
    std::optional<recognition::TextReader> m_reader;
    std::optional<recognition::SignDetector> m_signs;
    recognition::VisualMotion m_motion;
    localisation::SceneContext m_scene;
    recognition::LandmarkTracker m_tracker;
    PlateReadings m_plates;
    std::vector<Unread> m_unread;
    std::vector<std::string> m_messages;
    int m_sceneNow = 0;
    std::uint64_t m_framesSeen = 0;
    std::array<Post, 3> m_posts; ///< last: their threads use all of the above
};

} // namespace farol::session
