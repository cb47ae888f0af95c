#pragma once
// Listings for importer tests: a real file, or bytes that live in memory while the test looks at them.

#include "core/building/import/importer.h"

#include <cpl_vsi.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace farol::building::testing {

inline SourceListing listingOf(const std::vector<std::string>& paths) {
    SourceListing listing;
    for (const std::string& path : paths) {
        VSIStatBufL status{};
        if (VSIStatL(path.c_str(), &status) != 0) status.st_size = 0;
        listing.members.push_back(
            {path.substr(path.rfind('/') + 1), path, static_cast<std::uint64_t>(status.st_size)});
    }
    listing.path = paths.front();
    listing.folder = paths.size() > 1;
    return listing;
}

inline std::string fixture(const std::string& name) {
    return std::string(FAROL_SOURCE_DIR) + "/tests/data/import/" + name;
}

/// Empty when the folder is not on this machine.
inline std::string realMap(const std::string& name) {
    const char* data = std::getenv("FAROL_DATA");
    std::string path = data == nullptr ? std::string() : std::string(data) + "/maps/" + name;
    return std::filesystem::exists(path) ? path : std::string();
}

class MemoryFile {
public:
    MemoryFile(const std::string& name, std::string bytes)
        : m_path("/vsimem/import_test/" + name), m_bytes(std::move(bytes)) {
        VSIFCloseL(VSIFileFromMemBuffer(m_path.c_str(), reinterpret_cast<GByte*>(m_bytes.data()),
                                        m_bytes.size(), FALSE));
    }
    ~MemoryFile() { VSIUnlink(m_path.c_str()); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    const std::string& path() const { return m_path; }

private:
    std::string m_path, m_bytes;
};

inline Result<RawMap> readBytes(const Importer& importer, const std::string& name, const std::string& bytes,
                                const ImportOptions& options = {}) {
    MemoryFile file(name, bytes);
    return importer.read(listingOf({file.path()}), options);
}

inline const Region* regionOf(const RawMap& map, const std::string& id) {
    for (const Region& region : map.data.regions)
        if (region.id.value == id) return &region;
    return nullptr;
}

inline const Access* accessOf(const RawMap& map, const std::string& id) {
    for (const Access& access : map.data.accesses)
        if (access.id.value == id) return &access;
    return nullptr;
}

inline const Finding* findingOf(const RawMap& map, const std::string& rule) {
    for (const Finding& finding : map.findings)
        if (finding.rule == rule) return &finding;
    return nullptr;
}

} // namespace farol::building::testing
