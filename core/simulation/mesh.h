#pragma once
// The world as flat pieces: quads, each on a surface that says how its plane is painted and lit.

#include "core/simulation/vec3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace farol::simulation {

/// How a surface is painted. `texture` is an index into the world's textures.
struct Paint {
    std::uint32_t texture = 0;
    Vec3 tint{1.0F, 1.0F, 1.0F};
    float tileU = 1.0F; ///< metres that one copy of the texture covers
    float tileV = 1.0F;
    float glow = 0.0F;  ///< light of its own, as a multiple of the paint
    float gloss = 0.0F; ///< share of a mirror
    bool glass = false; ///< seen through, tinted by the paint
};

/// The plane of some quads. Map from metres along the two axes (u to the right, v downwards as one looks at
/// it) to the texture and to the grid of light that was computed beforehand.
struct Surface {
    Vec3 origin, uAxis, vAxis, normal;
    Vec3 tint{1.0F, 1.0F, 1.0F};
    float scaleU = 1.0F, scaleV = 1.0F; ///< shares of the texture a metre
    std::uint32_t texture = 0;
    float glow = 0.0F, gloss = 0.0F;
    float lightU = 0.0F, lightV = 0.0F; ///< metres at which the light grid starts
    float cellsU = 0.0F, cellsV = 0.0F; ///< cells a metre
    std::uint32_t light = 0;            ///< first sample in the world's light
    std::uint16_t lightColumns = 1, lightRows = 1;
    std::int32_t thing = -1; ///< index into the world's things
    bool glass = false;
    float lowU = 0.0F, highU = 0.0F, lowV = 0.0F, highV = 0.0F; ///< metres that its quads cover
};

using QuadIndices = std::array<std::uint32_t, 4>;

struct Mesh {
    std::vector<Vec3> vertices;
    std::vector<QuadIndices> quads; ///< a triangle repeats its last vertex
    std::vector<std::uint32_t> surfaceOf;
    std::vector<Surface> surfaces;

    Vec3 corner(std::size_t quad, std::size_t i) const { return vertices[quads[quad][i]]; }
};

/// Puts pieces together. Everything added while a thing is set belongs to it.
class MeshBuilder {
public:
    explicit MeshBuilder(Mesh& mesh) : m_mesh(mesh) {}

    void setThing(std::int32_t thing) { m_thing = thing; }
    std::int32_t thing() const { return m_thing; }
    /// A plane through `origin`; the axes need not have unit length.
    std::uint32_t surface(Vec3 origin, Vec3 u, Vec3 v, const Paint& paint);
    void quad(std::uint32_t surface, Vec3 a, Vec3 b, Vec3 c, Vec3 d);
    /// A rectangle from its top left as one looks at it, tiled in metres.
    std::uint32_t rect(Vec3 topLeft, Vec3 right, Vec3 down, const Paint& paint);
    /// The same with the texture stretched over it once.
    std::uint32_t picture(Vec3 topLeft, Vec3 right, Vec3 down, Paint paint);
    /// Any flat four-sided piece, tiled in metres; it faces the side from which a, b, c, d run clockwise.
    std::uint32_t flat(Vec3 a, Vec3 b, Vec3 c, Vec3 d, const Paint& paint);
    /// A box from a corner and three edges of a right-handed frame; without the faces of `omit` (bits 0 to 5:
    /// -x, +x, -y, +y, -z, +z of the edges).
    void box(Vec3 corner, Vec3 x, Vec3 y, Vec3 z, const Paint& paint, unsigned omit = 0);
    /// A beam of square section between two points.
    void beam(Vec3 from, Vec3 to, float width, const Paint& paint);
    /// A body turned about the vertical through `foot`: rings of radius and height.
    void lathe(Vec3 foot, const std::vector<std::array<float, 2>>& profile, int sides, const Paint& paint);

private:
    Mesh& m_mesh;
    std::int32_t m_thing = -1;
};

} // namespace farol::simulation
