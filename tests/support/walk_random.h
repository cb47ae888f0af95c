#pragma once
// Random numbers that are the same on every platform: the engine of the standard is, its distributions are
// not.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace farol::test {

class WalkRandom {
public:
    explicit WalkRandom(std::uint64_t seed) : m_engine(seed) {}

    double uniform() { return static_cast<double>(m_engine() >> 11U) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * uniform(); }
    bool chance(double probability) { return uniform() < probability; }
    std::size_t below(std::size_t count) {
        return count == 0 ? 0 : static_cast<std::size_t>(uniform() * static_cast<double>(count));
    }
    double normal() {
        double u = 1.0 - uniform();
        return std::sqrt(-2.0 * std::log(u)) * std::cos(6.283185307179586 * uniform());
    }

private:
    std::mt19937_64 m_engine;
};

} // namespace farol::test
