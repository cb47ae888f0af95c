#include "core/base/text.h"
#include "core/building/import/importer.h"
#include "core/building/import/zip_directory.h"

#include <cpl_vsi.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace farol::building {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMembers = 10000;
constexpr int kDeepestFolder = 8;
constexpr std::uint64_t kLargestMember = 1ULL << 30U, kLargestTotal = 2ULL << 30U;
/// Deflate cannot pack text by more than about 1000 to 1; real maps stay under 40 to 1.
constexpr std::uint64_t kHighestRatio = 200, kRatioFrom = 4ULL << 20U;

/// Names that would leave the place they are unpacked to.
bool leavesFolder(const std::string& name) {
    if (name.empty() || name.front() == '/' || name.front() == '\\') return true;
    if (name.size() > 1 && name[1] == ':') return true;
    std::string part;
    for (char c : name + "/") {
        if (c != '/' && c != '\\') {
            part.push_back(c);
            continue;
        }
        if (part == "..") return true;
        part.clear();
    }
    return name.find('\0') != std::string::npos;
}

/// What an operating system or archiver leaves behind beside the data.
bool isLitter(const std::string& name) {
    std::string last = name.substr(name.rfind('/') + 1);
    return name.rfind("__MACOSX/", 0) == 0 || last.empty() || last.front() == '.';
}

Result<void> listZip(SourceListing& listing) {
    auto entries = readZipDirectory(listing.path);
    if (!entries) return entries.error();
    if (entries->size() > kMostMembers)
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::ZipTooManyFiles), listing.path};
    std::uint64_t total = 0;
    for (const ZipEntry& entry : *entries) {
        std::string context = listing.path + ", " + entry.name;
        if (leavesFolder(entry.name))
            return Error{ErrorCode::Corrupt, english(Sentence::ZipLeadsOut), context};
        if (entry.encrypted)
            return Error{ErrorCode::UnsupportedFormat, english(Sentence::ZipLocked), context};
        bool bomb =
            entry.size > kRatioFrom && entry.size / std::max<std::uint64_t>(entry.packed, 1) > kHighestRatio;
        total += entry.size;
        if (bomb || entry.size > kLargestMember || total > kLargestTotal)
            return Error{ErrorCode::UnsupportedFormat,
                         english(Sentence::ZipUnpacksTo, static_cast<double>(total >> 20U)), context};
        if (isLitter(entry.name)) continue;
        // Braces: the file need not be called .zip for GDAL to look inside.
        listing.members.push_back({entry.name, "/vsizip/{" + listing.path + "}/" + entry.name, entry.size});
    }
    return {};
}

Result<void> listFolder(SourceListing& listing) {
    std::error_code failure;
    fs::path root(listing.path);
    fs::recursive_directory_iterator walk(root, fs::directory_options::skip_permission_denied, failure), end;
    for (; !failure && walk != end; walk.increment(failure)) {
        if (walk.depth() >= kDeepestFolder) walk.disable_recursion_pending();
        if (!walk->is_regular_file(failure)) continue;
        std::string name = walk->path().lexically_relative(root).generic_string();
        if (isLitter(name)) continue;
        listing.members.push_back({name, walk->path().string(), walk->file_size(failure)});
        if (listing.members.size() > kMostMembers)
            return Error{ErrorCode::UnsupportedFormat, english(Sentence::TooManyFiles), listing.path};
    }
    if (failure) return Error{ErrorCode::Io, english(Sentence::NotListed, failure.message()), listing.path};
    return {};
}

} // namespace

Result<SourceListing> listSource(const std::string& path) {
    SourceListing listing;
    listing.path = path;
    // Remote and nested file systems of GDAL are not opened on a map's word.
    if (path.empty() || (path.rfind("/vsi", 0) == 0 && path.rfind("/vsimem/", 0) != 0))
        return Error{ErrorCode::InvalidArgument, english(Sentence::NoFileOrFolder), path};
    VSIStatBufL state;
    if (VSIStatL(path.c_str(), &state) != 0)
        return Error{ErrorCode::NotFound, english(Sentence::NoSuchSource), path};
    std::error_code failure;
    Result<void> listed;
    if (path.rfind("/vsimem/", 0) != 0 && fs::is_directory(path, failure)) {
        listing.folder = true;
        listed = listFolder(listing);
    } else if (looksLikeZip(path)) {
        listing.zip = true;
        listed = listZip(listing);
    } else {
        listing.members.push_back(
            {path.substr(path.rfind('/') + 1), path, static_cast<std::uint64_t>(state.st_size)});
    }
    if (!listed) return listed.error();
    if (listing.members.empty()) return Error{ErrorCode::NotFound, english(Sentence::HoldsNoFiles), path};
    std::stable_sort(
        listing.members.begin(), listing.members.end(),
        [](const SourceMember& a, const SourceMember& b) { return naturalLess(a.name, b.name); });
    return listing;
}

} // namespace farol::building
