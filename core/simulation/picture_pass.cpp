#include "core/simulation/picture_pass.h"

#include "core/simulation/parallel.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

namespace {

constexpr int kBlock = 4; ///< 4 by 4 pixels are one packet

class Picture {
public:
    Picture(const Shader& shader, const Lens& lens, const Sight& sight, PictureBuffers& buffers)
        : m_shader(shader),
          m_lens(lens),
          m_sight(sight),
          m_buffers(buffers),
          m_width(lens.size().width),
          m_height(lens.size().height),
          m_halfWidth((m_width + 1) / 2),
          m_step(static_cast<float>(1.0 / lens.focalPx())),
          m_right(sight.right * m_step),
          m_down(sight.down * m_step) {}

    /// Pixel centres of four rows.
    void traceRows(int block) {
        RayPacket packet;
        int top = block * kBlock;
        for (int left = 0; left < m_width; left += kBlock) {
            packet.clear();
            for (int i = 0; i < kBlock * kBlock; ++i) {
                int x = left + i % kBlock, y = top + i / kBlock;
                if (x < m_width && y < m_height)
                    packet.set(static_cast<std::size_t>(i), m_sight.eye, centreOf(x, y));
            }
            m_shader.trace(packet);
            for (int i = 0; i < kBlock * kBlock; ++i) {
                int x = left + i % kBlock, y = top + i / kBlock;
                if (x >= m_width || y >= m_height) continue;
                RayHit hit = m_shader.hitOf(packet, static_cast<std::size_t>(i));
                m_buffers.hits[at(x, y)] = hit;
                m_buffers.depth[at(x, y)] = std::min(hit.t, 1.0e4F);
            }
        }
    }

    /// What shining surfaces mirror, for one pixel in four: a floor is no looking-glass.
    void mirrorRows(int block) {
        RayPacket packet;
        int top = block * 2 * kBlock;
        for (int left = 0; left < m_width; left += 2 * kBlock) {
            packet.clear();
            bool any = false;
            for (int i = 0; i < kBlock * kBlock; ++i) {
                int x = left + 2 * (i % kBlock), y = top + 2 * (i / kBlock);
                if (x >= m_width || y >= m_height) continue;
                mirroredAt(x, y) = {};
                const RayHit& hit = m_buffers.hits[at(x, y)];
                if (!hit.met()) continue;
                const Surface& plane = m_shader.surface(hit.surface);
                if (plane.gloss <= 0.0F || plane.glass) continue;
                any = true;
                // As seen by an eye behind the mirror, so that distances count from the real one.
                Vec3 direction = centreOf(x, y);
                Vec3 back = mirrored(direction, plane.normal);
                Vec3 point = m_sight.eye + direction * hit.t;
                packet.set(static_cast<std::size_t>(i), point - back * hit.t, back, hit.t + 0.004F);
            }
            if (!any) continue;
            m_shader.trace(packet);
            for (int i = 0; i < kBlock * kBlock; ++i) {
                if (!packet.valid[static_cast<std::size_t>(i)]) continue;
                int x = left + 2 * (i % kBlock), y = top + 2 * (i / kBlock);
                mirroredAt(x, y) =
                    mirroredLight(packet, static_cast<std::size_t>(i), m_buffers.hits[at(x, y)]);
            }
        }
    }

    /// A floor's polish is uneven: what it mirrors is spread a little.
    void softenRow(int row) {
        int rows = (m_height + 1) / 2;
        for (int x = 0; x < m_halfWidth; ++x) {
            Light sum;
            for (int y = std::max(0, row - 1); y <= std::min(rows - 1, row + 1); ++y) {
                for (int k = std::max(0, x - 1); k <= std::min(m_halfWidth - 1, x + 1); ++k) {
                    const Light& cell = m_buffers.mirrored[halfAt(k, y)];
                    sum.red += cell.red;
                    sum.green += cell.green;
                    sum.blue += cell.blue;
                    sum.spare += cell.spare;
                }
            }
            float share = sum.spare > 0.0F ? 1.0F / sum.spare : 0.0F;
            bool own = m_buffers.mirrored[halfAt(x, row)].spare > 0.0F;
            m_buffers.polished[halfAt(x, row)] = {sum.red * share, sum.green * share, sum.blue * share,
                                                  own ? 1.0F : 0.0F};
        }
    }

    void paintRow(int y, bool fourRays) {
        std::vector<int> edges;
        for (int x = 0; x < m_width; ++x) {
            std::int32_t thing = -1;
            const RayHit& hit = m_buffers.hits[at(x, y)];
            Vec3 direction = centreOf(x, y);
            bool edge = fourRays && onEdge(x, y);
            bool named = hit.met() && (m_shader.surface(hit.surface).glass);
            if (!edge || named) {
                Vec3 colour = m_shader.colour(m_sight.eye, direction, hit, m_right, m_down, &thing);
                colour = withMirror(colour, x, y, direction, hit);
                m_buffers.light[at(x, y)] = {colour.x, colour.y, colour.z, 0.0F};
            } else if (hit.met()) {
                thing = m_shader.surface(hit.surface).thing;
            }
            if (edge) edges.push_back(x);
            m_buffers.ids.at<std::uint16_t>(y, x) = static_cast<std::uint16_t>(thing + 1);
        }
        for (std::size_t first = 0; first < edges.size(); first += kBlock) fourRaysEach(edges, first, y);
    }

private:
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    }
    std::size_t halfAt(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_halfWidth) +
               static_cast<std::size_t>(x);
    }
    Light& mirroredAt(int x, int y) { return m_buffers.mirrored[halfAt(x / 2, y / 2)]; }
    Vec3 centreOf(int x, int y) const {
        const ImagePoint& ray = m_lens.centres()[at(x, y)];
        return m_sight.direction(static_cast<float>(ray.x), static_cast<float>(ray.y));
    }
    static Vec3 mirrored(Vec3 v, Vec3 normal) { return v - normal * (2.0F * dot(v, normal)); }

    Light mirroredLight(const RayPacket& packet, std::size_t i, const RayHit& mirror) const {
        RayHit hit = m_shader.hitOf(packet, i);
        Vec3 normal = m_shader.surface(mirror.surface).normal;
        Vec3 eye{packet.rays.ray.org_x[i], packet.rays.ray.org_y[i], packet.rays.ray.org_z[i]};
        // Three times as coarse as the picture: the floor's polish is not perfect.
        Vec3 seen = m_shader.colour(eye, packet.direction(i), hit, mirrored(m_right, normal) * 3.0F,
                                    mirrored(m_down, normal) * 3.0F, nullptr, 4);
        // A lamp in a polished floor is a soft patch, not a second lamp.
        auto soft = [](float x) { return std::min(x, 1.3F); };
        return {soft(seen.x), soft(seen.y), soft(seen.z), 1.0F};
    }

    bool onEdge(int x, int y) const {
        std::uint32_t own = m_buffers.hits[at(x, y)].surface;
        return (x > 0 && m_buffers.hits[at(x - 1, y)].surface != own) ||
               (x + 1 < m_width && m_buffers.hits[at(x + 1, y)].surface != own) ||
               (y > 0 && m_buffers.hits[at(x, y - 1)].surface != own) ||
               (y + 1 < m_height && m_buffers.hits[at(x, y + 1)].surface != own);
    }

    /// Between the four nearest of the coarse samples that show anything.
    Vec3 withMirror(Vec3 colour, int x, int y, Vec3 direction, const RayHit& hit) {
        if (!hit.met()) return colour;
        const Surface& plane = m_shader.surface(hit.surface);
        if (plane.gloss <= 0.0F || plane.glass) return colour;
        Vec3 sum;
        float weight = 0.0F;
        int left = std::max(0, (x - 1) / 2), top = std::max(0, (y - 1) / 2);
        for (int cy = top; cy <= top + 1; ++cy) {
            for (int cx = left; cx <= left + 1; ++cx) {
                if (2 * cx >= m_width || 2 * cy >= m_height) continue;
                const Light& cell = m_buffers.polished[halfAt(cx, cy)];
                float share = cell.spare * (2.01F - std::abs(static_cast<float>(x - 2 * cx))) *
                              (2.01F - std::abs(static_cast<float>(y - 2 * cy)));
                sum = sum + Vec3{cell.red, cell.green, cell.blue} * share;
                weight += share;
            }
        }
        if (weight <= 0.0F) return colour;
        float share = m_shader.mirror(plane, direction);
        return colour * (1.0F - 0.5F * share) + sum * (share / weight);
    }

    void fourRaysEach(const std::vector<int>& edges, std::size_t first, int y) {
        static constexpr float kShift[4][2] = {
            {-0.25F, -0.25F}, {0.25F, -0.25F}, {-0.25F, 0.25F}, {0.25F, 0.25F}};
        RayPacket packet;
        std::size_t count = std::min<std::size_t>(kBlock, edges.size() - first);
        for (std::size_t i = 0; i < count * 4; ++i) {
            const float* shift = kShift[i % 4];
            packet.set(i, m_sight.eye,
                       centreOf(edges[first + i / 4], y) + m_right * shift[0] + m_down * shift[1]);
        }
        m_shader.trace(packet);
        for (std::size_t pixel = 0; pixel < count; ++pixel) {
            Vec3 sum;
            int x = edges[first + pixel];
            for (std::size_t i = pixel * 4; i < pixel * 4 + 4; ++i) {
                RayHit hit = m_shader.hitOf(packet, i);
                Vec3 direction = packet.direction(i);
                Vec3 colour = m_shader.colour(m_sight.eye, direction, hit, m_right * 0.6F, m_down * 0.6F);
                sum = sum + withMirror(colour, x, y, direction, hit);
            }
            m_buffers.light[at(x, y)] = {sum.x * 0.25F, sum.y * 0.25F, sum.z * 0.25F, 0.0F};
        }
    }

    const Shader& m_shader;
    const Lens& m_lens;
    const Sight& m_sight;
    PictureBuffers& m_buffers;
    int m_width, m_height, m_halfWidth;
    float m_step;
    Vec3 m_right, m_down;
};

} // namespace

void drawPicture(const Shader& shader, const Lens& lens, const Sight& sight, int raysPerPixel, int threads,
                 PictureBuffers& buffers) {
    ImageSize size = lens.size();
    auto pixels = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    buffers.light.resize(pixels);
    buffers.depth.resize(pixels);
    buffers.hits.resize(pixels);
    buffers.mirrored.resize(static_cast<std::size_t>((size.width + 1) / 2) *
                            static_cast<std::size_t>((size.height + 1) / 2));
    buffers.ids.create(size.height, size.width, CV_16U);
    Picture picture(shader, lens, sight, buffers);
    inParallel((size.height + kBlock - 1) / kBlock, threads, [&](int block) { picture.traceRows(block); });
    inParallel((size.height + 2 * kBlock - 1) / (2 * kBlock), threads,
               [&](int block) { picture.mirrorRows(block); });
    buffers.polished.resize(buffers.mirrored.size());
    inParallel((size.height + 1) / 2, threads, [&](int row) { picture.softenRow(row); });
    inParallel(size.height, threads, [&](int y) { picture.paintRow(y, raysPerPixel == 4); });
}

} // namespace farol::simulation
