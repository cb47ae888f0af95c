#pragma once
// Visitors for a building that has none: where each comes in and where to go, drawn by number.

#include "core/building/building.h"
#include "core/routing/route.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace farol::simulation {

struct Visit {
    RegionId from, to;
    double metres = 0.0, seconds = 0.0; ///< of the way between them
};

class Visits {
public:
    explicit Visits(const std::shared_ptr<const building::Building>& building);

    /// A way that can be watched to its end: 15 to 60 metres where the map has such, between places with
    /// names of their own. Without `from` the visitor comes in anywhere. Empty where nothing can be reached.
    std::optional<Visit> visit(std::uint64_t number, const std::optional<RegionId>& from = {}) const;
    /// The way between two places; empty without one.
    std::optional<Visit> between(const RegionId& from, const RegionId& to) const;

private:
    std::unique_ptr<routing::Planner> m_planner;
    std::vector<RegionId> m_places;
};

} // namespace farol::simulation
