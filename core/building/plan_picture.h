#pragma once
// A picture of a floor plan: PNG, JPEG, GeoTIFF and whatever else GDAL reads, with its place on the map where
// the file or a world file beside it tells one.

#include "core/base/error.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace farol::building {

struct PlanPicture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba; ///< 4 bytes a pixel, the first line on top
    /// Map metres of a pixel: x = [0] + [1] column + [2] line, y = [3] + [4] column + [5] line.
    std::optional<std::array<double, 6>> toMap;
};

/// Made smaller where it is wider or taller than `mostPixels`. `crs`: of the map, as WKT; empty: a local
/// plane, in which only a place without a reference system of its own is understood.
Result<PlanPicture> loadPlanPicture(const std::string& path, const std::string& crs, int mostPixels = 4096);

} // namespace farol::building
