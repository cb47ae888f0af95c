#include "core/building/import/table_reader.h"

#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/import/height_levels.h"
#include "core/building/sentence.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace farol::building {

namespace {

constexpr std::size_t kMostFeatures = 1000000;

std::string textOf(const OGRFeature& row, int at) {
    return at >= 0 && row.IsFieldSetAndNotNull(at) ? row.GetFieldAsString(at) : std::string();
}

std::string partId(const std::string& id, std::size_t part) {
    return part == 0 ? id : id + "/" + std::to_string(part + 1);
}

bool isWhole(const std::string& text) {
    return !text.empty() && text.size() < 10 &&
           std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

Polyline pointsOf(const OGRLineString& line) {
    Polyline points;
    for (int i = 0; i < line.getNumPoints(); ++i) points.push_back({line.getX(i), line.getY(i)});
    return points;
}

/// A door or window drawn as a thin area: the line along its longest edge, through its middle.
Polyline middleLine(const Polygon& polygon) {
    const Ring& ring = polygon.outer;
    Point2 along;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Point2 edge = ring[(i + 1) % ring.size()] - ring[i];
        if (length(edge) > length(along)) along = edge;
    }
    if (!(length(along) > 0.0)) return ring.empty() ? Polyline{} : Polyline{ring.front()};
    along = along * (1.0 / length(along));
    Point2 middle = centroid(polygon);
    double low = 0.0, high = 0.0;
    for (Point2 p : ring) {
        low = std::min(low, dot(along, p - middle));
        high = std::max(high, dot(along, p - middle));
    }
    return {middle + along * low, middle + along * high};
}

std::string wktOf(const OGRSpatialReference& reference) {
    char* text = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
    std::string wkt;
    if (reference.exportToWkt(&text, options) == OGRERR_NONE && text != nullptr) wkt = text;
    CPLFree(text);
    return wkt;
}

/// Beyond this, in the units of any CRS, transforming may take for ever.
bool liesOnEarth(const OGRGeometry& geometry) {
    constexpr double kFurthestUnits = 1e9;
    OGREnvelope box;
    geometry.getEnvelope(&box);
    return box.MinX >= -kFurthestUnits && box.MinY >= -kFurthestUnits && box.MaxX <= kFurthestUnits &&
           box.MaxY <= kFurthestUnits;
}

/// The lowest height of a shape, when it has heights.
std::optional<double> heightOf(const OGRGeometry* geometry) {
    if (geometry == nullptr || geometry->Is3D() == FALSE || geometry->IsEmpty() != FALSE) return std::nullopt;
    OGREnvelope3D box;
    geometry->getEnvelope(&box);
    return std::isfinite(box.MinZ) ? std::optional(box.MinZ) : std::nullopt;
}

bool namesReference(const OGRSpatialReference* reference) {
    const char* name = reference == nullptr ? nullptr : reference->GetName();
    return name != nullptr && std::string(name).rfind("Undefined", 0) != 0;
}

/// Texts of a .dbf that names no encoding (no .cpg, language byte unset or "ANSI") come as they are: UTF-8
/// where they are valid as such, else taken as Latin-1 later. GDAL alone would read UTF-8 as Latin-1.
class PlainEncoding {
public:
    explicit PlainEncoding(const std::string& path) {
        std::string base = path.substr(0, path.rfind('.'));
        VSIStatBufL state;
        for (const char* ending : {".cpg", ".CPG"})
            if (VSIStatL((base + ending).c_str(), &state) == 0) return;
        VSILFILE* table = VSIFOpenL((base + ".dbf").c_str(), "rb");
        if (table == nullptr) return;
        unsigned char header[30] = {};
        m_set = VSIFReadL(header, 1, sizeof header, table) == sizeof header &&
                (header[29] == 0 || header[29] == 0x57);
        VSIFCloseL(table);
        if (m_set) CPLSetThreadLocalConfigOption("SHAPE_ENCODING", "");
    }
    ~PlainEncoding() {
        if (m_set) CPLSetThreadLocalConfigOption("SHAPE_ENCODING", nullptr);
    }
    PlainEncoding(const PlainEncoding&) = delete;
    PlainEncoding& operator=(const PlainEncoding&) = delete;

private:
    bool m_set = false;
};

} // namespace

TableReader::TableReader(TableWords words, ImportOptions options)
    : m_words(std::move(words)), m_options(std::move(options)) {}
TableReader::~TableReader() = default;

Result<void> TableReader::read(const SourceMember& member) {
    PlainEncoding encoding(member.ogrPath);
    auto dataset = openVector(member.ogrPath);
    if (!dataset) {
        Error error = dataset.error();
        error.context = member.name;
        return error;
    }
    int layers = (*dataset)->GetLayerCount();
    for (int i = 0; i < layers && i < 1000; ++i)
        if (OGRLayer* layer = (*dataset)->GetLayer(i))
            if (auto done = readLayer(*layer, member, layers == 1); !done) return done;
    return {};
}

TableReader::Layer TableReader::described(const std::string& name, const SourceMember& member) {
    Layer layer;
    layer.name = name;
    layer.context = member.name.find(name) == std::string::npos
                        ? said(Sentence::LayerOfFile, member.name, name).english()
                        : member.name;
    layer.role = TableWords::roleOfLayer(name);
    layer.level = m_words.levelOfName(name);
    if (!layer.level) layer.level = m_words.levelOfName(member.name.substr(member.name.rfind('/') + 1));
    if (const TableWords::LayerRule* rule = m_words.ruleFor(name)) {
        if (rule->role != TableRole::Unknown) layer.role = rule->role;
        if (rule->level) layer.level = rule->level;
        layer.kind = rule->kind;
    }
    return layer;
}

Result<void> TableReader::readLayer(OGRLayer& source, const SourceMember& member, bool onlyOne) {
    std::string file = member.name.substr(member.name.rfind('/') + 1);
    Layer layer = described(onlyOne ? file.substr(0, file.rfind('.')) : source.GetName(), member);
    GdalMessages messages;
    bool table = source.GetGeomType() == wkbNone;
    if (table && layer.role != TableRole::Level) return {};
    if (layer.role == TableRole::Ignore || (layer.role == TableRole::Level && !table)) {
        m_findings.add(Severity::Note, "layer-not-used", Sentence::LayersNotUsed, layer.name, layer.context);
        return {};
    }
    bool transform = !table && takeReference(source, layer);
    source.ResetReading();
    while (OGRFeatureUniquePtr row{source.GetNextFeature()}) {
        if (++m_features > kMostFeatures)
            return Error{ErrorCode::UnsupportedFormat, english(Sentence::TooManyFeatures), layer.context};
        ++layer.features;
        if (table)
            readLevelRow(*row);
        else if (transform && row->GetGeometryRef() != nullptr &&
                 (!liesOnEarth(*row->GetGeometryRef()) ||
                  row->GetGeometryRef()->transformTo(m_reference.get()) != OGRERR_NONE))
            m_findings.add(Severity::Warning, "feature-geometry", Sentence::FeaturesOtherCrs, layer.name,
                           idOf(*row, layer));
        else
            readFeature(*row, layer);
    }
    // What a driver complains of while reading is a damaged file; half of a building is worse than none.
    if (messages.failed())
        return messages.error(ErrorCode::Corrupt, english(Sentence::NotReadToItsEnd), layer.context);
    if (layer.features == 0) m_empty.insert(layer.context);
    return {};
}

/// True when the layer's coordinates must be brought to those of the layers before.
bool TableReader::takeReference(OGRLayer& source, const Layer& layer) {
    OGRSpatialReference* own = source.GetSpatialRef();
    if (!namesReference(own)) {
        m_withoutReference.insert(layer.context);
        return false;
    }
    own->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    if (m_reference == nullptr) {
        m_reference.reset(own->Clone());
        m_map.data.crs = wktOf(*own);
        return false;
    }
    return own->IsSame(m_reference.get()) == FALSE;
}

std::string TableReader::text(Row row, const std::string& meaning) const {
    for (const std::string& column : m_words.columns(meaning)) {
        int at = row.GetFieldIndex(column.c_str());
        std::string value = textOf(row, at);
        while (!value.empty() && value.back() == ' ') value.pop_back();
        if (!value.empty()) return value;
    }
    return {};
}

std::optional<double> TableReader::number(Row row, const std::string& meaning) const {
    return m_words.level(text(row, meaning)); // also reads plain numbers
}

bool TableReader::flag(Row row, const std::string& meaning) const {
    std::string value = lowerCase(text(row, meaning));
    return !value.empty() && value != "0" && value != "false" && value != "no" && value != "n" &&
           value != "null";
}

std::string TableReader::idOf(Row row, const Layer& layer) const {
    std::string id = text(row, "id");
    // Numbers begin anew in every file; names that stand for rooms everywhere do not.
    if (id.empty()) return layer.name + ":" + std::to_string(row.GetFID());
    bool rowNumber = isWhole(id) && text(row, "region") != id;
    return rowNumber ? layer.name + ":" + id : id;
}

double TableReader::levelOf(Row row, const Layer& layer) {
    std::optional<double> level;
    const std::string& from = m_options.levelFrom;
    if (from == "filename") {
        level = layer.level;
    } else if (from == "z") {
        // by height alone
    } else if (!from.empty()) {
        level = m_words.level(textOf(row, row.GetFieldIndex(from.c_str())));
    } else {
        level = number(row, "level");
        if (!level) level = layer.level;
    }
    m_height.reset();
    if (level) return *level;
    m_height = heightOf(row.GetGeometryRef());
    if (m_height) return 0.0; // until all heights are known
    m_findings.add(Severity::Note, "level-assumed", Sentence::LayersNoLevel, layer.name, layer.context);
    return 0.0;
}

void TableReader::rememberHeight(std::map<std::size_t, double>& heights, std::size_t at) const {
    if (m_height) heights.emplace(at, *m_height);
}

/// Where no column and no name tells the level, the floors are told apart by the heights of the shapes.
Result<void> TableReader::levelsFromHeights() {
    std::vector<double> heights;
    for (const auto* each : {&m_heights.regions, &m_heights.accesses})
        for (const auto& [at, height] : *each) heights.push_back(height);
    HeightLevels levels(std::move(heights));
    if (levels.empty() && m_options.levelFrom == "z")
        return Error{ErrorCode::InvalidArgument, english(Sentence::NoHeights), ""};
    if (levels.empty()) return {};
    auto apply = [&](auto& items, const std::map<std::size_t, double>& known) {
        for (const auto& [at, height] : known) items[at].level = levels.ordinalOf(height);
    };
    apply(m_map.data.regions, m_heights.regions);
    apply(m_map.data.accesses, m_heights.accesses);
    apply(m_map.data.landmarks, m_heights.landmarks);
    apply(m_map.data.walls, m_heights.walls);
    for (std::size_t i = 0; i < levels.floors().size(); ++i) {
        Level level;
        level.ordinal = levels.ordinalAt(i);
        level.elevationM = levels.floors()[i];
        level.ref = formatNumber(level.ordinal);
        m_map.data.levels.push_back(std::move(level));
    }
    m_findings.add(Severity::Note, "level-by-height", Sentence::LevelsByHeight, "levels",
                   formatNumber(levels.ground()));
    return {};
}

Attributes TableReader::attributes(Row row) const {
    Attributes attributes;
    for (int i = 0; i < row.GetFieldCount(); ++i) {
        if (!row.IsFieldSetAndNotNull(i)) continue;
        const OGRFieldDefn& field = *row.GetFieldDefnRef(i);
        OGRFieldType type = field.GetType();
        if (type == OFTBinary) continue;
        if (type == OFTInteger || type == OFTInteger64)
            attributes[field.GetNameRef()] = static_cast<std::int64_t>(row.GetFieldAsInteger64(i));
        else if (type == OFTReal)
            attributes[field.GetNameRef()] = row.GetFieldAsDouble(i);
        else
            attributes[field.GetNameRef()] = std::string(row.GetFieldAsString(i));
    }
    return attributes;
}

void TableReader::readLevelRow(Row row) {
    auto ordinal = number(row, "level");
    if (!ordinal) return;
    Level level;
    level.ordinal = *ordinal;
    level.name = text(row, "name");
    level.ref = text(row, "ref");
    m_map.data.levels.push_back(std::move(level));
}

void TableReader::readShapes(const OGRGeometry& geometry, Shapes& shapes) const {
    OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
    if (OGR_GT_IsNonLinear(type)) {
        std::unique_ptr<OGRGeometry> linear(geometry.getLinearGeometry());
        if (linear != nullptr && OGR_GT_IsNonLinear(wkbFlatten(linear->getGeometryType())) == FALSE)
            readShapes(*linear, shapes);
    } else if (type == wkbPolygon) {
        Polygon polygon;
        for (const OGRLinearRing* ring : *geometry.toPolygon()) {
            Ring points = pointsOf(*ring);
            if (points.size() > 1 && points.front() == points.back()) points.pop_back();
            if (ring == geometry.toPolygon()->getExteriorRing())
                polygon.outer = std::move(points);
            else
                polygon.holes.push_back(std::move(points));
        }
        shapes.polygons.push_back(std::move(polygon));
    } else if (type == wkbLineString) {
        shapes.lines.push_back(pointsOf(*geometry.toLineString()));
    } else if (type == wkbPoint) {
        shapes.points.push_back({geometry.toPoint()->getX(), geometry.toPoint()->getY()});
    } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
        for (const OGRGeometry* part : *geometry.toGeometryCollection()) readShapes(*part, shapes);
    }
}

TableRole TableReader::roleFor(const TableKind& kind, const Layer& layer, const Shapes& shapes) {
    if (kind.role == TableRole::Ignore || kind.role == TableRole::Wall) return kind.role;
    bool areas = !shapes.polygons.empty(), lines = !shapes.lines.empty();
    // A door as an area is still a door; a staircase is a room as an area and an access as a line.
    if (kind.role == TableRole::Access && layer.role != TableRole::Region) return TableRole::Access;
    if (kind.role == TableRole::Access && layer.role == TableRole::Region && kind.access != AccessKind::Door)
        return TableRole::Access;
    if (kind.role == TableRole::Access && areas && kind.access == AccessKind::Door &&
        layer.role == TableRole::Region)
        return TableRole::Access;
    if (kind.role == TableRole::Landmark && !areas && !lines) return TableRole::Landmark;
    if (layer.role == TableRole::Region)
        return areas ? TableRole::Region : lines ? TableRole::Wall : TableRole::Landmark;
    if (layer.role != TableRole::Unknown) return layer.role;
    if (areas) return TableRole::Region;
    if (!lines) return TableRole::Landmark;
    if (kind.role == TableRole::Unknown && kind.access != AccessKind::Door)
        return TableRole::Access; // stairs as a line
    m_findings.add(Severity::Warning, "layer-role", Sentence::LinesAsWalls, layer.name, layer.context);
    return TableRole::Wall;
}

void TableReader::readFeature(Row row, Layer& layer) {
    const OGRGeometry* geometry = row.GetGeometryRef();
    Shapes shapes;
    if (geometry != nullptr && geometry->IsEmpty() == FALSE) readShapes(*geometry, shapes);
    if (shapes.polygons.empty() && shapes.lines.empty() && shapes.points.empty()) {
        m_findings.add(Severity::Warning, "feature-geometry", Sentence::FeaturesNoGeometry, layer.name,
                       idOf(row, layer));
        return;
    }
    std::string word = text(row, "kind");
    TableKind kind = m_words.kind(word.empty() ? layer.kind : word);
    if (word.empty() && layer.kind.empty() && lowerCase(layer.name).find("window") != std::string::npos)
        kind.access = AccessKind::Window;
    if (word.empty() && layer.kind.empty() && lowerCase(layer.name).find("janela") != std::string::npos)
        kind.access = AccessKind::Window;
    TableRole role = roleFor(kind, layer, shapes);
    bool known = kind.role != TableRole::Unknown || kind.access != AccessKind::Door;
    if (!word.empty() && !known && (role == TableRole::Region || role == TableRole::Access))
        tellUnknownKind(word, layer.name, idOf(row, layer));
    if (role == TableRole::Region)
        addRegions(row, layer, kind, std::move(shapes));
    else if (role == TableRole::Access)
        addAccesses(row, layer, kind, shapes);
    else if (role == TableRole::Landmark)
        addLandmarks(row, layer, kind, shapes);
    else if (role == TableRole::Wall)
        addWalls(row, layer, shapes);
}

void TableReader::tellUnknownKind(const std::string& word, const std::string& layer, const std::string& id) {
    m_findings.add(Severity::Note, "code-unknown", said(Sentence::CodeUnknown, word.substr(0, 60)), layer,
                   id);
}

void TableReader::addRegions(Row row, const Layer& layer, const TableKind& kind, Shapes shapes) {
    Region region;
    std::string id = idOf(row, layer);
    region.level = levelOf(row, layer);
    region.name = text(row, "name");
    region.ref = text(row, "ref");
    region.kind =
        kind.role == TableRole::Access || kind.role == TableRole::Landmark ? RegionKind::Room : kind.region;
    region.restricted = kind.restricted || flag(row, "restricted");
    region.extra = attributes(row);
    if (shapes.polygons.size() > 1)
        m_findings.add(Severity::Warning, "region-split", Sentence::RegionsSplit, "regions", id);
    for (std::size_t part = 0; part < shapes.polygons.size(); ++part) {
        region.id = RegionId(partId(id, part));
        region.polygon = std::move(shapes.polygons[part]);
        rememberHeight(m_heights.regions, m_map.data.regions.size());
        m_map.data.regions.push_back(region);
    }
}

/// In the direction from A to B or against it, by many words; up or down for what climbs.
void TableReader::readDirection(Row row, Access& access, RawMap::LevelChange& change) {
    static const std::set<std::string> forth{"a_to_b", "forward", "1", "yes", "true", "sim", "ft"};
    static const std::set<std::string> back{"b_to_a", "backward", "-1", "reverse", "tf"};
    static const std::set<std::string> both{"",     "0",     "no",         "nao",       "false",
                                            "both", "ambos", "undirected", "reversible"};
    std::string way = lowerCase(text(row, "oneway"));
    change.toLevel = number(row, "level_to");
    change.up = climbDirection(way);
    access.oneWay = forth.count(way) != 0 ? OneWay::AToB : back.count(way) != 0 ? OneWay::BToA : OneWay::No;
    if (access.oneWay != OneWay::No || change.up || both.count(way) != 0) return;
    m_findings.add(Severity::Warning, "access-direction-unknown", Sentence::DirectionUnknown, "accesses",
                   access.id.value);
}

void TableReader::addAccesses(Row row, const Layer& layer, const TableKind& kind, const Shapes& shapes) {
    Access access;
    std::string id = idOf(row, layer);
    access.id = AccessId(id);
    access.kind = kind.access;
    access.level = levelOf(row, layer);
    access.regionA = RegionId(text(row, "region_a"));
    access.regionB = RegionId(text(row, "region_b"));
    std::string known = text(row, "region");
    if (access.regionA.empty() && access.regionB.empty() && known != id) access.regionA = RegionId(known);
    access.shaft = ShaftId(text(row, "shaft"));
    RawMap::LevelChange change;
    readDirection(row, access, change);
    access.doorType = text(row, "door_type");
    access.automatic = flag(row, "automatic");
    access.closed = flag(row, "closed");
    if (auto width = number(row, "width_m"); width && *width > 0.0 && *width < 100.0) access.widthM = *width;
    if (auto steps = number(row, "steps"); steps && *steps >= 0.0 && *steps < 10000.0)
        access.steps = static_cast<int>(*steps);
    access.extra = attributes(row);
    std::vector<Polyline> lines = shapes.lines;
    for (const Polygon& polygon : shapes.polygons) lines.push_back(middleLine(polygon));
    for (Point2 point : shapes.points) lines.push_back({point});
    for (std::size_t part = 0; part < lines.size(); ++part) {
        access.id = AccessId(partId(id, part));
        access.line = lines[part];
        rememberHeight(m_heights.accesses, m_map.data.accesses.size());
        if (change.toLevel || change.up) {
            change.access = access.id;
            m_map.levelChanges.push_back(change);
        }
        m_map.data.accesses.push_back(access);
    }
}

void TableReader::addLandmarks(Row row, const Layer& layer, const TableKind& kind, const Shapes& shapes) {
    Landmark landmark;
    std::string id = idOf(row, layer);
    landmark.kind = kind.landmark;
    if (kind.landmark == Kind::Other) landmark.kindText = text(row, "kind");
    landmark.level = levelOf(row, layer);
    landmark.region = RegionId(text(row, "region"));
    // A point named by its room alone is not the room.
    if (id == landmark.region.value) id = layer.name + ":" + std::to_string(row.GetFID());
    landmark.text = text(row, "text");
    landmark.templateId = TemplateId(text(row, "template"));
    if (auto heading = number(row, "heading_deg")) landmark.heading = fromDegrees(*heading);
    landmark.extra = attributes(row);
    std::vector<Point2> points = shapes.points;
    for (const Polygon& polygon : shapes.polygons) points.push_back(pointInside(polygon));
    for (const Polyline& line : shapes.lines)
        if (!line.empty()) points.push_back(line[line.size() / 2]);
    for (std::size_t part = 0; part < points.size(); ++part) {
        landmark.id = LandmarkId(partId(id, part));
        landmark.position = points[part];
        rememberHeight(m_heights.landmarks, m_map.data.landmarks.size());
        m_map.data.landmarks.push_back(landmark);
    }
}

void TableReader::addWalls(Row row, const Layer& layer, const Shapes& shapes) {
    double level = levelOf(row, layer);
    for (const Polyline& line : shapes.lines) {
        rememberHeight(m_heights.walls, m_map.data.walls.size());
        m_map.data.walls.push_back({level, line, attributes(row)});
    }
    for (const Polygon& polygon : shapes.polygons) {
        rememberHeight(m_heights.walls, m_map.data.walls.size());
        Polyline line = polygon.outer;
        if (!line.empty()) line.push_back(line.front());
        m_map.data.walls.push_back({level, std::move(line), attributes(row)});
    }
}

/// Room numbers may begin anew on every floor: then a room is its number and its floor.
void TableReader::resolveReferences() {
    std::map<std::string, std::set<double>> levels;
    for (const Region& region : m_map.data.regions) levels[region.id.value].insert(region.level);
    auto onLevel = [&](RegionId& id, double level) {
        auto found = levels.find(id.value);
        if (found != levels.end() && found->second.size() > 1) id.value += "@" + formatNumber(level);
    };
    for (Region& region : m_map.data.regions) onLevel(region.id, region.level);
    for (Access& access : m_map.data.accesses) {
        onLevel(access.regionA, access.level);
        onLevel(access.regionB, access.level);
    }
    std::set<std::string> known;
    for (const Region& region : m_map.data.regions) known.insert(region.id.value);
    for (Landmark& landmark : m_map.data.landmarks) {
        onLevel(landmark.region, landmark.level);
        if (landmark.region.empty() || known.count(landmark.region.value) != 0) continue;
        m_findings.add(Severity::Warning, "landmark-region-exists", Sentence::PointsRegionMissing,
                       "landmarks", landmark.id.value);
        landmark.region = RegionId();
    }
}

Result<RawMap> TableReader::finish(const std::string& source) {
    const BuildingData& data = m_map.data;
    std::string empty;
    for (const std::string& layer : m_empty) empty += (empty.empty() ? "" : ", ") + layer;
    if (data.regions.empty()) {
        Message nothing = Sentence::HoldsNoRooms;
        if (!data.accesses.empty())
            nothing = said(Sentence::HoldsDoorsAlone, data.accesses.front().id.value);
        else if (!data.walls.empty())
            nothing = Sentence::HoldsLinesAlone;
        else if (!empty.empty())
            nothing = said(Sentence::HoldsNoFeatures, empty);
        return Error{ErrorCode::Corrupt, nothing.english(), source};
    }
    if (!empty.empty())
        m_findings.add({Severity::Warning, "layer-empty", said(Sentence::LayersEmpty, empty), "", {}});
    if (m_reference != nullptr && !m_withoutReference.empty())
        for (const std::string& layer : m_withoutReference)
            m_findings.add(Severity::Warning, "crs-missing", Sentence::LayersNoCrs, layer, layer);
    if (auto done = levelsFromHeights(); !done) return Error{done.error().code, done.error().message, source};
    resolveReferences();
    m_map.findings = m_findings.take();
    return std::move(m_map);
}

} // namespace farol::building
