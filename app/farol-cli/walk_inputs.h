#pragma once
// What `locate`, `run` and `replay` open before they begin. Failures are reported on stderr; `exitCode` is
// then set.

#include "core/building/building.h"
#include "core/building/info.h"
#include "core/recognition/landmark_library.h"

#include <memory>
#include <optional>
#include <string>

namespace farol::cli {

/// Null when it cannot be read.
std::shared_ptr<const building::Building> openMap(const std::string& path, int& exitCode);
/// WHERE of an option; a place that does not exist is wrong usage (2), with near spellings. Empty text: no
/// place.
bool findPlace(const building::Building& building, const std::string& option, const std::string& where,
               std::optional<building::Location>& place, int& exitCode);
/// The library of `path`; where that is empty or missing, the one in the map's own file; null (and true) when
/// there is none. False for a library that is there and cannot be used.
bool openLibrary(const std::string& path, const std::string& map,
                 std::shared_ptr<const recognition::LandmarkLibrary>& library, int& exitCode);
/// Words in that language; a language that is not there is told, and English used.
void chooseLanguage(const std::string& language);

} // namespace farol::cli
