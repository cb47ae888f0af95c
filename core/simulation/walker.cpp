#include "core/simulation/walker.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

namespace {

constexpr double kTickS = 0.1;
/// Of a body that walks: two steps a second, a few degrees and centimetres each.
constexpr double kStepsPerSecond = 1.8, kRollDeg = 1.2, kBobM = 0.015;

Point2 somewhereIn(const Polygon& polygon, localisation::Random& random) {
    auto box = boundingBox(polygon.outer);
    for (int i = 0; box && i < 60; ++i) {
        Point2 p{box->low.x + box->width() * random.uniformDouble(),
                 box->low.y + box->height() * random.uniformDouble()};
        if (contains(polygon, p)) return p;
    }
    return pointInside(polygon);
}

} // namespace

Result<std::unique_ptr<Walker>> Walker::create(std::shared_ptr<const WalkWorld> world,
                                               const building::Location& start,
                                               const WalkerOptions& options) {
    if (auto checked = options.check(); !checked) return checked.error();
    auto region = world->building().regionIndex(start.region);
    if (!region)
        return Error{ErrorCode::NotFound,
                     "the walker cannot start in " + start.region.value + ": it is not in the map", ""};
    return std::unique_ptr<Walker>(new Walker(std::move(world), *region, start, options));
}

Walker::Walker(std::shared_ptr<const WalkWorld> world, std::size_t region, const building::Location& start,
               const WalkerOptions& options)
    : m_world(std::move(world)),
      m_options(options),
      m_random(options.seed * 0x9e3779b97f4a7c15ULL + 0x51ULL),
      m_mind(options, m_random),
      m_body(m_world, region,
             start.position ? *start.position
                            : somewhereIn(m_world->building().regions()[region].polygon, m_random),
             Radians{2.0 * kPi * m_random.uniformDouble()}, options) {}

void Walker::hear(const WalkInstruction& instruction) {
    if (instruction.stop) m_body.stop();
    m_mind.hear(instruction);
}

void Walker::walkUntil(double time) {
    while (m_time < time - 1e-9) {
        double seconds = std::min(kTickS, time - m_time);
        Radians yaw = m_mind.cameraYaw();
        Wish wish;
        if (m_body.busy())
            m_mind.pass(seconds);
        else
            wish = m_mind.decide(seconds, m_body.touch());
        if (wish.take) m_body.take(*wish.take, wish.level);
        m_body.step(seconds, wish.speed, wish.turnRate);
        if (auto passed = m_body.takePassed()) m_mind.passed(*passed);
        m_cameraTurnRate = m_body.turnRate().value + wrapped(m_mind.cameraYaw() - yaw).value / seconds;
        m_time += seconds;
    }
    m_time = time;
}

const RegionId& Walker::region() const {
    return m_world->building().regions()[m_body.region()].id;
}

CameraPose Walker::pose() const {
    CameraPose pose;
    pose.time = m_time;
    pose.position = m_body.position();
    pose.level = m_body.level();
    pose.heading = wrapped(m_body.heading() + m_mind.cameraYaw());
    pose.pitch = m_mind.cameraPitch();
    double moving = std::min(1.0, m_body.speed() / m_options.speed);
    double phase = 2.0 * kPi * kStepsPerSecond * m_time;
    pose.roll = fromDegrees(kRollDeg * moving * std::sin(phase / 2.0));
    pose.eyeHeightM = m_options.eyeHeightM + kBobM * moving * std::sin(phase);
    pose.speed = m_body.speed();
    pose.turnRate = Radians{m_cameraTurnRate};
    return pose;
}

} // namespace farol::simulation
