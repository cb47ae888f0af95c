#pragma once
// Which regions an access joins where the map does not say.

#include "core/building/building.h"

#include <vector>

namespace farol::building {

/// Fills empty sides of accesses from geometry. A line: the regions 0.3 m to its left (A) and right (B). A
/// point: the two regions of its level that lie nearest, within 0.3 m, when no third one is as near. A side
/// that stays unsure stays empty, and so does the other side of stairs, lifts and escalators that name one.
void deriveAccessRegions(BuildingData& data);

} // namespace farol::building
