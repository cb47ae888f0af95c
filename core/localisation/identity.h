#pragma once
// When two things are identical in the paper's sense (4.2; field.md ambiguity 8).

#include "core/building/building.h"
#include "core/recognition/detection.h"

#include <string>

namespace farol::localisation {

/// What identity is decided by: made once of a landmark or a detection, so that texts are folded only once.
struct Identity {
    Kind kind = Kind::Other;
    TemplateId templateId;
    std::string text; ///< folded for matching; empty when there is none
};

Identity identityOf(const recognition::Detection& detection);
Identity identityOf(const building::Landmark& landmark);

/// By trained template when both have one; a place by template only; by the text when one of them was read
/// from the picture or is known by its words (kinds text and sign); else by kind. `textTolerance` is the edit
/// distance at which texts are still the same; it never lets a text match that is not longer than it.
bool sameThing(const Identity& a, const Identity& b, int textTolerance = 0);

} // namespace farol::localisation
