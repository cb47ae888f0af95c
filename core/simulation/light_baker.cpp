#include "core/simulation/light_baker.h"

#include "core/simulation/hash.h"
#include "core/simulation/packet.h"
#include "core/simulation/parallel.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <tuple>

namespace farol::simulation {

namespace {

constexpr std::size_t kSampleBudget = 450000;
constexpr float kFinestCellM = 0.22F, kReachM = 9.0F;
constexpr int kRays = 16;
const Vec3 kSky{1.1F, 1.2F, 1.35F};

/// Lamps found by place.
class LampGrid {
public:
    explicit LampGrid(const std::vector<Lamp>& lamps) : m_lamps(lamps) {
        for (std::size_t i = 0; i < lamps.size(); ++i) m_cells[keyOf(lamps[i].position)].push_back(i);
    }
    /// The strongest at a point that faces that way, at most `kRays` of them.
    void strongest(Vec3 point, Vec3 normal, std::vector<std::pair<float, std::size_t>>& out) const {
        out.clear();
        Key middle = keyOf(point);
        for (int dz = -1; dz <= 1; ++dz) {
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx) {
                    auto cell = m_cells.find(
                        {std::get<0>(middle) + dx, std::get<1>(middle) + dy, std::get<2>(middle) + dz});
                    if (cell == m_cells.end()) continue;
                    for (std::size_t lamp : cell->second) {
                        float strength = strengthAt(m_lamps[lamp], point, normal);
                        if (strength > 1.0e-3F) out.emplace_back(-strength, lamp);
                    }
                }
            }
        }
        std::sort(out.begin(), out.end());
        if (out.size() > kRays) out.resize(kRays);
    }

private:
    using Key = std::tuple<int, int, int>;
    static Key keyOf(Vec3 p) {
        auto cell = [](float x) { return static_cast<int>(std::floor(x / kReachM)); };
        return {cell(p.x), cell(p.y), cell(p.z * 3.0F)};
    }
    static float strengthAt(const Lamp& lamp, Vec3 point, Vec3 normal) {
        Vec3 way = lamp.position - point;
        float squared = dot(way, way);
        if (squared > kReachM * kReachM) return 0.0F;
        Vec3 to = unit(way);
        float emitted = -dot(lamp.facing, to), received = dot(normal, to);
        if (emitted <= 0.0F || received <= 0.0F) return 0.0F;
        float fade = 1.0F - squared / (kReachM * kReachM);
        return emitted * received / std::max(squared, 0.35F) * fade;
    }

    const std::vector<Lamp>& m_lamps;
    std::map<Key, std::vector<std::size_t>> m_cells;
};

class Baker {
public:
    Baker(SceneData& scene, std::shared_ptr<const TraceDevice> device)
        : m_scene(scene), m_device(std::move(device)), m_lamps(scene.lamps) {}

    Result<void> bake() {
        layGrids();
        auto tracer = makeTracer();
        if (!tracer) return tracer.error();
        m_tracer = std::move(*tracer);
        std::vector<Vec3> direct(m_scene.light.size());
        eachSample([&](const Sample& sample) { direct[sample.index] = directAt(sample); });
        m_scene.light = direct;
        std::vector<Vec3> bounced(m_scene.light.size());
        eachSample([&](const Sample& sample) { bounced[sample.index] = bouncedAt(sample); });
        smooth(bounced);
        for (std::size_t i = 0; i < direct.size(); ++i)
            m_scene.light[i] = direct[i] + bounced[i] * 1.45F + Vec3{0.012F, 0.012F, 0.013F};
        return {};
    }

private:
    struct Sample {
        std::size_t index = 0;
        Vec3 point, normal;
    };

    std::vector<Surface>& surfacesOf(int which) {
        return which == 0 ? m_scene.mesh.surfaces : m_scene.leafMesh.surfaces;
    }

    void layGrids() {
        double metres = 0.0;
        for (int which : {0, 1})
            for (const Surface& surface : surfacesOf(which))
                metres +=
                    static_cast<double>((surface.highU - surface.lowU) * (surface.highV - surface.lowV));
        // The ground stretches far beyond the building: counted, it would take all the samples.
        auto coarse =
            static_cast<float>(std::sqrt(std::min(metres, 1.0e5) / static_cast<double>(kSampleBudget)));
        m_cell = std::max(kFinestCellM, coarse);
        std::size_t samples = 0;
        for (int which : {0, 1}) {
            for (Surface& surface : surfacesOf(which)) {
                surface.light = static_cast<std::uint32_t>(samples);
                lay(surface.lowU, surface.highU, surface.lightU, surface.cellsU, surface.lightColumns);
                lay(surface.lowV, surface.highV, surface.lightV, surface.cellsV, surface.lightRows);
                samples += static_cast<std::size_t>(surface.lightColumns) * surface.lightRows;
            }
        }
        m_scene.light.assign(samples, Vec3{});
    }

    /// Samples stand a little inside, where no neighbour's wall covers them.
    void lay(float low, float high, float& first, float& cells, std::uint16_t& count) const {
        float size = high - low, margin = std::min(0.07F, size * 0.25F);
        float cell = size > 200.0F ? 8.0F : m_cell;
        int steps =
            std::clamp(static_cast<int>(std::ceil((size - 2 * margin) / cell)), size > 0.25F ? 1 : 0, 1000);
        first = steps == 0 ? low + size / 2 : low + margin;
        cells = steps == 0 ? 0.0F : static_cast<float>(steps) / std::max(size - 2 * margin, 1.0e-4F);
        count = static_cast<std::uint16_t>(steps + 1);
    }

    /// All that stops light; glass does not.
    Result<std::unique_ptr<Tracer>> makeTracer() {
        std::vector<Vec3> vertices = m_scene.mesh.vertices;
        auto shift = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), m_scene.leafMesh.vertices.begin(), m_scene.leafMesh.vertices.end());
        std::vector<QuadIndices> quads;
        for (int which : {0, 1}) {
            const Mesh& mesh = which == 0 ? m_scene.mesh : m_scene.leafMesh;
            for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
                const Surface& surface = mesh.surfaces[mesh.surfaceOf[i]];
                if (surface.glass) continue;
                QuadIndices quad = mesh.quads[i];
                if (which == 1)
                    for (std::uint32_t& index : quad) index += shift;
                quads.push_back(quad);
                m_hit.push_back(&surface);
            }
        }
        return Tracer::build(m_device, vertices, quads, 0);
    }

    template <class Visit>
    void eachSample(const Visit& visit) {
        for (int which : {0, 1}) {
            const std::vector<Surface>& surfaces = surfacesOf(which);
            const auto& covered = coverage(which);
            inParallel(static_cast<int>(surfaces.size()), 0, [&](int i) {
                const Surface& surface = surfaces[static_cast<std::size_t>(i)];
                if (surface.glass || surface.glow > 1.0F) return;
                std::size_t count = static_cast<std::size_t>(surface.lightColumns) * surface.lightRows;
                for (std::size_t k = 0; k < count; ++k) {
                    if (!covered[surface.light + k].covered()) continue;
                    visit(sampleOf(surface, surface.light + k));
                }
            });
        }
    }

    Sample sampleOf(const Surface& surface, std::size_t index) const {
        const Cover& cover = m_covered[index];
        Sample sample;
        sample.index = index;
        sample.normal = surface.normal;
        sample.point =
            surface.origin + surface.uAxis * cover.u + surface.vAxis * cover.v + surface.normal * 0.012F;
        return sample;
    }

    /// Where on its surface the light of a sample is taken.
    struct Cover {
        float u = 0.0F, v = 0.0F, moved = 1.0e9F;
        bool covered() const { return moved < 1.0e8F; }
    };

    /// Which samples lie at or near a quad of their surface (a bent corridor fills little of its box), and
    /// where to take them: a little inside that quad, off the frames and corners that would shade them.
    const std::vector<Cover>& coverage(int which) {
        if (m_covered.empty()) m_covered.assign(m_scene.light.size(), Cover{});
        if (m_coverageKnown[static_cast<std::size_t>(which)]) return m_covered;
        m_coverageKnown[static_cast<std::size_t>(which)] = true;
        const Mesh& mesh = which == 0 ? m_scene.mesh : m_scene.leafMesh;
        for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
            const Surface& surface = mesh.surfaces[mesh.surfaceOf[i]];
            Extent u, v;
            for (std::size_t k = 0; k < 4; ++k) {
                Vec3 p = mesh.corner(i, k) - surface.origin;
                u.add(dot(p, surface.uAxis));
                v.add(dot(p, surface.vAxis));
            }
            cover(surface, u, v);
        }
        return m_covered;
    }

    struct Extent {
        float low = 1.0e9F, high = -1.0e9F;
        void add(float x) {
            low = std::min(low, x);
            high = std::max(high, x);
        }
        float inside(float x) const {
            constexpr float kMarginM = 0.11F;
            float margin = std::min(kMarginM, (high - low) / 2);
            return std::clamp(x, low + margin, high - margin);
        }
    };

    void cover(const Surface& surface, const Extent& u, const Extent& v) {
        auto first = [](float metres, float start, float cells, int count) {
            return std::clamp(static_cast<int>(std::floor((metres - start) * cells)), 0, count - 1);
        };
        auto last = [](float metres, float start, float cells, int count) {
            return std::clamp(static_cast<int>(std::ceil((metres - start) * cells)), 0, count - 1);
        };
        int columns = surface.lightColumns, rows = surface.lightRows;
        int left = first(u.low, surface.lightU, surface.cellsU, columns);
        int right = last(u.high, surface.lightU, surface.cellsU, columns);
        int bottom = last(v.high, surface.lightV, surface.cellsV, rows);
        for (int y = first(v.low, surface.lightV, surface.cellsV, rows); y <= bottom; ++y) {
            for (int x = left; x <= right; ++x) {
                float wantedU =
                    surface.lightU + (columns > 1 ? static_cast<float>(x) / surface.cellsU : 0.0F);
                float wantedV = surface.lightV + (rows > 1 ? static_cast<float>(y) / surface.cellsV : 0.0F);
                float atU = u.inside(wantedU), atV = v.inside(wantedV);
                float moved = std::abs(atU - wantedU) + std::abs(atV - wantedV);
                Cover& known = m_covered[surface.light + static_cast<std::size_t>(y * columns + x)];
                if (moved < known.moved) known = {atU, atV, moved};
            }
        }
    }

    Vec3 directAt(const Sample& sample) const {
        thread_local std::vector<std::pair<float, std::size_t>> lamps;
        m_lamps.strongest(sample.point, sample.normal, lamps);
        if (lamps.empty()) return {};
        alignas(64) RTCRay16 rays{};
        alignas(64) std::array<int, 16> valid{};
        for (std::size_t i = 0; i < lamps.size(); ++i) {
            const Lamp& lamp = m_scene.lamps[lamps[i].second];
            // Somewhere on the lamp, for a soft edge of the shadow.
            Draw draw(hashOf(sample.index, i));
            Vec3 spread{static_cast<float>(draw.between(-0.22, 0.22)),
                        static_cast<float>(draw.between(-0.22, 0.22)), 0.0F};
            spread = spread - lamp.facing * dot(spread, lamp.facing);
            Vec3 way = lamp.position + spread - sample.point;
            rays.org_x[i] = sample.point.x;
            rays.org_y[i] = sample.point.y;
            rays.org_z[i] = sample.point.z;
            rays.dir_x[i] = way.x;
            rays.dir_y[i] = way.y;
            rays.dir_z[i] = way.z;
            rays.tnear[i] = 0.0F;
            rays.tfar[i] = 0.98F;
            rays.time[i] = 0.0F;
            rays.mask[i] = 0xFFFFFFFFU;
            rays.id[i] = 0;
            rays.flags[i] = 0;
            valid[i] = -1;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded16(valid.data(), m_tracer->scene(), &context, &rays);
        Vec3 sum;
        for (std::size_t i = 0; i < lamps.size(); ++i)
            if (rays.tfar[i] > 0.0F) sum = sum + m_scene.lamps[lamps[i].second].power * -lamps[i].first;
        return sum;
    }

    Vec3 bouncedAt(const Sample& sample) const {
        RayPacket packet;
        Vec3 side =
            unit(cross(std::abs(sample.normal.z) > 0.9F ? Vec3{1.0F, 0.0F, 0.0F} : kUp, sample.normal));
        Vec3 other = cross(sample.normal, side);
        Draw draw(hashOf(77, sample.index));
        double turn = draw.unit();
        for (int i = 0; i < kRays; ++i) { // one ray in each of 4 by 4 fields of equal weight
            double radius = std::sqrt((i / 4 + draw.unit()) / 4.0);
            double angle = 2.0 * std::numbers::pi * ((i % 4 + draw.unit()) / 4.0 + turn);
            auto x = static_cast<float>(radius * std::cos(angle)),
                 y = static_cast<float>(radius * std::sin(angle));
            float up = std::sqrt(std::max(0.0F, 1.0F - x * x - y * y));
            packet.set(static_cast<std::size_t>(i), sample.point,
                       side * x + other * y + sample.normal * (up + 1.0e-3F), 0.0F, 60.0F);
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect16(packet.valid.data(), m_tracer->scene(), &context, &packet.rays);
        Vec3 sum;
        for (int i = 0; i < kRays; ++i) {
            if (packet.rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) {
                sum = sum + kSky * (packet.rays.ray.dir_z[i] < -0.05F ? 0.25F
                                    : sample.normal.z > 0.9F          ? 1.3F
                                                                      : 0.55F);
                continue;
            }
            const Surface& hit = *m_hit[packet.rays.hit.primID[i]];
            if (hit.glow > 1.0F) continue; // lamps count as lamps already
            float t = packet.rays.ray.tfar[i];
            Vec3 at = sample.point +
                      Vec3{packet.rays.ray.dir_x[i], packet.rays.ray.dir_y[i], packet.rays.ray.dir_z[i]} * t -
                      hit.origin;
            Vec3 light = lightAt(hit, m_scene.light, dot(at, hit.uAxis), dot(at, hit.vAxis));
            sum = sum + light * hit.tint * m_scene.textures[hit.texture].mean();
        }
        return sum * (1.0F / kRays);
    }

    /// Sixteen rays are few: neighbours on one surface share what they found.
    void smooth(std::vector<Vec3>& light) {
        std::vector<Vec3> out = light;
        for (int which : {0, 1}) {
            for (const Surface& surface : surfacesOf(which)) {
                int columns = surface.lightColumns, rows = surface.lightRows;
                for (int y = 0; y < rows; ++y) {
                    for (int x = 0; x < columns; ++x) {
                        Vec3 sum;
                        float weight = 0.0F;
                        for (int dy = -1; dy <= 1; ++dy) {
                            for (int dx = -1; dx <= 1; ++dx) {
                                int nx = x + dx, ny = y + dy;
                                if (nx < 0 || ny < 0 || nx >= columns || ny >= rows) continue;
                                std::size_t at = surface.light + static_cast<std::size_t>(ny * columns + nx);
                                if (!m_covered[at].covered()) continue;
                                sum = sum + light[at];
                                weight += 1.0F;
                            }
                        }
                        if (weight > 0.0F)
                            out[surface.light + static_cast<std::size_t>(y * columns + x)] =
                                sum * (1.0F / weight);
                    }
                }
            }
        }
        light = std::move(out);
    }

    SceneData& m_scene;
    std::shared_ptr<const TraceDevice> m_device;
    LampGrid m_lamps;
    std::unique_ptr<Tracer> m_tracer;
    std::vector<const Surface*> m_hit; ///< by quad of the tracer
    std::vector<Cover> m_covered;
    std::array<bool, 2> m_coverageKnown{};
    float m_cell = kFinestCellM;
};

} // namespace

Result<void> bakeLight(SceneData& scene, const std::shared_ptr<const TraceDevice>& device) {
    return Baker(scene, device).bake();
}

} // namespace farol::simulation
