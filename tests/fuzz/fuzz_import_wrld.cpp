#include "tests/fuzz/import_fuzz.h"

// The bytes up to the first zero are main.json, the rest is the floor "f.geojson" that it may name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto importer = farol::building::makeWrldImporter();
    std::string bytes(reinterpret_cast<const char*>(data), size);
    std::size_t cut = bytes.find('\0');
    std::string main = bytes.substr(0, cut),
                floor = cut == std::string::npos ? std::string() : bytes.substr(cut + 1);
    auto put = [](const std::string& path, std::string& text) {
        VSIFCloseL(
            VSIFileFromMemBuffer(path.c_str(), reinterpret_cast<GByte*>(text.data()), text.size(), FALSE));
    };
    put("/vsimem/fuzz/main.json", main);
    put("/vsimem/fuzz/f.geojson", floor);
    farol::building::SourceListing listing;
    listing.path = "/vsimem/fuzz";
    listing.members = {{"f.geojson", "/vsimem/fuzz/f.geojson", floor.size()},
                       {"main.json", "/vsimem/fuzz/main.json", main.size()}};
    importer->recognises(listing);
    auto map = importer->read(listing, {});
    if (map.ok() && map->data.regions.empty()) __builtin_trap();
    VSIUnlink("/vsimem/fuzz/main.json");
    VSIUnlink("/vsimem/fuzz/f.geojson");
    return 0;
}
