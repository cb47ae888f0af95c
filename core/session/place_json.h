#pragma once
// What a detection of a place says of other places that look alike: one form in lines and in recordings.

#include "core/recognition/detection.h"
#include "core/session/json_fields.h"

namespace farol::session {

/// "strength" and "look_alikes", [{"template", "strength"}, …]; nothing of a detection that has neither.
/// `number` writes numbers: rounded or with every digit.
void addLookAlikes(Json& json, const recognition::Detection& detection, Json (*number)(double));
void readLookAlikes(JsonFields& fields, recognition::Detection& detection);

} // namespace farol::session
