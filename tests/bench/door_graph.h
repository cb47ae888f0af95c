#pragma once
// The planner's graph as plain nodes and edges, with the ends of given pairs in it, for planners that know no
// maps.

#include "core/routing/portal_graph.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace farol::bench {

class DoorGraph {
public:
    struct Edge {
        std::uint32_t from, to;
        double seconds;
    };
    using Pairs = std::vector<std::pair<building::Location, building::Location>>;

    DoorGraph(const routing::RouteGraph& rules, const Pairs& pairs);

    const std::vector<Point2>& nodes() const { return m_nodes; } ///< where they lie
    const std::vector<Edge>& edges() const { return m_edges; }   ///< one way each
    std::uint32_t start(std::size_t pair) const { return m_first + static_cast<std::uint32_t>(2 * pair); }
    std::uint32_t goal(std::size_t pair) const { return start(pair) + 1; }

private:
    using Node = routing::PortalGraph::Node;

    void addDoors();
    void addPair(std::size_t pair, const routing::Endpoint& from, const routing::Endpoint& to);
    void addBetweenDeadEnds(std::uint32_t start, std::uint32_t goal, const routing::Endpoint& from,
                            const routing::Endpoint& to);
    void addEdge(std::uint32_t from, std::uint32_t to, double seconds);
    std::vector<std::uint32_t> zonesUp(std::size_t region) const;
    std::vector<Node> waysInto(std::uint32_t zone) const;

    routing::PortalGraph m_graph;
    std::uint32_t m_first = 0;
    std::vector<Point2> m_nodes;
    std::vector<Edge> m_edges;
};

} // namespace farol::bench
