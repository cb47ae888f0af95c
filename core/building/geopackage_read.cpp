#include "core/base/database_source.h"
#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/building/access_regions.h"
#include "core/building/database_map.h"
#include "core/building/feature_row.h"
#include "core/building/geopackage.h"
#include "core/building/layer_schema.h"
#include "core/building/sentence.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <functional>
#include <map>
#include <set>
#include <utility>

namespace farol::building {

namespace {

class Reader {
public:
    explicit Reader(std::string source) : m_source(std::move(source)), m_place(shownSource(m_source)) {}

    Result<LoadedBuilding> read();

private:
    using ReadRow = std::function<void(FeatureRow&)>;

    Result<void> readLayers();
    Result<void> readLayer(const LayerSpec& spec, const ReadRow& readRow);
    Result<void> checkFields(OGRLayer& layer, const LayerSpec& spec, const std::string& context);
    Result<void> checkIsMap();
    Result<void> checkCrs(OGRLayer& regions);
    Result<void> checkSchema();
    Result<void> readFarol();
    Result<void> readLevels();
    Result<void> readRegions();
    Result<void> readAccesses();
    Result<void> readLandmarks();
    Result<void> readWalls();
    bool firstUse(FeatureRow& row, std::set<std::string>& used);
    void readAccess(FeatureRow& row);
    void readLandmark(FeatureRow& row);
    template <class KindType>
    void readKind(FeatureRow& row, const std::optional<KindType>& kind, KindType& target, std::string& text);
    void fitTogether();
    void warnOfHalfAccesses();
    void warnOfUnknownKinds();

    std::string m_source;
    std::string m_place;
    DatasetPtr m_dataset;
    BuildingData m_data;
    std::map<std::string, double> m_regionLevels; ///< by id
    std::string m_schema;
    std::vector<std::string> m_warnings;
    std::map<std::string, std::vector<std::string>> m_unknownKinds; ///< kind -> ids
};

OGRLayer* layerOf(GDALDataset& dataset, const LayerSpec& spec) {
    return dataset.GetLayerByName(spec.name);
}

std::string listed(const std::vector<std::string>& ids) {
    std::string text;
    for (std::size_t i = 0; i < ids.size() && i < 5; ++i) text += (i == 0 ? "" : ", ") + ids[i];
    return ids.size() > 5 ? text + " and " + std::to_string(ids.size() - 5) + " more" : text;
}

Result<LoadedBuilding> Reader::read() {
    auto opened = openVector(m_source);
    if (!opened) {
        Error error = opened.error();
        error.context = m_place;
        return error;
    }
    m_dataset = std::move(*opened);
    bool shared = isDatabase(m_source);
    if (shared)
        if (auto held = holdMoment(*m_dataset, m_place); !held) return held.error();
    if (auto done = readLayers(); !done) return done.error();
    if (shared) {
        auto revision = mapRevision(*m_dataset, m_place);
        if (!revision) return revision.error();
        m_data.revision = *revision;
    }
    fitTogether();
    LoadedBuilding loaded;
    loaded.building = std::make_shared<const Building>(std::move(m_data));
    loaded.warnings = std::move(m_warnings);
    return loaded;
}

Result<void> Reader::readLayers() {
    using Step = Result<void> (Reader::*)();
    for (Step step :
         {&Reader::checkIsMap, &Reader::readFarol, &Reader::checkSchema, &Reader::readLevels,
          &Reader::readRegions, &Reader::readAccesses, &Reader::readLandmarks, &Reader::readWalls})
        if (auto done = (this->*step)(); !done) return done;
    return {};
}

Result<void> Reader::checkIsMap() {
    GdalMessages messages;
    OGRLayer* regions = layerOf(*m_dataset, regionsLayer());
    if (regions != nullptr) return checkCrs(*regions);
    bool library = m_dataset->GetLayerByName("templates") != nullptr;
    return Error{ErrorCode::UnsupportedFormat,
                 library ? english(Sentence::LibraryNotMap) : english(Sentence::NoFarolMap), m_place};
}

Result<void> Reader::checkCrs(OGRLayer& regions) {
    const OGRSpatialReference* reference = regions.GetSpatialRef();
    const char* name = reference == nullptr ? nullptr : reference->GetName();
    // GeoPackage's own placeholders for "no CRS".
    if (name == nullptr || std::string(name).rfind("Undefined", 0) == 0) return {};
    std::string context = english(Sentence::LayerOfFile, m_place, "regions");
    if (reference->IsGeographic() != 0)
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::MapInDegrees, name), context};
    if (std::abs(reference->GetLinearUnits() - 1.0) > 1e-9)
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::MapNotInMetres, name), context};
    char* wkt = nullptr;
    const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
    if (reference->exportToWkt(&wkt, options) == OGRERR_NONE && wkt != nullptr) m_data.crs = wkt;
    CPLFree(wkt);
    return {};
}

Result<void> Reader::checkFields(OGRLayer& layer, const LayerSpec& spec, const std::string& context) {
    OGRFeatureDefn& definition = *layer.GetLayerDefn();
    if (spec.key != nullptr && definition.GetFieldIndex(spec.key) < 0)
        return Error{ErrorCode::Corrupt, english(Sentence::FieldMissing, spec.key), context};
    if (spec.knows("level") && definition.GetFieldIndex("level") < 0)
        m_warnings.push_back(english(Sentence::InContext, context, Sentence::FieldLevelMissing));
    return {};
}

Result<void> Reader::readLayer(const LayerSpec& spec, const ReadRow& readRow) {
    GdalMessages messages;
    std::string context = m_place + ", layer " + spec.name;
    OGRLayer* layer = layerOf(*m_dataset, spec);
    if (layer == nullptr) {
        if (spec.name != std::string("walls"))
            m_warnings.push_back(
                english(Sentence::InContext, m_place, said(Sentence::LayerMissing, spec.name)));
        return {};
    }
    if (auto fields = checkFields(*layer, spec, context); !fields) return fields;
    layer->ResetReading();
    while (OGRFeatureUniquePtr feature{layer->GetNextFeature()}) {
        FeatureRow row(*feature, spec, context);
        if (!row.error()) readRow(row);
        if (row.error()) return *row.error();
    }
    if (messages.failed())
        return messages.error(ErrorCode::Corrupt, english(Sentence::NotReadToItsEnd), context);
    return {};
}

Result<void> Reader::readFarol() {
    return readLayer(farolLayer(), [&](FeatureRow& row) {
        std::string key = row.text("key");
        std::string value = row.text("value");
        if (key == "schema")
            m_schema = value;
        else if (key == "title")
            m_data.title = value;
        else if (key != "languages")
            m_data.properties[key] = value;
        std::string language;
        if (key != "languages") return;
        for (char c : value + ",") {
            if (c != ',' && c != ' ' && c != ';')
                language.push_back(c);
            else if (!language.empty())
                m_data.languages.push_back(std::exchange(language, {}));
        }
    });
}

Result<void> Reader::checkSchema() {
    if (m_schema.empty()) return {};
    int version = 0;
    auto [rest, failure] = std::from_chars(m_schema.data(), m_schema.data() + m_schema.size(), version);
    std::string context = english(Sentence::LayerOfFile, m_place, "farol");
    if (failure != std::errc() || rest != m_schema.data() + m_schema.size() || version < 1)
        return Error{ErrorCode::Corrupt, english(Sentence::SchemaNoVersion, m_schema), context};
    if (version > kSchemaVersion)
        return Error{ErrorCode::UnsupportedFormat,
                     english(Sentence::SchemaNewer, m_schema, static_cast<double>(kSchemaVersion)), context};
    return {};
}

/// Fails on the second feature with one key.
bool Reader::firstUse(FeatureRow& row, std::set<std::string>& used) {
    if (used.insert(row.name()).second) return true;
    row.fail(english(Sentence::IdTwice));
    return false;
}

template <class KindType>
void Reader::readKind(FeatureRow& row, const std::optional<KindType>& kind, KindType& target,
                      std::string& text) {
    target = kind.value_or(KindType::Other);
    if (kind) return;
    text = row.text("kind");
    m_unknownKinds[text].push_back(row.name());
}

Result<void> Reader::readLevels() {
    std::set<double> used;
    return readLayer(levelsLayer(), [&](FeatureRow& row) {
        Level level;
        level.ordinal = row.level();
        level.name = row.text("name");
        level.ref = row.text("ref");
        level.elevationM = row.number("elevation_m");
        level.heightM = row.number("height_m");
        level.extra = row.extra();
        if (!used.insert(level.ordinal).second) row.fail(english(Sentence::LevelListedTwice));
        m_data.levels.push_back(std::move(level));
    });
}

Result<void> Reader::readRegions() {
    std::set<std::string> used;
    auto done = readLayer(regionsLayer(), [&](FeatureRow& row) {
        if (!firstUse(row, used)) return;
        Region region;
        region.id = RegionId(row.name());
        region.level = row.level();
        region.name = row.text("name");
        region.ref = row.text("ref");
        readKind(row, regionKindFromName(row.text("kind")), region.kind, region.kindText);
        region.restricted = row.flag("restricted");
        region.polygon = row.polygon();
        region.extra = row.extra();
        m_regionLevels.emplace(region.id.value, region.level);
        m_data.regions.push_back(std::move(region));
    });
    if (done && m_data.regions.empty())
        return Error{ErrorCode::Corrupt, english(Sentence::MapNoRegions),
                     english(Sentence::LayerOfFile, m_place, "regions")};
    return done;
}

void Reader::readAccess(FeatureRow& row) {
    Access access;
    access.id = AccessId(row.name());
    readKind(row, accessKindFromName(row.text("kind")), access.kind, access.kindText);
    access.regionA = RegionId(row.text("region_a"));
    access.regionB = RegionId(row.text("region_b"));
    auto first = m_regionLevels.find(access.regionA.value);
    bool derived = !row.has("level") && first != m_regionLevels.end();
    access.level = derived ? first->second : row.level();
    access.shaft = ShaftId(row.text("shaft"));
    std::string oneWay = row.text("oneway");
    if (oneWay == "a_to_b")
        access.oneWay = OneWay::AToB;
    else if (oneWay == "b_to_a")
        access.oneWay = OneWay::BToA;
    else if (!oneWay.empty())
        row.fail(english(Sentence::OnewayUnknown, oneWay));
    access.doorType = row.text("door_type");
    access.automatic = row.flag("automatic");
    access.widthM = row.number("width_m");
    access.steps = row.whole("steps");
    access.closed = row.flag("closed");
    access.line = row.pointOrLine();
    access.extra = row.extra();
    m_data.accesses.push_back(std::move(access));
}

Result<void> Reader::readAccesses() {
    std::set<std::string> used;
    return readLayer(accessesLayer(), [&](FeatureRow& row) {
        if (firstUse(row, used)) readAccess(row);
    });
}

void Reader::readLandmark(FeatureRow& row) {
    Landmark landmark;
    landmark.id = LandmarkId(row.name());
    readKind(row, kindFromName(row.text("kind")), landmark.kind, landmark.kindText);
    landmark.templateId = TemplateId(row.text("template"));
    landmark.text = row.text("text");
    landmark.region = RegionId(row.text("region_id"));
    landmark.level = row.level();
    if (auto degrees = row.number("heading_deg")) landmark.heading = fromDegrees(*degrees);
    landmark.heightM = row.number("height_m");
    landmark.widthM = row.number("width_m");
    landmark.tallM = row.number("tall_m");
    landmark.position = row.point();
    landmark.extra = row.extra();
    m_data.landmarks.push_back(std::move(landmark));
}

Result<void> Reader::readLandmarks() {
    std::set<std::string> used;
    return readLayer(landmarksLayer(), [&](FeatureRow& row) {
        if (firstUse(row, used)) readLandmark(row);
    });
}

Result<void> Reader::readWalls() {
    return readLayer(wallsLayer(), [&](FeatureRow& row) {
        for (Polyline& line : row.lines())
            m_data.walls.push_back({row.level(), std::move(line), row.extra()});
    });
}

void Reader::fitTogether() {
    // The order of a file's features is chance (an edit in QGIS changes it): ids decide.
    auto byId = [](const auto& a, const auto& b) { return naturalLess(a.id.value, b.id.value); };
    std::stable_sort(m_data.regions.begin(), m_data.regions.end(), byId);
    std::stable_sort(m_data.accesses.begin(), m_data.accesses.end(), byId);
    std::stable_sort(m_data.landmarks.begin(), m_data.landmarks.end(), byId);
    deriveAccessRegions(m_data);
    warnOfHalfAccesses();
    warnOfUnknownKinds();
}

void Reader::warnOfHalfAccesses() {
    std::set<std::string> known;
    for (const Region& region : m_data.regions) known.insert(region.id.value);
    std::vector<std::string> ids;
    for (const Access& access : m_data.accesses) {
        bool both = known.count(access.regionA.value) != 0 && known.count(access.regionB.value) != 0;
        if (!both || access.regionA == access.regionB) ids.push_back(access.id.value);
    }
    if (!ids.empty())
        m_warnings.push_back(
            english(Sentence::InContext, said(Sentence::LayerOfFile, m_place, "accesses"),
                    said(Sentence::AccessesNotWalked, static_cast<double>(ids.size()), listed(ids))));
}

void Reader::warnOfUnknownKinds() {
    for (const auto& [kind, ids] : m_unknownKinds)
        m_warnings.push_back(english(Sentence::InContext, m_place,
                                     kind.empty() ? said(Sentence::NoKindAsOther, listed(ids))
                                                  : said(Sentence::KindAsOther, kind, listed(ids))));
}

} // namespace

Result<LoadedBuilding> loadBuilding(const std::string& source) {
    try {
        return Reader(source).read();
    } catch (const std::exception& failure) {
        return Error{ErrorCode::Internal, english(Sentence::ReadingFailed, failure.what()),
                     shownSource(source)};
    }
}

bool isBuildingFile(const std::string& source) {
    GdalMessages quiet;
    auto dataset = openVector(source);
    if (!dataset) return false;
    OGRLayer* regions = layerOf(**dataset, regionsLayer());
    OGRLayer* farol = layerOf(**dataset, farolLayer());
    return regions != nullptr && farol != nullptr &&
           regions->GetLayerDefn()->GetFieldIndex(regionsLayer().key) >= 0 &&
           farol->GetLayerDefn()->GetFieldIndex(farolLayer().key) >= 0;
}

} // namespace farol::building
