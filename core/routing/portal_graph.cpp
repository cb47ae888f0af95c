#include "core/routing/portal_graph.h"

#include "core/routing/wide_opening.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <numeric>
#include <utility>

namespace farol::routing {

using building::Access;
using building::Region;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostDoorsOfDeadEnd = 4;
constexpr std::size_t kManyZones = 2000;

std::size_t rootOf(std::vector<std::uint32_t>& parents, std::size_t i) {
    while (parents[i] != i) i = parents[i] = parents[parents[i]];
    return i;
}

} // namespace

PortalGraph::PortalGraph(const RouteGraph& graph) : m_graph(graph) {
    joinRegions();
    const Building& building = graph.building();
    std::vector<bool> wide(building.accesses().size(), false);
    for (const WideOpening& opening : m_openings) wide[opening.access] = true;
    for (std::size_t i = 0; i < building.accesses().size(); ++i) {
        if (wide[i]) continue;
        auto side = building.regionIndex(building.accesses()[i].regionA);
        auto step = side ? graph.rules().stepThrough(i, *side) : std::nullopt;
        if (step) addPortal(i, *step);
    }
    addZones();
    findDeadEnds();
    addBends();
    addArcs();
}

/// Regions are one zone where openings join them that anybody may cross anywhere, to and fro.
void PortalGraph::joinRegions() {
    const Building& building = m_graph.building();
    const RouteRules& rules = m_graph.rules();
    std::vector<std::uint32_t> parents(building.regions().size());
    std::iota(parents.begin(), parents.end(), 0U);
    for (std::size_t i = 0; i < building.accesses().size(); ++i) {
        const Access& access = building.accesses()[i];
        if (access.kind != building::AccessKind::Opening) continue;
        auto side = building.regionIndex(access.regionA);
        auto step = side ? rules.stepThrough(i, *side) : std::nullopt;
        if (!step || !rules.allowed(*step) || !rules.allowed({i, step->into, step->from}) ||
            rules.changesLevel(*step) || rules.barred(step->from) || rules.barred(step->into))
            continue;
        const Polygon& polygon = building.regions()[step->from].polygon;
        if (walkableWidth(access, polygon).empty()) continue;
        auto opening = wideOpening(access, polygon, m_graph.space(step->from), m_graph.space(step->into));
        if (!opening) continue;
        opening->access = i;
        opening->first = step->from;
        opening->second = step->into;
        m_openings.push_back(*opening);
        parents[rootOf(parents, step->from)] = static_cast<std::uint32_t>(rootOf(parents, step->into));
    }
    m_zoneOf.assign(parents.size(), kNoZone);
    for (std::size_t i = 0; i < parents.size(); ++i) {
        std::uint32_t& zone = m_zoneOf[rootOf(parents, i)];
        if (zone == kNoZone) {
            zone = static_cast<std::uint32_t>(m_zones.size());
            m_zones.emplace_back();
        }
        m_zoneOf[i] = zone;
        m_zones[zone].regions.push_back(i);
    }
}

void PortalGraph::addPortal(std::size_t access, const Step& step) {
    const RouteRules& rules = m_graph.rules();
    const Building& building = m_graph.building();
    Portal portal;
    portal.access = static_cast<std::uint32_t>(access);
    portal.lift = rules.isLift(access);
    Point2 middle = building.accesses()[access].midpoint();
    if (!isFinite(middle)) return;
    bool climbs = rules.changesLevel(step);
    for (std::size_t side : {0, 1}) {
        std::size_t region = side == 0 ? step.from : step.into;
        portal.region[side] = static_cast<std::uint32_t>(region);
        portal.entry[side] = nearestWithin(building.regions()[region].polygon, middle);
        // Stairs that come out elsewhere than they begin are walked on the stairs, not beside them.
        if (!climbs) portal.stub[side] = distance(middle, portal.entry[side]);
        Step into = side == 1 ? step : Step{access, step.into, step.from};
        portal.pass[side] = rules.allowed(into) ? rules.seconds(into, nullptr) : kInfinity;
    }
    if (std::isfinite(portal.pass[0]) || std::isfinite(portal.pass[1])) m_portals.push_back(portal);
}

void PortalGraph::addZones() {
    for (Node state = 0; state < stateCount(); ++state)
        m_zones[m_zoneOf[regionFrom(state)]].leaving.push_back(state);
    std::vector<std::vector<WideOpening>> openings(m_zones.size());
    for (const WideOpening& each : m_openings) openings[m_zoneOf[each.first]].push_back(each);
    for (std::size_t i = 0; i < m_zones.size(); ++i) {
        Zone& zone = m_zones[i];
        if (zone.regions.size() < 2) continue;
        std::vector<const WalkingSpace*> spaces;
        for (std::size_t region : zone.regions) spaces.push_back(&m_graph.space(region));
        zone.open = std::make_unique<OpenZone>(zone.regions, std::move(spaces), openings[i]);
    }
}

/// Zones that lie on no way between others are left out of the search unless one starts or ends there: most
/// rooms. Then what only leads to such, and so on.
void PortalGraph::findDeadEnds() {
    std::vector<std::uint32_t> open(m_zones.size());
    std::iota(open.begin(), open.end(), 0U);
    while (!open.empty()) {
        std::uint32_t zone = open.back();
        open.pop_back();
        if (m_zones[zone].parent == kNoZone && makeDeadEnd(zone)) open.push_back(m_zones[zone].parent);
    }
}

bool PortalGraph::makeDeadEnd(std::uint32_t zone) {
    const std::vector<Node>& out = m_zones[zone].leaving;
    if (out.empty() || out.size() > kMostDoorsOfDeadEnd) return false;
    std::uint32_t parent = zoneOfNode(out.front());
    for (Node state : out)
        if (zoneOfNode(state) != parent || parent == zone) return false;
    if (!noShortcut(out)) return false;
    m_zones[zone].parent = parent;
    for (Node state : out) {
        std::erase(m_zones[parent].leaving, state ^ 1U);
        m_zones[parent].deadEnds.push_back(state ^ 1U);
    }
    return true;
}

/// Is it never shorter to go in by one door and out by another than to stay outside?
bool PortalGraph::noShortcut(const std::vector<Node>& out) const {
    for (std::size_t i = 0; i < out.size(); ++i)
        for (std::size_t j = i + 1; j < out.size(); ++j) {
            const Access& a = m_graph.building().accesses()[portal(out[i]).access];
            const Access& b = m_graph.building().accesses()[portal(out[j]).access];
            if (m_graph.rules().changesLevel(stepOf(out[i])) || m_graph.rules().changesLevel(stepOf(out[j])))
                return false;
            double inside = walkingSeconds(distance(a.midpoint(), b.midpoint()));
            double doors = std::min(passSeconds(out[i], kNone) + passSeconds(out[j] ^ 1U, kNone),
                                    passSeconds(out[j], kNone) + passSeconds(out[i] ^ 1U, kNone));
            if (walkingSeconds(metresFromTo(out[i], out[j] ^ 1U)) > inside + doors) return false;
        }
    return true;
}

void PortalGraph::addBends() {
    auto next = static_cast<Node>(stateCount());
    for (std::uint32_t i = 0; i < m_zones.size(); ++i) {
        Zone& zone = m_zones[i];
        if (!zone.open) continue;
        zone.firstBend = next;
        next += static_cast<Node>(zone.open->bendCount());
        m_bendZone.resize(next - stateCount(), i);
        for (Node state : zone.leaving)
            zone.open->addTarget(regionFrom(state), portal(state).entry[1 - state % 2]);
    }
}

void PortalGraph::addArcs() {
    std::vector<Row> rows(stateCount() + m_bendZone.size());
    // Zones share no row. Where there are many, two threads share the work.
    std::atomic<std::size_t> next{0};
    auto work = [&] {
        for (std::size_t i = next++; i < m_zones.size(); i = next++) addArcsOfZone(m_zones[i], rows);
    };
    if (m_zones.size() < kManyZones) {
        work();
    } else {
        auto other = std::async(std::launch::async, work);
        work();
        other.get();
    }
    m_firstArc.reserve(rows.size() + 1);
    m_firstShut.reserve(rows.size());
    m_firstArc.push_back(0);
    for (const Row& row : rows) {
        m_firstShut.push_back(m_firstArc.back() + row.arcs.size());
        m_firstArc.push_back(m_firstShut.back() + row.shut.size());
    }
    m_arcs.reserve(m_firstArc.back());
    for (const Row& row : rows) {
        m_arcs.insert(m_arcs.end(), row.arcs.begin(), row.arcs.end());
        m_arcs.insert(m_arcs.end(), row.shut.begin(), row.shut.end());
    }
}

void PortalGraph::addRow(Node node, const std::vector<Link>& links, std::vector<Row>& rows) const {
    double stub = isState(node) ? portal(node).stub[node % 2] : 0.0;
    Row& row = rows[node];
    // Back through the same door is an arc too: never taken, but the bounds of the search rest on it.
    for (const Link& link : links) {
        double walk = walkingSeconds(stub + link.metres);
        double pass = passSeconds(link.node, node);
        (std::isfinite(pass) ? row.arcs : row.shut)
            .push_back({link.node, static_cast<float>(std::isfinite(pass) ? walk + pass : walk)});
    }
    row.arcs.shrink_to_fit();
}

void PortalGraph::addArcsOfZone(const Zone& zone, std::vector<Row>& rows) const {
    // A room with one door is walked through by nobody.
    if (!zone.open && zone.leaving.size() + zone.deadEnds.size() < 2) return;
    for (const std::vector<Node>* states : {&zone.leaving, &zone.deadEnds})
        for (Node state : *states) addRow(state ^ 1U, linksFrom(before(state)), rows);
    for (std::size_t i = 0; zone.open && i < zone.open->bendCount(); ++i) {
        std::vector<Link> links;
        for (const OpenZone::Seen& seen : zone.open->seenFromBend(i)) links.push_back(linkTo(zone, seen));
        addRow(zone.firstBend + static_cast<Node>(i), links, rows);
    }
}

PortalGraph::Link PortalGraph::linkTo(const Zone& zone, const OpenZone::Seen& seen) const {
    if (seen.what < zone.open->bendCount())
        return {zone.firstBend + static_cast<Node>(seen.what), seen.metres};
    Node state = zone.leaving[seen.what - zone.open->bendCount()];
    return {state, seen.metres + portal(state).stub[1 - state % 2]};
}

Step PortalGraph::stepOf(Node state) const {
    return {portal(state).access, regionFrom(state), regionInto(state)};
}

Point2 PortalGraph::bendAt(Node bend) const {
    return m_zones[m_bendZone[bend - stateCount()]].open->bend(bendIn(bend));
}

std::size_t PortalGraph::bendIn(Node bend) const {
    return bend - m_zones[m_bendZone[bend - stateCount()]].firstBend;
}

std::span<const PortalGraph::Arc> PortalGraph::arcs(Node node) const {
    return {m_arcs.data() + m_firstArc[node], m_firstShut[node] - m_firstArc[node]};
}

double PortalGraph::passSeconds(Node state, Node before) const {
    if (!isState(state)) return 0.0;
    const Portal& each = portal(state);
    double alone = each.pass[state % 2];
    if (!each.lift || before == kNone || !isState(before) || !portal(before).lift || !std::isfinite(alone))
        return alone;
    Step previous = stepOf(before);
    return m_graph.rules().seconds(stepOf(state), &previous);
}

std::uint32_t PortalGraph::zoneOfNode(Node node) const {
    return isState(node) ? m_zoneOf[regionInto(node)] : m_bendZone[node - stateCount()];
}

void PortalGraph::waysInto(std::uint32_t deadEnd, std::vector<Node>& ways) const {
    for (Node state : m_zones[deadEnd].leaving) ways.push_back(state ^ 1U);
}

Endpoint PortalGraph::before(Node leaving) const {
    return {regionFrom(leaving), portal(leaving).entry[1 - leaving % 2]};
}

std::vector<PortalGraph::Link> PortalGraph::linksFrom(const Endpoint& point) const {
    const Zone& zone = m_zones[m_zoneOf[point.region]];
    std::vector<Link> links;
    if (zone.open) {
        for (const OpenZone::Seen& seen : zone.open->seenFrom(point.region, point.position))
            links.push_back(linkTo(zone, seen));
        return links;
    }
    const WalkingSpace& space = m_graph.space(point.region);
    std::optional<WalkingSpace::Tree> tree;
    if (!space.open()) tree = space.from(point.position);
    for (Node state : zone.leaving) {
        Point2 door = portal(state).entry[1 - state % 2];
        double metres = tree ? space.lengthTo(*tree, door) : distance(point.position, door);
        links.push_back({state, metres + portal(state).stub[1 - state % 2]});
    }
    return links;
}

double PortalGraph::metresBetween(const Endpoint& a, const Endpoint& b) const {
    const Zone& zone = m_zones[m_zoneOf[a.region]];
    if (zone.open) {
        auto leg = zone.open->legTo(zone.open->placeOf(a.region), a.position, b.region, b.position);
        return leg.clear ? leg.metres : kInfinity;
    }
    const WalkingSpace& space = m_graph.space(a.region);
    return space.lengthTo(space.from(a.position), b.position);
}

double PortalGraph::metresTo(const Endpoint& point, Node leaving) const {
    return metresBetween(point, before(leaving)) + portal(leaving).stub[1 - leaving % 2];
}

double PortalGraph::metresFromTo(Node arrived, Node leaving) const {
    return metresTo(before(arrived ^ 1U), leaving) + portal(arrived).stub[arrived % 2];
}

} // namespace farol::routing
