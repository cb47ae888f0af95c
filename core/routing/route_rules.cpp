#include "core/routing/route_rules.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace farol::routing {

using building::Access;
using building::AccessKind;
using building::OneWay;
using building::Region;

namespace {

constexpr double kStairsRun = 2.0; // metres walked for each metre of height: stairs rise at about 30 degrees
constexpr double kRampRun = 12.0;  // accessible ramps rise by 1 in 12
constexpr double kStepsPerLevel = 18.0;   // 3 m at 17 cm a step
constexpr double kStairsOfNoHeight = 0.5; // of a level, where neither levels nor steps tell

bool sameLevel(double a, double b) {
    return std::abs(a - b) < 1e-6;
}

/// Drawn as a region, as importers do.
bool isWalkway(const Region& region) {
    return region.kindText == "moving_walkway";
}

} // namespace

const RouteRules::Obstacles& RouteRules::allObstacles() {
    static const Obstacles all{Obstacle::Stairs,     Obstacle::Elevator, Obstacle::Escalator,
                               Obstacle::Walkway,    Obstacle::Ramp,     Obstacle::Narrow,
                               Obstacle::Restricted, Obstacle::Closed,   Obstacle::OneWay};
    return all;
}

const char* RouteRules::obstacleWords(Obstacle obstacle) {
    switch (obstacle) {
    case Obstacle::Stairs:
        return "stairs";
    case Obstacle::Elevator:
        return "lift";
    case Obstacle::Escalator:
        return "escalator";
    case Obstacle::Walkway:
        return "moving walkway";
    case Obstacle::Ramp:
        return "ramp";
    case Obstacle::Narrow:
        return "a narrow door";
    case Obstacle::Restricted:
        return "a restricted region";
    case Obstacle::Closed:
        return "a closed access";
    case Obstacle::OneWay:
        return "a one-way access";
    }
    return "";
}

RouteRules::RouteRules(std::shared_ptr<const Building> building, RouteOptions options)
    : m_building(std::move(building)), m_options(options) {
    m_sides.reserve(m_building->accesses().size());
    for (const Access& access : m_building->accesses()) {
        auto a = m_building->regionIndex(access.regionA);
        auto b = m_building->regionIndex(access.regionB);
        if (!a || !b || a == b)
            m_sides.push_back({kNowhere, kNowhere});
        else
            m_sides.push_back({*a, *b});
    }
}

std::optional<Step> RouteRules::stepThrough(std::size_t access, std::size_t region) const {
    auto [a, b] = m_sides[access];
    if (a == kNowhere) return std::nullopt;
    if (region == a) return Step{access, a, b};
    if (region == b) return Step{access, b, a};
    return std::nullopt;
}

bool RouteRules::hasWay(std::size_t access) const {
    AccessKind kind = m_building->accesses()[access].kind;
    return kind != AccessKind::Window && kind != AccessKind::Other;
}

/// Only where the map tells a width: one that is not known is not known to be too narrow.
bool RouteRules::narrow(std::size_t access) const {
    const Access& each = m_building->accesses()[access];
    if (each.kind != AccessKind::Door && each.kind != AccessKind::Opening) return false;
    double width = each.widthM ? *each.widthM : length(each.line);
    return width > 0.0 && width < m_options.narrowDoorM - 1e-9;
}

bool RouteRules::changesLevel(const Step& step) const {
    return !sameLevel(m_building->regions()[step.from].level, m_building->regions()[step.into].level);
}

bool RouteRules::barred(std::size_t region) const {
    const Region& each = m_building->regions()[region];
    return (m_options.avoidRestricted && each.restricted) || (m_options.avoidWalkway && isWalkway(each));
}

template <class Visit>
void RouteRules::forEachObstacle(const Step& step, std::size_t start, std::size_t goal, Visit visit) const {
    const Access& access = m_building->accesses()[step.access];
    if (access.closed) visit(Obstacle::Closed);
    if (access.kind == AccessKind::Stairs && m_options.avoidStairs) visit(Obstacle::Stairs);
    if (access.kind == AccessKind::Elevator && m_options.avoidElevator) visit(Obstacle::Elevator);
    if (access.kind == AccessKind::Escalator) {
        // What moves and stays on its level is a moving walkway.
        if (changesLevel(step) && m_options.avoidEscalator) visit(Obstacle::Escalator);
        if (!changesLevel(step) && m_options.avoidWalkway) visit(Obstacle::Walkway);
    }
    if (access.kind == AccessKind::Ramp && m_options.avoidRamp) visit(Obstacle::Ramp);
    if (m_options.avoidNarrow && narrow(step.access)) visit(Obstacle::Narrow);
    if (access.oneWay == (step.from == m_sides[step.access][0] ? OneWay::BToA : OneWay::AToB))
        visit(Obstacle::OneWay);
    // One may leave a region one is in, and go to one that is asked for.
    if (step.into == goal || step.into == start) return;
    const Region& into = m_building->regions()[step.into];
    if (m_options.avoidRestricted && into.restricted) visit(Obstacle::Restricted);
    if (m_options.avoidWalkway && isWalkway(into)) visit(Obstacle::Walkway);
}

RouteRules::Obstacles RouteRules::obstacles(const Step& step, std::size_t start, std::size_t goal) const {
    Obstacles found;
    forEachObstacle(step, start, goal, [&](Obstacle each) { found.insert(each); });
    return found;
}

bool RouteRules::allowed(const Step& step) const {
    return allowed(step, step.into, step.into);
}

bool RouteRules::allowed(const Step& step, std::size_t start, std::size_t goal) const {
    bool free = hasWay(step.access);
    forEachObstacle(step, start, goal, [&](Obstacle) { free = false; });
    return free;
}

std::vector<Step> RouteRules::stepsFrom(std::size_t region, std::size_t start, std::size_t goal) const {
    std::vector<Step> steps;
    for (std::size_t index : m_building->accessesOf(region)) {
        auto step = stepThrough(index, region);
        if (step && allowed(*step, start, goal)) steps.push_back(*step);
    }
    return steps;
}

double RouteRules::heightM(const Step& step) const {
    double from = m_building->regions()[step.from].level;
    double into = m_building->regions()[step.into].level;
    if (sameLevel(from, into)) return 0.0;
    const building::Level* a = m_building->level(from);
    const building::Level* b = m_building->level(into);
    if (a != nullptr && b != nullptr && a->elevationM && b->elevationM)
        return std::abs(*a->elevationM - *b->elevationM);
    return std::abs(from - into) * m_options.storeyHeightM;
}

double RouteRules::verticalM(const Step& step) const {
    AccessKind kind = m_building->accesses()[step.access].kind;
    if (kind == AccessKind::Stairs || kind == AccessKind::Escalator) return kStairsRun * heightM(step);
    return kind == AccessKind::Ramp ? kRampRun * heightM(step) : 0.0; // in a lift one stands
}

bool RouteRules::isLift(std::size_t access) const {
    return m_building->accesses()[access].kind == AccessKind::Elevator;
}

double RouteRules::liftSeconds(const Step& step, const Step* previous) const {
    const Access& access = m_building->accesses()[step.access];
    double levels = levelsOf(step);
    // In the car: the same shaft, or the map says that the region between is a lift.
    bool inCar =
        !access.shaft.empty() || m_building->regions()[step.from].kind == building::RegionKind::Elevator;
    bool riding = inCar && previous != nullptr && isLift(previous->access) &&
                  m_building->accesses()[previous->access].shaft == access.shaft;
    // The first level of a ride includes the wait.
    double further = riding ? levels : std::max(0.0, levels - 1.0);
    return (riding ? 0.0 : m_options.elevatorSeconds) + m_options.elevatorSecondsPerLevel * further;
}

/// A few steps within one level take their part of a level's time.
double RouteRules::stairsSeconds(const Step& step) const {
    if (changesLevel(step)) return m_options.stairsSecondsPerLevel * levelsOf(step);
    const auto& steps = m_building->accesses()[step.access].steps;
    return m_options.stairsSecondsPerLevel * (steps ? std::abs(*steps) / kStepsPerLevel : kStairsOfNoHeight);
}

double RouteRules::levelsOf(const Step& step) const {
    return std::abs(m_building->regions()[step.from].level - m_building->regions()[step.into].level);
}

double RouteRules::seconds(const Step& step, const Step* previous) const {
    double narrowSeconds = narrow(step.access) ? m_options.narrowDoorSeconds : 0.0;
    switch (m_building->accesses()[step.access].kind) {
    case AccessKind::Door:
        return m_options.doorSeconds + narrowSeconds;
    case AccessKind::Stairs:
        return stairsSeconds(step);
    case AccessKind::Escalator:
        return changesLevel(step) ? m_options.escalatorSecondsPerLevel * levelsOf(step)
                                  : m_options.walkwaySeconds;
    case AccessKind::Ramp:
        return m_options.rampSeconds + walkingSeconds(verticalM(step));
    case AccessKind::Elevator:
        return liftSeconds(step, previous);
    case AccessKind::Opening:
        return narrowSeconds;
    case AccessKind::Window:
    case AccessKind::Other:
        return 0.0;
    }
    return 0.0;
}

/// The way with the fewest obstacles, all of them of the kinds allowed; no steps when there is none.
std::vector<Step> RouteRules::fewestObstacles(const Obstacles& allowed, std::size_t from,
                                              std::size_t to) const {
    std::vector<std::size_t> cost(m_building->regions().size(), kNowhere);
    std::vector<std::optional<Step>> by(m_building->regions().size());
    using Entry = std::pair<std::size_t, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    open.emplace(0, from);
    cost[from] = 0;
    while (!open.empty()) {
        auto [paid, region] = open.top();
        open.pop();
        if (paid > cost[region]) continue;
        if (region == to) break;
        for (std::size_t index : m_building->accessesOf(region)) {
            auto step = stepThrough(index, region);
            if (!step || !hasWay(index)) continue;
            std::size_t whole = paid;
            bool barredWay = false;
            forEachObstacle(*step, from, to, [&](Obstacle each) {
                ++whole;
                barredWay = barredWay || allowed.count(each) == 0;
            });
            if (barredWay || whole >= cost[step->into]) continue;
            cost[step->into] = whole;
            by[step->into] = *step;
            open.emplace(whole, step->into);
        }
    }
    std::vector<Step> steps;
    for (std::size_t at = to; at != from && by[at]; at = by[at]->from) steps.push_back(*by[at]);
    std::reverse(steps.begin(), steps.end());
    return steps;
}

bool RouteRules::reachable(std::size_t from, std::size_t to) const {
    return from == to || !fewestObstacles({}, from, to).empty();
}

/// Where the obstacle stands first on the way with the fewest of those allowed, if it does.
void RouteRules::addBarrier(NoRoute& why, Obstacle obstacle, const Obstacles& allowed, std::size_t from,
                            std::size_t to) const {
    for (const Step& step : fewestObstacles(allowed, from, to)) {
        if (obstacles(step, from, to).count(obstacle) == 0) continue;
        why.past.push_back(
            {obstacle, m_building->regions()[step.from].id, m_building->regions()[step.into].id});
        return;
    }
}

NoRoute RouteRules::noRoute(std::size_t from, std::size_t to) const {
    NoRoute why{m_building->regions()[from].id, m_building->regions()[to].id, {}, {}};
    if (fewestObstacles(allObstacles(), from, to).empty()) return why;
    // What would do by itself is told, all of it; else what stands on the way with the fewest obstacles.
    for (Obstacle obstacle : {Obstacle::Stairs, Obstacle::Elevator, Obstacle::Escalator, Obstacle::Walkway,
                              Obstacle::Ramp, Obstacle::Narrow, Obstacle::Restricted})
        if (!fewestObstacles({obstacle}, from, to).empty()) why.anyOf.push_back(obstacle);
    if (!why.anyOf.empty()) return why;
    for (Obstacle obstacle : {Obstacle::Closed, Obstacle::OneWay}) {
        if (fewestObstacles({obstacle}, from, to).empty()) continue;
        addBarrier(why, obstacle, {obstacle}, from, to);
        return why;
    }
    for (Obstacle obstacle : allObstacles()) addBarrier(why, obstacle, allObstacles(), from, to);
    return why;
}

std::string RouteRules::inWords(const NoRoute::Barrier& barrier) const {
    return " (" + spokenName(*m_building->region(barrier.from)) + " to " +
           spokenName(*m_building->region(barrier.into)) + ")";
}

Error RouteRules::unreachable(std::size_t from, std::size_t to) const {
    std::string start = spokenName(m_building->regions()[from]);
    std::string goal = spokenName(m_building->regions()[to]);
    std::string context = start + " to " + goal;
    const NoRoute why = noRoute(from, to);
    if (!why.joined())
        return {ErrorCode::NotFound,
                "there is no way at all: the map joins " + goal + " and " + start + " by no access", context};
    std::string text;
    for (Obstacle obstacle : why.anyOf)
        text += (text.empty() ? "" : " or ") + std::string(obstacleWords(obstacle));
    if (!why.anyOf.empty()) {
        const bool several = why.anyOf.size() > 1 || why.anyOf.front() == Obstacle::Stairs;
        text = "by " + text + " only, which " + (several ? "are" : "is") + " to be avoided";
    } else if (why.past.size() == 1 && why.past.front().obstacle == Obstacle::Closed) {
        text = "through a closed access only" + inWords(why.past.front());
    } else if (why.past.size() == 1 && why.past.front().obstacle == Obstacle::OneWay) {
        text = "against a one-way access only" + inWords(why.past.front());
    } else {
        for (const NoRoute::Barrier& barrier : why.past)
            text += (text.empty() ? "" : " and ") + std::string(obstacleWords(barrier.obstacle)) +
                    inWords(barrier);
        text = "past " + text + " only";
    }
    return {ErrorCode::NotFound, goal + " can be reached " + text, context};
}

} // namespace farol::routing
