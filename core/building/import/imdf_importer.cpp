#include "core/building/import/imdf_builder.h"
#include "core/building/import/importer.h"

#include <nlohmann/json.hpp>

#include <exception>
#include <utility>

namespace farol::building {

namespace {

constexpr std::uint64_t kLargestFile = 128ULL << 20U;
constexpr const char* kTypes[] = {"venue",   "building", "level",    "unit",         "opening",
                                  "amenity", "anchor",   "occupant", "relationship", "fixture",
                                  "kiosk",   "detail",   "section",  "geofence"};

/// The folders, within the source, that hold a unit.geojson.
std::vector<std::string> venueFolders(const SourceListing& source) {
    std::vector<std::string> folders;
    for (const SourceMember& member : source.members) {
        std::size_t slash = member.name.rfind('/');
        std::string folder = slash == std::string::npos ? "" : member.name.substr(0, slash + 1);
        if (member.name.substr(folder.size()) == "unit.geojson") folders.push_back(folder);
    }
    return folders;
}

const SourceMember* memberNamed(const SourceListing& source, const std::string& name) {
    for (const SourceMember& member : source.members)
        if (member.name == name) return &member;
    return nullptr;
}

class ImdfImporter : public Importer {
public:
    MapFormat format() const override { return MapFormat::Imdf; }

    int recognises(const SourceListing& source) const override {
        for (const std::string& folder : venueFolders(source)) {
            const SourceMember* level = memberNamed(source, folder + "level.geojson");
            if (level == nullptr) continue;
            if (source.head(*level).find("\"feature_type\"") != std::string::npos) return 90;
        }
        return 0;
    }

    Result<RawMap> read(const SourceListing& source, const ImportOptions& options) const override {
        std::vector<std::string> folders = venueFolders(source);
        if (folders.empty())
            return Error{ErrorCode::UnsupportedFormat, english(Sentence::ImdfNoUnits), source.path};
        if (folders.size() > 1)
            return Error{
                ErrorCode::InvalidArgument,
                english(Sentence::ImdfSeveralVenues, static_cast<double>(folders.size()), folders.front()),
                source.path};
        try {
            return readVenue(source, folders.front(), options);
        } catch (const std::exception& failure) {
            return Error{ErrorCode::Corrupt, english(Sentence::NotRead, failure.what()), source.path};
        }
    }

private:
    static std::string languageOf(const SourceListing& source, const std::string& folder) {
        const SourceMember* manifest = memberNamed(source, folder + "manifest.json");
        auto text =
            manifest == nullptr ? Result<std::string>(std::string()) : source.content(*manifest, 1U << 20U);
        if (!text) return {};
        auto json = nlohmann::json::parse(*text, nullptr, false);
        auto language = json.is_object() ? json.find("language") : json.end();
        return json.is_object() && language != json.end() && language->is_string()
                   ? language->get<std::string>()
                   : std::string();
    }

    static Result<RawMap> readVenue(const SourceListing& source, const std::string& folder,
                                    const ImportOptions& options) {
        ImdfFiles files;
        std::vector<Finding> findings;
        for (const char* type : kTypes) {
            const SourceMember* member = memberNamed(source, folder + type + ".geojson");
            if (member == nullptr) continue;
            auto text = source.content(*member, kLargestFile);
            if (!text) return text.error();
            auto collection = readTaggedGeoJson(*text, source.path + ", " + member->name, findings);
            if (!collection) return collection.error();
            files[type] = std::move(collection->features);
        }
        std::string language = options.language.empty() ? languageOf(source, folder) : options.language;
        RawMap map = ImdfBuilder(files, language).build();
        map.findings.insert(map.findings.begin(), findings.begin(), findings.end());
        return map;
    }
};

} // namespace

std::unique_ptr<Importer> makeImdfImporter() {
    return std::make_unique<ImdfImporter>();
}

} // namespace farol::building
