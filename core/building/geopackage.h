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
    /// What was odd but could be lived with: unknown kinds, missing optional layers, accesses without two
    /// regions.
    std::vector<std::string> warnings;
};

/// Reads the layers of the design. NotFound, UnsupportedFormat (not a map, degrees instead of metres, or a
/// later schema), Corrupt (no regions, coordinates that are not finite, duplicate ids, a layer without its
/// key field). Features are sorted by id. Empty region_a/region_b of an access are derived from geometry: for
/// a line, the regions of its level 0.3 m to the left (A) and right (B) of its midpoint; for a point, the two
/// nearest within 0.3 m; for stairs, lifts and escalators that name one region, none.
Result<LoadedBuilding> loadBuilding(const std::string& source);

/// Writes all layers in one transaction. An existing GeoPackage keeps its unknown layers (the landmark
/// library among them) and unknown fields; whatever fails, the old file stays whole. Keys of the layer
/// `farol` are added or changed, never removed. A new file starts as a copy of `origin`, the building file
/// that the map was read from, so that saving under another name keeps the same. What stands in the file as
/// it would be written stays to the byte. NoSpace for a full disk; Conflict while another program writes to
/// the file. `path` may name a database: see saveToDatabase().
Result<void> saveBuilding(const Building& building, const std::string& path, const std::string& origin = {});

/// Is that a building file as saveBuilding() writes it, rather than some other table of rooms?
bool isBuildingFile(const std::string& source);

} // namespace farol::building
