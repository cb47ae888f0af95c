#pragma once
// The least costly way through the portal graph.

#include "core/routing/landmark_bounds.h"
#include "core/routing/portal_graph.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace farol::routing {

/// What a search writes down; kept from one to the next, since most of it stays untouched.
class SearchRoom {
public:
    using Node = PortalGraph::Node;
    struct Label {
        double seconds = 0.0;
        double bound = 0.0;
        Node previous = PortalGraph::kNone;
        std::uint32_t search = 0; ///< in which the label was written
        std::uint32_t extra = 0;  ///< first of its extra arcs plus one; of the same search
        bool done = false;
    };
    struct Extra { ///< an arc of this search only: towards the goal
        Node to;
        std::uint32_t next;
        double seconds;
    };
    struct Entry {
        double key;
        double seconds;
        Node node;
    };

    explicit SearchRoom(std::size_t nodes) : labels(nodes) {}
    void begin();
    Label& label(Node node);
    void addExtra(Node from, Node to, double seconds);

    std::vector<Label> labels;
    std::vector<Extra> extras;
    std::vector<Entry> open;

private:
    std::uint32_t m_search = 0;
};

class PortalSearch {
public:
    using Node = PortalGraph::Node;

    PortalSearch(const PortalGraph& graph, const LandmarkBounds& bounds);

    struct Found {
        std::vector<Node> nodes; ///< passed on the way, in order
        double seconds = 0.0;
    };
    /// Empty when there is no way. Safe from several threads.
    std::optional<Found> run(const Endpoint& from, const Endpoint& to) const;

private:
    class Query;
    std::unique_ptr<SearchRoom> room() const;
    void giveBack(std::unique_ptr<SearchRoom> room) const;

    const PortalGraph& m_graph;
    const LandmarkBounds& m_bounds;
    mutable std::mutex m_mutex;
    mutable std::vector<std::unique_ptr<SearchRoom>> m_rooms;
};

} // namespace farol::routing
