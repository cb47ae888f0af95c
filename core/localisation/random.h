#pragma once
// A small generator with the same numbers on every platform (splitmix64), which std distributions do not
// promise.

#include <cmath>
#include <cstdint>

namespace farol::localisation {

class Random {
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    /// From 0 up to, not including, 1.
    float uniform() { return static_cast<float>(next() >> 40U) * 0x1p-24F; }
    double uniformDouble() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
    /// The sum of four uniform numbers: within 3.5 sigma as good as normal here, and a third of the time.
    float normal() {
        std::uint64_t z = next();
        auto part = [z](unsigned shift) { return static_cast<float>((z >> shift) & 0xffffU); };
        return (part(0) + part(16) + part(32) + part(48) - 131070.0F) * (1.7320508F / 65536.0F);
    }

private:
    std::uint64_t next() {
        std::uint64_t z = (m_state += 0x9e3779b97f4a7c15ULL);
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31U);
    }

    std::uint64_t m_state;
};

} // namespace farol::localisation
