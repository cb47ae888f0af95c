#pragma once
// "The third door on your left": what somebody counts who follows a wall.

#include "core/building/building.h"

#include <cstddef>
#include <optional>

namespace farol::routing {

struct DoorCount {
    int number = 1; ///< the door itself counts
    bool left = false;
};

/// Of the accesses of that kind in the wall that one walks along from `from` to the access: its number and
/// its side. Empty where it is not in a wall beside the way, or what is counted cannot be told.
std::optional<DoorCount> countDoors(const building::Building& building, std::size_t region,
                                    const building::Access& access, Point2 from);

/// The direction straight through the access out of the region, from its own line or the wall it stands in;
/// its length is 1. Empty where neither tells it.
std::optional<Point2> directionThrough(const Polygon& region, const building::Access& access);

} // namespace farol::routing
