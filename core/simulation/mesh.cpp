#include "core/simulation/mesh.h"

#include <algorithm>
#include <numbers>

namespace farol::simulation {

std::uint32_t MeshBuilder::surface(Vec3 origin, Vec3 u, Vec3 v, const Paint& paint) {
    Surface entry;
    entry.origin = origin;
    entry.uAxis = unit(u);
    entry.normal = unit(cross(v, u));
    entry.vAxis = cross(entry.uAxis, entry.normal); // square to u, whatever was given
    entry.tint = paint.tint;
    entry.scaleU = 1.0F / std::max(paint.tileU, 1.0e-3F);
    entry.scaleV = 1.0F / std::max(paint.tileV, 1.0e-3F);
    entry.texture = paint.texture;
    entry.glow = paint.glow;
    entry.gloss = paint.gloss;
    entry.glass = paint.glass;
    entry.thing = m_thing;
    entry.lowU = entry.lowV = 1.0e9F;
    entry.highU = entry.highV = -1.0e9F;
    m_mesh.surfaces.push_back(entry);
    return static_cast<std::uint32_t>(m_mesh.surfaces.size() - 1);
}

void MeshBuilder::quad(std::uint32_t surface, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    auto first = static_cast<std::uint32_t>(m_mesh.vertices.size());
    Surface& plane = m_mesh.surfaces[surface];
    for (Vec3 p : {a, b, c, d}) {
        m_mesh.vertices.push_back(p);
        float u = dot(p - plane.origin, plane.uAxis), v = dot(p - plane.origin, plane.vAxis);
        plane.lowU = std::min(plane.lowU, u);
        plane.highU = std::max(plane.highU, u);
        plane.lowV = std::min(plane.lowV, v);
        plane.highV = std::max(plane.highV, v);
    }
    m_mesh.quads.push_back({first, first + 1, first + 2, first + 3});
    m_mesh.surfaceOf.push_back(surface);
}

std::uint32_t MeshBuilder::rect(Vec3 topLeft, Vec3 right, Vec3 down, const Paint& paint) {
    std::uint32_t plane = surface(topLeft, right, down, paint);
    quad(plane, topLeft, topLeft + right, topLeft + right + down, topLeft + down);
    return plane;
}

std::uint32_t MeshBuilder::picture(Vec3 topLeft, Vec3 right, Vec3 down, Paint paint) {
    paint.tileU = length(right);
    paint.tileV = length(down);
    return rect(topLeft, right, down, paint);
}

std::uint32_t MeshBuilder::flat(Vec3 a, Vec3 b, Vec3 c, Vec3 d, const Paint& paint) {
    Vec3 u = b - a;
    Vec3 v = d - a;
    if (length(cross(v, u)) < 1.0e-9F) v = c - a;
    std::uint32_t plane = surface(a, u, v, paint);
    quad(plane, a, b, c, d);
    return plane;
}

void MeshBuilder::box(Vec3 corner, Vec3 x, Vec3 y, Vec3 z, const Paint& paint, unsigned omit) {
    Vec3 top = corner + z;
    Vec3 down = z * -1.0F;
    auto wanted = [omit](unsigned face) { return (omit & (1U << face)) == 0; };
    if (wanted(0)) rect(top + y, y * -1.0F, down, paint);
    if (wanted(1)) rect(top + x, y, down, paint);
    if (wanted(2)) rect(top, x, down, paint);
    if (wanted(3)) rect(top + x + y, x * -1.0F, down, paint);
    if (wanted(4)) rect(corner, x, y, paint);
    if (wanted(5)) rect(top + y, x, y * -1.0F, paint);
}

void MeshBuilder::beam(Vec3 from, Vec3 to, float width, const Paint& paint) {
    Vec3 along = to - from;
    Vec3 side = cross(along, kUp);
    if (length(side) < 1.0e-4F) side = {1.0F, 0.0F, 0.0F};
    side = unit(side) * width;
    Vec3 up = unit(cross(side, along)) * width;
    box(from - side * 0.5F - up * 0.5F, side, along, up, paint);
}

void MeshBuilder::lathe(Vec3 foot, const std::vector<std::array<float, 2>>& profile, int sides,
                        const Paint& paint) {
    auto at = [&](std::size_t ring, int side) {
        float angle =
            static_cast<float>(side % sides) * 2.0F * std::numbers::pi_v<float> / static_cast<float>(sides);
        return foot +
               Vec3{profile[ring][0] * std::cos(angle), profile[ring][0] * std::sin(angle), profile[ring][1]};
    };
    for (std::size_t ring = 1; ring < profile.size(); ++ring) {
        for (int side = 0; side < sides; ++side) {
            Vec3 lowLeft = at(ring - 1, side), lowRight = at(ring - 1, side + 1);
            Vec3 topLeft = at(ring, side), topRight = at(ring, side + 1);
            // Where a ring is a point its edge has no direction: the other one gives the axes.
            Vec3 right = length(topRight - topLeft) > 1.0e-5F ? topRight - topLeft : lowRight - lowLeft;
            Vec3 down = (lowLeft + lowRight - topLeft - topRight) * 0.5F;
            if (length(right) < 1.0e-5F || length(down) < 1.0e-5F) continue;
            std::uint32_t plane = surface(topLeft, right, down, paint);
            if (length(topRight - topLeft) < 1.0e-5F)
                quad(plane, topLeft, lowRight, lowLeft, lowLeft);
            else
                quad(plane, topLeft, topRight, lowRight, lowLeft);
        }
    }
}

} // namespace farol::simulation
