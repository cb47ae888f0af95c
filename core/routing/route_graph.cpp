#include "core/routing/route_graph.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace farol::routing {

using building::Access;
using building::AccessKind;
using building::OneWay;
using building::Region;

namespace {

constexpr double kStairsRun = 2.0; // metres walked for each metre of height: stairs rise at about 30 degrees
constexpr double kRampRun = 12.0;  // accessible ramps rise by 1 in 12
constexpr double kWideOpeningM = 1.2;    // from here on one does not aim for the middle
constexpr double kOpeningMarginM = 0.4;  // half a person, kept from the ends of a wide opening
constexpr double kCrossingsApartM = 1.0; // at most, along a wide opening
constexpr int kMostCrossings = 9;
constexpr int kSlides = 12;

bool sameLevel(double a, double b) {
    return std::abs(a - b) < 1e-6;
}

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

/// From one jamb to the other. An opening drawn as a point with a width lies along the border it stands on,
/// as far as that border goes.
Polyline widthLine(const Access& access, const Polygon& polygon) {
    if (access.line.size() != 1 || !access.widthM || *access.widthM < kWideOpeningM) return access.line;
    Polyline best = access.line;
    double nearest = 0.3;
    auto visit = [&](Point2 a, Point2 b) {
        Point2 middle = access.line[0];
        double gap = distanceToSegment(middle, a, b);
        double whole = distance(a, b);
        if (gap >= nearest || whole < kWideOpeningM) return;
        nearest = gap;
        Point2 half = (b - a) * (*access.widthM / 2.0 / whole);
        Point2 shift = middle - nearestOnSegment(middle, a, b);
        best = {nearestOnSegment(middle - half, a, b) + shift, nearestOnSegment(middle + half, a, b) + shift};
    };
    auto around = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
    };
    around(polygon.outer);
    for (const Ring& hole : polygon.holes) around(hole);
    return best;
}

/// Of a wide opening, what is left between the margins; empty for all others.
Polyline walkableWidth(const Access& access, const Polygon& polygon) {
    if (access.kind != AccessKind::Opening) return {};
    Polyline line = widthLine(access, polygon);
    double width = length(line);
    if (line.size() != 2 || width < kWideOpeningM) return {};
    Point2 inset = (line[1] - line[0]) * (kOpeningMarginM / width);
    return {line[0] + inset, line[1] - inset};
}

} // namespace

const RouteGraph::Obstacles& RouteGraph::allObstacles() {
    static const Obstacles all{Obstacle::Stairs,     Obstacle::Elevator, Obstacle::Escalator,
                               Obstacle::Restricted, Obstacle::Closed,   Obstacle::OneWay};
    return all;
}

const char* RouteGraph::obstacleWords(Obstacle obstacle) {
    switch (obstacle) {
    case Obstacle::Stairs:
        return "stairs";
    case Obstacle::Elevator:
        return "lift";
    case Obstacle::Escalator:
        return "escalator";
    case Obstacle::Restricted:
        return "a restricted region";
    case Obstacle::Closed:
        return "a closed access";
    case Obstacle::OneWay:
        return "a one-way access";
    }
    return "";
}

struct RouteGraph::Room {
    std::once_flag spaceOnce;
    std::unique_ptr<WalkingSpace> space;
    std::once_flag lengthsOnce;
    std::vector<std::size_t> starts; ///< of each of its accesses among its crossings
    std::vector<double> lengths;     ///< between its crossings, row by row
};

RouteGraph::RouteGraph(std::shared_ptr<const Building> building, RouteOptions options)
    : m_building(std::move(building)),
      m_options(options),
      m_rooms(std::make_unique<Room[]>(m_building->regions().size())) {
    for (const Access& access : m_building->accesses()) {
        const Region* region = m_building->region(access.regionA);
        m_widths.push_back(region == nullptr ? Polyline() : walkableWidth(access, region->polygon));
        m_crossings.push_back({access.midpoint()});
        if (m_widths.back().empty()) continue;
        Point2 a = m_widths.back()[0];
        Point2 along = m_widths.back()[1] - a;
        int parts =
            std::clamp(static_cast<int>(std::ceil(length(along) / kCrossingsApartM)), 1, kMostCrossings - 1);
        for (int i = 0; i <= parts; ++i)
            m_crossings.back().push_back(a + along * (static_cast<double>(i) / parts));
    }
}

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
    if (a != nullptr && b != nullptr && a->elevationM && b->elevationM)
        return std::abs(*a->elevationM - *b->elevationM);
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
    case AccessKind::Door:
        return m_options.doorSeconds;
    case AccessKind::Stairs:
    case AccessKind::Escalator:
        return m_options.stairsSecondsPerLevel * levels;
    case AccessKind::Ramp:
        return walkingSeconds(verticalM(step));
    case AccessKind::Elevator: {
        // In the car: the same shaft, or the map says that the region between is a lift.
        bool inCar =
            !access.shaft.empty() || m_building->regions()[step.from].kind == building::RegionKind::Elevator;
        bool riding = inCar && previous != nullptr &&
                      m_building->accesses()[previous->access].kind == AccessKind::Elevator &&
                      m_building->accesses()[previous->access].shaft == access.shaft;
        // The first level of a ride includes the wait.
        double further = riding ? levels : std::max(0.0, levels - 1.0);
        return (riding ? 0.0 : m_options.elevatorSeconds) + m_options.elevatorSecondsPerLevel * further;
    }
    case AccessKind::Opening:
    case AccessKind::Window:
    case AccessKind::Other:
        return 0.0;
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

std::vector<double> RouteGraph::lengthsWithin(std::size_t region) const {
    std::vector<Point2> points;
    for (std::size_t access : m_building->accessesOf(region))
        points.insert(points.end(), m_crossings[access].begin(), m_crossings[access].end());
    std::vector<double> lengths;
    lengths.reserve(points.size() * points.size());
    for (Point2 a : points) {
        auto tree = space(region).from(a);
        for (Point2 b : points) lengths.push_back(a == b ? 0.0 : space(region).lengthTo(tree, b));
    }
    return lengths;
}

double RouteGraph::between(std::size_t region, const Step& a, const Step& b) const {
    auto accesses = m_building->accessesOf(region);
    Room& room = m_rooms[region];
    std::call_once(room.lengthsOnce, [&] {
        room.starts.push_back(0);
        for (std::size_t access : accesses)
            room.starts.push_back(room.starts.back() + m_crossings[access].size());
        room.lengths = lengthsWithin(region);
    });
    auto position = [&](const Step& step) { // accessesOf is in the order of the map
        auto at = std::lower_bound(accesses.begin(), accesses.end(), step.access) - accesses.begin();
        return room.starts[static_cast<std::size_t>(at)] + step.crossing;
    };
    return room.lengths[position(a) * room.starts.back() + position(b)];
}

/// The way with the fewest obstacles, all of them of the kinds allowed; no steps when there is none.
std::vector<Step> RouteGraph::fewestObstacles(const Obstacles& allowed, std::size_t from,
                                              std::size_t to) const {
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
            if (!found || paid + found->size() >= cost[*other] ||
                !std::includes(allowed.begin(), allowed.end(), found->begin(), found->end()))
                continue;
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

bool RouteGraph::reachable(std::size_t from, std::size_t to) const {
    return from == to || !fewestObstacles({}, from, to).empty();
}

/// Between which regions the obstacle stands first on the way with the fewest of those allowed, in brackets;
/// or nothing.
std::string RouteGraph::where(Obstacle obstacle, const Obstacles& allowed, std::size_t from,
                              std::size_t to) const {
    for (const Step& step : fewestObstacles(allowed, from, to)) {
        auto found = obstacles(step, from, to);
        if (found && found->count(obstacle) != 0)
            return " (" + spokenName(m_building->regions()[step.from]) + " to " +
                   spokenName(m_building->regions()[step.into]) + ")";
    }
    return {};
}

std::string RouteGraph::severalObstacles(std::size_t from, std::size_t to) const {
    std::string text;
    for (Obstacle obstacle : allObstacles()) {
        std::string sides = where(obstacle, allObstacles(), from, to);
        if (!sides.empty())
            text += (text.empty() ? "" : " and ") + std::string(obstacleWords(obstacle)) + sides;
    }
    return "past " + text + " only";
}

Error RouteGraph::unreachable(std::size_t from, std::size_t to) const {
    std::string start = spokenName(m_building->regions()[from]);
    std::string goal = spokenName(m_building->regions()[to]);
    std::string context = start + " to " + goal;
    if (fewestObstacles(allObstacles(), from, to).empty())
        return {ErrorCode::NotFound,
                "there is no way at all: the map joins " + goal + " and " + start + " by no access", context};
    // What would do by itself is told, all of it; else what stands on the way with the fewest obstacles.
    std::string alternatives;
    bool several = false;
    for (Obstacle obstacle :
         {Obstacle::Stairs, Obstacle::Elevator, Obstacle::Escalator, Obstacle::Restricted}) {
        if (fewestObstacles({obstacle}, from, to).empty()) continue;
        several = !alternatives.empty() || obstacle == Obstacle::Stairs;
        alternatives += (alternatives.empty() ? "" : " or ") + std::string(obstacleWords(obstacle));
    }
    std::string how;
    if (!alternatives.empty())
        how = "by " + alternatives + " only, which " + (several ? "are" : "is") + " to be avoided";
    else if (!fewestObstacles({Obstacle::Closed}, from, to).empty())
        how = "through a closed access only" + where(Obstacle::Closed, {Obstacle::Closed}, from, to);
    else if (!fewestObstacles({Obstacle::OneWay}, from, to).empty())
        how = "against a one-way access only" + where(Obstacle::OneWay, {Obstacle::OneWay}, from, to);
    else
        how = severalObstacles(from, to);
    return {ErrorCode::NotFound, goal + " can be reached " + how, context};
}

/// Moves crossing `i` of a wide opening to where the way over it is shorter.
void RouteGraph::slide(std::vector<Point2>& points, const std::vector<Step>& steps, std::size_t i) const {
    const Polyline& width = m_widths[steps[i - 1].access];
    if (width.empty()) return;
    const WalkingSpace& before = space(steps[i - 1].from);
    const WalkingSpace& after = space(steps[i - 1].into);
    auto fromBefore = before.from(points[i - 1]);
    auto fromAfter = after.from(points[i + 1]);
    Polyline in = before.pathTo(fromBefore, points[i]);
    Polyline out = after.pathTo(fromAfter, points[i]);
    if (in.size() < 2 || out.size() < 2) return;
    Point2 better = bestCrossing(width[0], width[1], in[in.size() - 2], out[out.size() - 2]);
    double now = length(in) + length(out);
    if (before.lengthTo(fromBefore, better) + after.lengthTo(fromAfter, better) < now) points[i] = better;
}

/// Start, where each access is crossed, goal. Over wide openings the way is pulled straight.
std::vector<Point2> RouteGraph::pulledStraight(const Endpoint& from, const Endpoint& to,
                                               const std::vector<Step>& steps) const {
    std::vector<Point2> points{from.position};
    for (const Step& step : steps) points.push_back(m_crossings[step.access][step.crossing]);
    points.push_back(to.position);
    for (int round = 0; round < kSlides; ++round) {
        std::vector<Point2> before = points;
        for (std::size_t i = 1; i + 1 < points.size(); ++i) slide(points, steps, i);
        double moved = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i)
            moved = std::max(moved, distance(points[i], before[i]));
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
    std::vector<Point2> points = pulledStraight(from, to, steps);
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
