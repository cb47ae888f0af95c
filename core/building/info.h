#pragma once
// Counts that describe a map (`farol-cli map info`), and the WHERE words of the command line.

#include "core/base/error.h"
#include "core/building/building.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace farol::building {

struct LevelInfo {
    double level = 0.0;
    std::string ref;
    std::size_t regions = 0, accesses = 0, landmarks = 0;
};

struct BuildingInfo {
    std::size_t regions = 0, accesses = 0, accessesJoined = 0, landmarks = 0, components = 0,
                largestComponent = 0, unnamedRegions = 0;
    std::vector<LevelInfo> levels;
    std::map<std::string, std::size_t> landmarkKinds; ///< kind name -> count
    std::string crs;
    double widthM = 0.0, heightM = 0.0;
};

BuildingInfo describe(const Building& building);

/// A spot in the building: a region, and where in it when that is known.
struct Location {
    RegionId region;
    std::optional<Point2> position;
};

/// WHERE of the command line: a region id, a unique name or ref (compared folded), or "x,y,level".
/// NotFound names up to five near spellings; Conflict lists the regions that share the name.
Result<Location> resolveWhere(const Building& building, const std::string& where);

} // namespace farol::building
