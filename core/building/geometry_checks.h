#pragma once
// The rules of checkBuilding() that compare outlines with each other, and shafts and refs over levels.

#include "core/building/building.h"
#include "core/building/checks.h"

#include <vector>

namespace farol::building {

/// region-sliver, region-duplicate, region-overlap, region-inside.
void checkOutlines(const Building& building, std::vector<Finding>& findings);
/// crs-degrees-for-metres, region-ref-unique, shaft-misses-level, region-has-access.
void checkTables(const Building& building, std::vector<Finding>& findings);

/// Does the outline cross or touch itself? Fast also for outlines of many corners.
bool crossesItself(const Polygon& polygon);

} // namespace farol::building
