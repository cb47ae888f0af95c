#pragma once
// One cue of each kind and shape that the engine can send, with names as maps have them.

#include "core/guidance/cue.h"

#include <QString>

#include <vector>

namespace farol::test {

struct NamedCue {
    QString label;
    guidance::Cue cue;
    bool styled = false; ///< its sentence depends on the direction style
};

std::vector<NamedCue> representativeCues();

} // namespace farol::test
