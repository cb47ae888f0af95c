#pragma once
// A walk that is fixed beforehand, as a source of frames like any other.

#include "core/capture/frame_source.h"
#include "core/simulation/simulated_camera.h"

#include <string>
#include <vector>

namespace farol::simulation {

/// Poses between two stands, `framesPerSecond` of them each second at `speed` metres a second: straight on
/// from one to the next, turning on the spot at the corners. The stands' own times are of no account.
std::vector<CameraPose> walkThrough(const std::vector<CameraPose>& stands, double speed,
                                    double framesPerSecond);

/// Renders one frame for each pose, with the pose's time. A pose that is none is skipped and told by an
/// event.
class PathCamera : public capture::FrameSource {
public:
    PathCamera(SimulatedCamera camera, std::vector<CameraPose> poses, std::string name = "simulated walk");

    std::optional<capture::Frame> next() override;
    bool live() const override { return false; }
    std::optional<std::uint64_t> frameCount() const override { return m_poses.size(); }
    double framePeriod() const override;
    std::string description() const override;
    std::uint64_t skippedFrames() const override { return m_skipped; }

    const FrameTruth& truth() const { return m_truth; } ///< of the frame that came last

private:
    SimulatedCamera m_camera;
    std::vector<CameraPose> m_poses;
    std::string m_name;
    std::size_t m_next = 0;
    std::uint64_t m_delivered = 0, m_skipped = 0;
    FrameTruth m_truth;
};

} // namespace farol::simulation
