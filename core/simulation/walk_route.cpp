#include "core/simulation/walk_route.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

namespace {

constexpr double kTickS = 0.05, kClimbSPerLevel = 15.0, kTurnRate = 1.4, kTurnsOnTheSpot = 0.8;

class RouteWalk {
public:
    RouteWalk(const routing::Route& route, const WalkerOptions& options)
        : m_path(route.path), m_options(options), m_random(options.seed * 0x9e3779b97f4a7c15ULL + 0x77ULL) {
        m_phase = 2.0 * kPi * m_random.uniformDouble();
        m_pose.position = m_path.front().position;
        m_pose.level = m_path.front().level;
        m_pose.eyeHeightM = options.eyeHeightM;
        m_heading = m_path.size() > 1 ? directionOf(m_path[1].position - m_path[0].position).value : 0.0;
    }

    bool over() const { return m_next >= m_path.size(); }
    void tick();
    CameraPose pose(double time) const {
        CameraPose pose = m_pose;
        pose.time = time;
        double yaw = fromDegrees(m_options.swayDeg).value * std::sin(m_phase);
        pose.heading = wrapped(Radians{m_heading + yaw});
        return pose;
    }

private:
    const std::vector<routing::PathPoint>& m_path;
    WalkerOptions m_options;
    localisation::Random m_random;
    std::size_t m_next = 1;
    double m_heading = 0.0, m_phase = 0.0;
    CameraPose m_pose;
};

void RouteWalk::tick() {
    m_phase += 2.0 * kPi * kTickS / m_options.swaySeconds * (1.0 + 0.3 * m_random.normal());
    const routing::PathPoint& to = m_path[m_next];
    double climb = to.level - m_pose.level, turned = 0.0;
    m_pose.speed = 0.0;
    if (std::abs(climb) > 1e-9) {
        double most = kTickS / kClimbSPerLevel;
        m_pose.level += std::clamp(climb, -most, most);
        if (std::abs(climb) > most) return;
        m_pose.level = to.level;
    }
    Point2 way = to.position - m_pose.position;
    double left = length(way);
    if (left > 1e-6) {
        double off = wrapped(Radians{directionOf(way).value - m_heading}).value;
        turned = std::clamp(off, -kTurnRate * kTickS, kTurnRate * kTickS);
        m_heading += turned;
        if (std::abs(off) > kTurnsOnTheSpot) left = std::max(left, 1e-3);
        double gone = std::abs(off) > kTurnsOnTheSpot ? 0.0 : std::min(left, m_options.speed * kTickS);
        m_pose.position = m_pose.position + way * (gone / left);
        m_pose.speed = gone / kTickS;
        if (gone < left) {
            m_pose.turnRate = Radians{turned / kTickS};
            return;
        }
    }
    m_pose.turnRate = Radians{turned / kTickS};
    m_pose.position = to.position;
    ++m_next;
}

} // namespace

std::vector<CameraPose> posesAlong(const routing::Route& route, const WalkerOptions& options,
                                   double framesPerSecond) {
    std::vector<CameraPose> poses;
    if (route.path.empty() || !(framesPerSecond > 0.0)) return poses;
    RouteWalk walk(route, options);
    double ticked = 0.0;
    for (std::size_t index = 0;; ++index) {
        double time = static_cast<double>(index) / framesPerSecond;
        for (; ticked + kTickS <= time + 1e-9 && !walk.over(); ticked += kTickS) walk.tick();
        poses.push_back(walk.pose(time));
        if (walk.over()) return poses;
    }
}

} // namespace farol::simulation
