#pragma once
// Rays against the world, through Embree. Only the simulation's own sources include this.

#include "core/base/error.h"
#include "core/simulation/mesh.h"

#include <cstdint>
#include <embree3/rtcore.h>
#include <memory>
#include <span>
#include <vector>

namespace farol::simulation {

/// One Embree device. Its instruction set is pinned and it builds on one thread: trees, and so pictures, are
/// the same on every machine that has AVX2.
class TraceDevice {
public:
    static Result<std::shared_ptr<const TraceDevice>> open();
    ~TraceDevice();
    TraceDevice(const TraceDevice&) = delete;
    TraceDevice& operator=(const TraceDevice&) = delete;
    RTCDevice handle() const { return m_device; }

private:
    explicit TraceDevice(RTCDevice device) : m_device(device) {}
    RTCDevice m_device;
};

/// The quads of a mesh. `name` comes back as geomID of a hit.
class Tracer {
public:
    static Result<std::unique_ptr<Tracer>> build(std::shared_ptr<const TraceDevice> device,
                                                 std::span<const Vec3> vertices,
                                                 std::span<const QuadIndices> quads, unsigned name);
    ~Tracer();
    Tracer(const Tracer&) = delete;
    Tracer& operator=(const Tracer&) = delete;

    RTCScene scene() const { return m_scene; }
    const std::shared_ptr<const TraceDevice>& device() const { return m_device; }
    /// After vertices have moved.
    void move(std::span<const Vec3> vertices);

private:
    explicit Tracer(std::shared_ptr<const TraceDevice> device) : m_device(std::move(device)) {}

    std::shared_ptr<const TraceDevice> m_device;
    RTCScene m_scene = nullptr;
    RTCGeometry m_geometry = nullptr;
    float* m_vertices = nullptr;
};

} // namespace farol::simulation
