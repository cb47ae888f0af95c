#include "tests/fuzz/import_fuzz.h"

// The first byte chooses among GeoJSON, a GeoPackage and a .shp without its companions; what is read is also
// finished.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace farol::building;
    if (size == 0) return 0;
    const MapFormat formats[] = {MapFormat::GeoJson, MapFormat::GeoPackage, MapFormat::Shapefile};
    const char* names[] = {"MapA.geojson", "MapA.gpkg", "MapA.shp"};
    std::size_t which = data[0] % 3U;
    std::string bytes(reinterpret_cast<const char*>(data + 1), size - 1);
    std::string path = std::string("/vsimem/fuzz/") + names[which];
    VSIFCloseL(
        VSIFileFromMemBuffer(path.c_str(), reinterpret_cast<GByte*>(bytes.data()), bytes.size(), FALSE));
    ImportOptions options;
    options.format = formats[which];
    auto imported = importBuilding(path, options);
    if (imported.ok() ? imported->building->regions().empty() : imported.error().message.empty())
        __builtin_trap();
    VSIUnlink(path.c_str());
    return 0;
}
