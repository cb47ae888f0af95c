#pragma once
// "Follow the wall on your right and go through the second door": how a door is told from its neighbours in a
// small room, where several lie ahead of who comes in. It is what blind people do there: trail a wall.

#include "core/building/building.h"
#include "core/routing/door_count.h"

#include <cstddef>
#include <optional>

namespace farol::routing {

/// For somebody who has just come into the region through `entry`: which wall to follow to `access`, the one
/// on the left or the one on the right, and as which door along it that comes. Empty where "ahead" or a side
/// says it already, where an opening would have to be passed (there the wall ends), and for rooms that are
/// too large to walk round. Metres on the map's plane; `entry` is a door, `access` a door or an opening of
/// the region.
std::optional<DoorCount> countAlongWalls(const building::Building& building, std::size_t region,
                                         const building::Access& entry, const building::Access& access);

/// The same for somebody on the way along that wall, the one on their left or on their right.
struct WallSpot {
    int number = 0;   ///< doors up to the access, which counts
    Radians along;    ///< the direction of the wall there, in the sense in which it is followed
    double restM = 0; ///< along the wall
};

/// Empty where the spot is not beside a wall, or when `sigmaM` more or less would make it another number.
std::optional<WallSpot> wallSpot(const building::Building& building, std::size_t region,
                                 const building::Access& access, bool left, Point2 here, double sigmaM);

} // namespace farol::routing
