#pragma once
// What a zip says it holds, read from its own directory before anything is unpacked.

#include "core/base/error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace farol::building {

struct ZipEntry {
    std::string name;
    std::uint64_t packed = 0, size = 0;
    bool encrypted = false;
};

/// Does the file start as a zip does?
bool looksLikeZip(const std::string& path);
/// Corrupt for a directory that is damaged, UnsupportedFormat for one that is too large to be a map.
Result<std::vector<ZipEntry>> readZipDirectory(const std::string& path);

} // namespace farol::building
