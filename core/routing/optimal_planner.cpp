#include "core/routing/portal_search.h"
#include "core/routing/route_graph.h"

#include <utility>

namespace farol::routing {

namespace {

class OptimalPlanner : public Planner {
public:
    OptimalPlanner(std::shared_ptr<const Building> building, RouteOptions options)
        : m_graph(std::move(building), options), m_sound(options.check()) {
        if (!m_sound) return;
        m_portals = std::make_unique<PortalGraph>(m_graph);
        m_bounds = std::make_unique<LandmarkBounds>(*m_portals);
        m_search = std::make_unique<PortalSearch>(*m_portals, *m_bounds);
    }

    Result<Route> plan(const Location& from, const Location& to) const override {
        if (!m_sound) return m_sound.error();
        auto start = m_graph.endpoint(from, "start");
        if (!start) return start.error();
        auto goal = m_graph.endpoint(to, "destination");
        if (!goal) return goal.error();
        auto found = m_search->run(*start, *goal);
        if (!found) return m_graph.rules().unreachable(start->region, goal->region);
        return routeOver(found->nodes, *start, *goal);
    }

private:
    using Node = PortalGraph::Node;

    Route routeOver(const std::vector<Node>& nodes, const Endpoint& from, const Endpoint& to) const {
        RouteMaker maker(m_graph, "optimal", from);
        std::size_t region = from.region;
        std::size_t first = 0; // of the nodes since the last portal
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (!m_portals->isState(nodes[i])) continue;
            Endpoint door = m_portals->before(nodes[i]);
            walk(maker, region, {nodes.data() + first, i - first}, door);
            passPortal(maker, nodes[i]);
            region = m_portals->regionInto(nodes[i]);
            first = i + 1;
        }
        walk(maker, region, {nodes.data() + first, nodes.size() - first}, to);
        return maker.finished();
    }

    void passPortal(RouteMaker& maker, Node state) const {
        Step step = m_portals->stepOf(state);
        Point2 landing = m_portals->portal(state).entry[state % 2];
        if (m_graph.rules().changesLevel(step)) return maker.pass(step, landing);
        Point2 middle = m_graph.building().accesses()[step.access].midpoint();
        maker.walkStraightTo(middle); // into the thickness of the wall
        maker.pass(step, middle);
        maker.walkStraightTo(landing);
    }

    /// Within a zone, over its bends.
    void walk(RouteMaker& maker, std::size_t region, std::span<const Node> bends, const Endpoint& to) const {
        const OpenZone* open = m_portals->open(m_portals->zoneOf(region));
        if (open == nullptr) return maker.walkTo(to.position);
        std::uint32_t place = open->placeOf(region);
        for (std::size_t i = 0; i <= bends.size(); ++i) {
            bool last = i == bends.size();
            Point2 end = last ? to.position : m_portals->bendAt(bends[i]);
            OpenZone::Leg leg = last ? open->legTo(place, maker.position(), to.region, end)
                                     : open->legToBend(place, maker.position(), m_portals->bendIn(bends[i]));
            for (const OpenZone::Crossing& crossing : leg.crossings) {
                maker.walkStraightTo(crossing.position);
                maker.pass({crossing.access, maker.region(), crossing.into}, crossing.position);
            }
            maker.walkStraightTo(end);
            place = leg.endsIn;
        }
    }

    RouteGraph m_graph;
    Result<void> m_sound;
    std::unique_ptr<PortalGraph> m_portals;
    std::unique_ptr<LandmarkBounds> m_bounds;
    std::unique_ptr<PortalSearch> m_search;
};

} // namespace

std::unique_ptr<Planner> makeOptimalPlanner(std::shared_ptr<const Building> building, RouteOptions options) {
    return std::make_unique<OptimalPlanner>(std::move(building), options);
}

} // namespace farol::routing
