#pragma once
// Directions for people: clock hours (paper 4.3, repaired: field.md section 7) and turn words.

#include "core/base/angle.h"

namespace farol::guidance {

/// The clock hour of a direction relative to the way one faces: 12 ahead, 3 right, 6 behind, 9 left.
/// delta counter-clockwise positive; h = ((-delta) mod 360)/30, rounded, 0 becomes 12.
int clockHour(Radians delta);

enum class TurnWord { Straight, SlightLeft, Left, SharpLeft, Back, SharpRight, Right, SlightRight };

/// Bins at 22.5, 60, 120 and 150 degrees (field.md 2.1).
TurnWord turnWord(Radians delta);

/// A turn on the spot as it can be obeyed: people miss by some 15 degrees (field.md 4.4), so what is nearly
/// half a turn is one, along the walls.
Radians turnOnTheSpot(Radians delta);

} // namespace farol::guidance
