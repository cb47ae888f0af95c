#include "app/farol-cli/commands.h"
#include "app/farol-cli/findings_output.h"
#include "app/farol-cli/output.h"
#include "core/base/text.h"
#include "core/building/checks.h"
#include "core/building/geopackage.h"
#include "core/building/info.h"
#include "core/session/json_fields.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

namespace farol::cli {

namespace {

using building::BuildingInfo;
using building::Finding;
using building::Severity;
using session::Json;

int checkMap(const std::string& map, bool json) {
    auto loaded = building::loadBuilding(map);
    std::vector<Finding> findings;
    if (loaded) {
        warnAll(loaded->warnings);
        findings = building::checkBuilding(*loaded->building);
    } else {
        const Error& error = loaded.error();
        bool ofTheFile = error.code == ErrorCode::Corrupt || error.code == ErrorCode::UnsupportedFormat;
        if (!json || !ofTheFile) return report(error);
        report(error);
        Finding unreadable; // said by the reader, not by a check
        unreadable.severity = Severity::Error;
        unreadable.rule = "file-readable";
        unreadable.message = error.text();
        findings.push_back(std::move(unreadable));
    }
    if (json)
        printLine(session::dumped(findingsDocument(findings)));
    else
        printFindings(findings, stdout);
    bool failed = std::any_of(findings.begin(), findings.end(),
                              [](const Finding& finding) { return finding.severity == Severity::Error; });
    return failed ? kFailed : kDone;
}

std::string counted(std::size_t count, const std::string& word) {
    return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

} // namespace

Json infoJson(const BuildingInfo& info) {
    Json json;
    json["regions"] = info.regions;
    json["accesses"] = info.accesses;
    json["accesses_joined"] = info.accessesJoined;
    json["landmarks"] = info.landmarks;
    json["levels"] = Json::array();
    for (const building::LevelInfo& level : info.levels) {
        Json entry;
        entry["level"] = level.level;
        entry["ref"] = level.ref;
        entry["regions"] = level.regions;
        entry["accesses"] = level.accesses;
        entry["landmarks"] = level.landmarks;
        json["levels"].push_back(std::move(entry));
    }
    json["components"] = info.components;
    json["largest_component"] = info.largestComponent;
    json["kinds"] = Json::object();
    for (const auto& [kind, count] : info.landmarkKinds) json["kinds"][kind] = count;
    json["crs"] = info.crs;
    json["extent_m"] =
        Json::array({session::printedNumber(info.widthM), session::printedNumber(info.heightM)});
    json["unnamed_regions"] = info.unnamedRegions;
    return json;
}

namespace {

std::string metres(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

void printInfo(const BuildingInfo& info) {
    printLine(counted(info.regions, "region") + " (" + std::to_string(info.unnamedRegions) +
              " without a name), " + std::to_string(info.accesses) + " accesses (" +
              std::to_string(info.accessesJoined) + " join two regions), " +
              counted(info.landmarks, "landmark"));
    for (const building::LevelInfo& level : info.levels)
        printLine(
            "  level " + formatNumber(level.level) +
            (level.ref.empty() || level.ref == formatNumber(level.level) ? "" : " (" + level.ref + ")") +
            ": " + counted(level.regions, "region") + ", " + std::to_string(level.accesses) + " accesses, " +
            counted(level.landmarks, "landmark"));
    printLine(info.components == 1 ? "all regions are connected"
                                   : counted(info.components, "connected part") + ", the largest of " +
                                         counted(info.largestComponent, "region"));
    for (const auto& [kind, count] : info.landmarkKinds)
        printLine("  " + kind + ": " + std::to_string(count));
    printLine(metres(info.widthM) + " m x " + metres(info.heightM) + " m, CRS " +
              (info.crs.empty() ? "local metres" : info.crs));
}

int mapInfo(const std::string& map, bool json) {
    auto loaded = building::loadBuilding(map);
    if (!loaded) return report(loaded.error());
    warnAll(loaded->warnings);
    BuildingInfo info = building::describe(*loaded->building);
    if (json)
        printLine(session::dumped(infoJson(info)));
    else
        printInfo(info);
    return kDone;
}

struct MapArguments {
    std::string map;
    bool json = false;
};

void addMapArguments(CLI::App& command, const std::shared_ptr<MapArguments>& arguments) {
    command.add_option("MAP", arguments->map, "Building file (.gpkg) or OGR connection string (PG:...)")
        ->required();
    command.add_flag("--json", arguments->json, "One JSON document on standard output");
}

} // namespace

void addMapCommands(CLI::App& app, int& exitCode) {
    CLI::App* map = app.add_subcommand("map", "Imports, checks and describes building files");
    map->require_subcommand(1);

    CLI::App* check =
        map->add_subcommand("check", "Says what is wrong with a map; exit code 1 when there are errors");
    auto checkArguments = std::make_shared<MapArguments>();
    addMapArguments(*check, checkArguments);
    check->footer("Example:\n  farol-cli map check building.gpkg");
    check->callback(
        [checkArguments, &exitCode] { exitCode = checkMap(checkArguments->map, checkArguments->json); });

    addMapImport(*map, exitCode);
    addMapAmbiguity(*map, exitCode);
    CLI::App* info = map->add_subcommand("info", "Counts what is in a map");
    auto infoArguments = std::make_shared<MapArguments>();
    addMapArguments(*info, infoArguments);
    info->footer("Example:\n  farol-cli map info building.gpkg --json");
    info->callback(
        [infoArguments, &exitCode] { exitCode = mapInfo(infoArguments->map, infoArguments->json); });
    map->footer("Example:\n  farol-cli map info building.gpkg");
}

} // namespace farol::cli
