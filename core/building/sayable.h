#pragma once
// Which names of a map may be said aloud. Drawing programs leave "input name here" and numbers of their own
// behind; heard in a corridor such a name sends people looking for a sign that nobody ever put up.

#include "core/building/building.h"

#include <string>

namespace farol::building {

/// "unnamed", "TBD", "input name here", "Room", "???": what stands for a name that nobody has given.
bool isPlaceholderName(const std::string& name);
/// A name that people know the thing by: no placeholder, no identifier of a program.
bool isSayable(const std::string& name);
/// The region's name in the language, else its own, else its ref, when it can be said; else empty.
std::string sayableName(const Region& region, const std::string& language = {});

} // namespace farol::building
