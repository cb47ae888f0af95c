#pragma once
// Everything hop 2 says of one frame (design: the life of a frame), and what the rest of the chain makes of
// it. These values are what a recording holds and what the GUI shows.

#include "core/capture/frame_source.h"
#include "core/guidance/cue.h"
#include "core/guidance/route_tracker.h"
#include "core/localisation/localiser.h"
#include "core/recognition/detection.h"
#include "core/recognition/track.h"

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
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
    /// What recognition tells with this frame. It may have seen it a few frames ago: outlines are those of
    /// this frame. A thing is told again each time it is recognised, with the same track.
    std::vector<recognition::Detection> detections;
    std::vector<recognition::Rejection> rejections;
    recognition::Motion motion;
    std::vector<recognition::Track> tracks; ///< all that is followed now, also what was not looked at anew
};

/// What there is to be shown on this frame: the tracks, and detections that are not followed.
std::vector<recognition::Detection> inView(const Percept& percept);

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
    double sceneMs = 0.0, motionMs = 0.0, tracksMs = 0.0, landmarksMs = 0.0, doorsMs = 0.0,
           rectanglesMs = 0.0, textMs = 0.0, navigateMs = 0.0;
    double ageMs = 0.0;  ///< from the frame's entry into the program to the end of the chain
    double loopMs = 0.0; ///< of the session's thread, from taking the frame to the end of the chain
    /// The age of the frame in which landmarks were looked for, where this frame tells of such a look.
    std::optional<double> landmarkAgeMs;
    /// Entry of that frame; set by perception, for the session to make the age of it.
    std::optional<std::chrono::steady_clock::time_point> landmarksArrivedAt;
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
