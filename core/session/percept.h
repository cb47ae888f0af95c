#pragma once
// Everything hop 2 says of one frame (design: the life of a frame), and what the rest of the chain makes of
// it. These values are what a recording holds and what the GUI shows.

#include "core/capture/frame_source.h"
#include "core/guidance/cue.h"
#include "core/guidance/route_tracker.h"
#include "core/localisation/localiser.h"
#include "core/recognition/detection.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace farol::session {

/// A pure value: replaying it gives the same walk.
struct Percept {
    std::uint64_t frame = 0;
    double time = 0.0;
    std::string name;
    ImageSize size;
    int scene = 0;
    double sharpness = 0.0;
    std::vector<recognition::Detection> detections;
    std::vector<recognition::Rejection> rejections;
    recognition::Motion motion;
};

/// Hops 3 to 6 for one frame.
struct NavigationStep {
    Percept percept;
    std::vector<localisation::Observation> fresh;
    std::deque<localisation::Observation> history;
    localisation::Fix fix;
    guidance::Progress progress;
    std::vector<guidance::Cue> cues;
};

/// Milliseconds of each hop for one frame; measured, never part of a decision or of a recording.
struct HopTimes {
    double sceneMs = 0.0, motionMs = 0.0, landmarksMs = 0.0, doorsMs = 0.0, rectanglesMs = 0.0, textMs = 0.0,
           navigateMs = 0.0;
    double ageMs = 0.0; ///< from the frame's entry into the program to the end of the chain
};

enum class RunState { Idle, Running, Paused, Ended, Failed };

/// What the GUI shows; published as shared_ptr<const Snapshot>, never changed afterwards.
struct Snapshot {
    RunState state = RunState::Idle;
    capture::Frame frame;
    NavigationStep step;
    HopTimes times;
    std::uint64_t framesDropped = 0;
    std::uint64_t framesSkipped = 0;
    std::vector<std::string> warnings; ///< the newest few, oldest first
    std::string source;
};

} // namespace farol::session
