#pragma once
// The 3x3 detection zones of a picture (paper 4.3: left, centre, right and up, centre, down).

#include "core/base/geometry.h"

#include <string_view>

namespace farol {

enum class Column { Left, Centre, Right };
enum class Row { Up, Centre, Down };

struct Zone {
    Column column = Column::Centre;
    Row row = Row::Centre;

    friend constexpr bool operator==(Zone, Zone) = default;
};

/// The zone of a point by thirds of width and height; a point on a line belongs to the right or lower zone, a
/// point outside the picture to the nearest one.
Zone zoneOf(ImagePoint point, ImageSize size);
/// "left-down", and "centre" once for the middle (paper: "extinguisher-left-down").
std::string_view zoneName(Zone zone);

} // namespace farol
