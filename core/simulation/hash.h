#pragma once
// Random numbers that depend on what they are for and on nothing else: no generator is carried along, so the
// order in which things are built, and the number of threads, cannot change them.

#include <cstdint>
#include <string_view>

namespace farol::simulation {

constexpr std::uint64_t mixed(std::uint64_t x) { // splitmix64
    x += 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31U);
}

constexpr std::uint64_t hashOf(std::uint64_t seed, std::string_view text) { // FNV-1a, then mixed
    std::uint64_t hash = 0xCBF29CE484222325ULL ^ mixed(seed);
    for (char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
    return mixed(hash);
}

constexpr std::uint64_t hashOf(std::uint64_t seed, std::uint64_t value) {
    return mixed(mixed(seed) ^ value);
}

/// Numbers one after the other from one seed.
class Draw {
public:
    explicit constexpr Draw(std::uint64_t seed) : m_state(seed) {}
    constexpr std::uint64_t bits() { return mixed(m_state++); }
    constexpr double unit() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; } ///< [0, 1)
    constexpr double between(double low, double high) { return low + (high - low) * unit(); }
    constexpr bool chance(double p) { return unit() < p; }
    constexpr int below(int count) { return count > 0 ? static_cast<int>(unit() * count) : 0; }

private:
    std::uint64_t m_state;
};

} // namespace farol::simulation
