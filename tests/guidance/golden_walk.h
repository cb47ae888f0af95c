#pragma once
// What somebody hears who walks exactly as planned: the real tracker, scheduler, phrasebook and speech queue,
// a walker who knows the way, and a voice that takes the time that speaking takes.

#include "tests/guidance/golden_buildings.h"

#include <QString>

namespace farol::test {

/// The walk as text, in the language of the installed translators.
QString tellWalk(const GoldenBuilding& golden);

} // namespace farol::test
