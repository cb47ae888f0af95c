#pragma once
// What `farol-cli evaluate WHAT` measures. One file for each WHAT; the table of all of them is in
// evaluations.cpp. An evaluation reads data from disk, never writes, and answers with tables.

#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace farol::cli {

using EvaluationJson = nlohmann::ordered_json;

/// Rows of cells under named columns. A cell is a string, a number or null (shown as a dash).
struct EvaluationTable {
    std::string title;
    std::vector<std::string> columns;
    std::vector<std::vector<EvaluationJson>> rows;
};

struct EvaluationReport {
    std::vector<EvaluationTable> tables;
    std::vector<std::string> notes; ///< what was missing or has to be known to read the tables
};

struct Evaluation {
    const char* name;
    const char* help;
    std::function<Result<EvaluationReport>(const std::filesystem::path& data)> run;
};

/// In the order in which the help lists them.
const std::vector<Evaluation>& evaluations();

Result<EvaluationReport> evaluateDoors(const std::filesystem::path& data);
Result<EvaluationReport> evaluateGuidance(const std::filesystem::path& data);
Result<EvaluationReport> evaluateLocalisation(const std::filesystem::path& data);
Result<EvaluationReport> evaluatePlaces(const std::filesystem::path& data);
Result<EvaluationReport> evaluateRecognition(const std::filesystem::path& data);
Result<EvaluationReport> evaluateScenes(const std::filesystem::path& data);
Result<EvaluationReport> evaluateSigns(const std::filesystem::path& data);
Result<EvaluationReport> evaluateStairs(const std::filesystem::path& data);
Result<EvaluationReport> evaluateText(const std::filesystem::path& data);

} // namespace farol::cli
