#pragma once
// Synthetic campuses for tests and benchmarks: several buildings of several levels along outdoor walks. There
// are straight, L-shaped and ring corridors, rooms with doors (some through another room), halls with columns
// and wide openings, stairwells, lifts, and escalators that go one way. Everything can be reached from
// everywhere, both ways; checkBuilding() finds no errors or warnings. The same options give the same campus.

#include "core/building/building.h"
#include "core/building/info.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace farol::test {

// Default initialisers everywhere, so that tests may leave members out.
struct CampusOptions {
    std::size_t regions = 1000; ///< about: at most 15 % off, from 100 on
    std::uint32_t seed = 1;
    double turnDegrees = 0.0; ///< of the whole campus: then no wall lies along an axis
    Point2 origin{};          ///< of the lower left corner
    std::string crs{};        ///< WKT or "EPSG:32629"; empty: a local plane
};

/// In the names of tests and their failures.
std::ostream& operator<<(std::ostream& out, const CampusOptions& options);

building::BuildingData campusData(const CampusOptions& options = {});
std::shared_ptr<const building::Building> makeCampus(const CampusOptions& options = {});

/// Random spots in random regions, never in a column. The same seed gives the same pairs.
std::vector<std::pair<building::Location, building::Location>>
campusPairs(const building::Building& building, std::size_t count, std::uint32_t seed = 1);

} // namespace farol::test
