#pragma once
// Changes to a building as values: what stood there, and what stands there now. An editor keeps them for undo
// and redo; nothing here knows of windows.

#include "core/base/error.h"
#include "core/building/building.h"

#include <cstddef>
#include <optional>
#include <string>
#include <variant>

namespace farol::building {

using Feature = std::variant<Region, Access, Landmark>;

/// One feature put in, changed or taken out at `index` of its list. Exactly what reversed() needs.
struct Edit {
    std::size_t index = 0;
    std::optional<Feature> before; ///< empty: it was not there
    std::optional<Feature> after;  ///< empty: it is gone
};

Edit reversed(Edit edit);
void apply(BuildingData& data, const Edit& edit);

/// The feature behind the others of its list. Conflict where its id is taken.
Result<Edit> insertion(const Building& building, Feature feature);
/// InvalidArgument where the change makes no sense: a position or size that is no number, two equal sides,
/// an id that is taken, a region without an outline.
Result<Edit> change(const Building& building, std::size_t index, Feature after);
Edit removalOfAccess(const Building& building, std::size_t index);
Edit removalOfLandmark(const Building& building, std::size_t index);

/// A landmark with an id of its own, in the region that holds the spot (none where no region does).
Landmark newLandmark(const Building& building, Kind kind, Point2 at, double level);
/// A door 0.9 m wide along the nearest wall within half a metre, else a point, joining the two regions that
/// lie nearest (within 1 m); sides that stay unsure are empty.
Access newAccess(const Building& building, AccessKind kind, Point2 at, double level);
/// The same landmark elsewhere on its level: its region follows.
Landmark moved(const Building& building, Landmark landmark, Point2 to);
/// The same access elsewhere on its level: its sides follow, except those of stairs, lifts and escalators.
Access moved(const Building& building, Access access, Point2 by);

} // namespace farol::building
