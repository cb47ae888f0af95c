#include "core/building/import/importer.h"
#include "core/building/import/osm_builder.h"
#include "core/building/import/osm_reader.h"

#include <exception>

namespace farol::building {

namespace {

class OsmImporter : public Importer {
public:
    MapFormat format() const override { return MapFormat::Osm; }

    int recognises(const SourceListing& source) const override { return best(source).first; }

    Result<RawMap> read(const SourceListing& source, const ImportOptions& options) const override {
        const SourceMember* member = best(source).second;
        if (member == nullptr && source.members.size() == 1) member = &source.members.front();
        if (member == nullptr)
            return Error{ErrorCode::UnsupportedFormat, english(Sentence::OsmNoFile), source.path};
        try {
            std::vector<Finding> findings;
            auto features = readOsmFeatures(source, *member, findings);
            if (!features) return features.error();
            auto map = OsmBuilder(std::move(*features), options, member->name).build();
            if (map) map->findings.insert(map->findings.begin(), findings.begin(), findings.end());
            return map;
        } catch (const std::exception& failure) {
            return Error{ErrorCode::Corrupt, english(Sentence::NotRead, failure.what()), member->name};
        }
    }

private:
    static std::pair<int, const SourceMember*> best(const SourceListing& source) {
        std::pair<int, const SourceMember*> found{0, nullptr};
        for (const SourceMember& member : source.members)
            if (int score = looksLikeOsm(member, source.head(member)); score > found.first)
                found = {score, &member};
        return found;
    }
};

} // namespace

std::unique_ptr<Importer> makeOsmImporter() {
    return std::make_unique<OsmImporter>();
}

} // namespace farol::building
