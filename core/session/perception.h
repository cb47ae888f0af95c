#pragma once
// Hop 2 and the scene part of hop 3: one frame in, one Percept out. Single-threaded and deterministic.

#include "core/localisation/scene_context.h"
#include "core/recognition/door_detector.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/rectangle_detector.h"
#include "core/recognition/stairs_detector.h"
#include "core/recognition/text_reader.h"
#include "core/recognition/visual_motion.h"
#include "core/session/percept.h"

#include <memory>
#include <optional>

namespace farol::session {

struct PerceptionOptions {
    bool landmarks = true, doors = true, stairs = true, text = true, motion = true;
    /// Generic boards as detections too. Off: they only say where the text reader looks, and would fill the
    /// short history with things that nearly every wall has.
    bool rectangles = false;
    recognition::RecogniserOptions recogniser;
    recognition::DoorDetectorOptions doorDetector;
    recognition::StairsDetectorOptions stairsDetector;
    recognition::RectangleDetectorOptions rectangleDetector;
    recognition::TextReaderOptions textReader;
    recognition::VisualMotionOptions visualMotion;
    localisation::SceneOptions scene;
    /// Reading is the slowest hop: at most one read in this time of the frames' own clock.
    double secondsBetweenReadings = 0.3;

    Result<void> check() const;
};

class Perception {
public:
    /// `library` may be null: no trained landmarks. `warnings` tells what had to be left out (no landmarks,
    /// no tessdata).
    Perception(std::shared_ptr<const recognition::LandmarkLibrary> library, PerceptionOptions options,
               std::vector<std::string>& warnings);
    Percept look(const capture::Frame& frame, HopTimes* times = nullptr);

private:
    void readText(const capture::Frame& frame, const recognition::DetectorResult& boards, Percept& percept,
                  HopTimes& times);

    PerceptionOptions m_options;
    std::optional<recognition::LandmarkRecogniser> m_recogniser;
    std::optional<recognition::TextReader> m_reader;
    recognition::VisualMotion m_motion;
    localisation::SceneContext m_scene;
    std::optional<double> m_lastReading; ///< frame time
};

} // namespace farol::session
