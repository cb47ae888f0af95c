#pragma once
// What changes on the map with every frame, apart from the building itself.

#include "core/localisation/localiser.h"
#include "core/routing/route.h"

#include <memory>
#include <optional>
#include <vector>

namespace farol::ui {

struct MapOverlay {
    std::optional<localisation::Fix> fix;
    std::shared_ptr<const routing::Route> route;
    std::size_t regionsPassed = 0; ///< of the route
    std::optional<RegionId> destination;
    std::optional<RegionId> start;
    double sureConfidence = 0.5; ///< from here on a place counts as sure

    /// 0 to 1: the share of the best vote; 0 for a region without one.
    double heatOf(const RegionId& region) const;
};

} // namespace farol::ui
