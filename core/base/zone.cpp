#include "core/base/zone.h"

#include <array>

namespace farol {

Zone zoneOf(ImagePoint point, ImageSize size) {
    auto third = [](double value, int extent) {
        return value < extent / 3.0 ? 0 : value < extent * 2.0 / 3.0 ? 1 : 2;
    };
    return {static_cast<Column>(third(point.x, size.width)), static_cast<Row>(third(point.y, size.height))};
}

std::string_view zoneName(Zone zone) {
    static constexpr std::array<std::array<std::string_view, 3>, 3> kNames{
        {{"left-up", "up", "right-up"}, {"left", "centre", "right"}, {"left-down", "down", "right-down"}}};
    return kNames[static_cast<std::size_t>(zone.row)][static_cast<std::size_t>(zone.column)];
}

} // namespace farol
