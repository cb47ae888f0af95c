#include "ui/demo/simulated_user.h"

#include "core/building/info.h"
#include "core/simulation/visits.h"
#include "ui/convert/convert.h"

#include <utility>

namespace farol::ui {

namespace {

constexpr double kForeverS = 1e7; // a kiosk runs for months

} // namespace

SimulatedUser::SimulatedUser(Walk& walk, std::shared_ptr<SimulatedWalks> walks, QObject* parent)
    : QObject(parent), m_walk(walk), m_walks(std::move(walks)) {
    connect(&m_walk, &Walk::mapChanged, this, &SimulatedUser::plan);
    connect(&m_walk, &Walk::walkBegan, this, [this] {
        m_heard.clear();
        m_region = {};
        m_source = isSimulation(m_walk.source().name) ? m_walks->current() : nullptr;
    });
    connect(&m_walk, &Walk::stepped, this, &SimulatedUser::listen);
}

void SimulatedUser::listen(const session::NavigationStep& step) {
    if (!m_source) return;
    // Also of nothing heard: the walker waits for it.
    m_source->answer(step.percept.frame, std::exchange(m_heard, {}));
    const RegionId region = m_source->truth(step.percept.frame).region;
    if (region.empty() || region == m_region) return;
    m_region = region;
    Q_EMIT movedTo(m_region);
}

/// Where the user stands: as the source says, else where the walk is to start, else anywhere. A place that is
/// not in the map is told when the source is opened.
void SimulatedUser::plan() {
    if (!isSimulation(m_walk.source().name) || !m_walk.building()) return;
    WalkPlan plan;
    plan.building = m_walk.building();
    plan.mostSeconds = plan.afterArrivalS = kForeverS;
    const QString where = startOfSimulation(m_walk.source().name);
    if (!where.isEmpty()) {
        if (const auto found = building::resolveWhere(*plan.building, toUtf8(where)))
            plan.from = found->region;
    } else if (m_walk.start()) {
        plan.from = *m_walk.start();
    } else if (const auto visit = simulation::Visits(plan.building).visit(1)) {
        plan.from = visit->from;
    }
    const RegionId from = plan.from;
    m_walks->plan(std::move(plan));
    if (!m_walk.start() && !from.empty()) m_walk.setStart(from);
}

void SimulatedUser::hear(const guidance::Cue& cue) {
    if (m_source) m_heard.push_back(cue);
}

void SimulatedUser::setOut() {
    m_heard.clear(); // was of the way before
    if (m_source) m_source->sendOff();
}

void SimulatedUser::stand() {
    guidance::Cue halt;
    halt.kind = guidance::CueKind::NoRoute;
    hear(halt);
}

} // namespace farol::ui
