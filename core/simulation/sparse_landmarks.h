#pragma once
// Landmarks by rule for a map that has none, so that somebody can be guided in it before anyone has gone
// round with a camera: what the law and custom put into every building, and no more.

#include "core/building/building.h"

#include <memory>

namespace farol::simulation {

/// The same map with what it lacks of: an extinguisher for every 20 m of wall in corridors and halls, an exit
/// sign over each door to a stairwell, the number or name beside every other door of a room. A map that has
/// landmarks of a kind already gets none of that kind.
std::shared_ptr<const building::Building> withSparseLandmarks(const building::Building& building);

} // namespace farol::simulation
