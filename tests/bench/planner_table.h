#pragma once
// Both planners side by side on synthetic campuses.

#include <cstddef>
#include <vector>

namespace farol::bench {

/// Prints a table with one row for each number of regions.
int benchPlanners(const std::vector<std::size_t>& regions);

} // namespace farol::bench
