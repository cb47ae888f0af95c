#pragma once
// The category words of IMDF 1.0 (OGC 20-094) in Farol's kinds.

#include "core/base/kind.h"
#include "core/building/building.h"

#include <optional>
#include <string>

namespace farol::building {

struct UnitRole {
    RegionKind kind = RegionKind::Room;
    bool walkable = true; ///< false: a wall, a column, a void
    bool restricted = false;
    bool known = true; ///< a word of the standard
};

UnitRole imdfUnitRole(const std::string& category);
/// Other for what Farol has no kind for.
Kind imdfAmenityKind(const std::string& category);
/// Of a relationship; empty for traversals on one level.
std::optional<AccessKind> imdfLevelChange(const std::string& category);

} // namespace farol::building
