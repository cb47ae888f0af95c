#include "core/routing/portal_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace farol::routing {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Later {
    bool operator()(const SearchRoom::Entry& a, const SearchRoom::Entry& b) const {
        return a.key != b.key ? a.key > b.key : a.node > b.node; // the same way every time
    }
};

} // namespace

void SearchRoom::begin() {
    if (++m_search == 0) { // the count has come round
        labels.assign(labels.size(), {});
        m_search = 1;
    }
    extras.clear();
    open.clear();
}

SearchRoom::Label& SearchRoom::label(Node node) {
    Label& label = labels[node];
    if (label.search != m_search) {
        label = {};
        label.seconds = kInfinity;
        label.bound = -1.0;
        label.search = m_search;
    }
    return label;
}

void SearchRoom::addExtra(Node from, Node to, double seconds) {
    if (!std::isfinite(seconds)) return;
    Label& start = label(from);
    extras.push_back({to, start.extra, seconds});
    start.extra = static_cast<std::uint32_t>(extras.size());
}

/// One search. Ways into dead ends are no arcs of the graph: the few that lead to the goal are added.
class PortalSearch::Query {
public:
    Query(const PortalGraph& graph, const LandmarkBounds& bounds, SearchRoom& room, const Endpoint& from,
          const Endpoint& to)
        : m_graph(graph), m_room(room), m_from(from), m_to(to), m_goal(bounds) {
        room.begin();
    }

    std::optional<Found> run() {
        aimAtGoal();
        leaveStart();
        expandAll();
        if (!std::isfinite(m_best)) return std::nullopt;
        Found found;
        found.seconds = m_best;
        std::vector<Node>& nodes = found.nodes;
        for (Node at = m_last; at != PortalGraph::kNone; at = m_room.label(at).previous) nodes.push_back(at);
        std::reverse(nodes.begin(), nodes.end());
        return found;
    }

private:
    static constexpr Node kGoal = PortalGraph::kNone;

    std::vector<std::uint32_t> zonesUp(std::size_t region) const {
        std::vector<std::uint32_t> zones{m_graph.zoneOf(region)};
        while (m_graph.isDeadEnd(zones.back())) zones.push_back(m_graph.parent(zones.back()));
        return zones;
    }
    bool shut(Node node) const {
        return m_graph.barred(node) && m_graph.regionInto(node) != m_from.region &&
               m_graph.regionInto(node) != m_to.region;
    }
    void aimAtGoal();
    void aimAtPoint();
    void aimAtDoor(Node way, bool top);
    void boundAt(Node before, Node after, double walk);
    void leaveStart();
    void linkDeadEnds(std::uint32_t zone, const std::vector<Node>& goalWays);
    void reach(Node node, double seconds, Node previous);
    void expandAll();
    double boundOf(Node node) const;

    const PortalGraph& m_graph;
    SearchRoom& m_room;
    const Endpoint& m_from;
    const Endpoint& m_to;
    LandmarkBounds::Goal m_goal;
    std::vector<std::uint32_t> m_startZones, m_goalZones;
    std::vector<std::vector<Node>> m_goalWays; ///< into each of the goal's zones but the last
    bool m_bounded = false;
    double m_best = kInfinity;
    Node m_last = PortalGraph::kNone;
};

/// The last arcs to the goal, from the nodes of its zone.
void PortalSearch::Query::aimAtPoint() {
    bool top = m_goalZones.size() == 1;
    if (top) m_goal.addDoor();
    for (const PortalGraph::Link& link : m_graph.linksFrom(m_to)) {
        Node before = m_graph.isState(link.node) ? link.node ^ 1U : link.node;
        double walk = m_graph.walkingSeconds(link.metres);
        m_room.addExtra(before, kGoal, walk);
        if (top) boundAt(before, link.node, walk);
    }
}

/// The last arcs to the door of a dead end on the way to the goal.
void PortalSearch::Query::aimAtDoor(Node way, bool top) {
    if (top) m_goal.addDoor();
    m_graph.forEachWalkTo(way ^ 1U, [&](Node node, double walk) {
        Node before = m_graph.isState(node) ? node ^ 1U : node;
        m_room.addExtra(before, way, walk + m_graph.passSeconds(way, before));
        if (top) boundAt(before, node, walk);
    });
}

void PortalSearch::Query::boundAt(Node before, Node after, double walk) {
    m_goal.reachedFrom(before, walk);
    m_goal.leadsTo(after, walk + m_graph.passSeconds(after, PortalGraph::kNone));
}

void PortalSearch::Query::aimAtGoal() {
    m_goalZones = zonesUp(m_to.region);
    m_startZones = zonesUp(m_from.region);
    aimAtPoint();
    for (std::size_t i = 0; i + 1 < m_goalZones.size(); ++i) {
        std::vector<Node>& ways = m_goalWays.emplace_back();
        m_graph.waysInto(m_goalZones[i], ways);
        for (Node way : ways) aimAtDoor(way, i + 2 == m_goalZones.size());
    }
    m_goal.endDoors();
    // Bounds hold for who comes from outside the dead end that the goal is in.
    std::size_t goals = m_goalZones.size(), starts = m_startZones.size();
    m_bounded = goals == 1 || starts == 1 || m_startZones[starts - 2] != m_goalZones[goals - 2];
}

double PortalSearch::Query::boundOf(Node node) const {
    return m_bounded && !m_graph.isDeadEnd(m_graph.zoneOfNode(node)) ? m_goal.atLeast(node) : 0.0;
}

void PortalSearch::Query::reach(Node node, double seconds, Node previous) {
    if (node == kGoal) {
        if (seconds >= m_best) return;
        m_best = seconds;
        m_last = previous;
        return;
    }
    SearchRoom::Label& label = m_room.label(node);
    if (seconds >= label.seconds || shut(node)) return;
    if (label.bound < 0.0) label.bound = boundOf(node);
    label.seconds = seconds;
    label.previous = previous;
    if (seconds + label.bound >= m_best) return;
    m_room.open.push_back({seconds + label.bound, seconds, node});
    std::push_heap(m_room.open.begin(), m_room.open.end(), Later());
}

/// Whoever comes out of a dead end may go into the goal's next to it.
void PortalSearch::Query::linkDeadEnds(std::uint32_t zone, const std::vector<Node>& goalWays) {
    for (std::size_t i = 0; i + 1 < m_startZones.size(); ++i) {
        if (m_startZones[i + 1] != zone) continue;
        std::vector<Node> ways;
        m_graph.waysInto(m_startZones[i], ways);
        for (Node out : ways)
            for (Node way : goalWays) {
                if (out == way) continue;
                double walk = m_graph.walkingSeconds(m_graph.metresFromTo(out ^ 1U, way));
                m_room.addExtra(out ^ 1U, way, walk + m_graph.passSeconds(way, out ^ 1U));
            }
    }
}

void PortalSearch::Query::leaveStart() {
    std::vector<std::pair<Node, double>> starts;
    for (const PortalGraph::Link& link : m_graph.linksFrom(m_from))
        starts.emplace_back(link.node, m_graph.walkingSeconds(link.metres) +
                                           m_graph.passSeconds(link.node, PortalGraph::kNone));
    if (m_bounded) m_goal.chooseFor(starts);
    if (m_graph.zoneOf(m_from.region) == m_graph.zoneOf(m_to.region))
        reach(kGoal, m_graph.walkingSeconds(m_graph.metresBetween(m_from, m_to)), PortalGraph::kNone);
    for (std::size_t i = 0; i < m_goalWays.size(); ++i) {
        std::uint32_t zone = m_goalZones[i + 1];
        linkDeadEnds(zone, m_goalWays[i]);
        if (zone != m_graph.zoneOf(m_from.region)) continue;
        for (Node way : m_goalWays[i])
            starts.emplace_back(way, m_graph.walkingSeconds(m_graph.metresTo(m_from, way)) +
                                         m_graph.passSeconds(way, PortalGraph::kNone));
    }
    // From the start's dead end straight to a goal in the zone it leads into.
    for (std::size_t i = 0; i + 1 < m_startZones.size(); ++i) {
        if (m_startZones[i + 1] != m_graph.zoneOf(m_to.region)) continue;
        std::vector<Node> ways;
        m_graph.waysInto(m_startZones[i], ways);
        for (Node way : ways)
            m_room.addExtra(way ^ 1U, kGoal, m_graph.walkingSeconds(m_graph.metresTo(m_to, way)));
    }
    for (const auto& [node, seconds] : starts)
        if (std::isfinite(seconds)) reach(node, seconds, PortalGraph::kNone);
}

void PortalSearch::Query::expandAll() {
    while (!m_room.open.empty()) {
        std::pop_heap(m_room.open.begin(), m_room.open.end(), Later());
        SearchRoom::Entry entry = m_room.open.back();
        m_room.open.pop_back();
        if (entry.key >= m_best) return;
        const SearchRoom::Label label = m_room.label(entry.node);
        if (entry.seconds > label.seconds) continue;
        for (const PortalGraph::Arc& arc : m_graph.arcs(entry.node))
            reach(arc.to, entry.seconds + static_cast<double>(arc.seconds), entry.node);
        for (std::uint32_t i = label.extra; i != 0; i = m_room.extras[i - 1].next)
            reach(m_room.extras[i - 1].to, entry.seconds + m_room.extras[i - 1].seconds, entry.node);
    }
}

PortalSearch::PortalSearch(const PortalGraph& graph, const LandmarkBounds& bounds)
    : m_graph(graph), m_bounds(bounds) {}

std::unique_ptr<SearchRoom> PortalSearch::room() const {
    std::lock_guard lock(m_mutex);
    if (m_rooms.empty()) return std::make_unique<SearchRoom>(m_graph.nodeCount());
    auto room = std::move(m_rooms.back());
    m_rooms.pop_back();
    return room;
}

void PortalSearch::giveBack(std::unique_ptr<SearchRoom> room) const {
    std::lock_guard lock(m_mutex);
    m_rooms.push_back(std::move(room));
}

std::optional<PortalSearch::Found> PortalSearch::run(const Endpoint& from, const Endpoint& to) const {
    auto own = room();
    auto found = Query(m_graph, m_bounds, *own, from, to).run();
    giveBack(std::move(own));
    return found;
}

} // namespace farol::routing
