// The paper's 4.1 (a)-(g). A region from which one cannot go on is struck out and the search starts again (e,
// f). That a region whose neighbours have all been passed is struck out too makes it end, and loses no way:
// whoever comes back to a passed region could have stayed there.

#include "core/routing/route_graph.h"

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

class Greedy {
public:
    Greedy(const RouteGraph& graph, const Endpoint& from, const Endpoint& to)
        : m_graph(graph), m_from(from), m_to(to) {}

    std::optional<Steps> run() {
        std::set<double> visited{levelOf(m_from.region)};
        return betweenLevels(m_from, visited);
    }

private:
    /// Enough for any building; a map made to defeat the search ends it.
    static constexpr int kMostAttempts = 2000;

    double levelOf(std::size_t region) const { return m_graph.building().regions()[region].level; }
    Point2 centre(std::size_t region) const {
        return pointInside(m_graph.building().regions()[region].polygon);
    }
    Point2 middle(const Step& step) const { return m_graph.building().accesses()[step.access].midpoint(); }
    Steps stepsFrom(std::size_t region) const {
        return m_graph.stepsFrom(region, m_from.region, m_to.region);
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
            position = centre(region);
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
    for (std::size_t region = 0; region < m_graph.building().regions().size(); ++region) {
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

class GreedyPlanner : public Planner {
public:
    GreedyPlanner(std::shared_ptr<const Building> building, RouteOptions options)
        : m_graph(std::move(building), options) {}

    Result<Route> plan(const Location& from, const Location& to) const override {
        if (auto sound = m_graph.options().check(); !sound) return sound.error();
        auto start = m_graph.endpoint(from, "start");
        if (!start) return start.error();
        auto goal = m_graph.endpoint(to, "destination");
        if (!goal) return goal.error();
        if (auto steps = Greedy(m_graph, *start, *goal).run())
            return m_graph.routeAlong("greedy", *start, *goal, *steps);
        if (!m_graph.reachable(start->region, goal->region))
            return m_graph.unreachable(start->region, goal->region);
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
};

} // namespace

std::unique_ptr<Planner> makeGreedyPlanner(std::shared_ptr<const Building> building, RouteOptions options) {
    return std::make_unique<GreedyPlanner>(std::move(building), options);
}

} // namespace farol::routing
