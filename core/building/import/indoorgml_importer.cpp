#include "core/building/import/importer.h"
#include "core/building/import/indoorgml_builder.h"

#include <exception>

namespace farol::building {

namespace {

constexpr std::uint64_t kMaxBytes = 64ULL << 20U;

class IndoorGmlImporter : public Importer {
public:
    MapFormat format() const override { return MapFormat::IndoorGml; }

    int recognises(const SourceListing& source) const override { return find(source) == nullptr ? 0 : 90; }

    Result<RawMap> read(const SourceListing& source, const ImportOptions& options) const override {
        const SourceMember* member = find(source);
        if (member == nullptr && source.members.size() == 1) member = &source.members.front();
        if (member == nullptr)
            return Error{ErrorCode::UnsupportedFormat, english(Sentence::GmlNoFile), source.path};
        try {
            auto bytes = source.content(*member, kMaxBytes);
            if (!bytes) return bytes.error();
            auto document = parseXml(*bytes, member->name);
            if (!document) return document.error();
            return IndoorGmlBuilder(*document, options, member->name).build();
        } catch (const std::exception& failure) {
            return Error{ErrorCode::Corrupt, english(Sentence::NotRead, failure.what()), member->name};
        }
    }

private:
    static const SourceMember* find(const SourceListing& source) {
        for (const SourceMember& member : source.members) {
            std::string head = source.head(member);
            bool named = head.find("IndoorFeatures") != std::string::npos;
            if (named && head.find("indoorgml") != std::string::npos) return &member;
        }
        return nullptr;
    }
};

} // namespace

std::unique_ptr<Importer> makeIndoorGmlImporter() {
    return std::make_unique<IndoorGmlImporter>();
}

} // namespace farol::building
