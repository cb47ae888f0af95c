#include "core/building/import/importer.h"
#include "core/building/import/table_reader.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace farol::building {

namespace {

constexpr std::uint64_t kLargestFile = 1ULL << 30U;

bool endsWith(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

class TableImporter : public Importer {
public:
    explicit TableImporter(MapFormat format) : m_format(format) {}

    MapFormat format() const override { return m_format; }

    int recognises(const SourceListing& source) const override {
        int score = m_format == MapFormat::Shapefile ? 50 : m_format == MapFormat::GeoPackage ? 45 : 10;
        return std::any_of(source.members.begin(), source.members.end(),
                           [&](const SourceMember& member) { return fits(source, member); })
                   ? score
                   : 0;
    }

    Result<RawMap> read(const SourceListing& source, const ImportOptions& options) const override {
        try {
            auto words = TableWords::fromProfile(options.profile);
            if (!words) return words.error();
            TableReader reader(std::move(*words), options);
            bool any = false;
            for (const SourceMember& member : source.members) {
                if (!fits(source, member) && source.members.size() > 1) continue;
                if (member.size > kLargestFile)
                    return Error{ErrorCode::UnsupportedFormat, english(Sentence::FileOverOneGb), member.name};
                any = true;
                if (auto done = reader.read(member); !done) return done.error();
            }
            if (any) return reader.finish(source.path);
            return Error{ErrorCode::UnsupportedFormat,
                         english(Sentence::NoFileOfFormat, mapFormatName(m_format)), source.path};
        } catch (const std::exception& failure) {
            return Error{ErrorCode::Corrupt, english(Sentence::NotRead, failure.what()), source.path};
        }
    }

private:
    bool fits(const SourceListing& source, const SourceMember& member) const {
        std::string name = lowerCase(member.name);
        if (m_format == MapFormat::Shapefile) return endsWith(name, ".shp");
        if (m_format == MapFormat::GeoPackage) return endsWith(name, ".gpkg");
        return (endsWith(name, ".geojson") || endsWith(name, ".json")) &&
               source.head(member).find("\"Feature") != std::string::npos;
    }

    MapFormat m_format;
};

} // namespace

std::unique_ptr<Importer> makeTableImporter(MapFormat format) {
    return std::make_unique<TableImporter>(format);
}

} // namespace farol::building
