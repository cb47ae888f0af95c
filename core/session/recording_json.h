#pragma once
// The JSON of a recording's header and lines. Only the recorder and the loader use it.

#include "core/session/json_fields.h"
#include "core/session/recorder.h"

namespace farol::session {

Json headerJson(const RecordingHeader& header);
Result<RecordingHeader> headerFromJson(const Json& json);

/// {"percept": {...}, "picture": name} or {"command": "start"|..., ...}.
Json perceptLineJson(const Percept& percept, const std::string& picture);
Json commandJson(const Command& command);

struct RecordLine {
    RecordEntry entry;
    std::string picture; ///< empty: none was taken
};
Result<RecordLine> recordLineFromJson(const Json& json);

} // namespace farol::session
