#pragma once
// Doors and stairs that a plan draws and does not list: most plans hold them as accesses only, while a camera
// sees them as it sees any landmark.

#include "core/building/building.h"

#include <vector>

namespace farol::building {

/// A landmark for each side of each door that can be passed, unless the region on that side has one of kind
/// Door within a metre of it. It stands in the middle of the access and faces into its region; where the line
/// of the access is a mere point, any way. Ids are made from the access's and are in no map. Metres, the
/// building's own frame.
std::vector<Landmark> unmarkedDoors(const Building& building);

/// The same for each end of each flight of stairs or escalator, unless the region of that end has a landmark
/// of kind Stairs within two metres of it. From above its steps show little: they are seen from any side.
std::vector<Landmark> unmarkedStairs(const Building& building);

} // namespace farol::building
