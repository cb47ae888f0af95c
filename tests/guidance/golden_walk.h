#pragma once
// What somebody hears who walks exactly as planned: the real tracker, scheduler, phrasebook and speech queue,
// a walker who knows the way, and a voice that takes the time that speaking takes.

#include "core/guidance/cue.h"
#include "tests/guidance/golden_buildings.h"

#include <QString>

#include <functional>

namespace farol::test {

/// The walk as text, in the language of the installed translators.
QString tellWalk(const GoldenBuilding& golden);
/// Every cue of the walk that is spoken, with its words.
void listenToWalk(const GoldenBuilding& golden,
                  const std::function<void(const guidance::Cue& cue, const QString& words)>& listener);

} // namespace farol::test
