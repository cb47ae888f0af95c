#pragma once
// A camera worn by a simulated walker, as a source of frames: whoever is guided by the frames tells the
// walker the cues, and the walker walks on them. It waits for the answers, so that the same seed gives the
// same walk however fast the machine is.

#include "core/capture/frame_source.h"
#include "core/simulation/simulated_camera.h"
#include "core/simulation/walker.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace farol::simulation {

struct WalkSourceOptions {
    WalkerOptions walker;
    CameraOptions camera;
    double framesPerSecond = 10.0;
    double mostSeconds = 1800.0; ///< then the walker is fetched
    double hearingSeconds = 1.0; ///< from a cue to what is done on it
    double afterArrivalS = 3.0;  ///< of frames once the walker stands

    Result<void> check() const;
};

class WalkSource : public capture::FrameSource {
public:
    static Result<std::unique_ptr<WalkSource>> create(const World& world, const building::Location& start,
                                                      const WalkSourceOptions& options = {});

    std::optional<capture::Frame> next() override;
    bool live() const override { return false; }
    bool keepsPace() const override { return true; }
    void setSpeed(double factor) override; ///< before the first call: as fast as possible
    double framePeriod() const override { return 1.0 / m_options.framesPerSecond; }
    std::string description() const override { return m_description; }

    // From any thread.
    /// All that was said on a frame, also if it was nothing.
    void answer(std::uint64_t frame, const std::vector<guidance::Cue>& cues);
    /// The truth of a frame of late, for those who watch; of the nearest one that is remembered.
    FrameTruth truth(std::uint64_t frame) const;
    bool arrived() const;
    /// The way was left on purpose; see WalkMind.
    void takeWrongTurn();
    void setCovered(bool covered); ///< a hand lies on the lens
    void setLightsOut(bool out);
    /// Somebody who arrived, or is about to be fetched, is given another way to go.
    void sendOff();

private:
    WalkSource(std::unique_ptr<Walker> walker, SimulatedCamera camera, WalkSourceOptions options,
               std::string description);
    void waitForAnswer(std::unique_lock<std::mutex>& lock);
    void waitForTurn(std::unique_lock<std::mutex>& lock);
    bool walkTo(double time);

    WalkSourceOptions m_options;
    std::string m_description;
    SimulatedCamera m_camera; ///< of the thread that asks for frames

    mutable std::mutex m_mutex; ///< of all below
    std::condition_variable m_changed;
    std::unique_ptr<Walker> m_walker;
    std::vector<std::pair<double, WalkInstruction>> m_said;
    std::uint64_t m_index = 0;
    std::optional<std::uint64_t> m_lastAnswer;
    std::optional<double> m_arrivedAt;
    double m_sentOffAt = 0.0;
    double m_speed = 0.0; ///< 0: as fast as possible
    std::chrono::steady_clock::time_point m_turn;
    bool m_covered = false, m_lightsOut = false;
    std::deque<std::pair<std::uint64_t, FrameTruth>> m_truths; ///< of the last frames
};

} // namespace farol::simulation
