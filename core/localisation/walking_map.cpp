#include "core/localisation/walking_map.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace farol::localisation {

using building::Access;
using building::AccessKind;
using building::Region;
using building::RegionKind;

namespace {

constexpr double kDoorM = 0.3, kStairsM = 12.0, kLiftM = 14.0; // walking that takes as long as one level does
constexpr double kCornerClearanceM = 0.35;                     // people do not walk along the very wall
constexpr double kConvexShare = 0.93; // of the convex hull: alcoves do not bend a region
constexpr std::size_t kMostCorners = 60;

double crossAt(Point2 o, Point2 a, Point2 b) {
    return cross(a - o, b - o);
}

double hullArea(Ring points) {
    if (points.size() < 3) return 0.0;
    std::sort(points.begin(), points.end(),
              [](Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    Ring hull(2 * points.size());
    std::size_t k = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        while (k >= 2 && crossAt(hull[k - 2], hull[k - 1], points[i]) <= 0) --k;
        hull[k++] = points[i];
    }
    std::size_t lower = k + 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) {
        while (k >= lower && crossAt(hull[k - 2], hull[k - 1], points[i]) <= 0) --k;
        hull[k++] = points[i];
    }
    hull.resize(k > 0 ? k - 1 : 0);
    return std::abs(signedArea(hull));
}

bool meetsRing(const Ring& ring, Point2 a, Point2 b) {
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (segmentsCross(a, b, ring[i], ring[(i + 1) % ring.size()])) return true;
    return false;
}

double lengthOfCrossing(const Access& access) {
    if (access.kind == AccessKind::Stairs || access.kind == AccessKind::Escalator) return kStairsM;
    return access.kind == AccessKind::Elevator ? kLiftM : kDoorM;
}

/// Where one stands when passing: the access itself, unless it lies far off the region (stairs whose ends are
/// drawn apart).
Point2 standingIn(const Region& region, Point2 at) {
    constexpr double kFarM = 3.0;
    return distanceToPolygon(region.polygon, at) > kFarM ? pointInside(region.polygon) : at;
}

} // namespace

float gapBetween(Spot a, Spot b) {
    float dx = a.x - b.x, dy = a.y - b.y;
    return std::sqrt(dx * dx + dy * dy);
}

WalkingMap::WalkingMap(std::shared_ptr<const building::Building> building) : m_building(std::move(building)) {
    for (const Region& region : m_building->regions()) {
        if (auto box = boundingBox(region.polygon.outer); box && isFinite(box->low)) {
            m_origin = box->low;
            break;
        }
    }
    measureRegions();
    m_nodes.reserve(2 * m_building->accesses().size());
    for (const Access& access : m_building->accesses()) {
        auto a = m_building->regionIndex(access.regionA), b = m_building->regionIndex(access.regionB);
        if (!access.passable() || !a || !b || *a == *b || access.line.empty()) continue;
        if (isFinite(access.midpoint()))
            addAccess(access, static_cast<std::uint32_t>(*a), static_cast<std::uint32_t>(*b));
    }
    for (std::uint32_t r = 0; r < m_bent.size(); ++r)
        if (m_bent[r] != 0) addCorners(r);
    indexNodes();
}

void WalkingMap::measureRegions() {
    constexpr double kCorridorWidthM = 3.6, kStepM = 1.0, kRoomStepM = 2.2;
    const auto& regions = m_building->regions();
    m_bent.assign(regions.size(), 0);
    m_middles.resize(regions.size());
    m_frames.resize(regions.size());
    m_weightsUpTo.resize(regions.size());
    double total = 0.0;
    for (std::size_t r = 0; r < regions.size(); ++r) {
        const Region& region = regions[r];
        auto box = boundingBox(region.polygon.outer);
        if (box && isFinite(box->low) && isFinite(box->high) && region.polygon.outer.size() >= 3) {
            m_middles[r] = local(pointInside(region.polygon));
            const Ring& ring = region.polygon.outer;
            if (ring.size() == 4)
                m_frames[r] =
                    frameOf(region.polygon, local(ring[0]), local(ring[1]), local(ring[2]), local(ring[3]));
            double size = area(region.polygon), hull = hullArea(region.polygon.outer);
            m_bent[r] = size < kConvexShare * hull ? 1 : 0;
            double half = length(region.polygon.outer) / 2.0;
            // Of a rectangle a x b, from a + b and a b.
            double root = std::sqrt(std::max(0.0, half * half - 4.0 * size));
            double width = std::max(0.1, (half - root) / 2.0), run = (half + root) / 2.0;
            bool lane = region.kind != RegionKind::Room && width <= kCorridorWidthM;
            total += lane ? std::max(1.0, run / kStepM)
                          : std::max(1.0, std::ceil(width / kRoomStepM) * std::ceil(run / kRoomStepM));
        }
        m_weightsUpTo[r] = total;
    }
}

namespace {

/// Across a door from one region into the other: the side on which there is less of the one and more of the
/// other.
Spot outwards(const Polygon& from, const Polygon& into, Point2 at, Spot sill) {
    int best = 0;
    Spot way;
    for (double side : {1.0, -1.0}) {
        int speaksForIt = 0;
        for (double metres : {0.2, 0.5}) {
            Point2 there{at.x - side * metres * double(sill.y), at.y + side * metres * double(sill.x)};
            Point2 here{at.x + side * metres * double(sill.y), at.y - side * metres * double(sill.x)};
            speaksForIt +=
                contains(into, there) + contains(from, here) - contains(from, there) - contains(into, here);
        }
        if (speaksForIt <= best) continue;
        best = speaksForIt;
        way = {static_cast<float>(-side) * sill.y, static_cast<float>(side) * sill.x};
    }
    return way;
}

} // namespace

void WalkingMap::addAccess(const Access& access, std::uint32_t a, std::uint32_t b) {
    const auto& regions = m_building->regions();
    Point2 at = access.midpoint();
    WalkingNode one, two;
    one.at = local(standingIn(regions[a], at));
    two.at = local(standingIn(regions[b], at));
    one.region = a;
    two.region = b;
    auto first = static_cast<std::int32_t>(m_nodes.size());
    if (access.oneWay != building::OneWay::BToA) one.across = first + 1;
    if (access.oneWay != building::OneWay::AToB) two.across = first;
    one.changesLevel = two.changesLevel = access.changesLevel();
    one.isLift = two.isLift = access.kind == AccessKind::Elevator;
    one.kind = two.kind = access.kind;
    one.crossingM = two.crossingM = static_cast<float>(lengthOfCrossing(access));
    Point2 ends = access.line.back() - access.line.front();
    if (double wide = length(ends); wide > 1.2 && !access.changesLevel()) {
        one.along = {float(ends.x / wide), float(ends.y / wide)};
        one.halfWidthM = float(std::min(1.5, wide / 2.0 - 0.4));
        two.along = one.along;
        two.halfWidthM = one.halfWidthM;
    }
    one.isOpening = two.isOpening = access.kind == AccessKind::Opening;
    double open = length(ends);
    if (open > 0.1) one.sill = two.sill = {float(ends.x / open), float(ends.y / open)};
    one.halfOpenM = two.halfOpenM = float(std::max(open, access.widthM.value_or(0.9)) / 2.0);
    one.out = outwards(regions[a].polygon, regions[b].polygon, at, one.sill);
    two.out = outwards(regions[b].polygon, regions[a].polygon, at, one.sill);
    m_nodes.push_back(one);
    m_nodes.push_back(two);
}

/// Corners that stand into the region, a little away from the wall.
void WalkingMap::addCorners(std::uint32_t region) {
    const Polygon& polygon = m_building->regions()[region].polygon;
    std::size_t count = 0;
    auto ofRing = [&](const Ring& ring, bool outer) {
        bool left = (signedArea(ring) > 0) == outer; // free space to the left of the edges?
        for (std::size_t i = 0; i < ring.size() && count < kMostCorners; ++i) {
            Point2 before = ring[(i + ring.size() - 1) % ring.size()], at = ring[i],
                   after = ring[(i + 1) % ring.size()];
            Point2 in = at - before, out = after - at;
            double li = length(in), lo = length(out);
            constexpr double kNotchM = 0.6;
            if (li < kNotchM || lo < kNotchM) continue;
            double turn = cross(in, out) / (li * lo) * (left ? 1.0 : -1.0);
            if (turn > -0.2) continue;
            Point2 away = in * (1.0 / li) - out * (1.0 / lo);
            double size = length(away);
            if (size < 1e-6) continue;
            Point2 spot = at + away * (kCornerClearanceM / size);
            if (!contains(polygon, spot)) continue;
            WalkingNode node;
            node.at = local(spot);
            node.region = region;
            m_nodes.push_back(node);
            ++count;
        }
    };
    ofRing(polygon.outer, true);
    for (const Ring& hole : polygon.holes) ofRing(hole, false);
}

void WalkingMap::indexNodes() {
    std::size_t count = m_building->regions().size();
    m_firstNode.assign(count + 1, 0);
    for (const WalkingNode& node : m_nodes) ++m_firstNode[node.region + 1];
    for (std::size_t r = 0; r < count; ++r) m_firstNode[r + 1] += m_firstNode[r];
    m_nodeOfRegion.resize(m_nodes.size());
    std::vector<std::uint32_t> next(m_firstNode.begin(), m_firstNode.end() - 1);
    for (std::uint32_t n = 0; n < m_nodes.size(); ++n) m_nodeOfRegion[next[m_nodes[n].region]++] = n;
}

Spot WalkingMap::local(Point2 p) const {
    return {static_cast<float>(p.x - m_origin.x), static_cast<float>(p.y - m_origin.y)};
}

std::span<const std::uint32_t> WalkingMap::nodesOf(std::uint32_t region) const {
    return std::span(m_nodeOfRegion)
        .subspan(m_firstNode[region], m_firstNode[region + 1] - m_firstNode[region]);
}

bool WalkingMap::straight(std::uint32_t region, Spot a, Spot b) const {
    if (m_bent[region] == 0) return true;
    const Polygon& polygon = m_building->regions()[region].polygon;
    Point2 from = global(a), to = global(b);
    // Ends on the wall itself (doors) must not count as crossing it.
    Point2 p = from + (to - from) * 0.02, q = from + (to - from) * 0.98;
    if (meetsRing(polygon.outer, p, q)) return false;
    for (const Ring& hole : polygon.holes)
        if (meetsRing(hole, p, q)) return false;
    return contains(polygon, (p + q) * 0.5);
}

bool WalkingMap::nodesSee(std::uint32_t region, std::size_t i, std::size_t j) {
    constexpr char kNotYet = 2;
    if (m_bent[region] == 0 || i == j) return true;
    auto nodes = nodesOf(region);
    std::vector<char>& seen = m_sights[region];
    if (seen.empty()) seen.assign(nodes.size() * nodes.size(), kNotYet);
    char& known = seen[std::min(i, j) * nodes.size() + std::max(i, j)];
    if (known == kNotYet) known = straight(region, m_nodes[nodes[i]].at, m_nodes[nodes[j]].at) ? 1 : 0;
    return known != 0;
}

WalkingMap::Frame WalkingMap::frameOf(const Polygon& polygon, Spot first, Spot second, Spot third,
                                      Spot fourth) {
    constexpr float kStraightM = 0.05F, kLeastM2 = 0.01F;
    Frame frame{
        first, {second.x - first.x, second.y - first.y}, {fourth.x - first.x, fourth.y - first.y}, 0.0F};
    Spot across{second.x + frame.b.x, second.y + frame.b.y};
    float size = frame.a.x * frame.b.y - frame.a.y * frame.b.x;
    bool fits = polygon.holes.empty() && gapBetween(across, third) < kStraightM && std::abs(size) > kLeastM2;
    if (fits) frame.inverse = 1.0F / size;
    return frame;
}

bool WalkingMap::inside(std::uint32_t region, Spot s) const {
    const Frame& frame = m_frames[region];
    if (frame.inverse == 0.0F) return contains(m_building->regions()[region].polygon, global(s));
    float dx = s.x - frame.corner.x, dy = s.y - frame.corner.y;
    float u = (dx * frame.b.y - dy * frame.b.x) * frame.inverse;
    float v = (frame.a.x * dy - frame.a.y * dx) * frame.inverse;
    return u >= 0.0F && u <= 1.0F && v >= 0.0F && v <= 1.0F;
}

Spot WalkingMap::spotIn(std::uint32_t region, float u, float v) const {
    const Frame& frame = m_frames[region];
    if (frame.inverse != 0.0F)
        return {frame.corner.x + u * frame.a.x + v * frame.b.x,
                frame.corner.y + u * frame.a.y + v * frame.b.y};
    auto box = boundingBox(m_building->regions()[region].polygon.outer);
    if (!box) return m_middles[region];
    Spot low = local(box->low), high = local(box->high);
    constexpr int kTries = 8;
    for (int i = 0; i < kTries; ++i) {
        Spot spot{low.x + u * (high.x - low.x), low.y + v * (high.y - low.y)};
        if (inside(region, spot)) return spot;
        // Steps that fill a square evenly.
        u += 0.7548777F;
        v += 0.5698403F;
        u -= std::floor(u);
        v -= std::floor(v);
    }
    return m_middles[region];
}

double WalkingMap::weightOf(std::uint32_t region) const {
    return m_weightsUpTo[region] - (region > 0 ? m_weightsUpTo[region - 1] : 0.0);
}

std::uint32_t WalkingMap::regionAtShare(double u) const {
    auto it = std::upper_bound(m_weightsUpTo.begin(), m_weightsUpTo.end(), u * totalWeight());
    if (it == m_weightsUpTo.end()) --it;
    return static_cast<std::uint32_t>(it - m_weightsUpTo.begin());
}

void WalkingMap::setGoal(std::uint32_t region, Spot spot) {
    m_goalRegion = region;
    m_goalSpot = spot;
    m_toGoal.assign(m_nodes.size(), kUnreachable);
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    auto offer = [&](std::uint32_t node, float cost) {
        if (cost >= m_toGoal[node]) return;
        m_toGoal[node] = cost;
        open.emplace(cost, node);
    };
    for (std::uint32_t node : nodesOf(region))
        if (straight(region, m_nodes[node].at, spot)) offer(node, gapBetween(m_nodes[node].at, spot));
    if (open.empty())
        for (std::uint32_t node : nodesOf(region)) offer(node, gapBetween(m_nodes[node].at, spot));
    while (!open.empty()) {
        auto [cost, n] = open.top();
        open.pop();
        if (cost > m_toGoal[n]) continue;
        const WalkingNode& node = m_nodes[n];
        auto peers = nodesOf(node.region);
        auto self = static_cast<std::size_t>(std::lower_bound(peers.begin(), peers.end(), n) - peers.begin());
        for (std::size_t i = 0; i < peers.size(); ++i) {
            float next = cost + gapBetween(node.at, m_nodes[peers[i]].at);
            if (next < m_toGoal[peers[i]] && nodesSee(node.region, self, i)) offer(peers[i], next);
        }
        // The way out of the other side leads here.
        std::uint32_t twin = n ^ 1U;
        if (twin < m_nodes.size() && m_nodes[twin].across == static_cast<std::int32_t>(n))
            offer(twin, cost + m_nodes[twin].crossingM);
    }
}

bool WalkingMap::leadsOn(std::uint32_t node) const {
    constexpr float kSlack = 0.01F;
    std::int32_t across = m_nodes[node].across;
    if (across < 0) return m_toGoal[node] < kUnreachable;
    return m_toGoal[static_cast<std::size_t>(across)] + m_nodes[node].crossingM <= m_toGoal[node] + kSlack &&
           m_toGoal[node] < kUnreachable;
}

bool WalkingMap::fits(std::uint32_t node, const ToldWay& told) const {
    const WalkingNode& here = m_nodes[node];
    if (here.across < 0) return false;
    auto levelOf = [&](std::uint32_t region) { return m_building->regions()[region].level; };
    std::uint32_t beyond = m_nodes[static_cast<std::size_t>(here.across)].region;
    double rises = levelOf(beyond) - levelOf(here.region);
    // Whoever is told to take a lift goes through its door first.
    bool intoLift = !here.isLift && m_building->regions()[beyond].kind == building::RegionKind::Elevator;
    for (const ToldWay::Passage& passage : told.passages) {
        if (intoLift && passage.kind == AccessKind::Elevator) return true;
        if (passage.kind != here.kind || (passage.intoLift && !intoLift)) continue;
        // In a lift one chooses the level, on stairs only up or down.
        double wanted = passage.targetLevel - (here.isLift ? levelOf(here.region) : passage.level);
        if (rises == 0.0 ? wanted == 0.0 : rises * wanted > 0.0) return true;
    }
    return false;
}

bool WalkingMap::fitsHere(std::uint32_t node, const ToldWay& told) const {
    if (!fits(node, told)) return false;
    const WalkingNode& here = m_nodes[node];
    if (here.isLift) return true;
    double level = m_building->regions()[here.region].level;
    return std::any_of(told.passages.begin(), told.passages.end(), [&](const ToldWay::Passage& passage) {
        return passage.kind == here.kind && passage.level == level;
    });
}

void WalkingMap::clearGoal() {
    m_goalRegion = kNoRegion;
    m_toGoal.clear();
    m_toGoal.shrink_to_fit();
}

} // namespace farol::localisation
