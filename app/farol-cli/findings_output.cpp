#include "app/farol-cli/findings_output.h"

#include <algorithm>
#include <string>
#include <utility>

namespace farol::cli {

using building::Finding;
using building::Severity;
using session::Json;

namespace {

std::string counted(std::size_t count, const std::string& word) {
    return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

} // namespace

Json findingsDocument(const std::vector<Finding>& findings) {
    Json json;
    json["findings"] = Json::array();
    for (const Finding& finding : findings) {
        Json entry;
        entry["severity"] = building::severityName(finding.severity);
        entry["rule"] = finding.rule;
        entry["message"] = finding.message;
        entry["layer"] = finding.layer;
        entry["ids"] = finding.ids;
        json["findings"].push_back(std::move(entry));
    }
    return json;
}

void printFindings(const std::vector<Finding>& findings, std::FILE* out) {
    for (const Finding& finding : findings) {
        std::string ids;
        // Long lists help nobody on a terminal; --json has them all.
        for (std::size_t i = 0; i < finding.ids.size() && i < 20; ++i)
            ids += (i == 0 ? "" : ", ") + finding.ids[i];
        if (finding.ids.size() > 20) ids += ", and " + std::to_string(finding.ids.size() - 20) + " more";
        std::string line = building::severityName(finding.severity) + ": " + finding.message + " [" +
                           finding.rule + (ids.empty() ? "" : ": " + ids) + "]";
        std::fprintf(out, "%s\n", line.c_str());
    }
    auto count = [&](Severity severity) {
        return static_cast<std::size_t>(
            std::count_if(findings.begin(), findings.end(),
                          [&](const Finding& finding) { return finding.severity == severity; }));
    };
    std::string sum = counted(count(Severity::Error), "error") + ", " +
                      counted(count(Severity::Warning), "warning") + ", " +
                      counted(count(Severity::Note), "note");
    std::fprintf(out, "%s\n", sum.c_str());
    std::fflush(out);
}

} // namespace farol::cli
