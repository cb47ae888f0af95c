#include "ui/demo/demo.h"

#include "core/building/info.h"
#include "ui/convert/convert.h"

#include <utility>

namespace farol::ui {

namespace {

constexpr int kPauseMs = 6000; // between two visitors
/// A visitor who needs longer than this many times the way's own time, and a minute more, is fetched.
constexpr double kPatience = 4.0, kPatienceS = 60.0, kLongestS = 900.0;

} // namespace

Demo::Demo(Walk& walk, std::shared_ptr<SimulatedWalks> walks, QObject* parent)
    : QObject(parent), m_walk(walk), m_walks(std::move(walks)) {
    m_next.setSingleShot(true);
    m_next.setInterval(kPauseMs);
    connect(&m_next, &QTimer::timeout, this, &Demo::nextVisitor);
    connect(&m_walk, &Walk::sourceChanged, this, &Demo::sourceOrMapChanged);
    connect(&m_walk, &Walk::mapChanged, this, &Demo::sourceOrMapChanged);
    connect(&m_walk, &Walk::placesChanged, this, &Demo::placesChanged);
    connect(&m_walk, &Walk::walkBegan, this, &Demo::walkBegan);
    connect(&m_walk, &Walk::stepped, this, [this](const session::NavigationStep& step) {
        if (m_source) m_source->answer(step.percept.frame, step.cues);
        m_seconds = step.percept.time;
    });
    connect(&m_walk, &Walk::stateChanged, this, [this](session::RunState state) {
        if (state == session::RunState::Ended) return walkEnded();
        m_next.stop();
        if (state == session::RunState::Idle || state == session::RunState::Failed) m_source.reset();
    });
}

Walk::OpenSource Demo::opener(std::shared_ptr<SimulatedWalks> walks, Walk::OpenSource other) {
    return [walks = std::move(walks), other = std::move(other)](const std::string& name,
                                                                const capture::SourceOptions& options) {
        if (isSimulation(toQString(name))) return walks->open();
        return other ? other(name, options) : capture::openSource(name, options);
    };
}

bool Demo::on() const {
    return isSimulation(m_walk.source().name);
}

void Demo::sourceOrMapChanged() {
    m_next.stop();
    if (m_building != m_walk.building()) {
        m_building = m_walk.building();
        m_visits.reset();
        m_visit.reset();
    }
    if (on() && m_building && !m_visit) {
        m_visits = std::make_unique<simulation::Visits>(m_building);
        m_visitor = 1;
        welcome(firstVisit());
    }
    Q_EMIT changed();
}

/// From where "sim:WHERE" says; a place that is not in the map is told when the walk is opened.
std::optional<simulation::Visit> Demo::firstVisit() const {
    const QString where = startOfSimulation(m_walk.source().name);
    if (where.isEmpty()) return m_visits->visit(1);
    const auto found = building::resolveWhere(*m_building, toUtf8(where));
    if (!found) return std::nullopt;
    return m_visits->visit(1, found->region);
}

void Demo::welcome(const std::optional<simulation::Visit>& visit) {
    m_visit = visit;
    m_over = m_arrived = m_covered = m_lightsOut = false;
    m_seconds = 0.0;
    m_welcoming = true;
    m_walk.setStart(visit ? std::optional(visit->from) : std::nullopt);
    m_walk.setDestination(visit ? std::optional(visit->to) : std::nullopt);
    m_welcoming = false;
    plan();
}

void Demo::plan() {
    WalkPlan plan;
    plan.building = m_building;
    plan.seed = static_cast<std::uint64_t>(m_visitor);
    if (m_visit) {
        plan.from = m_visit->from;
        plan.mostSeconds = std::min(kLongestS, kPatience * m_visit->seconds + kPatienceS);
    }
    m_walks->plan(plan);
}

/// Somebody chose another way: the visitor who is there goes it.
void Demo::placesChanged() {
    if (m_welcoming || !on() || !m_visit) return;
    const std::optional<RegionId>& start = m_walk.start();
    const std::optional<RegionId>& goal = m_walk.destination();
    const bool elsewhere = start && *start != m_visit->from;
    const bool another = goal && *goal != m_visit->to;
    if (!elsewhere && !another) return;
    simulation::Visit visit = *m_visit;
    if (elsewhere) visit.from = *start;
    if (another) visit.to = *goal;
    if (const auto known = m_visits->between(visit.from, visit.to)) visit = *known;
    const bool walking = m_source && !m_over;
    if (elsewhere || m_over) {
        // Who has ended a walk begins the next one where it ended.
        if (!elsewhere && m_source) {
            const RegionId here = m_source->truth(UINT64_MAX).region;
            if (!here.empty()) visit = m_visits->between(here, visit.to).value_or(visit);
        }
        const bool play = walking || m_over;
        m_walk.stop();
        welcome(visit);
        if (play) m_walk.play();
    } else {
        m_visit = visit;
        plan();
        if (walking) m_source->sendOff();
    }
    Q_EMIT changed();
}

void Demo::walkBegan() {
    m_source = on() ? m_walks->current() : nullptr;
    m_over = m_arrived = m_covered = m_lightsOut = false;
    m_seconds = 0.0;
    Q_EMIT changed();
}

void Demo::walkEnded() {
    if (!on()) return;
    m_over = true;
    const bool there = m_source && m_visit && m_source->truth(UINT64_MAX).region == m_visit->to;
    m_arrived = there && m_source->arrived();
    m_next.start();
    Q_EMIT changed();
}

std::optional<simulation::FrameTruth> Demo::truth() const {
    if (!m_source || !m_walk.snapshot()) return std::nullopt;
    return m_source->truth(m_walk.snapshot()->frame.index);
}

void Demo::wrongTurn() {
    if (m_source) m_source->takeWrongTurn();
}

void Demo::setCovered(bool covered) {
    m_covered = covered && m_source;
    if (m_source) m_source->setCovered(m_covered);
    Q_EMIT changed();
}

void Demo::setLightsOut(bool out) {
    m_lightsOut = out && m_source;
    if (m_source) m_source->setLightsOut(m_lightsOut);
    Q_EMIT changed();
}

void Demo::nextVisitor() {
    m_next.stop();
    if (!on() || !m_visits) return;
    m_walk.stop();
    ++m_visitor;
    welcome(m_visits->visit(static_cast<std::uint64_t>(m_visitor)));
    m_walk.play();
    Q_EMIT changed();
}

} // namespace farol::ui
