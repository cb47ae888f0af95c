// Where am I, measured: voting as printed, voting repaired, the filter without and with the picture's motion.

#include "app/farol-cli/evaluate/data_set.h"
#include "app/farol-cli/evaluate/evaluation.h"
#include "app/farol-cli/evaluate/walk_scores.h"

#include <cmath>

namespace farol::cli {

namespace {

struct Contender {
    const char* title;
    const char* localiser;
    bool motion;
};

constexpr Contender kContenders[] = {{"voting, literal", "voting-literal", false},
                                     {"voting, repaired", "voting", false},
                                     {"filter without motion", "bayes", false},
                                     {"filter with motion", "bayes", true}};

double rounded(double value) {
    return std::round(value * 1000.0) / 1000.0;
}

} // namespace

Result<EvaluationReport> evaluateLocalisation(const std::filesystem::path& data) {
    auto folder = dataSet(data, "walks");
    if (!folder) return folder.error();
    auto walks = readWalks(*folder);
    if (!walks) return walks.error();
    EvaluationReport report;
    EvaluationTable table{
        "localisation, shares of time over " + std::to_string(walks->size()) + " walks", {"figure"}, {}};
    Progress progress("walks", walks->size() * std::size(kContenders));
    for (const Contender& contender : kContenders) {
        WalkScores scores;
        for (const LoggedWalk& walk : *walks) {
            auto moments = follow(walk, contender.localiser, contender.motion);
            if (!moments) return moments.error();
            scores.add(walk, *moments, true);
            progress.step();
        }
        table.columns.emplace_back(contender.title);
        std::size_t row = 0;
        for (const auto& [name, value] : scores.figures()) {
            if (table.rows.size() <= row) table.rows.push_back({name});
            table.rows[row++].emplace_back(rounded(value));
        }
    }
    report.tables.push_back(std::move(table));
    report.notes = {
        "A fix every second of the truth, after all lines up to that moment, as by locate --every 1.",
        "Next turn: of the route planned from the true position; right: the same clock hour or one "
        "beside it. Given: confidence .8 or more and a route known."};
    return report;
}

} // namespace farol::cli
