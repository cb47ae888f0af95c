#pragma once
// Buildings drawn at random: L-shapes, rings and halls, columns, doors, closed and one-way ones, narrow and
// wide openings, stairs and lifts; turned by any angle and far from the origin.

#include "core/building/building.h"
#include "core/building/info.h"

#include <cstdint>
#include <memory>
#include <random>

namespace farol::test {

struct RandomFloors {
    int levels = 2;
    int columns = 4; ///< of blocks, joined to regions at random
    int rows = 3;
    double openness = 0.5; ///< how often a wall between two regions has a wide opening
};

/// The same seed gives the same building.
std::shared_ptr<const building::Building> randomFloors(std::uint32_t seed, const RandomFloors& options = {});

building::Location randomSpot(const building::Building& building, std::mt19937& random);

} // namespace farol::test
