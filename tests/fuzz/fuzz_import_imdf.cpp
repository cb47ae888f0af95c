#include "tests/fuzz/import_fuzz.h"

#include <vector>

// Files parted by zero bytes: unit, level, opening, amenity, relationship, occupant, anchor.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace farol::building;
    static const auto importer = makeImdfImporter();
    const char* names[] = {"unit", "level", "opening", "amenity", "relationship", "occupant", "anchor"};
    std::vector<std::string> files(1);
    for (std::size_t i = 0; i < size; ++i) {
        if (data[i] != 0)
            files.back().push_back(static_cast<char>(data[i]));
        else
            files.emplace_back();
    }
    SourceListing listing;
    listing.path = "/vsimem/fuzz";
    for (std::size_t i = 0; i < files.size() && i < 7; ++i) {
        std::string name = std::string(names[i]) + ".geojson", path = "/vsimem/fuzz/" + name;
        VSIFCloseL(VSIFileFromMemBuffer(path.c_str(), reinterpret_cast<GByte*>(files[i].data()),
                                        files[i].size(), FALSE));
        listing.members.push_back({name, path, files[i].size()});
    }
    importer->recognises(listing);
    auto map = importer->read(listing, {});
    if (map.ok()) {
        auto finished = finishImport(std::move(*map), MapFormat::Imdf);
        if (finished.ok() && finished->building->regions().empty()) __builtin_trap();
    }
    for (const SourceMember& member : listing.members) VSIUnlink(member.ogrPath.c_str());
    return 0;
}
