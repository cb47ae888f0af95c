#pragma once
// Any indoor map in: importers behind one interface, chosen by content. An importer only reads: it answers a
// RawMap in the source's own coordinates and with what the source says. What all formats need alike (a metric
// CRS, repaired polygons, the two sides of each access, shafts, open boundaries, names) is done once, in
// finishImport().

#include "core/base/error.h"
#include "core/building/building.h"
#include "core/building/checks.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace farol::building {

/// What lies at the path a user named: one file, a folder, or the members of a zip. Made once, with limits on
/// the number of members, their sizes and the packing ratio, so that a bomb or "../" names are refused before
/// any reading.
struct SourceMember {
    std::string name;    ///< relative, with '/': "Addenbrookes/unit.geojson"
    std::string ogrPath; ///< what OGR and VSI open: a plain path or "/vsizip/..."
    std::uint64_t size = 0;
};

struct SourceListing {
    std::string path; ///< as the user named it
    bool folder = false, zip = false;
    std::vector<SourceMember> members; ///< natural order; one for a plain file

    /// The first `bytes` of a member, for recognising it; empty when it cannot be read.
    std::string head(const SourceMember& member, std::size_t bytes = 4096) const;
    /// The whole member, refused above `limit`.
    Result<std::string> content(const SourceMember& member, std::uint64_t limit = 256ULL << 20U) const;
    const SourceMember* find(const std::string& fileName) const; ///< by last path part, case-insensitive
};

Result<SourceListing> listSource(const std::string& path);

enum class MapFormat { Shapefile, GeoPackage, GeoJson, Imdf, Osm, IndoorGml, Hulop, Wrld };

std::string
mapFormatName(MapFormat format); ///< the word of --format: shapefile, geopackage, geojson, imdf, osm, ...
std::optional<MapFormat> mapFormatFromName(const std::string& name);

struct ImportOptions {
    std::optional<MapFormat> format; ///< empty: by content
    std::string profile; ///< path of a JSON profile with other column names and code lists; may be empty
    std::string
        levelFrom; ///< where a format leaves it open: "filename", a field's name, "storey", "z"; may be empty
    std::string language; ///< which of several names to take: "en", "pt", ...; empty: the first
};

/// How the coordinates of a RawMap are to be read.
enum class RawCoordinates { Metric, Geographic, Unknown };

struct RawMap {
    /// In source coordinates (x east or longitude, y north or latitude). Level ordinals are final. Access
    /// sides and landmark regions may be empty; `extra` keeps every source attribute that has no field of its
    /// own.
    BuildingData data; ///< `crs`: WKT of the source when it names one
    RawCoordinates coordinates = RawCoordinates::Unknown;
    /// Regions that join across levels by the source's own word (IMDF relationship, IndoorGML transition, a
    /// steps way): pairs of region ids with the access kind.
    struct VerticalLink {
        RegionId from, to;
        AccessKind kind = AccessKind::Stairs;
        OneWay oneWay = OneWay::No;
        ShaftId shaft;
        std::optional<int> steps;
    };
    std::vector<VerticalLink> verticalLinks;
    /// What a source says of an access that leads to another level beside the regions it names.
    struct LevelChange {
        AccessId access;
        std::optional<double> toLevel;
        std::optional<bool> up; ///< one way, upwards or downwards
    };
    std::vector<LevelChange> levelChanges;
    /// Formats with an explicit graph (IndoorGML, HULOP): accesses already name both regions; do not derive
    /// others.
    bool explicitGraph = false;
    /// Thin-wall formats (OSM): regions that share a boundary without a wall or door between them are openly
    /// joined.
    bool openBoundaries = false;
    std::vector<Finding> findings; ///< what was odd in the source, with its feature ids
};

class Importer {
public:
    virtual ~Importer() = default;
    virtual MapFormat format() const = 0;
    /// Cheap: names and first bytes only. 0: no; higher: more specific (IMDF before plain GeoJSON).
    virtual int recognises(const SourceListing& source) const = 0;
    virtual Result<RawMap> read(const SourceListing& source, const ImportOptions& options) const = 0;
};

std::unique_ptr<Importer> makeTableImporter(MapFormat format); ///< Shapefile, GeoPackage, GeoJson, by profile
std::unique_ptr<Importer> makeImdfImporter();
std::unique_ptr<Importer> makeOsmImporter();
std::unique_ptr<Importer> makeIndoorGmlImporter();
std::unique_ptr<Importer> makeHulopImporter();
std::unique_ptr<Importer> makeWrldImporter();

struct ImportedBuilding {
    std::shared_ptr<const Building> building;
    MapFormat format = MapFormat::GeoJson;
    std::vector<Finding> findings; ///< of the source, of the mending, and of checkBuilding() at the end
    /// The source, when it is a building file already: taken as it stands, and to be saved with what else is
    /// in it (see saveBuilding).
    std::string origin{};
};

/// Metric CRS (UTM of the place; never 3857), repaired polygons (GEOS through OGR), accesses joined to the
/// two regions they touch, open boundaries, shafts across levels, names for the unnamed. Whatever is mended
/// is told.
Result<ImportedBuilding> finishImport(RawMap raw, MapFormat format);

/// listSource, the importer that recognises it best, read, finish. A building file is read as it stands
/// unless that fails (degrees, say) or the options ask for more.
Result<ImportedBuilding> importBuilding(const std::string& source, const ImportOptions& options = {});

} // namespace farol::building
