#include "tests/bench/door_graph.h"

#include <cmath>

namespace farol::bench {

using routing::Endpoint;
using routing::PortalGraph;

DoorGraph::DoorGraph(const routing::RouteGraph& rules, const Pairs& pairs) : m_graph(rules) {
    m_first = static_cast<std::uint32_t>(m_graph.nodeCount());
    for (Node node = 0; node < m_first; ++node)
        m_nodes.push_back(m_graph.isState(node) ? m_graph.portal(node).entry[node % 2]
                                                : m_graph.bendAt(node));
    addDoors();
    for (std::size_t i = 0; i < pairs.size(); ++i)
        addPair(i, *rules.endpoint(pairs[i].first, "start"), *rules.endpoint(pairs[i].second, "destination"));
}

void DoorGraph::addEdge(std::uint32_t from, std::uint32_t to, double seconds) {
    if (std::isfinite(seconds)) m_edges.push_back({from, to, seconds});
}

void DoorGraph::addDoors() {
    for (Node node = 0; node < m_first; ++node)
        for (const PortalGraph::Arc& arc : m_graph.arcs(node))
            addEdge(node, arc.to, static_cast<double>(arc.seconds));
    // The planner searches rooms that lie on no way only when they hold an end; other planners have their
    // doors too.
    for (Node way = 0; way < m_graph.stateCount(); ++way) {
        std::uint32_t zone = m_graph.zoneOf(m_graph.regionInto(way));
        if (!m_graph.isDeadEnd(zone) || m_graph.parent(zone) != m_graph.zoneOf(m_graph.regionFrom(way)))
            continue;
        m_graph.forEachWalkTo(way ^ 1U, [&](Node node, double walk) {
            Node before = m_graph.isState(node) ? node ^ 1U : node;
            addEdge(before, way, walk + m_graph.passSeconds(way, before));
        });
    }
}

std::vector<std::uint32_t> DoorGraph::zonesUp(std::size_t region) const {
    std::vector<std::uint32_t> zones{m_graph.zoneOf(region)};
    while (m_graph.isDeadEnd(zones.back())) zones.push_back(m_graph.parent(zones.back()));
    return zones;
}

std::vector<DoorGraph::Node> DoorGraph::waysInto(std::uint32_t zone) const {
    std::vector<Node> ways;
    m_graph.waysInto(zone, ways);
    return ways;
}

void DoorGraph::addPair(std::size_t pair, const Endpoint& from, const Endpoint& to) {
    m_nodes.push_back(from.position);
    m_nodes.push_back(to.position);
    for (const PortalGraph::Link& link : m_graph.linksFrom(from))
        addEdge(start(pair), link.node,
                m_graph.walkingSeconds(link.metres) + m_graph.passSeconds(link.node, PortalGraph::kNone));
    for (const PortalGraph::Link& link : m_graph.linksFrom(to))
        addEdge(m_graph.isState(link.node) ? link.node ^ 1U : link.node, goal(pair),
                m_graph.walkingSeconds(link.metres));
    if (m_graph.zoneOf(from.region) == m_graph.zoneOf(to.region))
        addEdge(start(pair), goal(pair), m_graph.walkingSeconds(m_graph.metresBetween(from, to)));
    addBetweenDeadEnds(start(pair), goal(pair), from, to);
}

/// From and to rooms along one corridor, which the graph has no edges for.
void DoorGraph::addBetweenDeadEnds(std::uint32_t start, std::uint32_t goal, const Endpoint& from,
                                   const Endpoint& to) {
    std::vector<std::uint32_t> starts = zonesUp(from.region), goals = zonesUp(to.region);
    for (std::size_t i = 0; i + 1 < goals.size(); ++i) {
        for (Node way : waysInto(goals[i])) {
            if (goals[i + 1] == starts[0])
                addEdge(start, way,
                        m_graph.walkingSeconds(m_graph.metresTo(from, way)) +
                            m_graph.passSeconds(way, PortalGraph::kNone));
            for (std::size_t j = 0; j + 1 < starts.size(); ++j)
                for (Node out : waysInto(starts[j]))
                    if (starts[j + 1] == goals[i + 1] && out != way)
                        addEdge(out ^ 1U, way,
                                m_graph.walkingSeconds(m_graph.metresFromTo(out ^ 1U, way)) +
                                    m_graph.passSeconds(way, out ^ 1U));
        }
    }
    for (std::size_t j = 0; j + 1 < starts.size(); ++j)
        for (Node out : waysInto(starts[j]))
            if (starts[j + 1] == goals[0])
                addEdge(out ^ 1U, goal, m_graph.walkingSeconds(m_graph.metresTo(to, out)));
}

} // namespace farol::bench
