#include "core/localisation/rate_cache.h"

#include <algorithm>
#include <cmath>

namespace farol::localisation {

namespace {

constexpr float kCellM = 0.5F, kSectorDeg = 15.0F;
constexpr float kUnit = 0.02F; // detections a second

std::uint8_t counted(float rate) {
    return static_cast<std::uint8_t>(std::min(255.0F, rate / kUnit + 0.5F));
}

} // namespace

void RateCache::fill(Slot& slot, const SensorModel& sensors, std::uint32_t region, Spot middle) {
    std::array<float, kSectors> rates;
    sensors.expectedRates(region, middle, kWideDeg, rates);
    std::transform(rates.begin(), rates.end(), slot.wide.begin(), counted);
    sensors.expectedRates(region, middle, kNarrowDeg, rates);
    std::transform(rates.begin(), rates.end(), slot.narrow.begin(), counted);
    float sum = 0.0F;
    for (float rate : rates) sum += rate;
    slot.anyhow = sum / static_cast<float>(kSectors);
}

float RateCache::rateAt(const SensorModel& sensors, std::uint32_t region, Spot at, const Gaze& gaze) {
    auto column = static_cast<std::int32_t>(std::floor(at.x / kCellM));
    auto row = static_cast<std::int32_t>(std::floor(at.y / kCellM));
    // Regions overlap on other levels: the region is part of the key. Maps are far under 2^20 cells wide.
    std::uint64_t key = (std::uint64_t{region} << 40U) ^
                        ((static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) & 0xfffffU) << 20U) ^
                        (static_cast<std::uint64_t>(static_cast<std::uint32_t>(row)) & 0xfffffU);
    Slot& slot = m_slots[(key * 0x9e3779b97f4a7c15ULL) >> 49U];
    if (slot.key != key) {
        slot.key = key;
        fill(slot, sensors, region,
             {(static_cast<float>(column) + 0.5F) * kCellM, (static_cast<float>(row) + 0.5F) * kCellM});
    }
    if (gaze.variance > kUnknownDeg * kUnknownDeg) return slot.anyhow;
    float yaw = gaze.yawDeg < 0.0F ? gaze.yawDeg + 360.0F : gaze.yawDeg;
    auto sector = std::min(kSectors - 1, static_cast<std::size_t>(std::max(0.0F, yaw) / kSectorDeg));
    bool narrow = gaze.variance < kBetweenDeg * kBetweenDeg;
    float looked = kUnit * static_cast<float>(narrow ? slot.narrow[sector] : slot.wide[sector]);
    return (1.0F - gaze.unknownShare) * looked + gaze.unknownShare * slot.anyhow;
}

} // namespace farol::localisation
