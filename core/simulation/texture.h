#pragma once
// A picture on a surface, with its smaller copies for the distance (mip levels). Texels hold the square root
// of linear light in 8 bits: finer where it is dark, and made linear again by one multiplication.

#include "core/simulation/vec3.h"

#include <opencv2/core.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace farol::simulation {

class Texture {
public:
    /// `picture`: 8-bit BGR as screens show it. `wraps`: it is laid again and again, like tiles.
    Texture(const cv::Mat& picture, bool wraps);

    int width() const { return m_levels[0].width; }
    int height() const { return m_levels[0].height; }
    int levelCount() const { return m_levelCount; }
    Vec3 mean() const { return m_mean; } ///< linear
    std::size_t bytes() const { return m_texels.size() * sizeof(std::uint32_t); }

    /// Linear colour at (u, v), shares of the whole picture from its top left, smoothed for a footprint of
    /// 2^level texels.
    Vec3 at(float u, float v, float level) const {
        if (level <= 0.0F) return bilinear(u, v, m_levels[0]);
        int low = static_cast<int>(level);
        if (low >= m_levelCount - 1)
            return bilinear(u, v, m_levels[static_cast<std::size_t>(m_levelCount) - 1]);
        float high = level - static_cast<float>(low);
        const Level& fine = m_levels[static_cast<std::size_t>(low)];
        const Level& coarse = m_levels[static_cast<std::size_t>(low) + 1];
        // Where one level has nearly all the weight the other is not worth its price.
        if (high < 0.15F) return bilinear(u, v, fine);
        if (high > 0.85F) return bilinear(u, v, coarse);
        float share = (high - 0.15F) / 0.7F;
        return bilinear(u, v, fine) * (1.0F - share) + bilinear(u, v, coarse) * share;
    }

private:
    struct Level {
        int width = 1, height = 1;
        std::size_t first = 0;
    };

    static int wrapped(int i, int size) {
        int rest = i % size;
        return rest < 0 ? rest + size : rest;
    }
    static int floorOf(float x) {
        int whole = static_cast<int>(x);
        return whole - (static_cast<float>(whole) > x ? 1 : 0);
    }
    Vec3 bilinear(float u, float v, const Level& level) const;

    std::array<Level, 16> m_levels{};
    int m_levelCount = 0;
    std::vector<std::uint32_t> m_texels;
    Vec3 m_mean;
    bool m_wraps;
};

inline Vec3 Texture::bilinear(float u, float v, const Level& level) const {
    if (m_wraps) { // before the float loses its fraction
        u -= static_cast<float>(floorOf(u));
        v -= static_cast<float>(floorOf(v));
    }
    float x = u * static_cast<float>(level.width) - 0.5F;
    float y = v * static_cast<float>(level.height) - 0.5F;
    x = std::fmin(std::fmax(x, -1.0e6F), 1.0e6F);
    y = std::fmin(std::fmax(y, -1.0e6F), 1.0e6F);
    int left = floorOf(x), top = floorOf(y);
    float fx = x - static_cast<float>(left), fy = y - static_cast<float>(top);
    int right = left + 1, bottom = top + 1;
    auto inside = [this](int i, int size) {
        if (i >= 0 && i < size) return i;
        if (m_wraps) return wrapped(i, size);
        return i < 0 ? 0 : size - 1;
    };
    left = inside(left, level.width);
    right = inside(right, level.width);
    const std::uint32_t* rows = m_texels.data() + level.first;
    const std::uint32_t* upper = rows + static_cast<std::ptrdiff_t>(inside(top, level.height)) * level.width;
    const std::uint32_t* lower =
        rows + static_cast<std::ptrdiff_t>(inside(bottom, level.height)) * level.width;
    const std::uint32_t texels[4] = {upper[left], upper[right], lower[left], lower[right]};
    const float weights[4] = {(1.0F - fx) * (1.0F - fy), fx * (1.0F - fy), (1.0F - fx) * fy, fx * fy};
    Vec3 sum;
    for (int i = 0; i < 4; ++i) {
        sum.x += weights[i] * static_cast<float>(texels[i] & 255U);
        sum.y += weights[i] * static_cast<float>((texels[i] >> 8U) & 255U);
        sum.z += weights[i] * static_cast<float>((texels[i] >> 16U) & 255U);
    }
    constexpr float kScale = 1.0F / (255.0F * 255.0F);
    return {sum.x * sum.x * kScale, sum.y * sum.y * kScale, sum.z * sum.z * kScale};
}

/// A colour as screens show it (0 to 255) as linear light.
Vec3 linearOf(int red, int green, int blue);

} // namespace farol::simulation
