#pragma once
// The regions of each level found by place.

#include "core/building/box_index.h"
#include "core/building/building.h"

#include <map>
#include <optional>
#include <vector>

namespace farol::building {

/// Holds references: the regions must outlive it and stay as they are.
class LevelRegions {
public:
    explicit LevelRegions(const std::vector<Region>& regions);

    std::vector<std::size_t> meeting(double level, const Box2& box) const; ///< by bounding box, ascending
    /// The smallest region that holds the point.
    std::optional<std::size_t> at(double level, Point2 point) const;
    /// As `at`, else the nearest one within `reach`.
    std::optional<std::size_t> nearest(double level, Point2 point, double reach) const;
    std::vector<double> levels() const; ///< ascending

private:
    struct Floor {
        std::vector<std::size_t> regions;
        BoxIndex index;
    };
    static long long keyOf(double level);

    const std::vector<Region>& m_regions;
    std::map<long long, Floor> m_floors;
};

} // namespace farol::building
