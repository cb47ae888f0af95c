#pragma once
// The report over all pairs of regions: which of them no way joins, and why.

#include "core/routing/route.h"

#include <memory>
#include <vector>

namespace farol::routing {

/// Regions between which one gets about either way. `regions` in the order of the map.
struct RegionGroup {
    std::vector<RegionId> regions;
};

/// From no region of one group to any region of the other.
struct MissingRoute {
    std::size_t from = 0, to = 0; ///< in MissingRoutes::groups
    bool bothWays = false;        ///< nor the other way round
    std::size_t pairs = 0;        ///< of a start and a goal
    NoRoute why;                  ///< from the first of the one to the first of the other
};

struct MissingRoutes {
    std::vector<RegionGroup> groups;  ///< the largest first
    std::vector<MissingRoute> routes; ///< those with the most pairs first, at most `most`
    std::size_t pairs = 0;            ///< in all, of a start and another place as goal
    std::size_t missingPairs = 0;     ///< of these without a way
    std::size_t leftOut = 0;          ///< of `routes`, beyond the most
};

MissingRoutes findMissingRoutes(const std::shared_ptr<const Building>& building, const RouteOptions& options,
                                std::size_t most = 100);

} // namespace farol::routing
