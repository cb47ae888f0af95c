#pragma once
// Openings one does not pass in the middle: where they may be crossed, and how they lie between their
// regions.

#include "core/building/building.h"
#include "core/routing/open_zone.h"

#include <optional>

namespace farol::routing {

/// Of an opening drawn as a straight line, or as a point with a width on a border, and at least 1.2 m wide:
/// the line that may be crossed, 0.4 m from either end. Empty for all others: they are passed in their
/// middle.
Polyline walkableWidth(const building::Access& access, const Polygon& polygon);

/// The same between its two regions; empty where it does not lie along both of them.
std::optional<WideOpening> wideOpening(const building::Access& access, const Polygon& polygonA,
                                       const WalkingSpace& spaceA, const WalkingSpace& spaceB);

} // namespace farol::routing
