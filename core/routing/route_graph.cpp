#include "core/routing/route_graph.h"

#include "core/building/sentence.h"

#include <cmath>
#include <utility>

namespace farol::routing {

struct RouteGraph::Room {
    std::once_flag once;
    std::unique_ptr<WalkingSpace> space;
};

RouteGraph::RouteGraph(std::shared_ptr<const Building> building, RouteOptions options)
    : m_rules(std::move(building), options),
      m_rooms(std::make_unique<Room[]>(m_rules.building().regions().size())) {}

RouteGraph::~RouteGraph() = default;

Result<Endpoint> RouteGraph::endpoint(const Location& location, const std::string& role) const {
    auto index = building().regionIndex(location.region);
    if (!index)
        return Error{ErrorCode::NotFound,
                     building::english(building::Sentence::WayRegionMissing, location.region.value), role};
    const Polygon& polygon = building().regions()[*index].polygon;
    Point2 position = location.position.value_or(pointInside(polygon));
    if (!isFinite(position))
        return Error{ErrorCode::InvalidArgument, building::english(building::Sentence::WayNoPlace), role};
    if (!location.position || contains(polygon, position)) return Endpoint{*index, position};
    return Endpoint{*index, space(*index).entryOf(position)};
}

const WalkingSpace& RouteGraph::space(std::size_t region) const {
    Room& room = m_rooms[region];
    std::call_once(room.once, [&] {
        room.space = std::make_unique<WalkingSpace>(building().regions()[region].polygon);
    });
    return *room.space;
}

RouteMaker::RouteMaker(const RouteGraph& graph, std::string planner, const Endpoint& from)
    : m_graph(graph), m_region(from.region), m_level(graph.building().regions()[from.region].level) {
    m_route.planner = std::move(planner);
    m_route.regions.push_back(graph.building().regions()[from.region].id);
    m_route.path.push_back({from.position, m_level});
}

void RouteMaker::add(Point2 p) {
    bool moved = std::abs(m_route.path.back().level - m_level) > 1e-6;
    double gone = distance(m_route.path.back().position, p);
    if (!moved && gone < 1e-9) return;
    if (!moved) m_flat += gone;
    m_route.path.push_back({p, m_level});
}

void RouteMaker::walkTo(Point2 to) {
    const WalkingSpace& space = m_graph.space(m_region);
    for (Point2 p : space.pathTo(space.from(m_route.path.back().position), to)) add(p);
}

void RouteMaker::pass(const Step& step, Point2 landing) {
    const Building& building = m_graph.building();
    m_portals.push_back(m_route.path.size() - 1);
    m_route.regions.push_back(building.regions()[step.into].id);
    m_route.accesses.push_back(building.accesses()[step.access].id);
    m_vertical += m_graph.rules().verticalM(step);
    m_route.seconds += m_graph.rules().seconds(step, m_last ? &*m_last : nullptr);
    m_last = step;
    m_region = step.into;
    m_level = building.regions()[step.into].level;
    add(landing);
}

Route RouteMaker::finished() {
    m_route.lengthM = m_flat + m_vertical;
    m_route.seconds += m_graph.rules().walkingSeconds(m_flat);
    m_route.manoeuvres = manoeuvresAlong(m_graph.building(), m_route, m_portals);
    return std::move(m_route);
}

} // namespace farol::routing
