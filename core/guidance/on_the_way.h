#pragma once
// What somebody on the way counts and feels: doors from here on, and things just before a manoeuvre. Private
// to guidance.

#include "core/guidance/route_tracker.h"

namespace farol::guidance {

/// As which door or opening on its side the manoeuvre comes, counted from here; 0 when that cannot be told,
/// or when `sigmaM` more or less would make it another number.
int countedFrom(const building::Building& building, const routing::Manoeuvre& manoeuvre, Point2 here,
                double sigmaM);

/// The only thing of its kind on the straight way from here to the manoeuvre, shortly before it, with no
/// other door between. Only what hand or cane finds.
std::optional<Mark> markBefore(const building::Building& building, const routing::Manoeuvre& manoeuvre,
                               Point2 here, double sigmaM);

/// The direction of the route's path where it passes nearest to a position on that level.
std::optional<Radians> wayDirection(const routing::Route& route, Point2 here, double level);

} // namespace farol::guidance
