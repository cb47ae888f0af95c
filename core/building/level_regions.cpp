#include "core/building/level_regions.h"

#include <cmath>

namespace farol::building {

LevelRegions::LevelRegions(const std::vector<Region>& regions) : m_regions(regions) {
    std::map<long long, std::vector<Box2>> boxes;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        auto box = boundingBox(regions[i].polygon.outer);
        if (!box || !isFinite(box->low) || !isFinite(box->high)) continue;
        m_floors[keyOf(regions[i].level)].regions.push_back(i);
        boxes[keyOf(regions[i].level)].push_back(*box);
    }
    for (auto& [key, floor] : m_floors) floor.index = BoxIndex(boxes[key]);
}

// Ordinals such as 0.5 compare exactly in thousandths.
long long LevelRegions::keyOf(double level) {
    return std::isfinite(level) ? std::llround(std::clamp(level, -1e9, 1e9) * 1000.0) : 0;
}

std::vector<std::size_t> LevelRegions::meeting(double level, const Box2& box) const {
    auto floor = m_floors.find(keyOf(level));
    if (floor == m_floors.end()) return {};
    std::vector<std::size_t> found = floor->second.index.meeting(box);
    for (std::size_t& index : found) index = floor->second.regions[index];
    return found;
}

std::optional<std::size_t> LevelRegions::at(double level, Point2 point) const {
    std::optional<std::size_t> best;
    double smallest = 0.0;
    for (std::size_t index : meeting(level, {point, point})) {
        if (!contains(m_regions[index].polygon, point)) continue;
        double size = area(m_regions[index].polygon);
        if (best && size >= smallest) continue;
        best = index;
        smallest = size;
    }
    return best;
}

std::optional<std::size_t> LevelRegions::nearest(double level, Point2 point, double reach) const {
    if (auto inside = at(level, point)) return inside;
    std::optional<std::size_t> best;
    for (std::size_t index : meeting(level, grown({point, point}, reach))) {
        double gap = distanceToPolygon(m_regions[index].polygon, point);
        if (gap > reach) continue;
        best = index;
        reach = gap;
    }
    return best;
}

std::vector<double> LevelRegions::levels() const {
    std::vector<double> ordinals;
    for (const auto& [key, floor] : m_floors) ordinals.push_back(static_cast<double>(key) / 1000.0);
    return ordinals;
}

} // namespace farol::building
