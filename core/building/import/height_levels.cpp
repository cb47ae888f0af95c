#include "core/building/import/height_levels.h"

#include <algorithm>
#include <cmath>

namespace farol::building {

namespace {

constexpr double kStoreyGapM = 1.5;

} // namespace

HeightLevels::HeightLevels(std::vector<double> heights) {
    std::erase_if(heights, [](double height) { return !std::isfinite(height); });
    std::sort(heights.begin(), heights.end());
    double before = 0.0;
    for (double height : heights) {
        if (m_floors.empty() || height - before > kStoreyGapM) m_floors.push_back(height);
        before = height;
    }
    for (std::size_t i = 1; i < m_floors.size(); ++i)
        if (std::abs(m_floors[i]) < std::abs(m_floors[m_ground])) m_ground = i;
}

double HeightLevels::ordinalAt(std::size_t floor) const {
    return static_cast<double>(floor) - static_cast<double>(m_ground);
}

double HeightLevels::ordinalOf(double height) const {
    auto above = std::upper_bound(m_floors.begin(), m_floors.end(), height);
    return ordinalAt(above == m_floors.begin() ? 0 : static_cast<std::size_t>(above - m_floors.begin()) - 1);
}

} // namespace farol::building
