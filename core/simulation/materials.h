#pragma once
// What floors, walls, ceilings and doors are made of: tiles of texture drawn by rule, so that nothing is
// shipped and nothing is alike in two seeds.

#include "core/simulation/texture.h"

#include <cstdint>
#include <vector>

namespace farol::simulation {

/// Indices of the world's first textures. Those without a colour of their own are light grey and get a tint.
enum class Material : std::uint32_t {
    Plain,
    Plaster,
    Blocks,
    FloorTiles,
    Lino,
    Terrazzo,
    Carpet,
    Parquet,
    CeilingGrid,
    CeilingPlain,
    Concrete,
    Metal,
    Asphalt,
    Grass,
    Brick,
    DoorWood,
    Leaves,
    LampPrism,
    Count
};

/// Metres that one copy of the material covers.
float tileOf(Material material);
std::vector<Texture> makeMaterials(std::uint64_t seed);

} // namespace farol::simulation
