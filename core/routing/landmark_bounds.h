#pragma once
// Lower bounds for the search: how far it is from and to a few far-off nodes is known, and by the triangle
// inequality it is at least so far to the goal (A*, landmarks, triangle inequality).

#include "core/routing/portal_graph.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace farol::routing {

class LandmarkBounds {
public:
    static constexpr std::size_t kMost = 8;
    /// With `landmarks` 0 there are no bounds: the search is Dijkstra's.
    explicit LandmarkBounds(const PortalGraph& graph, std::size_t landmarks = kMost);

    /// Seconds to and from the landmarks; infinite where there is no way.
    struct Distances {
        std::array<float, kMost> from{};
        std::array<float, kMost> to{};
    };
    std::size_t count() const { return m_count; }
    const Distances& at(PortalGraph::Node node) const { return m_distances[node]; }

    /// A place that is the goal: it can be told only from the nodes around it.
    class Goal {
    public:
        explicit Goal(const LandmarkBounds& bounds);
        /// One of the doors to it, or the goal itself: what follows is told of that one.
        void addDoor();
        /// One comes to it from this node.
        void reachedFrom(PortalGraph::Node node, double seconds);
        /// Who stands there can go on to this node.
        void leadsTo(PortalGraph::Node node, double seconds);
        /// After the last door.
        void endDoors();
        /// Of the landmarks the few that tell most on the way from a node.
        void chooseFor(const std::vector<std::pair<PortalGraph::Node, double>>& starts);
        /// At least so many seconds from a node to the goal.
        double atLeast(PortalGraph::Node node) const;

    private:
        double bound(PortalGraph::Node node, std::size_t landmark) const;

        const LandmarkBounds& m_bounds;
        Distances m_distances, m_door;
        std::array<std::size_t, 3> m_chosen{};
        std::size_t m_chosenCount = 0;
        bool m_hasDoor = false;
    };

private:
    struct Reverse {
        std::vector<std::size_t> first;
        std::vector<PortalGraph::Arc> arcs;
    };
    void fill(const PortalGraph& graph, const Reverse& reverse, PortalGraph::Node landmark);
    std::vector<float> nearest() const;

    std::size_t m_states; ///< nodes from here on are bends
    std::size_t m_count = 0;
    std::vector<Distances> m_distances;
};

} // namespace farol::routing
