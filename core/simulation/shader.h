#pragma once
// The colour of what a ray meets.

#include "core/simulation/lens.h"
#include "core/simulation/packet.h"
#include "core/simulation/scene_data.h"

namespace farol::simulation {

/// What a ray meets first. `t`: along its direction, which has a forward part of one for camera rays.
struct RayHit {
    static constexpr std::uint32_t kNothing = 0xFFFFFFFFU;
    static constexpr std::uint32_t kLeaf = 0x80000000U; ///< the surface is one of the door leaves

    float t = 1.0e6F;
    std::uint32_t surface = kNothing;

    bool met() const { return surface != kNothing; }
};

/// Light that a picture is made of, with room for wide instructions.
struct alignas(16) Light {
    float red = 0.0F, green = 0.0F, blue = 0.0F, spare = 0.0F;
};

class Shader {
public:
    Shader(const SceneData& scene, const Mesh& leaves, RTCScene fixed, RTCScene moving, bool lightsOut)
        : m_scene(scene),
          m_leaves(leaves),
          m_fixed(fixed),
          m_moving(moving),
          m_lamps(lightsOut ? 0.03F : 1.0F) {}

    const Surface& surface(std::uint32_t hit) const {
        return hit & RayHit::kLeaf ? m_leaves.surfaces[hit & ~RayHit::kLeaf] : m_scene.mesh.surfaces[hit];
    }
    void trace(RayPacket& packet) const {
        packet.trace(m_fixed);
        packet.trace(m_moving);
    }
    RayHit hitOf(const RayPacket& packet, std::size_t i) const;
    RayHit trace(Vec3 from, Vec3 direction, float near) const; ///< one ray, for the few that leave the pack

    /// Colour of the hit of a ray from `eye`. `right`, `down`: how the direction changes from one sample to
    /// the next. Glass shows what is behind it; `thing` receives what the eye takes the pixel for, -1 for
    /// nothing.
    Vec3 colour(Vec3 eye, Vec3 direction, const RayHit& hit, Vec3 right, Vec3 down,
                std::int32_t* thing = nullptr, int depth = 0) const;
    Vec3 sky(Vec3 direction) const;
    /// How much of a mirror the surface is at this angle.
    float mirror(const Surface& surface, Vec3 direction) const;

private:
    Vec3 painted(const Surface& surface, Vec3 eye, Vec3 direction, float t, Vec3 right, Vec3 down) const;

    const SceneData& m_scene;
    const Mesh& m_leaves;
    RTCScene m_fixed, m_moving;
    float m_lamps;
};

} // namespace farol::simulation
