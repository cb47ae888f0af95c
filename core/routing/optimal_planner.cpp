#include "core/routing/route_graph.h"

#include <queue>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace farol::routing {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// Dijkstra over crossings of accesses: a node is a crossing together with the side on which one has come
/// out.
class Search {
public:
    Search(const RouteGraph& graph, const Endpoint& from, const Endpoint& to)
        : m_graph(graph), m_from(from), m_to(to) {
        for (std::size_t access = 0; access < graph.building().accesses().size(); ++access) {
            m_first.push_back(m_nodes.size());
            m_nodes.resize(m_nodes.size() + 2 * graph.crossings(access).size());
        }
    }

    /// The steps to the goal, or nothing when it cannot be reached.
    std::optional<std::vector<Step>> run();

private:
    struct Node {
        Step step{};
        double cost = std::numeric_limits<double>::infinity();
        std::size_t previous = kNone;
    };

    std::size_t nodeOf(const Step& step) const {
        const building::Access& access = m_graph.building().accesses()[step.access];
        bool forward = m_graph.building().regions()[step.into].id == access.regionB;
        return m_first[step.access] + 2 * step.crossing + (forward ? 1 : 0);
    }
    void reach(const Step& step, double cost, std::size_t previous);
    void leaveStart();
    void expand(std::size_t node);
    void tryGoal(std::size_t node);

    const RouteGraph& m_graph;
    const Endpoint& m_from;
    const Endpoint& m_to;
    std::vector<Node> m_nodes;
    std::vector<std::size_t> m_first;             ///< node of each access
    using Entry = std::pair<double, std::size_t>; // the node's number breaks ties: the same way every time
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_open;
    std::optional<WalkingSpace::Tree> m_goalTree;
    double m_best = std::numeric_limits<double>::infinity();
    std::size_t m_last = kNone;
};

void Search::reach(const Step& step, double cost, std::size_t previous) {
    std::size_t index = nodeOf(step);
    Node& node = m_nodes[index];
    if (cost >= node.cost) return;
    node = {step, cost, previous};
    m_open.emplace(cost, index);
}

void Search::leaveStart() {
    const WalkingSpace& space = m_graph.space(m_from.region);
    auto tree = space.from(m_from.position);
    for (Step step : m_graph.stepsFrom(m_from.region, m_from.region, m_to.region)) {
        const std::vector<Point2>& crossings = m_graph.crossings(step.access);
        for (step.crossing = 0; step.crossing < crossings.size(); ++step.crossing) {
            double metres = space.lengthTo(tree, crossings[step.crossing]);
            reach(step, m_graph.walkingSeconds(metres) + m_graph.seconds(step, nullptr), kNone);
        }
    }
}

void Search::expand(std::size_t index) {
    const Node node = m_nodes[index];
    for (Step step : m_graph.stepsFrom(node.step.into, m_from.region, m_to.region)) {
        if (step.access == node.step.access) continue;
        double paid = node.cost + m_graph.seconds(step, &node.step);
        for (step.crossing = 0; step.crossing < m_graph.crossings(step.access).size(); ++step.crossing)
            reach(step, paid + m_graph.walkingSeconds(m_graph.between(node.step.into, node.step, step)),
                  index);
    }
}

void Search::tryGoal(std::size_t index) {
    if (m_nodes[index].step.into != m_to.region) return;
    const WalkingSpace& space = m_graph.space(m_to.region);
    if (!m_goalTree) m_goalTree = space.from(m_to.position);
    double metres = space.lengthTo(
        *m_goalTree, m_graph.crossings(m_nodes[index].step.access)[m_nodes[index].step.crossing]);
    double cost = m_nodes[index].cost + m_graph.walkingSeconds(metres);
    if (cost >= m_best) return;
    m_best = cost;
    m_last = index;
}

std::optional<std::vector<Step>> Search::run() {
    leaveStart();
    while (!m_open.empty()) {
        auto [cost, index] = m_open.top();
        m_open.pop();
        if (cost >= m_best) break;
        if (cost > m_nodes[index].cost) continue;
        tryGoal(index);
        expand(index);
    }
    if (m_last == kNone) return std::nullopt;
    std::vector<Step> steps;
    for (std::size_t at = m_last; at != kNone; at = m_nodes[at].previous) steps.push_back(m_nodes[at].step);
    std::reverse(steps.begin(), steps.end());
    return steps;
}

class OptimalPlanner : public Planner {
public:
    OptimalPlanner(std::shared_ptr<const Building> building, RouteOptions options)
        : m_graph(std::move(building), options) {}

    Result<Route> plan(const Location& from, const Location& to) const override {
        if (auto sound = m_graph.options().check(); !sound) return sound.error();
        auto start = m_graph.endpoint(from, "start");
        if (!start) return start.error();
        auto goal = m_graph.endpoint(to, "destination");
        if (!goal) return goal.error();
        std::optional<std::vector<Step>> steps;
        if (start->region == goal->region)
            steps.emplace();
        else
            steps = Search(m_graph, *start, *goal).run();
        if (!steps) return m_graph.unreachable(start->region, goal->region);
        return m_graph.routeAlong("optimal", *start, *goal, *steps);
    }

private:
    RouteGraph m_graph;
};

} // namespace

std::unique_ptr<Planner> makeOptimalPlanner(std::shared_ptr<const Building> building, RouteOptions options) {
    return std::make_unique<OptimalPlanner>(std::move(building), options);
}

} // namespace farol::routing
