#pragma once
// A camera worn by a simulated walker, as a source of frames: whoever is guided by the frames tells the
// walker the cues, and the walker walks on them.

#include "core/capture/frame_source.h"
#include "core/simulation/simulated_camera.h"
#include "core/simulation/walker.h"

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace farol::simulation {

struct WalkSourceOptions {
    WalkerOptions walker;
    CameraOptions camera;
    double framesPerSecond = 10.0;
    double mostSeconds = 1800.0; ///< then the walker is fetched
    double hearingSeconds = 1.0; ///< from a cue to what is done on it
    double afterArrivalS = 3.0;  ///< of frames once the walker stands
    /// Each frame waits until the one before was answered, so that the same seed gives the same walk however
    /// fast the machine is. Not for sources that are played at their own pace, where late frames are dropped.
    bool waitsForAnswers = false;

    Result<void> check() const;
};

class WalkSource : public capture::FrameSource {
public:
    static Result<std::unique_ptr<WalkSource>> create(const World& world, const building::Location& start,
                                                      const WalkSourceOptions& options = {});

    std::optional<capture::Frame> next() override;
    bool live() const override { return false; }
    double framePeriod() const override { return 1.0 / m_options.framesPerSecond; }
    std::string description() const override { return m_description; }

    // From any thread.
    /// All that was said on a frame, also if it was nothing.
    void answer(std::uint64_t frame, const std::vector<guidance::Cue>& cues);
    /// The truth of the last frame, for those who watch.
    FrameTruth truth() const;
    bool arrived() const;

private:
    WalkSource(std::unique_ptr<Walker> walker, SimulatedCamera camera, WalkSourceOptions options,
               std::string description);
    void waitForAnswer(std::unique_lock<std::mutex>& lock);

    WalkSourceOptions m_options;
    std::string m_description;
    SimulatedCamera m_camera; ///< of the thread that asks for frames

    mutable std::mutex m_mutex; ///< of all below
    std::condition_variable m_answered;
    std::unique_ptr<Walker> m_walker;
    std::vector<std::pair<double, WalkInstruction>> m_said;
    std::uint64_t m_index = 0;
    std::optional<std::uint64_t> m_lastAnswer;
    std::optional<double> m_arrivedAt;
    FrameTruth m_truth;
};

} // namespace farol::simulation
