#include "core/building/import/osm_reader.h"

#include "core/base/ogr.h"
#include "core/building/sentence.h"

#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <atomic>
#include <exception>
#include <memory>

namespace farol::building {

namespace {

constexpr std::size_t kMaxFeatures = 500000;
constexpr std::uint64_t kMaxGeoJsonBytes = 64ULL << 20U;

// Every tag comes in one text, so that no key is lost or renamed. The list of areas is only for parts of
// relations: which closed way is an area is decided by our own rules, as the driver takes most closed indoor
// ways for lines.
constexpr const char* kConfiguration = R"(
closed_ways_are_polygons=indoor,room,area,building:part,amenity,shop
report_all_nodes=no
report_all_ways=no
attribute_name_laundering=no
[points]
osm_id=yes
attributes=
unsignificant=created_by,converted_by,source
all_tags=yes
[lines]
osm_id=yes
attributes=
all_tags=yes
[multipolygons]
osm_id=yes
attributes=
all_tags=yes
[multilinestrings]
osm_id=yes
attributes=
all_tags=yes
[other_relations]
osm_id=yes
attributes=
all_tags=yes
)";

/// The configuration as a file in memory, while it lives.
class ConfigurationFile {
public:
    ConfigurationFile() {
        static std::atomic<int> count{0};
        m_path = "/vsimem/farol_osm_" + std::to_string(count++) + ".ini";
        auto* bytes = reinterpret_cast<GByte*>(const_cast<char*>(kConfiguration)); // only read
        VSILFILE* file = VSIFileFromMemBuffer(m_path.c_str(), bytes,
                                              std::char_traits<char>::length(kConfiguration), FALSE);
        if (file != nullptr) VSIFCloseL(file);
    }
    ~ConfigurationFile() { VSIUnlink(m_path.c_str()); }
    ConfigurationFile(const ConfigurationFile&) = delete;
    ConfigurationFile& operator=(const ConfigurationFile&) = delete;
    const std::string& path() const { return m_path; }

private:
    std::string m_path;
};

/// `"key"=>"value","key"=>"value"` with backslashes before quotes.
Tags hstoreTags(const char* text) {
    Tags tags;
    std::string parts[2];
    int which = 0;
    bool quoted = false;
    for (const char* c = text; *c != '\0'; ++c) {
        if (quoted && *c == '\\' && c[1] != '\0')
            parts[which] += *++c;
        else if (*c == '"' && !quoted)
            quoted = true;
        else if (*c == '"') {
            quoted = false;
            if (which == 1) tags[parts[0]] = parts[1];
            if (which == 1) parts[0].clear(), parts[1].clear();
            which = 1 - which;
        } else if (quoted)
            parts[which] += *c;
    }
    return tags;
}

std::string textOf(const OGRFeature& feature, const char* field) {
    int index = feature.GetFieldIndex(field);
    return index < 0 || feature.IsFieldSetAndNotNull(index) == 0 ? std::string()
                                                                 : feature.GetFieldAsString(index);
}

TaggedFeature featureOf(const OGRFeature& source, const std::string& layer) {
    TaggedFeature feature;
    for (const char* field : {"all_tags", "other_tags"})
        for (auto& [key, value] : hstoreTags(textOf(source, field).c_str())) feature.tags[key] = value;
    std::string way = textOf(source, "osm_way_id"), id = textOf(source, "osm_id");
    if (layer == "points")
        feature.id = "node/" + id;
    else if (layer == "lines")
        feature.id = "way/" + id;
    else
        feature.id = way.empty() ? "relation/" + id : "way/" + way;
    return feature;
}

void ringsToPolygons(TaggedFeature& feature) {
    if (feature.is("area", "no")) return;
    for (std::size_t i = feature.lines.size(); i-- > 0;) {
        Polyline& line = feature.lines[i];
        if (line.size() < 4 || line.front() != line.back()) continue;
        line.pop_back();
        feature.polygons.push_back({std::move(line), {}});
        feature.lines.erase(feature.lines.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

Result<std::vector<TaggedFeature>> readLayers(GDALDataset& dataset, const std::string& context,
                                              std::vector<Finding>& findings) {
    GdalMessages messages;
    std::vector<TaggedFeature> features;
    Finding broken{Severity::Warning, "source-geometry", Sentence::ShapesUnusable, context, {}};
    dataset.ResetReading();
    for (;;) {
        OGRLayer* layer = nullptr;
        std::unique_ptr<OGRFeature> source(dataset.GetNextFeature(&layer, nullptr, nullptr, nullptr));
        if (source == nullptr) break;
        TaggedFeature feature = featureOf(*source, layer == nullptr ? "" : layer->GetName());
        const OGRGeometry* geometry = source->GetGeometryRef();
        if (feature.tags.empty()) continue;
        bool usable = geometry != nullptr && addShapes(*geometry, feature);
        ringsToPolygons(feature);
        if (usable)
            features.push_back(std::move(feature));
        else
            broken.ids.push_back(feature.id);
        if (features.size() > kMaxFeatures)
            return Error{ErrorCode::Corrupt, english(Sentence::OsmTooManyFeatures), context};
    }
    if (messages.failed()) return messages.error(ErrorCode::Corrupt, english(Sentence::OsmDamaged), context);
    if (!broken.ids.empty()) findings.push_back(std::move(broken));
    return features;
}

Result<std::vector<TaggedFeature>> readThroughOgr(const SourceMember& member,
                                                  std::vector<Finding>& findings) {
    GDALAllRegister();
    ConfigurationFile configuration;
    std::string option = "CONFIG_FILE=" + configuration.path();
    const char* const drivers[] = {"OSM", nullptr};
    const char* const options[] = {option.c_str(), "INTERLEAVED_READING=YES", "MAX_TMPFILE_SIZE=200",
                                   nullptr};
    GdalMessages messages;
    DatasetPtr dataset(
        GDALDataset::Open(member.ogrPath.c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers, options));
    if (dataset == nullptr)
        return messages.error(ErrorCode::Corrupt, english(Sentence::OsmNotRead), member.name);
    return readLayers(*dataset, member.name, findings);
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

} // namespace

int looksLikeOsm(const SourceMember& member, const std::string& head) {
    if (contains(head.substr(0, 64), "OSMHeader")) return 90;
    if (contains(head, "<osm ") || contains(head, "<osm>")) return 90;
    bool json = contains(member.name, "json") || head.find_first_not_of(" \t\r\n") == head.find('{');
    if (!json || !contains(head, "Feature")) return 0;
    bool ids = contains(head, "\"node/") || contains(head, "\"way/") || contains(head, "\"relation/");
    if (ids || contains(head, "overpass") || contains(head, "openstreetmap")) return 70;
    return contains(head, "\"indoor\"") && contains(head, "\"level\"") ? 40 : 0;
}

Result<std::vector<TaggedFeature>> readOsmFeatures(const SourceListing& source, const SourceMember& member,
                                                   std::vector<Finding>& findings) {
    std::string head = source.head(member);
    if (head.empty()) return Error{ErrorCode::Corrupt, english(Sentence::EmptyFile), member.name};
    std::size_t first = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first == std::string::npos || head[first] != '{') return readThroughOgr(member, findings);
    auto text = source.content(member, kMaxGeoJsonBytes);
    if (!text) return text.error();
    auto collection = readTaggedGeoJson(*text, member.name, findings);
    if (!collection) return collection.error();
    return std::move(collection->features);
}

} // namespace farol::building
