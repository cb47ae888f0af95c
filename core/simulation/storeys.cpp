#include "core/simulation/storeys.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace farol::simulation {

namespace {

constexpr double kCeilingM = 2.7, kSlabM = 0.35, kLeastRiseM = 2.3;

} // namespace

Storeys::Storeys(const building::Building& building) {
    std::map<double, const building::Level*> ordinals;
    for (const building::Region& region : building.regions())
        if (std::isfinite(region.level)) ordinals[region.level] = building.level(region.level);
    for (const building::Level& level : building.levels())
        if (std::isfinite(level.ordinal)) ordinals[level.ordinal] = &level;
    if (ordinals.empty()) ordinals[0.0] = nullptr;

    for (const auto& [ordinal, level] : ordinals) {
        Storey storey;
        storey.ordinal = ordinal;
        double ceiling =
            level && level->heightM && std::isfinite(*level->heightM) ? *level->heightM : kCeilingM;
        storey.ceilingM = std::clamp(ceiling, 2.2, 8.0);
        storey.riseM = storey.ceilingM + kSlabM;
        if (m_storeys.empty()) {
            storey.floorZ = level && level->elevationM && std::isfinite(*level->elevationM)
                                ? *level->elevationM
                                : ordinal * (kCeilingM + kSlabM);
        } else {
            Storey& below = m_storeys.back();
            double rise = (ordinal - below.ordinal) * below.riseM;
            double z = below.floorZ + (ordinal - below.ordinal < 1.0 ? std::max(rise, 0.5) : rise);
            const building::Level* under = building.level(below.ordinal);
            if (level && level->elevationM && under && under->elevationM) {
                double given = below.floorZ + *level->elevationM - *under->elevationM;
                // Levels in the wrong order, or nearly at one height, would cut through each other.
                if (std::isfinite(given) && given - below.floorZ > kLeastRiseM) z = given;
            }
            storey.floorZ = z;
            below.riseM = z - below.floorZ;
            if (below.riseM >= kLeastRiseM) below.ceilingM = std::min(below.ceilingM, below.riseM - 0.2);
        }
        m_storeys.push_back(storey);
    }
}

const Storey& Storeys::at(double ordinal) const {
    auto nearer = [ordinal](const Storey& a, const Storey& b) {
        return std::abs(a.ordinal - ordinal) < std::abs(b.ordinal - ordinal);
    };
    return *std::min_element(m_storeys.begin(), m_storeys.end(), nearer);
}

double Storeys::footZ(double ordinal) const {
    auto above = std::lower_bound(m_storeys.begin(), m_storeys.end(), ordinal,
                                  [](const Storey& storey, double value) { return storey.ordinal < value; });
    if (above == m_storeys.begin()) return above->floorZ;
    if (above == m_storeys.end()) return m_storeys.back().floorZ;
    const Storey& below = *(above - 1);
    return below.floorZ +
           (above->floorZ - below.floorZ) * (ordinal - below.ordinal) / (above->ordinal - below.ordinal);
}

} // namespace farol::simulation
