#include "tests/routing/free_space_graph.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <cmath>
#include <limits>

namespace farol::test {

using building::Access;
using building::AccessKind;
using building::OneWay;
using building::Region;

namespace {

constexpr double kTouch = 1e-6;

bool holds(const Polygon& polygon, Point2 p) {
    return distanceToPolygon(polygon, p) <= kTouch;
}

Point2 nearestIn(const Polygon& polygon, Point2 p) {
    if (holds(polygon, p)) return p;
    std::vector<Ring> rings{polygon.outer};
    rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
    Point2 best = polygon.outer[0];
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            Point2 candidate = nearestOnSegment(p, ring[i], ring[(i + 1) % ring.size()]);
            if (distance(p, candidate) < distance(p, best)) best = candidate;
        }
    return best;
}

} // namespace

FreeSpaceGraph::~FreeSpaceGraph() = default;

FreeSpaceGraph::FreeSpaceGraph(std::shared_ptr<const building::Building> building,
                               routing::RouteOptions options)
    : m_building(std::move(building)), m_options(options) {
    for (std::size_t i = 0; i < m_building->regions().size(); ++i) {
        const Region& region = m_building->regions()[i];
        floorOf(region.level).regions.push_back(i);
        std::vector<Ring> rings{region.polygon.outer};
        rings.insert(rings.end(), region.polygon.holes.begin(), region.polygon.holes.end());
        for (const Ring& ring : rings)
            for (std::size_t k = 0; k < ring.size(); ++k) {
                floorOf(region.level).walls.push_back({ring[k], ring[(k + 1) % ring.size()]});
                addNode(i, ring[k]);
            }
    }
    for (std::size_t i = 0; i < m_building->accesses().size(); ++i) addAccess(i);
    addRides();
    addSight();
}

FreeSpaceGraph::Floor& FreeSpaceGraph::floorOf(double level) {
    for (Floor& floor : m_floors)
        if (floor.level == level) return floor;
    m_floors.push_back({level, {}, {}, {}, {}});
    return m_floors.back();
}

std::size_t FreeSpaceGraph::addNode(std::size_t region, Point2 point) {
    m_nodes.push_back({point, region});
    floorOf(m_building->regions()[region].level).nodes.push_back(m_nodes.size() - 1);
    return m_nodes.size() - 1;
}

bool FreeSpaceGraph::usable(std::size_t index, bool forward) const {
    const Access& access = m_building->accesses()[index];
    if (!access.passable() || access.oneWay == (forward ? OneWay::BToA : OneWay::AToB)) return false;
    return !((access.kind == AccessKind::Stairs && m_options.avoidStairs) ||
             (access.kind == AccessKind::Elevator && m_options.avoidElevator) ||
             (access.kind == AccessKind::Escalator && m_options.avoidEscalator));
}

double FreeSpaceGraph::price(const Access& access, double levels) const {
    switch (access.kind) {
    case AccessKind::Door:
        return m_options.doorSeconds;
    case AccessKind::Stairs:
    case AccessKind::Escalator:
        return m_options.stairsSecondsPerLevel * levels;
    default:
        return 0.0;
    }
}

/// A door is two nodes, one on either side; a wide opening is a gate whose ends may be turned about.
void FreeSpaceGraph::addAccess(std::size_t index) {
    const Access& access = m_building->accesses()[index];
    auto a = m_building->regionIndex(access.regionA), b = m_building->regionIndex(access.regionB);
    if (!a || !b || (!usable(index, true) && !usable(index, false))) return;
    const Region &first = m_building->regions()[*a], &second = m_building->regions()[*b];
    double width = access.line.size() == 2 ? distance(access.line[0], access.line[1]) : 0.0;
    bool bothWays = usable(index, true) && usable(index, false);
    if (access.kind == AccessKind::Opening && width >= 1.2 && bothWays) {
        Point2 inset = (access.line[1] - access.line[0]) * (0.4 / width);
        Gate gate{access.line[0] + inset, access.line[1] - inset, *a, *b, true, true};
        floorOf(first.level).gates.push_back(gate);
        for (Point2 end : {gate.a, gate.b}) {
            std::size_t one = addNode(*a, end), other = addNode(*b, end);
            m_arcs.push_back({one, other, 0.0});
            m_arcs.push_back({other, one, 0.0});
        }
        return;
    }
    Point2 inA = nearestIn(first.polygon, access.midpoint()),
           inB = nearestIn(second.polygon, access.midpoint());
    std::size_t one = addNode(*a, inA), other = addNode(*b, inB);
    double levels = std::abs(first.level - second.level);
    double stub = levels > 0.0 ? 0.0 : distance(inA, access.midpoint()) + distance(inB, access.midpoint());
    double seconds = price(access, levels) + stub / m_options.walkingSpeed;
    if (access.kind == AccessKind::Elevator) {
        if (usable(index, true)) m_rides.push_back({index, one, other});
        if (usable(index, false)) m_rides.push_back({index, other, one});
        return;
    }
    if (usable(index, true)) m_arcs.push_back({one, other, seconds});
    if (usable(index, false)) m_arcs.push_back({other, one, seconds});
}

/// One waits for a lift once; whoever rides on only pays for the levels.
void FreeSpaceGraph::addRides() {
    std::vector<std::size_t> aboard;
    auto levels = [&](const Ride& ride) {
        return std::abs(m_building->regions()[m_nodes[ride.in].region].level -
                        m_building->regions()[m_nodes[ride.out].region].level);
    };
    for (const Ride& ride : m_rides) {
        m_nodes.push_back(m_nodes[ride.out]); // on no floor's list: one does not walk while riding
        aboard.push_back(m_nodes.size() - 1);
        m_arcs.push_back({ride.in, aboard.back(),
                          m_options.elevatorSeconds +
                              m_options.elevatorSecondsPerLevel * std::max(0.0, levels(ride) - 1.0)});
        m_arcs.push_back({aboard.back(), ride.out, 0.0});
    }
    for (std::size_t i = 0; i < m_rides.size(); ++i)
        for (std::size_t j = 0; j < m_rides.size(); ++j) {
            const Access& before = m_building->accesses()[m_rides[i].access];
            const Access& after = m_building->accesses()[m_rides[j].access];
            if (m_nodes[m_rides[i].out].region != m_nodes[m_rides[j].in].region || before.shaft.empty() ||
                before.shaft != after.shaft)
                continue;
            double walk = distance(m_nodes[m_rides[i].out].point, m_nodes[m_rides[j].in].point);
            m_arcs.push_back(
                {aboard[i], aboard[j],
                 walk / m_options.walkingSpeed + m_options.elevatorSecondsPerLevel * levels(m_rides[j])});
        }
}

void FreeSpaceGraph::addSight() {
    for (const Floor& floor : m_floors)
        for (std::size_t i = 0; i < floor.nodes.size(); ++i)
            for (std::size_t j = 0; j < floor.nodes.size(); ++j) {
                const Node &from = m_nodes[floor.nodes[i]], &to = m_nodes[floor.nodes[j]];
                if (i == j || !sees(floor, from, to)) continue;
                m_arcs.push_back({floor.nodes[i], floor.nodes[j],
                                  distance(from.point, to.point) / m_options.walkingSpeed});
            }
}

/// Adds the regions one comes into who stands in a gate.
void FreeSpaceGraph::cross(const Floor& floor, Point2 at, std::vector<std::size_t>& regions) {
    for (std::size_t i = 0; i < regions.size(); ++i)
        for (const Gate& gate : floor.gates) {
            if (distanceToSegment(at, gate.a, gate.b) > kTouch) continue;
            for (auto [from, into] : {std::pair(gate.first, gate.second), std::pair(gate.second, gate.first)})
                if (regions[i] == from && std::find(regions.begin(), regions.end(), into) == regions.end())
                    regions.push_back(into);
        }
}

/// Cuts the line wherever it meets a wall or a gate, and follows in which regions one can be between.
bool FreeSpaceGraph::sees(const Floor& floor, const Node& from, const Node& to) const {
    Point2 way = to.point - from.point;
    std::vector<double> cuts{0.0, 1.0};
    auto cut = [&](Point2 a, Point2 b) {
        double turn = farol::cross(way, b - a);
        if (std::abs(turn) < 1e-12) {
            for (Point2 p : {a, b}) // along the line: its ends
                if (distanceToSegment(p, from.point, to.point) <= kTouch)
                    cuts.push_back(dot(p - from.point, way) / dot(way, way));
            return;
        }
        double share = farol::cross(a - from.point, b - a) / turn;
        double part = farol::cross(a - from.point, way) / turn;
        if (share > 0.0 && share < 1.0 && part > -1e-6 && part < 1.0 + 1e-6) cuts.push_back(share);
    };
    if (way == Point2{}) cuts = {0.0};
    if (way != Point2{})
        for (const auto& wall : floor.walls) cut(wall[0], wall[1]);
    if (way != Point2{})
        for (const Gate& gate : floor.gates) cut(gate.a, gate.b);
    std::sort(cuts.begin(), cuts.end());
    std::vector<std::size_t> in{from.region};
    double whole = length(way);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        cross(floor, from.point + way * cuts[i], in);
        if (i + 1 == cuts.size() || (cuts[i + 1] - cuts[i]) * whole < 10.0 * kTouch) continue;
        Point2 middle = from.point + way * ((cuts[i] + cuts[i + 1]) / 2.0);
        std::erase_if(in, [&](std::size_t r) { return !holds(m_building->regions()[r].polygon, middle); });
        if (in.empty()) return false;
    }
    return std::find(in.begin(), in.end(), to.region) != in.end();
}

std::optional<double> FreeSpaceGraph::seconds(const building::Location& from,
                                              const building::Location& to) const {
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                        boost::property<boost::edge_weight_t, double>>;
    Graph graph(m_nodes.size() + 2);
    for (const Arc& arc : m_arcs) boost::add_edge(arc.from, arc.to, arc.seconds, graph);
    Node start{*from.position, *m_building->regionIndex(from.region)};
    Node goal{*to.position, *m_building->regionIndex(to.region)};
    for (const Floor& floor : m_floors)
        for (std::size_t i : floor.nodes) {
            double first = distance(start.point, m_nodes[i].point) / m_options.walkingSpeed;
            double last = distance(goal.point, m_nodes[i].point) / m_options.walkingSpeed;
            if (floor.level == m_building->regions()[start.region].level && sees(floor, start, m_nodes[i]))
                boost::add_edge(m_nodes.size(), i, first, graph);
            if (floor.level == m_building->regions()[goal.region].level && sees(floor, m_nodes[i], goal))
                boost::add_edge(i, m_nodes.size() + 1, last, graph);
        }
    for (const Floor& floor : m_floors)
        if (floor.level == m_building->regions()[start.region].level &&
            floor.level == m_building->regions()[goal.region].level && sees(floor, start, goal))
            boost::add_edge(m_nodes.size(), m_nodes.size() + 1,
                            distance(start.point, goal.point) / m_options.walkingSpeed, graph);
    std::vector<double> costs(boost::num_vertices(graph));
    boost::dijkstra_shortest_paths(graph, boost::vertex(m_nodes.size(), graph),
                                   boost::distance_map(boost::make_iterator_property_map(
                                       costs.begin(), boost::get(boost::vertex_index, graph))));
    double best = costs.back();
    if (best >= std::numeric_limits<double>::max()) return std::nullopt;
    return best;
}

} // namespace farol::test
