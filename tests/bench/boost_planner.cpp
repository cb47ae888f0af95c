#include "tests/bench/boost_planner.h"

#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <limits>
#include <vector>

namespace farol::bench {

namespace {

struct Cost {
    double seconds = 0.0;
};
using Csr = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Cost, boost::no_property,
                                               std::uint32_t, std::uint32_t>;

struct Arrived {};

struct StopAtGoal : boost::default_astar_visitor {
    std::uint32_t goal = 0;
    template <class Vertex, class Graph>
    void examine_vertex(Vertex vertex, const Graph&) const {
        if (vertex == goal) throw Arrived();
    }
};

struct StraightLine : boost::astar_heuristic<Csr, double> {
    const std::vector<Point2>* places = nullptr;
    Point2 goal;
    double secondsEachMetre = 0.0;
    double operator()(std::uint32_t vertex) const {
        return distance((*places)[vertex], goal) * secondsEachMetre;
    }
};

} // namespace

struct BoostPlanner::Graph {
    Csr graph;
    std::vector<Point2> places;
    std::vector<double> distances, costs;
    std::vector<std::uint32_t> previous;
    std::vector<boost::default_color_type> colours;
    double secondsEachMetre = 0.0;
};

BoostPlanner::BoostPlanner(const DoorGraph& graph, double speed) : m_graph(std::make_unique<Graph>()) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    std::vector<Cost> costs;
    for (const DoorGraph::Edge& edge : graph.edges()) {
        ends.emplace_back(edge.from, edge.to);
        costs.push_back({edge.seconds});
    }
    auto count = static_cast<std::uint32_t>(graph.nodes().size());
    m_graph->graph =
        Csr(boost::edges_are_unsorted_multi_pass, ends.begin(), ends.end(), costs.begin(), count);
    m_graph->places = graph.nodes();
    m_graph->distances.resize(count);
    m_graph->costs.resize(count);
    m_graph->previous.resize(count);
    m_graph->colours.resize(count);
    m_graph->secondsEachMetre = 0.999999 / speed; // the rounding of edges must not break the bound
}

BoostPlanner::~BoostPlanner() = default;

double BoostPlanner::seconds(std::uint32_t from, std::uint32_t to) {
    Graph& own = *m_graph;
    auto index = get(boost::vertex_index, own.graph);
    auto map = [&](auto& values) { return boost::make_iterator_property_map(values.begin(), index); };
    StraightLine bound;
    bound.places = &own.places;
    bound.goal = own.places[to];
    bound.secondsEachMetre = own.secondsEachMetre;
    StopAtGoal visitor;
    visitor.goal = to;
    try {
        boost::astar_search(own.graph, from, bound,
                            boost::weight_map(get(&Cost::seconds, own.graph))
                                .predecessor_map(map(own.previous))
                                .distance_map(map(own.distances))
                                .rank_map(map(own.costs))
                                .color_map(map(own.colours))
                                .visitor(visitor));
    } catch (const Arrived&) {
        return own.distances[to];
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace farol::bench
