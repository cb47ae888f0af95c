#pragma once
// Do two buildings say the same?

#include "core/building/building.h"

namespace farol::building {

/// Every value of every feature, in the order in which they stand; `revision`, which no user sees, aside.
bool sameContent(const BuildingData& a, const BuildingData& b);

} // namespace farol::building
