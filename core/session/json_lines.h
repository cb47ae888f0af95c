#pragma once
// The lines of `farol-cli run`, `replay` and `locate` (design, section 5), one JSON object each, without the
// newline. Printed numbers are rounded to three decimals; recordings keep every digit.

#include "core/base/error.h"
#include "core/session/json_fields.h"
#include "core/session/percept.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace farol::session {

/// frame, detection..., fix, progress (when it changed), cue... for one step, in this order. `before`: the
/// progress of the step before, to tell whether it changed. The last lines are those of `step.cues`, one
/// each.
std::vector<std::string> linesOf(const NavigationStep& step, const guidance::Progress* before);
std::string warningLine(double time, std::uint64_t frame, const std::string& message);
/// A cue alone, for warnings that come from outside the chain.
std::string cueLine(const guidance::Cue& cue);
/// `cause`: the cue's id.
std::string utteranceLine(double time, std::uint64_t frame, std::uint64_t cause, const std::string& text);
/// A fix as in `locate`.
Json fixJson(const localisation::Fix& fix);
Json routeJson(const routing::Route& route);

/// One line of a `locate` log: exactly one detection. `unknownKind`: the word in the file that is no kind of
/// ours; it counts as Other. `frameGiven`: false where the log does not count frames.
struct LogDetection {
    Percept percept;
    std::string unknownKind;
    bool frameGiven = false;
};
struct LogStart {
    double time = 0.0;
    std::optional<RegionId> region;
};
struct LogDestination {
    double time = 0.0;
    std::string where;
};
struct LogMotion {
    double time = 0.0;
    recognition::Motion motion;
};
struct LogOther {
    double time = 0.0;
}; ///< frame, fix, cue... lines of `run`: kept, not acted on
using LogLine = std::variant<LogDetection, LogStart, LogDestination, LogMotion, LogOther>;

/// Corrupt with the reason for anything that is not such an object: NaN, a box that is no box, a missing t.
Result<LogLine> parseLogLine(const std::string& line);

/// Lossless forms for recordings.
Json perceptJson(const Percept& percept);
Result<Percept> perceptFromJson(const Json& json);

} // namespace farol::session
