#include "core/simulation/path_camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace farol::simulation {

namespace {

constexpr double kTurnPerSecond = 1.2; ///< radians

double turnBetween(Radians from, Radians to) {
    return std::remainder(to.value - from.value, 2.0 * 3.14159265358979323846);
}

} // namespace

std::vector<CameraPose> walkThrough(const std::vector<CameraPose>& stands, double speed,
                                    double framesPerSecond) {
    std::vector<CameraPose> poses;
    if (stands.empty() || !(speed > 0.0) || !(framesPerSecond > 0.0)) return poses;
    double period = 1.0 / framesPerSecond, time = 0.0;
    auto add = [&](CameraPose pose, double pace, double turn) {
        pose.time = time;
        pose.speed = pace;
        pose.turnRate = Radians{turn};
        poses.push_back(pose);
        time += period;
    };
    auto turnTo = [&](CameraPose& at, Radians heading) {
        double turn = turnBetween(at.heading, heading);
        int frames = static_cast<int>(std::ceil(std::abs(turn) / (kTurnPerSecond * period)));
        Radians start = at.heading;
        for (int i = 1; i <= frames; ++i) {
            at.heading = Radians{start.value + turn * i / frames};
            add(at, 0.0, turn / (frames * period));
        }
        at.heading = heading;
    };
    CameraPose at = stands.front();
    add(at, 0.0, 0.0);
    for (std::size_t i = 1; i < stands.size(); ++i) {
        Point2 way = stands[i].position - at.position;
        double metres = length(way);
        double rise = stands[i].level - at.level;
        if (metres > 1.0e-6) turnTo(at, directionOf(way));
        CameraPose from = at;
        int frames = std::max(1, static_cast<int>(std::ceil(metres / (speed * period))));
        for (int k = 1; k <= frames; ++k) {
            double share = static_cast<double>(k) / frames;
            at.position = from.position + way * share;
            at.level = from.level + rise * share;
            add(at, metres / (frames * period), 0.0);
        }
        turnTo(at, stands[i].heading);
    }
    return poses;
}

PathCamera::PathCamera(SimulatedCamera camera, std::vector<CameraPose> poses, std::string name)
    : m_camera(std::move(camera)), m_poses(std::move(poses)), m_name(std::move(name)) {}

double PathCamera::framePeriod() const {
    return m_poses.size() > 1 ? m_poses[1].time - m_poses[0].time : 0.0;
}

std::string PathCamera::description() const {
    return m_name + " (" + std::to_string(m_poses.size()) + " pictures)";
}

std::optional<capture::Frame> PathCamera::next() {
    while (m_next < m_poses.size() && !stopRequested()) {
        const CameraPose& pose = m_poses[m_next++];
        Result<RenderedFrame> rendered = m_camera.render(pose);
        if (!rendered) {
            ++m_skipped;
            tell(capture::SourceEventKind::FrameSkipped, rendered.error().text());
            continue;
        }
        m_truth = std::move(rendered->truth);
        capture::Frame frame;
        frame.index = m_delivered++;
        frame.capturedAt = pose.time;
        frame.image = std::move(rendered->image);
        frame.arrivedAt = std::chrono::steady_clock::now();
        return frame;
    }
    return std::nullopt;
}

} // namespace farol::simulation
