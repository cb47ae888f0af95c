#include "core/building/import/hulop_builder.h"
#include "core/building/import/hulop_records.h"
#include "core/building/import/importer.h"

#include <exception>

namespace farol::building {

namespace {

constexpr std::uint64_t kMaxBytes = 32ULL << 20U;

bool looksLikeHulop(const std::string& head) {
    auto has = [&head](const char* text) { return head.find(text) != std::string::npos; };
    bool json = head.find_first_of("{[") != std::string::npos;
    bool old = has("\"ノードID\"") || has("\"リンクID\"") || has("\"対応ノードID\"") || has("\"施設ID\"");
    bool fresh = has("\"facil_id\"") || has("\"start_id\"") || has("\"hulop_") ||
                 (has("\"node_id\"") && has("\"link1_id\""));
    return json && (old || fresh);
}

class HulopImporter : public Importer {
public:
    MapFormat format() const override { return MapFormat::Hulop; }

    int recognises(const SourceListing& source) const override {
        for (const SourceMember& member : source.members)
            if (looksLikeHulop(source.head(member))) return 80;
        return 0;
    }

    Result<RawMap> read(const SourceListing& source, const ImportOptions& options) const override {
        try {
            std::vector<Finding> findings;
            std::vector<TaggedFeature> features;
            std::string context;
            for (const SourceMember& member : source.members) {
                if (source.members.size() > 1 && !looksLikeHulop(source.head(member))) continue;
                auto text = source.content(member, kMaxBytes);
                if (!text) return text.error();
                std::size_t first = text->find_first_not_of(" \t\r\n");
                // The map server answers with the bare list.
                if (first != std::string::npos && (*text)[first] == '[')
                    *text = "{\"features\":" + *text + "}";
                auto collection = readTaggedGeoJson(*text, member.name, findings);
                if (!collection) return collection.error();
                for (TaggedFeature& feature : collection->features) features.push_back(std::move(feature));
                if (context.empty()) context = member.name;
                if (features.size() > 200000)
                    return Error{ErrorCode::Corrupt, english(Sentence::HulopTooManyFeatures), source.path};
            }
            auto map = HulopBuilder(hulopRecords(features, options.language), options,
                                    context.empty() ? source.path : context)
                           .build();
            if (map) map->findings.insert(map->findings.begin(), findings.begin(), findings.end());
            return map;
        } catch (const std::exception& failure) {
            return Error{ErrorCode::Corrupt, english(Sentence::NotRead, failure.what()), source.path};
        }
    }
};

} // namespace

std::unique_ptr<Importer> makeHulopImporter() {
    return std::make_unique<HulopImporter>();
}

} // namespace farol::building
