#pragma once
// The graph that the optimal planner searches: doors and level changes, each side for itself, and the bends
// of ways in regions joined by wide openings. Made once for a building and a profile.

#include "core/routing/open_zone.h"
#include "core/routing/route_graph.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace farol::routing {

class PortalGraph {
public:
    using Node = std::uint32_t;
    static constexpr Node kNone = std::numeric_limits<Node>::max();
    static constexpr std::uint32_t kNoZone = std::numeric_limits<std::uint32_t>::max();

    /// A door or level change. Side 0 lies in the access's regionA.
    struct Portal {
        std::uint32_t access = 0;
        std::uint32_t region[2] = {0, 0};
        Point2 entry[2];         ///< on or in the polygon of that side
        double stub[2] = {0, 0}; ///< metres from there to the middle of the access
        double pass[2] = {0, 0}; ///< seconds to come out on that side; infinite where it is not allowed
        bool lift = false;
    };
    struct Arc {
        Node to;
        float seconds;
    };
    /// From a place in a zone to a node that leaves it or lies in it.
    struct Link {
        Node node;
        double metres;
    };

    explicit PortalGraph(const RouteGraph& graph);

    /// Nodes 2 p + s: portal p has been passed and one stands on its side s. Then the bends.
    std::size_t nodeCount() const { return m_firstArc.size() - 1; }
    std::size_t stateCount() const { return 2 * m_portals.size(); }
    bool isState(Node node) const { return node < stateCount(); }
    const Portal& portal(Node state) const { return m_portals[state / 2]; }
    /// The region one stands in after passing, or before.
    std::size_t regionInto(Node state) const { return portal(state).region[state % 2]; }
    std::size_t regionFrom(Node state) const { return portal(state).region[1 - state % 2]; }
    Step stepOf(Node state) const;
    Point2 bendAt(Node bend) const;
    std::size_t bendIn(Node bend) const; ///< its number in its OpenZone
    std::span<const Arc> arcs(Node node) const;
    /// The other side of `arcs`: from where one comes to the door one would step out of there, walking only.
    template <class Visit>
    void forEachWalkTo(Node arrived, Visit visit) const;
    /// Seconds to pass the portal of a state, coming from a node of the same zone (kNone: not from a portal).
    double passSeconds(Node state, Node before) const;
    double walkingSeconds(double metres) const { return m_graph.rules().walkingSeconds(metres); }
    /// May one come out in a region that is barred to all who do not start or end there?
    bool barred(Node state) const { return isState(state) && m_graph.rules().barred(regionInto(state)); }

    std::uint32_t zoneOf(std::size_t region) const { return m_zoneOf[region]; }
    std::uint32_t zoneOfNode(Node node) const;
    /// The zone that all ways out of this one lead into; kNoZone for those that may lie on the way.
    std::uint32_t parent(std::uint32_t zone) const { return m_zones[zone].parent; }
    bool isDeadEnd(std::uint32_t zone) const { return m_zones[zone].parent != kNoZone; }
    /// Adds the states by which one comes into a dead end from its parent.
    void waysInto(std::uint32_t deadEnd, std::vector<Node>& ways) const;
    const OpenZone* open(std::uint32_t zone) const { return m_zones[zone].open.get(); }

    /// What is reached directly from a point of a region: portals that lead on, and bends.
    std::vector<Link> linksFrom(const Endpoint& point) const;
    /// The direct way between two points of one zone, or infinity.
    double metresBetween(const Endpoint& a, const Endpoint& b) const;
    /// From where one comes out on this side of a portal, to before another portal of the zone.
    double metresFromTo(Node arrived, Node leaving) const;
    double metresTo(const Endpoint& point, Node leaving) const;
    Endpoint before(Node leaving) const;

private:
    struct Zone {
        std::vector<std::size_t> regions;
        std::vector<Node> leaving;  ///< states that lead out of it or from one of its regions into another
        std::vector<Node> deadEnds; ///< states that lead into zones that lie on no way
        std::uint32_t parent = kNoZone;
        Node firstBend = kNone;
        std::unique_ptr<OpenZone> open; ///< of several regions
    };

    void joinRegions();
    void addPortal(std::size_t access, const Step& step);
    void addZones();
    void findDeadEnds();
    bool makeDeadEnd(std::uint32_t zone);
    bool noShortcut(const std::vector<Node>& out) const;
    void addBends();
    void addArcs();
    struct Row {
        std::vector<Arc> arcs, shut;
    };
    void addRow(Node node, const std::vector<Link>& links, std::vector<Row>& rows) const;
    void addArcsOfZone(const Zone& zone, std::vector<Row>& rows) const;
    Link linkTo(const Zone& zone, const OpenZone::Seen& seen) const;

    const RouteGraph& m_graph;
    std::vector<WideOpening> m_openings;
    std::vector<std::uint32_t> m_zoneOf;
    std::vector<Zone> m_zones;
    std::vector<Portal> m_portals;
    std::vector<std::uint32_t> m_bendZone;
    std::vector<std::size_t> m_firstArc;
    std::vector<std::size_t>
        m_firstShut; ///< from there on: doors that may not be passed from this side, seconds to walk
    std::vector<Arc> m_arcs;
};

template <class Visit>
void PortalGraph::forEachWalkTo(Node arrived, Visit visit) const {
    for (std::size_t i = m_firstArc[arrived]; i < m_firstArc[arrived + 1]; ++i) {
        double seconds = static_cast<double>(m_arcs[i].seconds);
        if (i < m_firstShut[arrived]) seconds -= passSeconds(m_arcs[i].to, arrived);
        visit(m_arcs[i].to, seconds);
    }
}

} // namespace farol::routing
