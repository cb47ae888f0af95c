#include "core/simulation/tracer.h"

#include <algorithm>
#include <string>

namespace farol::simulation {

namespace {

Error traceError(RTCDevice device, const char* what) {
    RTCError code = rtcGetDeviceError(device);
    if (code == RTC_ERROR_OUT_OF_MEMORY)
        return {ErrorCode::Unavailable, std::string("there is not enough memory for ") + what, ""};
    return {ErrorCode::Internal,
            std::string("the ray tracer (Embree) failed on ") + what + ", error " + std::to_string(code), ""};
}

} // namespace

Result<std::shared_ptr<const TraceDevice>> TraceDevice::open() {
    const char* config = "threads=1,set_affinity=0";
#if defined(__x86_64__)
    // Wider instructions would give other last bits on other machines.
    if (__builtin_cpu_supports("avx2")) config = "threads=1,set_affinity=0,isa=avx2";
#endif
    RTCDevice device = rtcNewDevice(config);
    if (!device) return traceError(nullptr, "opening");
    return std::shared_ptr<const TraceDevice>(new TraceDevice(device));
}

TraceDevice::~TraceDevice() {
    rtcReleaseDevice(m_device);
}

Result<std::unique_ptr<Tracer>> Tracer::build(std::shared_ptr<const TraceDevice> device,
                                              std::span<const Vec3> vertices,
                                              std::span<const QuadIndices> quads, unsigned name) {
    std::unique_ptr<Tracer> tracer(new Tracer(std::move(device)));
    RTCDevice handle = tracer->m_device->handle();
    tracer->m_scene = rtcNewScene(handle);
    rtcSetSceneFlags(tracer->m_scene, RTC_SCENE_FLAG_ROBUST);
    if (!quads.empty()) {
        tracer->m_geometry = rtcNewGeometry(handle, RTC_GEOMETRY_TYPE_QUAD);
        tracer->m_vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            tracer->m_geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3), vertices.size()));
        auto* indices = static_cast<std::uint32_t*>(
            rtcSetNewGeometryBuffer(tracer->m_geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4,
                                    sizeof(QuadIndices), quads.size()));
        if (!tracer->m_vertices || !indices) return traceError(handle, "the world's walls");
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            tracer->m_vertices[3 * i] = vertices[i].x;
            tracer->m_vertices[3 * i + 1] = vertices[i].y;
            tracer->m_vertices[3 * i + 2] = vertices[i].z;
        }
        for (std::size_t i = 0; i < quads.size(); ++i)
            std::copy(quads[i].begin(), quads[i].end(), indices + 4 * i);
        rtcCommitGeometry(tracer->m_geometry);
        rtcAttachGeometryByID(tracer->m_scene, tracer->m_geometry, name);
    }
    rtcCommitScene(tracer->m_scene);
    if (rtcGetDeviceError(handle) != RTC_ERROR_NONE) return traceError(handle, "the world");
    return tracer;
}

Tracer::~Tracer() {
    if (m_geometry) rtcReleaseGeometry(m_geometry);
    if (m_scene) rtcReleaseScene(m_scene);
}

void Tracer::move(std::span<const Vec3> vertices) {
    if (!m_geometry) return;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        m_vertices[3 * i] = vertices[i].x;
        m_vertices[3 * i + 1] = vertices[i].y;
        m_vertices[3 * i + 2] = vertices[i].z;
    }
    rtcUpdateGeometryBuffer(m_geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(m_geometry);
    rtcCommitScene(m_scene);
}

} // namespace farol::simulation
