#include "app/farol-cli/commands.h"
#include "app/farol-cli/findings_output.h"
#include "app/farol-cli/output.h"
#include "core/base/database_source.h"
#include "core/building/geopackage.h"
#include "core/building/import/importer.h"
#include "core/building/info.h"

#include <memory>

namespace farol::cli {

namespace {

using session::Json;

struct ImportArguments {
    std::string source, target, format = "auto";
    building::ImportOptions options;
    bool json = false;
};

int importMap(ImportArguments arguments) {
    if (arguments.format != "auto") {
        arguments.options.format = building::mapFormatFromName(arguments.format);
        if (!arguments.options.format)
            return report({ErrorCode::InvalidArgument,
                           "\"" + arguments.format +
                               "\" is none of auto, shapefile, geopackage, geojson, imdf, osm, "
                               "indoorgml, hulop, wrld",
                           "--format"});
    }
    auto imported = building::importBuilding(arguments.source, arguments.options);
    if (!imported) return report(imported.error());
    if (auto saved = building::saveBuilding(*imported->building, arguments.target, imported->origin); !saved)
        return report(saved.error());
    building::BuildingInfo info = building::describe(*imported->building);
    if (arguments.json) {
        Json json;
        json["format"] = building::mapFormatName(imported->format);
        json["map"] = infoJson(info);
        json["findings"] = findingsDocument(imported->findings)["findings"];
        printLine(session::dumped(json));
        return kDone;
    }
    printFindings(imported->findings, stderr);
    printLine(shownSource(arguments.target) + ": " + std::to_string(info.regions) + " regions on " +
              std::to_string(info.levels.size()) + " levels, " + std::to_string(info.accesses) +
              " accesses (" + std::to_string(info.accessesJoined) + " join two regions), " +
              std::to_string(info.landmarks) + " landmarks, read as " +
              building::mapFormatName(imported->format));
    return kDone;
}

} // namespace

void addMapImport(CLI::App& map, int& exitCode) {
    CLI::App* command = map.add_subcommand("import", "Turns a map of another format into a building file");
    auto arguments = std::make_shared<ImportArguments>();
    command->add_option("SOURCE", arguments->source, "File, folder or zip")->required();
    command
        ->add_option("OUT", arguments->target,
                     "Building file (.gpkg) or database (PG:...); untouched when the import fails")
        ->required();
    command->add_option("--format", arguments->format,
                        "auto, shapefile, geopackage, geojson, imdf, osm, indoorgml, hulop or wrld");
    command->add_option("--profile", arguments->options.profile, "JSON file that names columns and codes");
    command->add_option(
        "--level-from", arguments->options.levelFrom,
        "Where the level stands when the format leaves it open: filename, storey, z, or a field's name");
    command->add_option("--language", arguments->options.language,
                        "Which of several names to take, such as en or pt");
    command->add_flag("--json", arguments->json, "One JSON document on standard output, findings in it");
    command->footer("Example:\n  farol-cli map import venue.zip building.gpkg --language en");
    command->callback([arguments, &exitCode] { exitCode = importMap(*arguments); });
}

} // namespace farol::cli
