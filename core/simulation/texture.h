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

    /// As `at`, from the one level that is nearest, for samples that are averaged anyway.
    Vec3 nearAt(float u, float v, float level) const {
        int nearest = level > 0.0F ? static_cast<int>(level + 0.5F) : 0;
        return bilinear(
            u, v, m_levels[static_cast<std::size_t>(nearest < m_levelCount ? nearest : m_levelCount - 1)]);
    }
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
    if (m_wraps) {
        u -= static_cast<float>(floorOf(u));
        v -= static_cast<float>(floorOf(v));
    }
    // One texel beyond the edges at most: farther out a clamped texture looks the same.
    u = u > -1.0F ? (u < 2.0F ? u : 2.0F) : -1.0F;
    v = v > -1.0F ? (v < 2.0F ? v : 2.0F) : -1.0F;
    float x = u * static_cast<float>(level.width) - 0.5F;
    float y = v * static_cast<float>(level.height) - 0.5F;
    int left = floorOf(x), top = floorOf(y);
    auto wx = static_cast<std::uint32_t>((x - static_cast<float>(left)) * 256.0F);
    auto wy = static_cast<std::uint32_t>((y - static_cast<float>(top)) * 256.0F);
    auto inside = [wraps = m_wraps](int i, int size) {
        if (i < 0) return wraps ? size - 1 : 0;
        if (i >= size) return wraps ? 0 : size - 1;
        return i;
    };
    int right = inside(left + 1, level.width), bottom = inside(top + 1, level.height);
    left = inside(left, level.width);
    top = inside(top, level.height);
    const std::uint32_t* rows = m_texels.data() + level.first;
    const std::uint32_t* upper = rows + static_cast<std::ptrdiff_t>(top) * level.width;
    const std::uint32_t* lower = rows + static_cast<std::ptrdiff_t>(bottom) * level.width;
    // Weights of 8 bits, so that red and blue go through one multiplication.
    std::uint32_t w11 = wx * wy >> 8U, w01 = wx - w11, w10 = wy - w11, w00 = 256U - wx - w10;
    std::uint32_t t00 = upper[left], t01 = upper[right], t10 = lower[left], t11 = lower[right];
    constexpr std::uint32_t kPair = 0xFF00FFU;
    std::uint32_t pair =
        (t00 & kPair) * w00 + (t01 & kPair) * w01 + (t10 & kPair) * w10 + (t11 & kPair) * w11;
    std::uint32_t green = (t00 >> 8U & 255U) * w00 + (t01 >> 8U & 255U) * w01 + (t10 >> 8U & 255U) * w10 +
                          (t11 >> 8U & 255U) * w11;
    Vec3 sum{static_cast<float>(static_cast<int>(pair & 0xFFFFU)),
             static_cast<float>(static_cast<int>(green)), static_cast<float>(static_cast<int>(pair >> 16U))};
    constexpr float kScale = 1.0F / (256.0F * 256.0F * 255.0F * 255.0F);
    return {sum.x * sum.x * kScale, sum.y * sum.y * kScale, sum.z * sum.z * kScale};
}

/// A colour as screens show it (0 to 255) as linear light.
Vec3 linearOf(int red, int green, int blue);

} // namespace farol::simulation
