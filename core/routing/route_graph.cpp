#include "core/routing/route_graph.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <utility>

namespace farol::routing {

using building::Access;
using building::AccessKind;
using building::OneWay;
using building::Region;

namespace {

constexpr double kStairsRun = 2.0;      // metres walked for each metre of height: stairs rise at about 30 degrees
constexpr double kRampRun = 12.0;       // accessible ramps rise by 1 in 12
constexpr double kWideOpeningM = 1.2;   // from here on one does not aim for the middle
constexpr double kOpeningMarginM = 0.4; // half a person, kept from the ends of a wide opening
constexpr int kSlides = 12;

bool sameLevel(double a, double b) { return std::abs(a - b) < 1e-6; }

/// The point of a-b over which the way from `from` to `to` is shortest.
Point2 bestCrossing(Point2 a, Point2 b, Point2 from, Point2 to) {
    Point2 along = b - a;
    Point2 normal{-along.y, along.x};
    double sideFrom = dot(from - a, normal);
    double sideTo = dot(to - a, normal);
    // Mirrored to the other side where both lie on one; then the straight line between them crosses.
    double gap = std::abs(sideFrom) + std::abs(sideTo);
    double squared = dot(along, along);
    if (squared <= 0.0) return a;
    double atFrom = dot(from - a, along) / squared;
    double atTo = dot(to - a, along) / squared;
    double share = gap > 0.0 ? std::abs(sideFrom) / gap : 0.5;
    return a + along * std::clamp(atFrom + (atTo - atFrom) * share, 0.0, 1.0);
}

} // namespace

struct RouteGraph::Room {
    std::once_flag spaceOnce;
    std::unique_ptr<WalkingSpace> space;
    std::once_flag lengthsOnce;
    std::vector<double> lengths; ///< between its accesses, row by row
};

RouteGraph::RouteGraph(std::shared_ptr<const Building> building, RouteOptions options)
    : m_building(std::move(building)), m_options(options),
      m_rooms(std::make_unique<Room[]>(m_building->regions().size())) {}

RouteGraph::~RouteGraph() = default;

Result<Endpoint> RouteGraph::endpoint(const Location& location, const std::string& role) const {
    auto index = m_building->regionIndex(location.region);
    if (!index)
        return Error{ErrorCode::NotFound, "the map has no region \"" + location.region.value + "\"", role};
    const Polygon& polygon = m_building->regions()[*index].polygon;
    Point2 position = location.position.value_or(pointInside(polygon));
    if (!isFinite(position)) return Error{ErrorCode::InvalidArgument, "the position is no number", role};
    if (!location.position || contains(polygon, position)) return Endpoint{*index, position};
    Polyline path = space(*index).pathTo(space(*index).from(position), pointInside(polygon));
    return Endpoint{*index, path.size() > 1 ? path[1] : position};
}

std::optional<RouteGraph::Obstacles> RouteGraph::obstacles(const Step& step, std::size_t start,
                                                           std::size_t goal) const {
    const Access& access = m_building->accesses()[step.access];
    if (access.kind == AccessKind::Window || access.kind == AccessKind::Other) return std::nullopt;
    Obstacles found;
    if (access.closed) found.insert(Obstacle::Closed);
    if (access.kind == AccessKind::Stairs && m_options.avoidStairs) found.insert(Obstacle::Stairs);
    if (access.kind == AccessKind::Elevator && m_options.avoidElevator) found.insert(Obstacle::Elevator);
    if (access.kind == AccessKind::Escalator && m_options.avoidEscalator) found.insert(Obstacle::Escalator);
    bool forward = m_building->regions()[step.from].id == access.regionA;
    if (access.oneWay == (forward ? OneWay::BToA : OneWay::AToB)) found.insert(Obstacle::OneWay);
    // One may leave a restricted region one is in, and go to one that is asked for.
    if (m_options.avoidRestricted && m_building->regions()[step.into].restricted && step.into != goal &&
        step.into != start)
        found.insert(Obstacle::Restricted);
    return found;
}

std::vector<Step> RouteGraph::stepsFrom(std::size_t region, std::size_t start, std::size_t goal) const {
    std::vector<Step> steps;
    for (std::size_t index : m_building->accessesOf(region)) {
        auto other = m_building->otherSide(m_building->accesses()[index], region);
        if (!other) continue;
        Step step{index, region, *other};
        auto found = obstacles(step, start, goal);
        if (found && found->empty()) steps.push_back(step);
    }
    return steps;
}

double RouteGraph::heightM(const Step& step) const {
    double from = m_building->regions()[step.from].level;
    double into = m_building->regions()[step.into].level;
    if (sameLevel(from, into)) return 0.0;
    const building::Level* a = m_building->level(from);
    const building::Level* b = m_building->level(into);
    if (a != nullptr && b != nullptr && a->elevationM && b->elevationM) return std::abs(*a->elevationM - *b->elevationM);
    return std::abs(from - into) * m_options.storeyHeightM;
}

double RouteGraph::verticalM(const Step& step) const {
    AccessKind kind = m_building->accesses()[step.access].kind;
    if (kind == AccessKind::Stairs || kind == AccessKind::Escalator) return kStairsRun * heightM(step);
    return kind == AccessKind::Ramp ? kRampRun * heightM(step) : 0.0; // in a lift one stands
}

double RouteGraph::seconds(const Step& step, const Step* previous) const {
    const Access& access = m_building->accesses()[step.access];
    double levels = std::abs(m_building->regions()[step.from].level - m_building->regions()[step.into].level);
    switch (access.kind) {
    case AccessKind::Door: return m_options.doorSeconds;
    case AccessKind::Stairs:
    case AccessKind::Escalator: return m_options.stairsSecondsPerLevel * levels;
    case AccessKind::Ramp: return walkingSeconds(verticalM(step));
    case AccessKind::Elevator: {
        // In the car: the same shaft, or the map says that the region between is a lift.
        bool inCar = !access.shaft.empty() || m_building->regions()[step.from].kind == building::RegionKind::Elevator;
        bool riding = inCar && previous != nullptr &&
                      m_building->accesses()[previous->access].kind == AccessKind::Elevator &&
                      m_building->accesses()[previous->access].shaft == access.shaft;
        // The first level of a ride includes the wait.
        double further = riding ? levels : std::max(0.0, levels - 1.0);
        return (riding ? 0.0 : m_options.elevatorSeconds) + m_options.elevatorSecondsPerLevel * further;
    }
    case AccessKind::Opening:
    case AccessKind::Window:
    case AccessKind::Other: return 0.0;
    }
    return 0.0;
}

const WalkingSpace& RouteGraph::space(std::size_t region) const {
    Room& room = m_rooms[region];
    std::call_once(room.spaceOnce, [&] {
        room.space = std::make_unique<WalkingSpace>(m_building->regions()[region].polygon);
    });
    return *room.space;
}

double RouteGraph::between(std::size_t region, std::size_t accessA, std::size_t accessB) const {
    auto accesses = m_building->accessesOf(region);
    Room& room = m_rooms[region];
    std::call_once(room.lengthsOnce, [&] {
        const WalkingSpace& walking = space(region);
        std::vector<double> lengths;
        lengths.reserve(accesses.size() * accesses.size());
        for (std::size_t a : accesses) {
            auto tree = walking.from(m_building->accesses()[a].midpoint());
            for (std::size_t b : accesses)
                lengths.push_back(a == b ? 0.0 : walking.lengthTo(tree, m_building->accesses()[b].midpoint()));
        }
        room.lengths = std::move(lengths);
    });
    auto position = [&](std::size_t access) { // accessesOf is in the order of the map
        return static_cast<std::size_t>(std::lower_bound(accesses.begin(), accesses.end(), access) - accesses.begin());
    };
    return room.lengths[position(accessA) * accesses.size() + position(accessB)];
}

/// The way with the fewest obstacles, whatever they are (a breadth-first search with weights 0 and more).
std::vector<Step> RouteGraph::fewestObstacles(std::size_t from, std::size_t to) const {
    std::vector<std::size_t> cost(m_building->regions().size(), static_cast<std::size_t>(-1));
    std::vector<std::optional<Step>> by(m_building->regions().size());
    std::deque<std::pair<std::size_t, std::size_t>> open{{0, from}};
    cost[from] = 0;
    while (!open.empty()) {
        auto nearest = std::min_element(open.begin(), open.end());
        auto [paid, region] = *nearest;
        open.erase(nearest);
        if (paid > cost[region]) continue;
        for (std::size_t index : m_building->accessesOf(region)) {
            auto other = m_building->otherSide(m_building->accesses()[index], region);
            if (!other) continue;
            Step step{index, region, *other};
            auto found = obstacles(step, from, to);
            if (!found || paid + found->size() >= cost[*other]) continue;
            cost[*other] = paid + found->size();
            by[*other] = step;
            open.emplace_back(cost[*other], *other);
        }
    }
    std::vector<Step> steps;
    for (std::size_t at = to; at != from && by[at]; at = by[at]->from) steps.push_back(*by[at]);
    std::reverse(steps.begin(), steps.end());
    return steps;
}

std::string RouteGraph::reason(const std::vector<Step>& steps, std::size_t from, std::size_t to) const {
    std::map<Obstacle, std::string> where; // the first of each kind
    for (const Step& step : steps) {
        std::string sides = spokenName(m_building->regions()[step.from]) + " to " +
                            spokenName(m_building->regions()[step.into]);
        for (Obstacle each : obstacles(step, from, to).value_or(Obstacles())) where.emplace(each, sides);
    }
    auto phrase = [](Obstacle obstacle, const std::string& sides) -> std::string {
        switch (obstacle) {
        case Obstacle::Stairs: return "by stairs only, which are to be avoided";
        case Obstacle::Elevator: return "by lift only, which is to be avoided";
        case Obstacle::Escalator: return "by escalator only, which is to be avoided";
        case Obstacle::Restricted: return "through a restricted region only, which is to be avoided (" + sides + ")";
        case Obstacle::Closed: return "through a closed access only (" + sides + ")";
        case Obstacle::OneWay: return "against a one-way access only (" + sides + ")";
        }
        return {};
    };
    std::string text;
    for (const auto& [obstacle, sides] : where) text += (text.empty() ? "" : ", and ") + phrase(obstacle, sides);
    return text;
}

bool RouteGraph::reachable(std::size_t from, std::size_t to) const {
    std::vector<Step> steps = fewestObstacles(from, to);
    return from == to || (!steps.empty() && reason(steps, from, to).empty());
}

Error RouteGraph::unreachable(std::size_t from, std::size_t to) const {
    std::string start = spokenName(m_building->regions()[from]);
    std::string goal = spokenName(m_building->regions()[to]);
    std::string context = start + " to " + goal;
    std::vector<Step> steps = fewestObstacles(from, to);
    if (steps.empty())
        return {ErrorCode::NotFound, "there is no way at all: the map joins " + goal + " and " + start + " by no access",
                context};
    return {ErrorCode::NotFound, goal + " can be reached " + reason(steps, from, to), context};
}

/// Moves crossing `i` of a wide opening to where the way over it is shortest.
void RouteGraph::slide(std::vector<Point2>& points, const std::vector<Step>& steps, std::size_t i) const {
    const Access& access = m_building->accesses()[steps[i - 1].access];
    if (access.kind != AccessKind::Opening || access.line.size() != 2) return;
    double width = length(access.line);
    if (width < kWideOpeningM) return;
    Point2 inset = (access.line[1] - access.line[0]) * (kOpeningMarginM / width);
    Point2 a = access.line[0] + inset;
    Point2 b = access.line[1] - inset;
    const WalkingSpace& before = space(steps[i - 1].from);
    const WalkingSpace& after = space(steps[i - 1].into);
    Polyline in = before.pathTo(before.from(points[i - 1]), points[i]);
    Polyline out = after.pathTo(after.from(points[i]), points[i + 1]);
    if (in.size() < 2 || out.size() < 2) return;
    points[i] = bestCrossing(a, b, in[in.size() - 2], out[1]);
}

/// Start, where each access is crossed, goal. Doors and narrow openings in their middle; over wide openings the way
/// is pulled straight.
std::vector<Point2> RouteGraph::crossings(const Endpoint& from, const Endpoint& to,
                                          const std::vector<Step>& steps) const {
    std::vector<Point2> points{from.position};
    for (const Step& step : steps) points.push_back(m_building->accesses()[step.access].midpoint());
    points.push_back(to.position);
    for (int round = 0; round < kSlides; ++round) {
        std::vector<Point2> before = points;
        for (std::size_t i = 1; i + 1 < points.size(); ++i) slide(points, steps, i);
        double moved = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) moved = std::max(moved, distance(points[i], before[i]));
        if (moved < 0.01) break;
    }
    return points;
}

void RouteGraph::appendLeg(Route& route, std::size_t region, Point2 from, Point2 to) const {
    double level = m_building->regions()[region].level;
    Polyline leg = space(region).pathTo(space(region).from(from), to);
    for (Point2 p : leg) {
        bool repeated = !route.path.empty() && sameLevel(route.path.back().level, level) &&
                        distance(route.path.back().position, p) < 1e-9;
        if (!repeated) route.path.push_back({p, level});
    }
}

Route RouteGraph::routeAlong(const std::string& planner, const Endpoint& from, const Endpoint& to,
                             const std::vector<Step>& steps) const {
    Route route;
    route.planner = planner;
    route.regions.push_back(m_building->regions()[from.region].id);
    std::vector<Point2> points = crossings(from, to, steps);
    std::vector<std::size_t> portals;
    double vertical = 0.0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        appendLeg(route, steps[i].from, points[i], points[i + 1]);
        portals.push_back(route.path.size() - 1);
        route.regions.push_back(m_building->regions()[steps[i].into].id);
        route.accesses.push_back(m_building->accesses()[steps[i].access].id);
        vertical += verticalM(steps[i]);
        route.seconds += seconds(steps[i], i == 0 ? nullptr : &steps[i - 1]);
    }
    appendLeg(route, to.region, points[steps.size()], to.position);
    double flat = 0.0;
    for (std::size_t i = 1; i < route.path.size(); ++i)
        flat += distance(route.path[i - 1].position, route.path[i].position);
    route.lengthM = flat + vertical;
    route.seconds += walkingSeconds(flat);
    route.manoeuvres = manoeuvresAlong(*m_building, route, portals);
    return route;
}

} // namespace farol::routing
