#pragma once
// A* of Boost.Graph over the same nodes and edges.

#include "tests/bench/door_graph.h"

#include <memory>

namespace farol::bench {

class BoostPlanner {
public:
    /// `speed`: metres a second, for the lower bound by the straight line.
    BoostPlanner(const DoorGraph& graph, double speed);
    ~BoostPlanner();

    double seconds(std::uint32_t from, std::uint32_t to); ///< infinite when there is no way

private:
    struct Graph;
    std::unique_ptr<Graph> m_graph;
};

} // namespace farol::bench
