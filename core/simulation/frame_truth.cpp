#include "core/simulation/frame_truth.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace farol::simulation {

namespace {

using Outline = std::vector<ImagePoint>;

constexpr double kNearM = 0.05;

class Viewer {
public:
    Viewer(const Lens& lens, const Sight& sight) : m_lens(lens), m_sight(sight) {}

    Vec3 seen(Vec3 p) const { ///< right, down, forward
        Vec3 way = p - m_sight.eye;
        return {dot(way, m_sight.right), dot(way, m_sight.down), dot(way, m_sight.forward)};
    }
    std::optional<ImagePoint> project(Vec3 p) const {
        Vec3 at = seen(p);
        if (at.z < kNearM) return std::nullopt;
        return m_lens.project(at.x, at.y, at.z);
    }
    /// A flat piece in the picture, cut off where it comes too near; edges in pieces, because the lens bends
    /// them.
    Outline outlineOf(const std::vector<Vec3>& corners) const {
        std::vector<Vec3> front;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            Vec3 a = seen(corners[i]), b = seen(corners[(i + 1) % corners.size()]);
            constexpr int kPieces = 6;
            for (int k = 0; k < kPieces; ++k) {
                float from = static_cast<float>(k) / kPieces, to = static_cast<float>(k + 1) / kPieces;
                Vec3 p = a * (1.0F - from) + b * from, q = a * (1.0F - to) + b * to;
                float dp = p.z - static_cast<float>(kNearM), dq = q.z - static_cast<float>(kNearM);
                if (dp >= 0.0F) front.push_back(p);
                if ((dp < 0.0F) != (dq < 0.0F)) front.push_back(p + (q - p) * (dp / (dp - dq)));
            }
        }
        Outline outline;
        for (Vec3 p : front)
            if (auto at = m_lens.project(p.x, p.y, std::max<double>(p.z, kNearM))) outline.push_back(*at);
        return outline;
    }

private:
    const Lens& m_lens;
    const Sight& m_sight;
};

double areaOf(const Outline& outline) {
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const ImagePoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2;
}

struct Extent {
    double left = 1.0e9, top = 1.0e9, right = -1.0e9, bottom = -1.0e9;
    void add(const Outline& outline) {
        for (const ImagePoint& p : outline) {
            left = std::min(left, p.x);
            right = std::max(right, p.x);
            top = std::min(top, p.y);
            bottom = std::max(bottom, p.y);
        }
    }
    bool empty() const { return right <= left || bottom <= top; }
};

/// Pixels that the pieces cover together, whether or not they are within the picture.
double unionArea(const std::vector<Outline>& pieces, const Extent& extent) {
    double scale = std::min(4.0, 300.0 / std::max(extent.right - extent.left, extent.bottom - extent.top));
    cv::Mat mask = cv::Mat::zeros(static_cast<int>((extent.bottom - extent.top) * scale) + 3,
                                  static_cast<int>((extent.right - extent.left) * scale) + 3, CV_8U);
    constexpr int kShift = 6;
    for (const Outline& piece : pieces) {
        std::vector<cv::Point> points;
        for (const ImagePoint& p : piece)
            points.emplace_back(
                static_cast<int>(std::lround(((p.x - extent.left) * scale + 0.5) * (1 << kShift))),
                static_cast<int>(std::lround(((p.y - extent.top) * scale + 0.5) * (1 << kShift))));
        if (points.size() >= 3) cv::fillConvexPoly(mask, points, cv::Scalar(1), cv::LINE_8, kShift);
    }
    // The filler takes every pixel that the outline touches: half a pixel too many all round.
    double pixels = cv::countNonZero(mask);
    return std::max(0.4 * pixels, pixels - std::sqrt(pixels) * 1.8) / (scale * scale);
}

class TruthTeller {
public:
    TruthTeller(const SceneData& scene, const Shader& shader, const Lens& lens, const Sight& sight,
                const cv::Mat& ids)
        : m_scene(scene), m_shader(shader), m_lens(lens), m_sight(sight), m_viewer(lens, sight) {
        m_counts.assign(scene.things.size() + 1, 0);
        for (int y = 0; y < ids.rows; ++y)
            for (int x = 0; x < ids.cols; ++x) ++m_counts[ids.at<std::uint16_t>(y, x)];
    }

    std::vector<SeenThing> all() const {
        std::vector<SeenThing> seen;
        for (std::size_t i = 0; i < m_scene.things.size(); ++i) {
            const Thing& thing = m_scene.things[i];
            SeenThing entry;
            bool visible = thing.opening ? seeOpening(thing, i, entry) : seeObject(thing, i, entry);
            if (visible) {
                describe(thing, entry);
                seen.push_back(entry);
            }
        }
        std::stable_sort(seen.begin(), seen.end(),
                         [](const SeenThing& a, const SeenThing& b) { return a.rangeM < b.rangeM; });
        return seen;
    }

private:
    bool seeObject(const Thing& thing, std::size_t index, SeenThing& entry) const {
        double pixels = m_counts[index + 1];
        if (pixels <= 0.0) return false;
        std::vector<Outline> pieces;
        Extent extent;
        auto add = [&](const std::vector<Vec3>& corners) {
            Outline outline = m_viewer.outlineOf(corners);
            if (outline.size() < 3) return;
            extent.add(outline);
            pieces.push_back(std::move(outline));
        };
        if (thing.corners) {
            add({thing.corners->begin(), thing.corners->end()});
        } else {
            for (std::uint32_t quad : thing.quads) {
                std::vector<Vec3> corners;
                for (std::size_t k = 0; k < 4; ++k) corners.push_back(m_scene.mesh.corner(quad, k));
                add(corners);
            }
        }
        if (pieces.empty() || extent.empty()) return false;
        double whole = thing.corners ? areaOf(pieces.front()) : unionArea(pieces, extent);
        entry.visibleShare = std::min(1.0, pixels / std::max(whole, 1.0));
        entry.quad = thing.corners ? cornersOf(*thing.corners, extent)
                                   : quadOf(ImageBox{extent.left, extent.top, extent.right - extent.left,
                                                     extent.bottom - extent.top});
        return true;
    }

    /// The projected corners; where one is behind the camera, the box of what is before it.
    Quad cornersOf(const std::array<Vec3, 4>& corners, const Extent& extent) const {
        Quad quad{};
        for (std::size_t i = 0; i < 4; ++i) {
            auto at = m_viewer.project(corners[i]);
            if (!at)
                return quadOf(ImageBox{extent.left, extent.top, extent.right - extent.left,
                                       extent.bottom - extent.top});
            quad[i] = *at;
        }
        return quad;
    }

    /// A door is what fills its frame, open or closed: asked by rays to points in the frame.
    bool seeOpening(const Thing& thing, std::size_t index, SeenThing& entry) const {
        Vec3 way = thing.centre - m_sight.eye;
        Vec3 at = m_viewer.seen(thing.centre);
        if (dot(way, way) > 30.0F * 30.0F || at.z < 0.2F || std::abs(way.z) > 3.0F) return false;
        std::array<Vec3, 4> corners = *thing.corners;
        if (dot(thing.facing, way) > 0.0F) { // seen from the other side
            std::swap(corners[0], corners[1]);
            std::swap(corners[3], corners[2]);
        }
        constexpr int kAcross = 5, kDown = 8;
        int visible = 0;
        for (int i = 0; i < kAcross * kDown; ++i) {
            float u = (static_cast<float>(i % kAcross) + 0.5F) / kAcross;
            float v = (static_cast<float>(i / kAcross) + 0.5F) / kDown;
            Vec3 p = (corners[0] * (1.0F - u) + corners[1] * u) * (1.0F - v) +
                     (corners[3] * (1.0F - u) + corners[2] * u) * v;
            visible += reaches(p, index) ? 1 : 0;
        }
        if (visible == 0) return false;
        Extent extent;
        extent.add(m_viewer.outlineOf({corners.begin(), corners.end()}));
        if (extent.empty()) return false;
        entry.visibleShare = static_cast<double>(visible) / (kAcross * kDown);
        entry.quad = cornersOf(corners, extent);
        return true;
    }

    bool reaches(Vec3 p, std::size_t thing) const {
        auto pixel = m_viewer.project(p);
        const ImageSize size = m_lens.size();
        if (!pixel || pixel->x < 0.0 || pixel->y < 0.0 || pixel->x >= size.width || pixel->y >= size.height)
            return false;
        Vec3 way = p - m_sight.eye;
        float near = 0.0F;
        for (int pane = 0; pane < 4; ++pane) { // through glass
            RayHit hit = m_shader.trace(m_sight.eye, way, near);
            if (!hit.met() || hit.t > 1.0F - 0.1F / std::max(length(way), 0.2F)) return true;
            const Surface& surface = m_shader.surface(hit.surface);
            if (surface.thing == static_cast<std::int32_t>(thing)) return true;
            if (!surface.glass) return false;
            near = hit.t + 0.003F;
        }
        return false;
    }

    void describe(const Thing& thing, SeenThing& entry) const {
        const building::Building& building = *m_scene.building;
        if (thing.landmark) {
            entry.landmark = building.landmarks()[*thing.landmark].id;
            entry.kind = building.landmarks()[*thing.landmark].kind;
        }
        if (thing.access) {
            entry.access = building.accesses()[*thing.access].id;
            if (!thing.landmark) entry.kind = thing.lift ? Kind::Elevator : Kind::Door;
        }
        Vec3 way = m_sight.eye - thing.centre, at = m_viewer.seen(thing.centre);
        entry.rangeM = length(way);
        entry.bearing = Radians{-std::atan2(static_cast<double>(at.x), static_cast<double>(at.z))};
        float facing = length(thing.facing);
        if (facing > 0.0F && entry.rangeM > 0.0) {
            double cosine = dot(thing.facing, way) / (static_cast<double>(facing) * entry.rangeM);
            if (thing.opening) cosine = std::abs(cosine); // it has two fronts
            entry.angle = Radians{std::acos(std::clamp(cosine, -1.0, 1.0))};
        }
    }

    const SceneData& m_scene;
    const Shader& m_shader;
    const Lens& m_lens;
    const Sight& m_sight;
    Viewer m_viewer;
    std::vector<std::uint32_t> m_counts;
};

} // namespace

std::vector<SeenThing> seenThings(const SceneData& scene, const Shader& shader, const Lens& lens,
                                  const Sight& sight, const cv::Mat& ids) {
    return TruthTeller(scene, shader, lens, sight, ids).all();
}

} // namespace farol::simulation
