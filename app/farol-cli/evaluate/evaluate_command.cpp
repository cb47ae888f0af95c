#include "app/farol-cli/commands.h"
#include "app/farol-cli/evaluate/evaluation.h"
#include "app/farol-cli/output.h"
#include "core/base/text.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace farol::cli {

namespace {

std::string defaultData() {
    const char* given = std::getenv("FAROL_DATA");
    return given != nullptr && *given != '\0' ? given : "../shared/data";
}

std::string shown(const EvaluationJson& cell) {
    if (cell.is_null()) return "-";
    if (cell.is_string()) return cell.get<std::string>();
    if (cell.is_number()) return formatNumber(cell.get<double>());
    return cell.dump(-1, ' ', false, EvaluationJson::error_handler_t::replace);
}

void print(const EvaluationTable& table) {
    printLine(table.title);
    std::vector<std::vector<std::string>> lines{table.columns};
    for (const auto& row : table.rows) {
        lines.emplace_back();
        for (const EvaluationJson& cell : row) lines.back().push_back(shown(cell));
    }
    std::vector<std::size_t> widths;
    for (const auto& line : lines) {
        widths.resize(std::max(widths.size(), line.size()));
        for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    }
    for (const auto& line : lines) {
        std::string text = " ";
        for (std::size_t i = 0; i < line.size(); ++i)
            text +=
                " " + line[i] + std::string(i + 1 < line.size() ? widths[i] - line[i].size() + 1 : 0, ' ');
        printLine(text);
    }
    printLine("");
}

EvaluationJson jsonOf(const EvaluationTable& table) {
    EvaluationJson json;
    json["title"] = table.title;
    json["rows"] = EvaluationJson::array();
    for (const auto& row : table.rows) {
        EvaluationJson one;
        for (std::size_t i = 0; i < std::min(row.size(), table.columns.size()); ++i)
            one[table.columns[i]] = row[i];
        json["rows"].push_back(std::move(one));
    }
    return json;
}

void printJson(const std::string& what, const std::string& data, const EvaluationReport& found) {
    EvaluationJson json;
    json["what"] = what;
    json["data"] = data;
    json["tables"] = EvaluationJson::array();
    for (const EvaluationTable& table : found.tables) json["tables"].push_back(jsonOf(table));
    json["notes"] = found.notes;
    printLine(json.dump(-1, ' ', false, EvaluationJson::error_handler_t::replace));
}

int evaluate(const std::string& what, const std::string& data, bool asJson) {
    const auto& all = evaluations();
    auto wanted = std::find_if(all.begin(), all.end(), [&](const Evaluation& e) { return what == e.name; });
    if (wanted == all.end()) {
        std::string names;
        for (const Evaluation& e : all) names += (names.empty() ? "" : ", ") + std::string(e.name);
        return report(
            {ErrorCode::InvalidArgument, "\"" + what + "\" is not measured; there are " + names, "WHAT"});
    }
    auto found = wanted->run(data);
    if (!found) return report(found.error());
    if (asJson) {
        printJson(what, data, *found);
        return kDone;
    }
    for (const EvaluationTable& table : found->tables) print(table);
    for (const std::string& note : found->notes) printLine(note);
    return kDone;
}

} // namespace

void addEvaluateCommand(CLI::App& app, int& exitCode) {
    struct Arguments {
        std::string what, data = defaultData();
        bool json = false;
    };
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("evaluate", "Measure the engine on real data from disk");
    std::string list = "What there is:\n";
    for (const Evaluation& e : evaluations()) list += "  " + std::string(e.name) + ": " + e.help + "\n";
    command->footer(list + "Example:\n  farol-cli evaluate text --data ../shared/data --json");
    command->add_option("WHAT", arguments->what, "What to measure")->required();
    command->add_option("--data", arguments->data,
                        "Folder of real maps and photographs (default: FAROL_DATA)");
    command->add_flag("--json", arguments->json, "One JSON document");
    command->callback(
        [arguments, &exitCode] { exitCode = evaluate(arguments->what, arguments->data, arguments->json); });
}

} // namespace farol::cli
