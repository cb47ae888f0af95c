#pragma once
// Sixteen rays from one eye, traced together against the fixed world and the door leaves.

#include "core/simulation/tracer.h"

#include <array>

namespace farol::simulation {

struct RayPacket {
    alignas(64) RTCRayHit16 rays{};
    alignas(64) std::array<int, 16> valid{};

    void clear() { valid.fill(0); }

    void set(std::size_t i, Vec3 from, Vec3 direction, float near = 0.0F, float far = 1.0e6F) {
        rays.ray.org_x[i] = from.x;
        rays.ray.org_y[i] = from.y;
        rays.ray.org_z[i] = from.z;
        rays.ray.dir_x[i] = direction.x;
        rays.ray.dir_y[i] = direction.y;
        rays.ray.dir_z[i] = direction.z;
        rays.ray.tnear[i] = near;
        rays.ray.tfar[i] = far;
        rays.ray.time[i] = 0.0F;
        rays.ray.mask[i] = 0xFFFFFFFFU;
        rays.ray.id[i] = 0;
        rays.ray.flags[i] = 0;
        rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        rays.hit.primID[i] = 0;
        valid[i] = -1;
    }
    Vec3 direction(std::size_t i) const { return {rays.ray.dir_x[i], rays.ray.dir_y[i], rays.ray.dir_z[i]}; }

    void trace(RTCScene scene) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        rtcIntersect16(valid.data(), scene, &context, &rays);
    }
};

} // namespace farol::simulation
