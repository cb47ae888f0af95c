#pragma once
// Feeds bytes to an importer as a file in memory. What is wrong with them must come back as an Error.

#include "core/building/import/importer.h"

#include <cpl_vsi.h>

#include <cstdint>
#include <string>

namespace farol::building {

inline int fuzzImporter(const Importer& importer, const char* name, const std::uint8_t* data,
                        std::size_t size) {
    std::string bytes(reinterpret_cast<const char*>(data), size);
    std::string path = std::string("/vsimem/fuzz/") + name;
    VSIFCloseL(
        VSIFileFromMemBuffer(path.c_str(), reinterpret_cast<GByte*>(bytes.data()), bytes.size(), FALSE));
    SourceListing listing;
    listing.path = path;
    listing.members.push_back({name, path, bytes.size()});
    importer.recognises(listing);
    auto map = importer.read(listing, {});
    if (map.ok() && map->data.regions.empty())
        __builtin_trap(); // a map without regions is an error, not a map
    VSIUnlink(path.c_str());
    return 0;
}

} // namespace farol::building
