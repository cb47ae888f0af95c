#pragma once
// `farol-bench-routing`: what a route costs on synthetic campuses, and the same graph for other planners.

#include <cstddef>
#include <string>
#include <vector>

namespace farol::bench {

struct RoutingBenchOptions {
    std::string folder; ///< where campuses, graphs and results go
    std::vector<std::size_t> sizes{100, 1000, 10000, 100000};
    std::size_t pairs = 1000;
};

/// Prints Markdown tables and writes for each size what tests/bench/routing_peers reads; answers the exit
/// code.
int benchRouting(const RoutingBenchOptions& options);

/// Imports a map and makes the planner's graph; in a process of its own, for the sake of its peak of memory.
int benchRoutingImport(const std::string& map, const std::string& profile);

} // namespace farol::bench
