#include "core/routing/landmark_bounds.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>
#include <limits>
#include <span>
#include <utility>

namespace farol::routing {

namespace {

using Node = PortalGraph::Node;
using Arc = PortalGraph::Arc;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kLeastNodes = 200; // smaller graphs are searched at once without
constexpr std::size_t kManyNodes = 5000; // from here on two threads are worth their while
/// The distances are rounded; a bound may never be too high.
constexpr double kSlackSeconds = 2e-3;

/// Seconds from a node to all others along the arcs that `arcsOf` gives.
template <class ArcsOf>
std::vector<float> distancesFrom(std::size_t nodes, Node start, const ArcsOf& arcsOf) {
    std::vector<float> seconds(nodes, kInfinity);
    using Entry = std::pair<float, Node>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    seconds[start] = 0.0F;
    open.emplace(0.0F, start);
    while (!open.empty()) {
        auto [paid, node] = open.top();
        open.pop();
        if (paid > seconds[node]) continue;
        for (const Arc& arc : arcsOf(node)) {
            float whole = paid + arc.seconds;
            if (whole >= seconds[arc.to]) continue;
            seconds[arc.to] = whole;
            open.emplace(whole, arc.to);
        }
    }
    return seconds;
}

} // namespace

LandmarkBounds::LandmarkBounds(const PortalGraph& graph, std::size_t landmarks)
    : m_states(graph.stateCount()) {
    std::size_t nodes = graph.nodeCount();
    if (nodes < kLeastNodes || m_states == 0 || landmarks == 0) return;
    Reverse reverse;
    reverse.first.assign(nodes + 1, 0);
    for (Node node = 0; node < nodes; ++node)
        for (const Arc& arc : graph.arcs(node)) ++reverse.first[arc.to + 1];
    for (std::size_t i = 0; i < nodes; ++i) reverse.first[i + 1] += reverse.first[i];
    reverse.arcs.resize(reverse.first.back());
    std::vector<std::size_t> next(reverse.first.begin(), reverse.first.end() - 1);
    for (Node node = 0; node < nodes; ++node)
        for (const Arc& arc : graph.arcs(node)) reverse.arcs[next[arc.to]++] = {node, arc.seconds};

    m_distances.resize(nodes);
    // Each as far from the ones before as any door is; the first as far as may be from the busiest. Bends are
    // none: they are come to by taut ways only, so that ways to them do not add up as distances do.
    Node busiest = 0;
    for (Node node = 0; node < m_states; ++node)
        if (graph.arcs(node).size() > graph.arcs(busiest).size()) busiest = node;
    std::vector<float> gap = distancesFrom(nodes, busiest, [&](Node node) { return graph.arcs(node); });
    while (m_count < std::min(landmarks, kMost)) {
        Node furthest = busiest;
        for (Node node = 0; node < m_states; ++node)
            if (std::isfinite(gap[node]) && gap[node] > gap[furthest]) furthest = node;
        fill(graph, reverse, furthest);
        gap = nearest();
    }
}

void LandmarkBounds::fill(const PortalGraph& graph, const Reverse& reverse, Node landmark) {
    std::size_t nodes = graph.nodeCount();
    auto forwards = [&] {
        return distancesFrom(nodes, landmark, [&](Node node) { return graph.arcs(node); });
    };
    auto backwards = [&] {
        return distancesFrom(nodes, landmark, [&](Node node) {
            return std::span<const Arc>(reverse.arcs.data() + reverse.first[node],
                                        reverse.first[node + 1] - reverse.first[node]);
        });
    };
    auto other = std::async(nodes < kManyNodes ? std::launch::deferred : std::launch::async, forwards);
    std::vector<float> to = backwards(), from = other.get();
    for (std::size_t node = 0; node < nodes; ++node) {
        m_distances[node].from[m_count] = from[node];
        m_distances[node].to[m_count] = to[node];
    }
    ++m_count;
}

/// Of each node to the landmark it is nearest to, there.
std::vector<float> LandmarkBounds::nearest() const {
    std::vector<float> gap;
    gap.reserve(m_distances.size());
    for (const Distances& each : m_distances)
        gap.push_back(
            *std::min_element(each.from.begin(), each.from.begin() + static_cast<std::ptrdiff_t>(m_count)));
    return gap;
}

LandmarkBounds::Goal::Goal(const LandmarkBounds& bounds) : m_bounds(bounds) {
    m_distances.from.fill(kInfinity);
    m_distances.to.fill(-kInfinity);
}

void LandmarkBounds::Goal::addDoor() {
    endDoors();
    m_door.from.fill(kInfinity);
    m_door.to.fill(kInfinity);
    m_hasDoor = true;
}

/// Whichever door is taken: the nearest from a landmark, the furthest to it.
void LandmarkBounds::Goal::endDoors() {
    for (std::size_t i = 0; m_hasDoor && i < m_bounds.count(); ++i) {
        m_distances.from[i] = std::min(m_distances.from[i], m_door.from[i]);
        m_distances.to[i] = std::max(m_distances.to[i], m_door.to[i]);
    }
    m_hasDoor = false;
}

void LandmarkBounds::Goal::reachedFrom(Node node, double seconds) {
    for (std::size_t i = 0; i < m_bounds.count(); ++i)
        m_door.from[i] = std::min(m_door.from[i], m_bounds.at(node).from[i] + static_cast<float>(seconds));
}

void LandmarkBounds::Goal::leadsTo(Node node, double seconds) {
    for (std::size_t i = 0; i < m_bounds.count(); ++i)
        m_door.to[i] = std::min(m_door.to[i], m_bounds.at(node).to[i] + static_cast<float>(seconds));
}

double LandmarkBounds::Goal::bound(Node node, std::size_t i) const {
    const Distances& here = m_bounds.at(node);
    double best = 0.0;
    // Where a landmark cannot be reached, or reaches nothing here, it tells nothing.
    if (std::isfinite(here.from[i]) && std::isfinite(m_distances.from[i]))
        best = std::max(best, static_cast<double>(m_distances.from[i] - here.from[i]));
    // One leaves a bend only where a taut way would: from the goal it may be nearer to a landmark than the
    // bend's own ways and the way to the goal say.
    if (node < m_bounds.m_states && std::isfinite(here.to[i]) && std::isfinite(m_distances.to[i]))
        best = std::max(best, static_cast<double>(here.to[i] - m_distances.to[i]));
    return best;
}

void LandmarkBounds::Goal::chooseFor(const std::vector<std::pair<Node, double>>& starts) {
    std::array<std::pair<double, std::size_t>, kMost> ranked{};
    for (std::size_t i = 0; i < m_bounds.count(); ++i) {
        ranked[i] = {0.0, i};
        for (const auto& start : starts) ranked[i].first = std::max(ranked[i].first, bound(start.first, i));
    }
    std::sort(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(m_bounds.count()),
              [](const auto& a, const auto& b) { return a.first > b.first; });
    m_chosenCount = std::min(m_chosen.size(), m_bounds.count());
    for (std::size_t i = 0; i < m_chosenCount; ++i) m_chosen[i] = ranked[i].second;
}

double LandmarkBounds::Goal::atLeast(Node node) const {
    double best = kSlackSeconds;
    for (std::size_t i = 0; i < m_chosenCount; ++i) best = std::max(best, bound(node, m_chosen[i]));
    return best - kSlackSeconds;
}

} // namespace farol::routing
