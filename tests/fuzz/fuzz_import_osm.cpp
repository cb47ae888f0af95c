#include "tests/fuzz/import_fuzz.h"

// The first byte chooses between the XML or PBF of the driver and GeoJSON.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto importer = farol::building::makeOsmImporter();
    if (size == 0) return 0;
    const char* name = data[0] % 2 == 0 ? "map.osm" : "map.geojson";
    return farol::building::fuzzImporter(*importer, name, data + 1, size - 1);
}
