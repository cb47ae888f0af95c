#pragma once
// What should be seen from a place, looked up instead of summed anew for each of thousands of walkers:
// squares of half a metre, directions of 15 degrees, two widths of doubt about the direction. Squares are
// filled when first asked for; a later one may take the slot of an earlier one, so memory stays the same on
// any map. Not thread-safe.

#include "core/localisation/sensor_model.h"

#include <array>
#include <cstdint>
#include <vector>

namespace farol::localisation {

class RateCache {
public:
    RateCache() : m_slots(kSlots) {}
    /// SensorModel::expectedRate(), within the roughness of the squares.
    float rateAt(const SensorModel& sensors, std::uint32_t region, Spot at, const Gaze& gaze);

private:
    static constexpr std::size_t kSlots = 1U << 15U, kSectors = 24;
    static constexpr float kNarrowDeg = 9.0F, kWideDeg = 24.0F, kBetweenDeg = 15.0F, kUnknownDeg = 80.0F;

    struct Slot {
        std::uint64_t key = ~std::uint64_t{0};
        std::array<std::uint8_t, kSectors> narrow{}, wide{}; ///< in units of kUnit
        float anyhow = 0.0F;                                 ///< whichever way the camera looks
    };
    static_assert(sizeof(Slot) == 64, "one line of the processor's cache");

    static void fill(Slot& slot, const SensorModel& sensors, std::uint32_t region, Spot middle);

    std::vector<Slot> m_slots;
};

} // namespace farol::localisation
