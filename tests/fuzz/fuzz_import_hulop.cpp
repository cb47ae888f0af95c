#include "tests/fuzz/import_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto importer = farol::building::makeHulopImporter();
    return farol::building::fuzzImporter(*importer, "map.geojson", data, size);
}
