#include "core/simulation/shader.h"

#include "core/simulation/light_baker.h"

#include <algorithm>
#include <bit>

namespace farol::simulation {

namespace {

/// Good to a few hundredths, which no eye can tell in a choice of mip level.
float roughLog2(float x) {
    auto bits = std::bit_cast<std::uint32_t>(x);
    float mantissa = std::bit_cast<float>((bits & 0x7FFFFFU) | 0x3F800000U);
    return static_cast<float>(static_cast<int>(bits >> 23U) - 127) +
           (mantissa - 1.0F) * (1.3465F - 0.3465F * (mantissa - 1.0F));
}

} // namespace

RayHit Shader::hitOf(const RayPacket& packet, std::size_t i) const {
    RayHit hit;
    unsigned geometry = packet.rays.hit.geomID[i];
    if (geometry == RTC_INVALID_GEOMETRY_ID) return hit;
    hit.t = packet.rays.ray.tfar[i];
    unsigned quad = packet.rays.hit.primID[i];
    hit.surface = geometry == 0 ? m_scene.mesh.surfaceOf[quad] : m_leaves.surfaceOf[quad] | RayHit::kLeaf;
    return hit;
}

RayHit Shader::trace(Vec3 from, Vec3 direction, float near) const {
    RTCRayHit ray{};
    ray.ray.org_x = from.x;
    ray.ray.org_y = from.y;
    ray.ray.org_z = from.z;
    ray.ray.dir_x = direction.x;
    ray.ray.dir_y = direction.y;
    ray.ray.dir_z = direction.z;
    ray.ray.tnear = near;
    ray.ray.tfar = 1.0e6F;
    ray.ray.mask = 0xFFFFFFFFU;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(m_fixed, &context, &ray);
    rtcIntersect1(m_moving, &context, &ray);
    RayHit hit;
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
    hit.t = ray.ray.tfar;
    hit.surface = ray.hit.geomID == 0 ? m_scene.mesh.surfaceOf[ray.hit.primID]
                                      : m_leaves.surfaceOf[ray.hit.primID] | RayHit::kLeaf;
    return hit;
}

Vec3 Shader::sky(Vec3 direction) const {
    Vec3 way = unit(direction);
    float up = way.z;
    // Trees along the horizon, their height from the direction alone.
    float round = way.x * 9.0F - way.y * 7.0F;
    float trees = 0.035F + 0.012F * std::sin(round * 2.3F) + 0.008F * std::sin(round * 7.1F + 1.0F) +
                  0.004F * std::sin(way.x * 131.0F + way.y * 97.0F);
    if (up > 0.0F && up < trees) return {0.16F, 0.21F, 0.13F};
    if (up <= 0.0F) return {0.25F, 0.24F, 0.22F}; // beyond the ground's edge
    float high = std::min(1.0F, up * 2.2F);
    return Vec3{1.5F, 1.52F, 1.55F} * (1.0F - high) + Vec3{0.62F, 0.95F, 1.55F} * high;
}

float Shader::mirror(const Surface& surface, Vec3 direction) const {
    if (surface.gloss <= 0.0F) return 0.0F;
    float straight = std::abs(dot(surface.normal, unit(direction)));
    float rest = 1.0F - straight;
    return std::min(0.85F, surface.gloss * (0.35F + 4.0F * rest * rest * rest));
}

Vec3 Shader::painted(const Surface& surface, Vec3 eye, Vec3 direction, float t, Vec3 right, Vec3 down) const {
    Vec3 at = eye + direction * t - surface.origin;
    float u = dot(at, surface.uAxis), v = dot(at, surface.vAxis);
    const Texture& texture = m_scene.textures[surface.texture];
    Vec3 light = lightAt(surface, m_scene.light, u, v);
    Vec3 albedo = texture.mean();
    if (texture.width() > 8) {
        // How far the point on the plane moves from one pixel to the next, in texels.
        float facing = dot(surface.normal, direction);
        if (std::abs(facing) < 1.0e-4F) facing = 1.0e-4F;
        float du = dot(direction, surface.uAxis) / facing, dv = dot(direction, surface.vAxis) / facing;
        float nx = dot(surface.normal, right), ny = dot(surface.normal, down);
        float wide = static_cast<float>(texture.width()) * surface.scaleU * t;
        float tall = static_cast<float>(texture.height()) * surface.scaleV * t;
        float ux = (dot(right, surface.uAxis) - du * nx) * wide,
              vx = (dot(right, surface.vAxis) - dv * nx) * tall;
        float uy = (dot(down, surface.uAxis) - du * ny) * wide,
              vy = (dot(down, surface.vAxis) - dv * ny) * tall;
        float x2 = ux * ux + vx * vx, y2 = uy * uy + vy * vy;
        bool alongX = x2 > y2;
        float major = std::sqrt(alongX ? x2 : y2), minor = std::sqrt(alongX ? y2 : x2);
        int taps = std::clamp(static_cast<int>(major / std::max(minor, 0.7F) + 0.3F), 1, 4);
        float level = roughLog2(std::max(major / static_cast<float>(taps), minor) + 1.0e-6F);
        float textureU = u * surface.scaleU, textureV = v * surface.scaleV;
        if (taps == 1) {
            albedo = texture.at(textureU, textureV, level);
        } else {
            float stepU = (alongX ? ux : uy) / static_cast<float>(texture.width() * taps);
            float stepV = (alongX ? vx : vy) / static_cast<float>(texture.height() * taps);
            Vec3 sum;
            for (int i = 0; i < taps; ++i) {
                float shift = static_cast<float>(i) - static_cast<float>(taps - 1) * 0.5F;
                sum = sum + texture.nearAt(textureU + stepU * shift, textureV + stepV * shift, level);
            }
            albedo = sum * (1.0F / static_cast<float>(taps));
        }
    }
    Vec3 glow{surface.glow, surface.glow, surface.glow};
    return albedo * surface.tint * ((light + glow) * m_lamps);
}

Vec3 Shader::colour(Vec3 eye, Vec3 direction, const RayHit& hit, Vec3 right, Vec3 down, std::int32_t* thing,
                    int depth) const {
    if (!hit.met()) return sky(direction);
    const Surface& plane = surface(hit.surface);
    if (!plane.glass || depth >= 5) {
        if (thing) *thing = plane.thing;
        return painted(plane, eye, direction, hit.t, right, down);
    }
    std::int32_t behind = -1;
    RayHit next = trace(eye, direction, hit.t + 0.004F);
    Vec3 seen = colour(eye, direction, next, right, down, &behind, depth + 1);
    // A pane belongs to its door where nothing with a name of its own stands behind it.
    if (thing) *thing = behind >= 0 ? behind : plane.thing;
    float share = mirror(plane, direction);
    Vec3 reflected = direction - plane.normal * (2.0F * dot(direction, plane.normal));
    return seen * plane.tint * (1.0F - share) + (sky(reflected) * 0.22F * m_lamps) * share;
}

} // namespace farol::simulation
