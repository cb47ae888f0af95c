#pragma once
// The building file (design, section 4): a GeoPackage, or the same layers behind an OGR connection string.

#include "core/base/error.h"
#include "core/building/building.h"

#include <memory>
#include <string>
#include <vector>

namespace farol::building {

struct LoadedBuilding {
    std::shared_ptr<const Building> building;
    /// What was odd but could be lived with: unknown kinds, missing optional layers, accesses without two regions.
    std::vector<std::string> warnings;
};

/// Reads the layers of the design. NotFound, UnsupportedFormat (not a map, or a later schema), Corrupt (no regions,
/// coordinates that are not finite, a layer without its key field). Empty region_a/region_b of an access are derived
/// from geometry: the regions of its level that its midpoint, moved 0.3 m to either side, falls into.
Result<LoadedBuilding> loadBuilding(const std::string& source);

/// Writes all layers in one transaction. An existing GeoPackage keeps its unknown layers (the landmark library among
/// them) and unknown fields; whatever fails, the old file stays whole.
Result<void> saveBuilding(const Building& building, const std::string& path);

} // namespace farol::building
