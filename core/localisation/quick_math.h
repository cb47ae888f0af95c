#pragma once
// Angles and exponentials good to a few ten-thousandths, for what every walker needs several times a second.

#include <bit>
#include <cmath>
#include <cstdint>

namespace farol::localisation {

/// Degrees counter-clockwise from east, within 0.01.
inline float quickDirectionDeg(float dx, float dy) {
    float ax = std::abs(dx), ay = std::abs(dy);
    float longer = ax > ay ? ax : ay, shorter = ax > ay ? ay : ax;
    if (longer <= 0.0F) return 0.0F;
    float t = shorter / longer, s = t * t;
    // Minimax polynomial of the arc tangent on 0 to 1.
    float angle = t * (57.2881F + s * (-18.92477F + s * (10.32132F + s * (-4.87776F + s * 1.193764F))));
    if (ay > ax) angle = 90.0F - angle;
    if (dx < 0.0F) angle = 180.0F - angle;
    return dy < 0.0F ? -angle : angle;
}

/// e to the x: within 0.02 %; 0 far below.
inline float quickExp(float x) {
    constexpr float kLog2E = 1.44269504F, kLeast = -80.0F, kMost = 80.0F;
    if (!(x > kLeast)) return 0.0F;
    if (x > kMost) x = kMost;
    float y = x * kLog2E, whole = std::floor(y), part = y - whole;
    float scaled = 1.0F + part * (0.69555686F + part * (0.22617357F + part * 0.07814557F));
    auto bits = static_cast<std::uint32_t>(static_cast<std::int32_t>(whole) + 127) << 23U;
    return std::bit_cast<float>(bits) * scaled;
}

} // namespace farol::localisation
