#pragma once

#include "core/building/building.h"

#include <string>
#include <vector>

namespace farol::session {

/// What signs in the building may say: refs and names of regions and levels, words of landmarks. Each once,
/// in order of the alphabet.
std::vector<std::string> wordsOf(const building::Building& building);

} // namespace farol::session
