#include "core/building/import/zip_directory.h"

#include "core/building/sentence.h"

#include <cpl_vsi.h>

#include <algorithm>
#include <memory>
#include <string_view>

namespace farol::building {

namespace {

struct FileCloser {
    void operator()(VSILFILE* file) const { VSIFCloseL(file); }
};
using VsiFile = std::unique_ptr<VSILFILE, FileCloser>;

constexpr std::uint64_t kLargestDirectory = 16ULL << 20U;
constexpr std::size_t kEndSize = 22, kEntrySize = 46;

std::uint64_t littleEndian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = count; i > 0; --i)
        value = value << 8U | static_cast<unsigned char>(bytes[at + i - 1]);
    return value;
}

std::string readAt(VSILFILE& file, std::uint64_t offset, std::uint64_t count) {
    std::string bytes(count, '\0');
    if (VSIFSeekL(&file, offset, SEEK_SET) != 0) return {};
    bytes.resize(VSIFReadL(bytes.data(), 1, bytes.size(), &file));
    return bytes;
}

Result<std::vector<ZipEntry>> entriesOf(std::string_view directory, const std::string& path) {
    std::vector<ZipEntry> entries;
    std::size_t at = 0;
    while (at + kEntrySize <= directory.size() && directory.substr(at, 4) == "PK\x01\x02") {
        std::size_t nameLength = littleEndian(directory, at + 28, 2);
        std::size_t rest = littleEndian(directory, at + 30, 2) + littleEndian(directory, at + 32, 2);
        if (at + kEntrySize + nameLength > directory.size()) break;
        ZipEntry entry;
        entry.encrypted = (littleEndian(directory, at + 8, 2) & 1U) != 0;
        entry.packed = littleEndian(directory, at + 20, 4);
        entry.size = littleEndian(directory, at + 24, 4);
        entry.name = directory.substr(at + kEntrySize, nameLength);
        entries.push_back(std::move(entry));
        at += kEntrySize + nameLength + rest;
    }
    if (at != directory.size()) return Error{ErrorCode::Corrupt, english(Sentence::ZipListDamaged), path};
    return entries;
}

} // namespace

bool looksLikeZip(const std::string& path) {
    VsiFile file(VSIFOpenL(path.c_str(), "rb"));
    if (file == nullptr) return false;
    std::string start = readAt(*file, 0, 4);
    return start == std::string_view("PK\x03\x04", 4) || start == std::string_view("PK\x05\x06", 4);
}

Result<std::vector<ZipEntry>> readZipDirectory(const std::string& path) {
    VsiFile file(VSIFOpenL(path.c_str(), "rb"));
    if (file == nullptr) return Error{ErrorCode::Io, english(Sentence::NotOpened), path};
    VSIFSeekL(file.get(), 0, SEEK_END);
    std::uint64_t size = VSIFTellL(file.get());
    std::uint64_t tailSize =
        std::min<std::uint64_t>(size, kEndSize + 0xFFFF); // a comment may follow the end record
    std::string tail = readAt(*file, size - tailSize, tailSize);
    std::size_t end = tail.rfind(std::string_view("PK\x05\x06", 4));
    if (end == std::string::npos || end + kEndSize > tail.size())
        return Error{ErrorCode::Corrupt, english(Sentence::ZipCutOff), path};
    std::uint64_t count = littleEndian(tail, end + 12, 4), offset = littleEndian(tail, end + 16, 4);
    if (count == 0xFFFFFFFF || offset == 0xFFFFFFFF || count > kLargestDirectory)
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::ZipTooLarge), path};
    if (offset + count > size) return Error{ErrorCode::Corrupt, english(Sentence::ZipListOutside), path};
    return entriesOf(readAt(*file, offset, count), path);
}

} // namespace farol::building
