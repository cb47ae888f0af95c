#pragma once
// The built world as its parts share it; World is the closed form that others see.

#include "core/building/building.h"
#include "core/simulation/materials.h"
#include "core/simulation/mesh.h"
#include "core/simulation/scene_plan.h"
#include "core/simulation/texture.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace farol::simulation {

/// Something that the truth tells of: a landmark, or the door in an access.
struct Thing {
    std::optional<std::size_t> landmark;
    std::optional<std::size_t> access;
    double level = 0.0;
    Vec3 centre, facing; ///< `facing`: null when it looks the same from all sides
    /// Flat things: corners clockwise from the top left. Others are known by their quads.
    std::optional<std::array<Vec3, 4>> corners;
    bool lift = false;
    bool stairs = false;
    bool opening = false;             ///< a door: seen by what is in its frame, not by its own pixels alone
    std::vector<std::uint32_t> quads; ///< of the fixed mesh
};

/// A part that moves: a door leaf on its hinge, or a sliding one.
struct Leaf {
    std::uint32_t firstQuad = 0, lastQuad = 0;       ///< of the leaf mesh
    std::uint32_t firstSurface = 0, lastSurface = 0; ///< of the leaf mesh
    Vec3 hinge, middle;
    float swing = 0.0F; ///< radians when fully open, counter-clockwise from above
    Vec3 slide;         ///< metres when fully open
    bool opens = true;
    bool lift = false;
};

struct Lamp {
    Vec3 position, facing;
    Vec3 power; ///< what a surface one metre in front of it receives
};

/// Two flights with a landing half-way. Along: from the landing into the first flight; across: from that
/// flight towards the second. Metres from `corner`, which lies at the door's end on the first flight's side.
struct StairsPlan {
    std::size_t lower = 0, upper = 0; ///< regions
    std::size_t access = 0;
    Point2 corner, along, across;
    double width = 0.0;   ///< of both flights together
    double landing = 0.0; ///< depth of the floor's landing
    double tread = 0.28;
    double far = 0.0;                    ///< depth at which the well ends
    int firstSteps = 9, secondSteps = 9; ///< risers
    double lowZ = 0.0, highZ = 0.0;

    Point2 at(double a, double c) const { return corner + along * a + across * c; }
    double middleZ() const { return lowZ + (highZ - lowZ) * firstSteps / (firstSteps + secondSteps); }
};

/// How a region is furnished.
struct RegionStyle {
    Paint wall, lowerWall, floor, ceiling, skirting;
    double dadoM = 0.0; ///< height of the lower wall; 0: none
    Vec3 doorTint{1.0F, 1.0F, 1.0F};
    Material doorMaterial = Material::DoorWood;
    int lampKind = 0; ///< 0 square, 1 strip, 2 round
    Vec3 lampColour{1.0F, 1.0F, 1.0F};
    std::uint64_t seed = 0;
};

struct SceneData {
    std::shared_ptr<const building::Building> building;
    ScenePlan plan;
    Mesh mesh;     ///< what never moves
    Mesh leafMesh; ///< door leaves, closed
    std::vector<Leaf> leaves;
    std::vector<Texture> textures;
    double pictureScale = 1.0; ///< of pictures on walls: where there are many, each is coarser
    std::vector<Vec3> light;   ///< samples of the surfaces of both meshes
    std::vector<Lamp> lamps;
    std::vector<std::pair<std::size_t, std::size_t>> lampsOf; ///< by region: first and behind the last
    std::vector<Thing> things;
    std::vector<StairsPlan> stairs;
    std::vector<RegionStyle> styles; ///< by region
};

inline Vec3 flatVec(Point2 p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), 0.0F};
}
inline Vec3 vecOf(Point2 p, double z) {
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(z)};
}

} // namespace farol::simulation
