#pragma once
// Findings about a map, for people and as JSON; and what `map info` and `map import` say of one.

#include "core/building/checks.h"
#include "core/building/info.h"
#include "core/session/json_fields.h"

#include <cstdio>
#include <vector>

namespace farol::cli {

/// {"findings": [...]}
session::Json findingsDocument(const std::vector<building::Finding>& findings);
/// A line each, and their number at the end.
void printFindings(const std::vector<building::Finding>& findings, std::FILE* out);
session::Json infoJson(const building::BuildingInfo& info);

} // namespace farol::cli
