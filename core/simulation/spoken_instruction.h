#pragma once
// What an obedient walker takes from a sentence alone: the English that Farol speaks, with turns said as left
// and right, back into an instruction. Nothing of the cue behind it is known here.

#include "core/simulation/walk_instruction.h"

#include <string>

namespace farol::simulation {

/// What is said in one go, also several sentences. Inform for what is no order.
WalkInstruction instructionFrom(const std::string& words);

} // namespace farol::simulation
