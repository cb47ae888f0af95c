#pragma once
// Buildings of our own to tune and measure localisation on: a straight corridor, a ring, two wings at a hall,
// rooms about a hall; several levels, turned by any angle. The same options give the same building.

#include "core/building/building.h"

#include <cstdint>

namespace farol::test {

enum class Archetype { Corridor, Ring, Wings, Hall };

struct WalkBuildingOptions {
    Archetype archetype = Archetype::Corridor;
    int density = 1; ///< of landmarks: 0 sparse, 1 medium, 2 dense
    std::uint64_t seed = 1;
    double leastM = 30.0, mostM = 100.0; ///< of the plan
};

building::BuildingData walkBuildingData(const WalkBuildingOptions& options);
/// One of 35 to 440 regions, archetypes and densities by turns.
building::BuildingData variedBuildingData(std::uint64_t seed);

} // namespace farol::test
