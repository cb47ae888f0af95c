#include "core/base/database_source.h"
#include "core/building/geopackage.h"
#include "core/building/import/importer.h"

#include <array>
#include <exception>
#include <utility>

namespace farol::building {

namespace {

constexpr std::array<std::pair<MapFormat, const char*>, 8> kFormats{{{MapFormat::Shapefile, "shapefile"},
                                                                     {MapFormat::GeoPackage, "geopackage"},
                                                                     {MapFormat::GeoJson, "geojson"},
                                                                     {MapFormat::Imdf, "imdf"},
                                                                     {MapFormat::Osm, "osm"},
                                                                     {MapFormat::IndoorGml, "indoorgml"},
                                                                     {MapFormat::Hulop, "hulop"},
                                                                     {MapFormat::Wrld, "wrld"}}};

/// Every reader there is, the more specific first where two recognise a source equally well.
std::vector<std::unique_ptr<Importer>> allImporters() {
    std::vector<std::unique_ptr<Importer>> importers;
    importers.push_back(makeWrldImporter());
    importers.push_back(makeImdfImporter());
    importers.push_back(makeHulopImporter());
    importers.push_back(makeOsmImporter());
    importers.push_back(makeIndoorGmlImporter());
    for (MapFormat format : {MapFormat::Shapefile, MapFormat::GeoPackage, MapFormat::GeoJson})
        importers.push_back(makeTableImporter(format));
    return importers;
}

std::string formatWords(const std::vector<std::unique_ptr<Importer>>& importers) {
    std::string words;
    for (const auto& importer : importers)
        words += (words.empty() ? "" : ", ") + mapFormatName(importer->format());
    return words;
}

std::string membersOf(const SourceListing& source) {
    std::string names;
    for (std::size_t i = 0; i < source.members.size() && i < 5; ++i)
        names += (i == 0 ? "" : ", ") + source.members[i].name;
    if (source.members.size() <= 5) return names;
    return english(Sentence::MoreOf, names, static_cast<double>(source.members.size() - 5));
}

Result<std::unique_ptr<Importer>> chosenImporter(const SourceListing& source, const ImportOptions& options) {
    auto importers = allImporters();
    std::string words = formatWords(importers);
    std::unique_ptr<Importer> best;
    int score = 0;
    for (auto& importer : importers) {
        bool wanted = options.format && importer->format() == *options.format;
        int sure = options.format ? (wanted ? 1 : 0) : importer->recognises(source);
        if (sure <= score) continue;
        score = sure;
        best = std::move(importer);
    }
    if (best != nullptr) return best;
    return Error{ErrorCode::UnsupportedFormat, english(Sentence::UnknownKindOfMap, membersOf(source), words),
                 source.path};
}

/// A building file is no foreign map: nothing in it is renamed, joined anew or mended.
std::optional<ImportedBuilding> asItStands(const SourceListing& source, const ImportOptions& options) {
    bool plain = !source.folder && !source.zip && options.profile.empty() && options.levelFrom.empty() &&
                 (!options.format || *options.format == MapFormat::GeoPackage);
    bool database = plain && source.members.size() == 1 &&
                    source.head(source.members.front(), 16).rfind("SQLite format 3", 0) == 0;
    if (!database || !isBuildingFile(source.path)) return std::nullopt;
    auto loaded = loadBuilding(source.path);
    if (!loaded) return std::nullopt;
    ImportedBuilding imported;
    imported.building = loaded->building;
    imported.format = MapFormat::GeoPackage;
    imported.origin = source.path;
    imported.findings = checkBuilding(*imported.building);
    return imported;
}

/// A map that others share, to be kept in a file or another database.
Result<ImportedBuilding> fromDatabase(const std::string& source) {
    auto loaded = loadBuilding(source);
    if (!loaded) return loaded.error();
    BuildingData data = loaded->building->data();
    data.revision.clear(); // of the source, which says nothing of where it goes
    ImportedBuilding imported;
    imported.building = std::make_shared<const Building>(std::move(data));
    imported.format = MapFormat::GeoPackage;
    imported.findings = checkBuilding(*imported.building);
    return imported;
}

} // namespace

std::string mapFormatName(MapFormat format) {
    for (const auto& [value, name] : kFormats)
        if (value == format) return name;
    return "unknown";
}

std::optional<MapFormat> mapFormatFromName(const std::string& name) {
    for (const auto& [value, word] : kFormats)
        if (name == word) return value;
    return std::nullopt;
}

Result<ImportedBuilding> importBuilding(const std::string& source, const ImportOptions& options) {
    try {
        if (isDatabase(source)) return fromDatabase(source);
        auto listing = listSource(source);
        if (!listing) return listing.error();
        if (auto own = asItStands(*listing, options)) return std::move(*own);
        auto importer = chosenImporter(*listing, options);
        if (!importer) return importer.error();
        auto raw = (*importer)->read(*listing, options);
        if (!raw) return raw.error();
        auto finished = finishImport(std::move(*raw), (*importer)->format());
        if (finished) return finished;
        Error error = finished.error();
        error.context = source + (error.context.empty() ? "" : ", " + error.context);
        return error;
    } catch (const std::exception& failure) {
        return Error{ErrorCode::Corrupt, english(Sentence::NotImported, failure.what()), source};
    }
}

} // namespace farol::building
