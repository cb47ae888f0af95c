#include "app/farol-cli/commands.h"
#include "app/farol-cli/output.h"
#include "core/building/ambiguity.h"
#include "core/building/geopackage.h"
#include "core/session/json_fields.h"

#include <memory>

namespace farol::cli {

namespace {

using building::Ambiguity;
using session::Json;

struct AmbiguityArguments {
    std::string map;
    bool json = false;
};

Json idsJson(const std::vector<RegionId>& ids) {
    Json list = Json::array();
    for (const RegionId& id : ids) list.push_back(id.value);
    return list;
}

Json ambiguityJson(const building::Building& map, const Ambiguity& ambiguity) {
    Json json;
    json["regions"] = map.regions().size();
    json["confused_pairs"] = ambiguity.confusedPairs;
    json["groups"] = Json::array();
    for (const auto& group : ambiguity.groups) json["groups"].push_back(idsJson(group));
    json["without_landmarks"] = idsJson(ambiguity.withoutLandmarks);
    json["suggestions"] = Json::array();
    for (const Ambiguity::Suggestion& suggestion : ambiguity.suggestions) {
        Json entry;
        entry["region"] = suggestion.region.value;
        entry["name"] = building::spokenName(*map.region(suggestion.region));
        entry["pairs_told_apart"] = suggestion.pairs;
        json["suggestions"].push_back(std::move(entry));
    }
    return json;
}

std::string listed(const building::Building& map, const std::vector<RegionId>& ids) {
    std::string text;
    for (std::size_t i = 0; i < ids.size() && i < 20; ++i)
        text += (i == 0 ? "" : ", ") + building::spokenName(*map.region(ids[i])) + " (" + ids[i].value + ")";
    return ids.size() > 20 ? text + " and " + std::to_string(ids.size() - 20) + " more" : text;
}

void print(const building::Building& map, const Ambiguity& ambiguity) {
    printLine(std::to_string(ambiguity.groups.size()) +
              " groups of regions that the last four landmarks cannot tell apart (" +
              std::to_string(ambiguity.confusedPairs) + " pairs)");
    for (const auto& group : ambiguity.groups) printLine("  " + listed(map, group));
    printLine(std::to_string(ambiguity.withoutLandmarks.size()) + " of " +
              std::to_string(map.regions().size()) + " regions have no landmark" +
              (ambiguity.withoutLandmarks.empty() ? "" : ": " + listed(map, ambiguity.withoutLandmarks)));
    for (const Ambiguity::Suggestion& suggestion : ambiguity.suggestions)
        printLine("one more landmark in " + listed(map, {suggestion.region}) + " tells " +
                  std::to_string(suggestion.pairs) + " pairs apart");
}

int mapAmbiguity(const AmbiguityArguments& arguments) {
    auto loaded = building::loadBuilding(arguments.map);
    if (!loaded) return report(loaded.error());
    warnAll(loaded->warnings);
    Ambiguity ambiguity = building::findAmbiguity(*loaded->building);
    if (arguments.json)
        printLine(session::dumped(ambiguityJson(*loaded->building, ambiguity)));
    else
        print(*loaded->building, ambiguity);
    return kDone;
}

} // namespace

void addMapAmbiguity(CLI::App& map, int& exitCode) {
    CLI::App* command = map.add_subcommand(
        "ambiguity", "Says which regions the landmarks cannot tell apart, and where one more helps");
    auto arguments = std::make_shared<AmbiguityArguments>();
    command->add_option("MAP", arguments->map, "Building file (.gpkg) or OGR connection string (PG:...)")
        ->required();
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->footer("Example:\n  farol-cli map ambiguity building.gpkg");
    command->callback([arguments, &exitCode] { exitCode = mapAmbiguity(*arguments); });
}

} // namespace farol::cli
