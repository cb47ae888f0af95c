#include "core/base/base_sayings.h"
#include "core/base/file.h"
#include "core/base/log.h"
#include "core/base/ogr.h"
#include "core/base/text.h"
#include "core/recognition/feature_blobs.h"
#include "core/recognition/landmark_library.h"
#include "core/recognition/sayings.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace farol::recognition {

namespace {

constexpr const char* kTemplates = "templates";
constexpr const char* kViews = "views";
constexpr const char* kProperties = "farol";
constexpr const char* kSchemaKey = "library_schema";
constexpr int kSchema = 1;

std::string text(const OGRFeature& feature, const char* field) {
    int at = feature.GetFieldIndex(field);
    return at < 0 || feature.IsFieldSetAndNotNull(at) == 0 ? std::string()
                                                           : std::string(feature.GetFieldAsString(at));
}

std::optional<double> number(const OGRFeature& feature, const char* field) {
    int at = feature.GetFieldIndex(field);
    if (at < 0 || feature.IsFieldSetAndNotNull(at) == 0) return std::nullopt;
    double value = feature.GetFieldAsDouble(at);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string blob(OGRFeature& feature, const char* field) {
    int at = feature.GetFieldIndex(field);
    if (at < 0 || feature.IsFieldSetAndNotNull(at) == 0) return {};
    if (feature.GetFieldDefnRef(at)->GetType() != OFTBinary) return {};
    int bytes = 0;
    GByte* data = feature.GetFieldAsBinary(at, &bytes);
    return data == nullptr || bytes <= 0
               ? std::string()
               : std::string(reinterpret_cast<char*>(data), static_cast<std::size_t>(bytes));
}

std::string outlineText(const Quad& outline) {
    std::string out;
    for (const ImagePoint& p : outline)
        out += (out.empty() ? "" : ",") + formatNumber(p.x) + "," + formatNumber(p.y);
    return out;
}

std::optional<Quad> outlineFrom(const std::string& words) {
    std::array<double, 8> values{};
    const char* at = words.data();
    const char* end = at + words.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
        auto [next, failed] = std::from_chars(at, end, values[i]);
        if (failed != std::errc() || !std::isfinite(values[i]) || std::abs(values[i]) > 1e6)
            return std::nullopt;
        at = next;
        if (i + 1 < values.size() && (at == end || *at++ != ',')) return std::nullopt;
    }
    if (at != end) return std::nullopt;
    Quad outline;
    for (std::size_t i = 0; i < 4; ++i) outline[i] = {values[2 * i], values[2 * i + 1]};
    return outline;
}

std::string parametersText(const ExtractorOptions& options) {
    return "version=" + std::to_string(options.version) +
           " long_side=" + std::to_string(options.workingLongSide) +
           " keypoints=" + std::to_string(options.maxKeypoints) +
           " contrast=" + formatNumber(options.contrastThreshold);
}

/// Unknown words are kept out: a later program would have raised the version.
std::optional<ExtractorOptions> extractorFrom(const std::string& name, const std::string& words) {
    std::map<std::string, double> values;
    std::istringstream in(words);
    for (std::string word; in >> word;) {
        std::size_t equals = word.find('=');
        if (equals == std::string::npos) return std::nullopt;
        double value = 0.0;
        auto [next, failed] = std::from_chars(word.data() + equals + 1, word.data() + word.size(), value);
        if (failed != std::errc() || next != word.data() + word.size() || !(std::abs(value) < 1e9))
            return std::nullopt;
        values[word.substr(0, equals)] = value;
    }
    for (const char* key : {"version", "long_side", "keypoints", "contrast"})
        if (values.count(key) == 0) return std::nullopt;
    ExtractorOptions options;
    options.name = name;
    options.version = static_cast<int>(values["version"]);
    options.workingLongSide = static_cast<int>(values["long_side"]);
    options.maxKeypoints = static_cast<int>(values["keypoints"]);
    options.contrastThreshold = values["contrast"];
    return options;
}

std::string checksumText(const View& view, const FeatureBlobs& blobs) {
    std::uint32_t sum = checksum(view.jpeg);
    sum = checksum(outlineText(view.outline), sum);
    sum = checksum(blobs.keypoints, sum);
    return std::to_string(checksum(blobs.descriptors, sum));
}

Result<void> checkSchema(GDALDataset& dataset, const std::string& path) {
    OGRLayer* layer = dataset.GetLayerByName(kProperties);
    if (layer == nullptr) return {};
    for (auto& feature : *layer) {
        if (text(*feature, "key") != kSchemaKey) continue;
        std::string value = text(*feature, "value");
        int schema = 0;
        auto [next, failed] = std::from_chars(value.data(), value.data() + value.size(), schema);
        if (failed != std::errc() || next != value.data() + value.size())
            return Error{ErrorCode::Corrupt, said(Saying::LibraryVersion, {value}), path};
        if (schema > kSchema)
            return Error{ErrorCode::UnsupportedFormat,
                         said(Saying::LibraryLater, {value, std::to_string(kSchema)}), path};
    }
    return {};
}

Result<void> readTemplates(OGRLayer& layer, const std::string& path, LandmarkLibrary& library) {
    std::set<std::string> names;
    for (auto& feature : layer) {
        Template entry;
        entry.id = TemplateId(text(*feature, "template"));
        std::string where =
            said(Saying::RowOf, {path + ", layer templates", std::to_string(feature->GetFID())});
        if (entry.id.empty()) return Error{ErrorCode::Corrupt, said(Saying::TemplateNoName), where};
        if (!names.insert(entry.id.value).second)
            return Error{ErrorCode::Corrupt, said(Saying::TemplateTwice, {entry.id.value}), where};
        std::string kind = text(*feature, "kind");
        auto known = kindFromName(kind);
        entry.kind = known.value_or(Kind::Other);
        if (!known) {
            entry.unknownKind = kind;
            logWarning(where + ": kind \"" + kind + "\" of template " + entry.id.value +
                       " is not known; used as other");
        }
        entry.name = text(*feature, "name");
        entry.widthM = number(*feature, "width_m");
        entry.heightM = number(*feature, "height_m");
        library.templates.push_back(std::move(entry));
    }
    return {};
}

/// One row of the views layer; the order within a template is that of the rows.
struct StoredView {
    std::string templateName, extractor, parameters, keypoints, descriptors, checksum, outline;
    View view;
    std::string where;
};

StoredView storedView(OGRFeature& feature, const std::string& path, int ordinal) {
    StoredView stored;
    stored.templateName = text(feature, "template");
    stored.where = said(Saying::ViewOf,
                        {said(Saying::TemplateOf, {path, stored.templateName}), std::to_string(ordinal)});
    stored.extractor = text(feature, "extractor");
    stored.parameters = text(feature, "extractor_parameters");
    stored.keypoints = blob(feature, "keypoints");
    stored.descriptors = blob(feature, "descriptors");
    stored.checksum = text(feature, "checksum");
    stored.outline = text(feature, "outline");
    stored.view.jpeg = blob(feature, "jpeg");
    stored.view.size = {static_cast<int>(std::clamp(number(feature, "width_px").value_or(0.0), 0.0, 1e6)),
                        static_cast<int>(std::clamp(number(feature, "height_px").value_or(0.0), 0.0, 1e6))};
    return stored;
}

/// `expected`: that of the views before, or the one wanted; empty before the first view where any will do.
Result<void> checkExtractor(const StoredView& stored, std::optional<ExtractorOptions>& expected) {
    auto options = extractorFrom(stored.extractor, stored.parameters);
    if (!options)
        return Error{ErrorCode::Corrupt, said(Saying::ExtractorNotRead, {stored.parameters}), stored.where};
    if (!expected) {
        if (auto known = options->check(); !known)
            return Error{ErrorCode::Conflict,
                         said(Saying::ExtractorUnusable, {options->description(), known.error().message}),
                         stored.where};
        expected = options;
    }
    if (*options == *expected) return {};
    return Error{ErrorCode::Conflict,
                 said(Saying::ExtractorOther, {options->description(), expected->description()}),
                 stored.where};
}

Result<View> finishedView(StoredView stored) {
    auto damaged = [&](const std::string& what) {
        return Error{ErrorCode::Corrupt, said(Saying::ViewDamaged, {what}), stored.where};
    };
    auto outline = outlineFrom(stored.outline);
    if (!outline) return damaged(said(Saying::ViewOutline, {stored.outline}));
    stored.view.outline = *outline;
    auto features = decodeFeatures(stored.keypoints, stored.descriptors);
    if (!features) return damaged(features.error().message);
    if (features->descriptors.rows > 0 && features->descriptors.cols != descriptorBytes(stored.extractor))
        return damaged(said(Saying::ViewWidth, {stored.extractor}));
    if (stored.view.size.width < 1 || stored.view.size.height < 1) return damaged(said(Saying::ViewSize));
    if (checksumText(stored.view, {stored.keypoints, stored.descriptors}) != stored.checksum)
        return damaged(said(Saying::ViewChecksum));
    stored.view.features = std::move(*features);
    return std::move(stored.view);
}

/// Only what training needs.
Result<View> photographOf(StoredView stored) {
    auto outline = outlineFrom(stored.outline);
    if (!outline || stored.view.jpeg.empty())
        return Error{ErrorCode::Corrupt, said(Saying::PhotographMissing), stored.where};
    stored.view.outline = *outline;
    return std::move(stored.view);
}

enum class Want { Features, Photographs };

Result<void> readViews(OGRLayer& layer, const std::string& path,
                       const std::optional<ExtractorOptions>& wanted, Want want, LandmarkLibrary& library) {
    std::map<std::string, Template*> byName;
    for (Template& entry : library.templates) byName[entry.id.value] = &entry;
    std::map<std::string, int> ordinals;
    std::optional<ExtractorOptions> expected = wanted;
    for (auto& feature : layer) {
        StoredView stored = storedView(*feature, path, ordinals[text(*feature, "template")]++);
        auto owner = byName.find(stored.templateName);
        if (owner == byName.end())
            return Error{ErrorCode::Corrupt, said(Saying::ViewWithoutTemplate), stored.where};
        if (want == Want::Features)
            if (auto same = checkExtractor(stored, expected); !same) return same;
        auto view =
            want == Want::Features ? finishedView(std::move(stored)) : photographOf(std::move(stored));
        if (!view) return view.error();
        owner->second->views.push_back(std::move(*view));
    }
    if (expected) library.extractor = *expected;
    return {};
}

struct Field {
    const char* name;
    OGRFieldType type;
};

Result<OGRLayer*> freshLayer(GDALDataset& dataset, const char* name, std::initializer_list<Field> fields,
                             const std::string& path) {
    GdalMessages messages;
    for (int i = 0; i < dataset.GetLayerCount(); ++i)
        if (std::string(dataset.GetLayer(i)->GetName()) == name && dataset.DeleteLayer(i) != OGRERR_NONE)
            return messages.error(ErrorCode::Io, said(Saying::LayerNotReplaced), path + ", layer " + name);
    OGRLayer* layer = dataset.CreateLayer(name, nullptr, wkbNone);
    if (layer == nullptr)
        return messages.error(ErrorCode::Io, said(Saying::LayerNotMade), path + ", layer " + name);
    for (const Field& field : fields) {
        OGRFieldDefn definition(field.name, field.type);
        if (layer->CreateField(&definition) != OGRERR_NONE)
            return messages.error(ErrorCode::Io, said(Saying::FieldNotMade, {field.name}),
                                  path + ", layer " + name);
    }
    return layer;
}

Result<void> writeSchema(GDALDataset& dataset, const std::string& path) {
    GdalMessages messages;
    OGRLayer* layer = dataset.GetLayerByName(kProperties);
    if (layer == nullptr) {
        auto made = freshLayer(dataset, kProperties, {{"key", OFTString}, {"value", OFTString}}, path);
        if (!made) return made.error();
        layer = *made;
    }
    std::vector<GIntBig> old;
    for (auto& feature : *layer)
        if (text(*feature, "key") == kSchemaKey) old.push_back(feature->GetFID());
    for (GIntBig row : old)
        if (layer->DeleteFeature(row) != OGRERR_NONE)
            return messages.error(ErrorCode::Io, said(Saying::VersionNotReplaced), path + ", layer farol");
    OGRFeature feature(layer->GetLayerDefn());
    int key = feature.GetFieldIndex("key");
    int value = feature.GetFieldIndex("value");
    if (key < 0 || value < 0)
        return Error{ErrorCode::Conflict, said(Saying::LayerNotFarols), path + ", layer farol"};
    feature.SetField(key, kSchemaKey);
    feature.SetField(value, std::to_string(kSchema).c_str());
    if (layer->CreateFeature(&feature) != OGRERR_NONE)
        return messages.error(ErrorCode::Io, said(BaseSaying::NotWritten), path + ", layer farol");
    return {};
}

Result<void> writeTemplate(OGRLayer& layer, const Template& entry, const std::string& path) {
    GdalMessages messages;
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField("template", entry.id.value.c_str());
    feature.SetField("kind", entry.unknownKind.empty() ? std::string(kindName(entry.kind)).c_str()
                                                       : entry.unknownKind.c_str());
    if (!entry.name.empty()) feature.SetField("name", entry.name.c_str());
    if (entry.widthM) feature.SetField("width_m", *entry.widthM);
    if (entry.heightM) feature.SetField("height_m", *entry.heightM);
    if (layer.CreateFeature(&feature) != OGRERR_NONE)
        return messages.error(ErrorCode::Io, said(BaseSaying::NotWritten),
                              said(Saying::TemplateOf, {path, entry.id.value}));
    return {};
}

Result<void> writeView(OGRLayer& layer, const LandmarkLibrary& library, const Template& entry,
                       const View& view, const std::string& path) {
    GdalMessages messages;
    FeatureBlobs blobs = encodeFeatures(view.features);
    OGRFeature feature(layer.GetLayerDefn());
    auto setBlob = [&](const char* field, const std::string& bytes) {
        feature.SetField(feature.GetFieldIndex(field), static_cast<int>(bytes.size()), bytes.data());
    };
    feature.SetField("template", entry.id.value.c_str());
    feature.SetField("width_px", view.size.width);
    feature.SetField("height_px", view.size.height);
    feature.SetField("outline", outlineText(view.outline).c_str());
    feature.SetField("extractor", library.extractor.name.c_str());
    feature.SetField("extractor_parameters", parametersText(library.extractor).c_str());
    feature.SetField("checksum", checksumText(view, blobs).c_str());
    setBlob("jpeg", view.jpeg);
    setBlob("keypoints", blobs.keypoints);
    setBlob("descriptors", blobs.descriptors);
    if (layer.CreateFeature(&feature) != OGRERR_NONE)
        return messages.error(ErrorCode::Io, said(BaseSaying::NotWritten),
                              said(Saying::SomeViewOf, {path, entry.id.value}));
    return {};
}

Result<void> writeLayers(GDALDataset& dataset, const LandmarkLibrary& library, const std::string& path) {
    auto templates = freshLayer(dataset, kTemplates,
                                {{"template", OFTString},
                                 {"kind", OFTString},
                                 {"name", OFTString},
                                 {"width_m", OFTReal},
                                 {"height_m", OFTReal}},
                                path);
    if (!templates) return templates.error();
    auto views = freshLayer(dataset, kViews,
                            {{"template", OFTString},
                             {"width_px", OFTInteger},
                             {"height_px", OFTInteger},
                             {"outline", OFTString},
                             {"extractor", OFTString},
                             {"extractor_parameters", OFTString},
                             {"checksum", OFTString},
                             {"jpeg", OFTBinary},
                             {"keypoints", OFTBinary},
                             {"descriptors", OFTBinary}},
                            path);
    if (!views) return views.error();
    for (const Template& entry : library.templates) {
        if (auto written = writeTemplate(**templates, entry, path); !written) return written;
        for (const View& view : entry.views)
            if (auto written = writeView(**views, library, entry, view, path); !written) return written;
    }
    return writeSchema(dataset, path);
}

Result<void> writeInto(const std::filesystem::path& temporary, const LandmarkLibrary& library,
                       const std::string& path) {
    std::error_code failure;
    bool exists = std::filesystem::exists(temporary, failure);
    auto dataset =
        exists ? openVector(temporary.string(), OpenMode::Update) : createGeoPackage(temporary.string());
    if (!dataset) {
        Error error = dataset.error();
        error.context = path; // not the temporary file's name, which says nothing to anyone
        return error;
    }
    if (std::string((*dataset)->GetDriverName()) != "GPKG")
        return Error{ErrorCode::UnsupportedFormat, said(Saying::LibraryNoGeoPackage), path};
    GdalMessages messages;
    if ((*dataset)->StartTransaction() != OGRERR_NONE)
        return messages.error(ErrorCode::Io, said(BaseSaying::NotBegun), path);
    if (auto written = writeLayers(**dataset, library, path); !written) return written;
    if ((*dataset)->CommitTransaction() != OGRERR_NONE)
        return messages.error(ErrorCode::Io, said(BaseSaying::NotFinished), path);
    return closeVector(std::move(*dataset), path);
}

Result<LandmarkLibrary> load(const std::string& path, const std::optional<ExtractorOptions>& wanted,
                             Want want) {
    auto dataset = openVector(path);
    if (!dataset) return dataset.error();
    GdalMessages messages;
    if (auto known = checkSchema(**dataset, path); !known) return known.error();
    OGRLayer* templates = (*dataset)->GetLayerByName(kTemplates);
    OGRLayer* views = (*dataset)->GetLayerByName(kViews);
    if (templates == nullptr || views == nullptr)
        return Error{ErrorCode::NotFound, said(Saying::LibraryNone), path};
    LandmarkLibrary library;
    if (auto read = readTemplates(*templates, path, library); !read) return read.error();
    if (auto read = readViews(*views, path, wanted, want, library); !read) return read.error();
    if (messages.failed()) return messages.error(ErrorCode::Corrupt, said(Saying::LibraryNotRead), path);
    return library;
}

} // namespace

Result<LandmarkLibrary> loadLibrary(const std::string& path, const std::optional<ExtractorOptions>& wanted) {
    return load(path, wanted, Want::Features);
}

Result<LandmarkLibrary> loadPhotographs(const std::string& path) {
    return load(path, std::nullopt, Want::Photographs);
}

Result<void> saveLibrary(const LandmarkLibrary& library, const std::string& path) {
    try {
        return replaceFile(path, true, [&](const std::filesystem::path& temporary) {
            return writeInto(temporary, library, path);
        });
    } catch (const std::exception& problem) {
        return Error{ErrorCode::Io, said(Saying::LibraryNotSaved, {problem.what()}), path};
    }
}

} // namespace farol::recognition
