// The paper's 4.1 (a)-(g). A region from which one cannot go on is struck out and the search starts again (e,
// f). That a region whose neighbours have all been passed is struck out too makes it end, and loses no way:
// whoever comes back to a passed region could have stayed there.

#include "core/routing/route_graph.h"
#include "core/routing/wide_opening.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace farol::routing {

using building::AccessKind;

namespace {

using Steps = std::vector<Step>;

/// (g) A shaft as seen from two levels: where one goes in, the steps within, where one comes out.
struct Passage {
    std::size_t entry;
    std::size_t exit;
    Steps steps;
    bool lift;
};

/// What is asked of the map again and again.
struct GreedyMap {
    explicit GreedyMap(const RouteGraph& graph) {
        const Building& building = graph.building();
        for (const building::Access& access : building.accesses()) middles.push_back(access.midpoint());
        for (std::size_t region = 0; region < building.regions().size(); ++region) {
            centres.push_back(pointInside(building.regions()[region].polygon));
            auto accesses = building.accessesOf(region);
            bool climbs = std::any_of(accesses.begin(), accesses.end(), [&](std::size_t access) {
                auto step = graph.rules().stepThrough(access, region);
                return step && graph.rules().changesLevel(*step);
            });
            if (climbs) climbing.push_back(region);
        }
    }

    std::vector<Point2> centres;       ///< of the regions
    std::vector<Point2> middles;       ///< of the accesses
    std::vector<std::size_t> climbing; ///< regions that stairs, lifts and the like lead out of
};

class Greedy {
public:
    Greedy(const RouteGraph& graph, const GreedyMap& map, const Endpoint& from, const Endpoint& to)
        : m_graph(graph), m_map(map), m_from(from), m_to(to) {}

    std::optional<Steps> run() {
        std::set<double> visited{levelOf(m_from.region)};
        return betweenLevels(m_from, visited);
    }

private:
    /// Enough for any building; a map made to defeat the search ends it.
    static constexpr int kMostAttempts = 2000;

    double levelOf(std::size_t region) const { return m_graph.building().regions()[region].level; }
    Point2 middle(const Step& step) const { return m_map.middles[step.access]; }
    Steps stepsFrom(std::size_t region) const {
        return m_graph.rules().stepsFrom(region, m_from.region, m_to.region);
    }

    std::optional<Step> nextStep(std::size_t region, Point2 position, Point2 destination,
                                 const std::set<std::size_t>& passed,
                                 const std::set<std::size_t>& struck) const;
    std::optional<Steps> onLevel(const Endpoint& from, const Endpoint& to) const;
    std::optional<Steps> throughShaft(std::size_t from, double level, bool lift, std::size_t& exit) const;
    std::vector<Passage> passages(const Endpoint& from, double level) const;
    std::optional<Steps> betweenLevels(const Endpoint& from, std::set<double>& visited);
    std::vector<double> levelsNearGoal() const;

    const RouteGraph& m_graph;
    const GreedyMap& m_map;
    const Endpoint& m_from;
    const Endpoint& m_to;
    int m_attempts = 0;
};

/// (a), (c) The access in the destination's direction that lies nearest to it; where none is ahead, the
/// nearest of all.
std::optional<Step> Greedy::nextStep(std::size_t region, Point2 position, Point2 destination,
                                     const std::set<std::size_t>& passed,
                                     const std::set<std::size_t>& struck) const {
    std::optional<Step> best;
    std::tuple<bool, double> bestRank;
    for (const Step& step : stepsFrom(region)) {
        if (levelOf(step.into) != levelOf(region) || passed.count(step.into) != 0 ||
            struck.count(step.into) != 0)
            continue;
        bool behind = dot(middle(step) - position, destination - position) <= 0.0;
        std::tuple rank(behind, distance(middle(step), destination));
        if (best && rank >= bestRank) continue;
        best = step;
        bestRank = rank;
    }
    return best;
}

std::optional<Steps> Greedy::onLevel(const Endpoint& from, const Endpoint& to) const {
    std::set<std::size_t> struck;
    while (true) {
        Steps steps;
        std::set<std::size_t> passed{from.region};
        std::size_t region = from.region;
        Point2 position = from.position;
        while (region != to.region) {
            auto step = nextStep(region, position, to.position, passed, struck);
            if (!step) break;
            steps.push_back(*step);
            region = step->into; // (b) the room behind it is the new starting point
            passed.insert(region);
            position = m_map.centres[region];
        }
        if (region == to.region) return steps;
        if (region == from.region) return std::nullopt;
        struck.insert(region); // (e), and (f) once more from the start
    }
}

/// Up or down by stairs (escalators and ramps with them) or by lift alone, from a region to a region of that
/// level.
std::optional<Steps> Greedy::throughShaft(std::size_t from, double level, bool lift,
                                          std::size_t& exit) const {
    std::vector<std::pair<std::size_t, Steps>> open{{from, {}}};
    std::set<std::size_t> seen{from};
    for (std::size_t i = 0; i < open.size(); ++i) {
        auto [region, steps] = open[i];
        if (levelOf(region) == level) {
            exit = region;
            return steps;
        }
        for (const Step& step : stepsFrom(region)) {
            bool byLift = m_graph.building().accesses()[step.access].kind == AccessKind::Elevator;
            if (byLift != lift || levelOf(step.into) == levelOf(region) || !seen.insert(step.into).second)
                continue;
            Steps longer = steps;
            longer.push_back(step);
            open.emplace_back(step.into, std::move(longer));
        }
    }
    return std::nullopt;
}

/// Stairs before lifts, as in the paper's example (what is to be avoided is not offered by the graph); then
/// the shaft over which the straight lines to and from are shortest.
std::vector<Passage> Greedy::passages(const Endpoint& from, double level) const {
    std::vector<std::pair<std::tuple<bool, double>, Passage>> ranked;
    for (std::size_t region : m_map.climbing) {
        if (levelOf(region) != levelOf(from.region)) continue;
        for (bool lift : {false, true}) {
            std::size_t exit = region;
            auto steps = throughShaft(region, level, lift, exit);
            if (!steps || steps->empty()) continue;
            double far = distance(from.position, middle(steps->front())) +
                         distance(middle(steps->back()), m_to.position);
            ranked.emplace_back(std::tuple(lift, far), Passage{region, exit, std::move(*steps), lift});
        }
    }
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Passage> list;
    for (auto& entry : ranked) list.push_back(std::move(entry.second));
    return list;
}

std::vector<double> Greedy::levelsNearGoal() const {
    std::set<double> all;
    for (const building::Region& region : m_graph.building().regions()) all.insert(region.level);
    std::vector<double> levels(all.begin(), all.end());
    double goal = levelOf(m_to.region);
    std::stable_sort(levels.begin(), levels.end(),
                     [&](double a, double b) { return std::abs(a - goal) < std::abs(b - goal); });
    return levels;
}

/// (g) Partial destinations: the entry of a shaft that both levels share; where none is shared, over a level
/// between.
std::optional<Steps> Greedy::betweenLevels(const Endpoint& from, std::set<double>& visited) {
    if (++m_attempts > kMostAttempts) return std::nullopt;
    if (levelOf(from.region) == levelOf(m_to.region)) return onLevel(from, m_to);
    for (double level : levelsNearGoal()) {
        if (visited.count(level) != 0) continue;
        for (const Passage& passage : passages(from, level)) {
            auto before = onLevel(from, {passage.entry, middle(passage.steps.front())});
            if (!before) continue;
            visited.insert(level);
            auto after = betweenLevels({passage.exit, middle(passage.steps.back())}, visited);
            visited.erase(level);
            if (!after) continue;
            before->insert(before->end(), passage.steps.begin(), passage.steps.end());
            before->insert(before->end(), after->begin(), after->end());
            return before;
        }
    }
    return std::nullopt;
}

/// The row of accesses as a way: doors in their middle, over wide openings pulled straight.
class PulledWay {
public:
    PulledWay(const RouteGraph& graph, const Endpoint& from, const Endpoint& to, const Steps& steps)
        : m_graph(graph), m_steps(steps) {
        m_points.push_back(from.position);
        for (const Step& step : steps) {
            const building::Access& access = graph.building().accesses()[step.access];
            m_points.push_back(access.midpoint());
            m_widths.push_back(walkableWidth(access, sideA(step)));
        }
        m_points.push_back(to.position);
    }

    Route route(const Endpoint& from) {
        for (int round = 0; round < kSlides && pull() > 0.001; ++round) {
        }
        RouteMaker maker(m_graph, "greedy", from);
        for (std::size_t i = 0; i < m_steps.size(); ++i) {
            Point2 crossing = m_points[i + 1], landing = crossing;
            if (m_graph.rules().changesLevel(m_steps[i])) { // stairs may come out elsewhere than they begin
                crossing = m_graph.space(m_steps[i].from).entryOf(crossing);
                landing = m_graph.space(m_steps[i].into).entryOf(landing);
            }
            maker.walkTo(crossing);
            maker.pass(m_steps[i], landing);
        }
        maker.walkTo(m_points.back());
        return maker.finished();
    }

private:
    static constexpr int kSlides = 50;

    const Polygon& sideA(const Step& step) const {
        const building::Region* region =
            m_graph.building().region(m_graph.building().accesses()[step.access].regionA);
        return region != nullptr ? region->polygon : m_graph.building().regions()[step.from].polygon;
    }

    /// Moves each crossing of a wide opening once; tells how far the furthest went.
    double pull() {
        double moved = 0.0;
        for (std::size_t i = 0; i < m_steps.size(); ++i) {
            Point2 before = m_points[i + 1];
            if (!m_widths[i].empty()) slide(i);
            moved = std::max(moved, distance(before, m_points[i + 1]));
        }
        return moved;
    }

    /// To where the way over it is shorter.
    void slide(std::size_t i) {
        const WalkingSpace& before = m_graph.space(m_steps[i].from);
        const WalkingSpace& after = m_graph.space(m_steps[i].into);
        Point2& point = m_points[i + 1];
        auto fromBefore = before.from(m_points[i]);
        auto fromAfter = after.from(m_points[i + 2]);
        Polyline in = before.pathTo(fromBefore, point);
        Polyline out = after.pathTo(fromAfter, point);
        if (in.size() < 2 || out.size() < 2) return;
        Point2 better = bestCrossing(m_widths[i], in[in.size() - 2], out[out.size() - 2]);
        double now = length(in) + length(out);
        if (before.lengthTo(fromBefore, better) + after.lengthTo(fromAfter, better) < now) point = better;
    }

    /// The point of the line over which the way from `from` to `to` is shortest.
    static Point2 bestCrossing(const Polyline& line, Point2 from, Point2 to) {
        Point2 a = line[0];
        Point2 along = line[1] - a;
        Point2 normal{-along.y, along.x};
        double sideFrom = dot(from - a, normal);
        double sideTo = dot(to - a, normal);
        // Mirrored to the other side where both lie on one; then the straight line between them crosses.
        double gap = std::abs(sideFrom) + std::abs(sideTo);
        double squared = dot(along, along);
        double atFrom = dot(from - a, along) / squared;
        double atTo = dot(to - a, along) / squared;
        double share = gap > 0.0 ? std::abs(sideFrom) / gap : 0.5;
        return a + along * std::clamp(atFrom + (atTo - atFrom) * share, 0.0, 1.0);
    }

    const RouteGraph& m_graph;
    const Steps& m_steps;
    std::vector<Point2> m_points;
    std::vector<Polyline> m_widths; ///< within which a wide opening is crossed; empty for others
};

class GreedyPlanner : public Planner {
public:
    GreedyPlanner(std::shared_ptr<const Building> building, RouteOptions options)
        : m_graph(std::move(building), options), m_map(m_graph) {}

    Result<Route> plan(const Location& from, const Location& to) const override {
        if (auto sound = m_graph.rules().options().check(); !sound) return sound.error();
        auto start = m_graph.endpoint(from, "start");
        if (!start) return start.error();
        auto goal = m_graph.endpoint(to, "destination");
        if (!goal) return goal.error();
        if (auto steps = Greedy(m_graph, m_map, *start, *goal).run())
            return PulledWay(m_graph, *start, *goal, *steps).route(*start);
        if (!m_graph.rules().reachable(start->region, goal->region))
            return m_graph.rules().unreachable(start->region, goal->region);
        const Building& building = m_graph.building();
        return Error{
            ErrorCode::NotFound,
            "the greedy planner finds no way, because it stays on each level and takes shafts between two of "
            "them only; the optimal planner finds one",
            spokenName(building.regions()[start->region]) + " to " +
                spokenName(building.regions()[goal->region])};
    }

private:
    RouteGraph m_graph;
    GreedyMap m_map;
};

} // namespace

std::unique_ptr<Planner> makeGreedyPlanner(std::shared_ptr<const Building> building, RouteOptions options) {
    return std::make_unique<GreedyPlanner>(std::move(building), options);
}

} // namespace farol::routing
