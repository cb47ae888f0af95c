#include "core/base/ogr.h"
#include "core/building/import/importer.h"

#include <cpl_vsi.h>

#include <algorithm>
#include <cctype>
#include <memory>

namespace farol::building {

namespace {

struct FileCloser {
    void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};
using VsiFile = std::unique_ptr<VSILFILE, FileCloser>;

std::string lowerCase(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string lastPart(const std::string& name) {
    return name.substr(name.rfind('/') + 1);
}

} // namespace

std::string SourceListing::head(const SourceMember& member, std::size_t bytes) const {
    GdalMessages quiet;
    VsiFile file(VSIFOpenL(member.ogrPath.c_str(), "rb"));
    if (file == nullptr) return {};
    std::string text(bytes, '\0');
    text.resize(VSIFReadL(text.data(), 1, bytes, file.get()));
    return text;
}

Result<std::string> SourceListing::content(const SourceMember& member, std::uint64_t limit) const {
    GdalMessages quiet;
    VsiFile file(VSIFOpenL(member.ogrPath.c_str(), "rb"));
    if (file == nullptr) return Error{ErrorCode::Io, english(Sentence::NotOpened), member.name};
    std::string text;
    constexpr std::size_t kBlock = 1U << 20U;
    for (;;) { // in blocks: the size a zip states may be a lie
        std::size_t before = text.size();
        text.resize(before + kBlock);
        std::size_t got = VSIFReadL(text.data() + before, 1, kBlock, file.get());
        text.resize(before + got);
        if (text.size() > limit)
            return Error{ErrorCode::Corrupt, english(Sentence::FileOverMb, static_cast<double>(limit >> 20U)),
                         member.name};
        if (got < kBlock) return text;
    }
}

const SourceMember* SourceListing::find(const std::string& fileName) const {
    for (const SourceMember& member : members)
        if (lowerCase(lastPart(member.name)) == lowerCase(fileName)) return &member;
    return nullptr;
}

} // namespace farol::building
