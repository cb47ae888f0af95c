#pragma once
// Two curators at one library: what both have made of it since they had the same, put together.

#include "core/recognition/landmark_library.h"

#include <optional>

namespace farol::ui {

/// `base` is what both began with. Empty where both changed the same template and not alike: that is for
/// people to decide.
std::optional<recognition::LandmarkLibrary> mergedLibraries(const recognition::LandmarkLibrary& base,
                                                            const recognition::LandmarkLibrary& mine,
                                                            const recognition::LandmarkLibrary& theirs);

} // namespace farol::ui
