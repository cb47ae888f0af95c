#include "core/simulation/motion_blur.h"

#include "core/simulation/parallel.h"

#include <algorithm>
#include <cmath>

namespace farol::simulation {

namespace {

struct Smear {
    float x = 0.0F, y = 0.0F; ///< pixels
};

/// A point at p seen from the moving camera moves by -velocity - rotation x p.
Smear smearOf(const ImagePoint& ray, float depth, const CameraMotion& motion, float pixels) {
    Vec3 p = Vec3{static_cast<float>(ray.x), static_cast<float>(ray.y), 1.0F} * depth;
    Vec3 moves = (motion.velocity + cross(motion.rotation, p)) * -1.0F;
    float x = (moves.x - static_cast<float>(ray.x) * moves.z) / depth;
    float y = (moves.y - static_cast<float>(ray.y) * moves.z) / depth;
    constexpr float kMost = 40.0F;
    return {std::clamp(x * pixels, -kMost, kMost), std::clamp(y * pixels, -kMost, kMost)};
}

} // namespace

void blurByMotion(std::vector<Light>& picture, const std::vector<float>& depth, const Lens& lens,
                  const CameraMotion& motion, double seconds, int threads) {
    if (seconds <= 0.0 || (length(motion.velocity) < 1.0e-3F && length(motion.rotation) < 1.0e-4F)) return;
    int width = lens.size().width, height = lens.size().height;
    auto pixels = static_cast<float>(lens.focalPx() * seconds);
    static thread_local std::vector<Light> sharp;
    sharp = picture;
    const Light* from = sharp.data();
    inParallel(height, threads, [&](int y) {
        for (int x = 0; x < width; ++x) {
            auto at =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
            Smear smear = smearOf(lens.centres()[at], std::max(depth[at], 0.15F), motion, pixels);
            float size = std::max(std::abs(smear.x), std::abs(smear.y));
            if (size < 0.7F) continue;
            int taps = std::min(24, static_cast<int>(size + 1.5F));
            float stepX = smear.x / static_cast<float>(taps), stepY = smear.y / static_cast<float>(taps);
            float startX = static_cast<float>(x) + 0.5F - stepX * static_cast<float>(taps - 1) * 0.5F;
            float startY = static_cast<float>(y) + 0.5F - stepY * static_cast<float>(taps - 1) * 0.5F;
            Light sum;
            for (int i = 0; i < taps; ++i) {
                int sx = std::clamp(static_cast<int>(startX + stepX * static_cast<float>(i)), 0, width - 1);
                int sy = std::clamp(static_cast<int>(startY + stepY * static_cast<float>(i)), 0, height - 1);
                const Light& tap = from[sy * width + sx];
                sum.red += tap.red;
                sum.green += tap.green;
                sum.blue += tap.blue;
            }
            float share = 1.0F / static_cast<float>(taps);
            picture[at] = {sum.red * share, sum.green * share, sum.blue * share, 0.0F};
        }
    });
}

} // namespace farol::simulation
