#include "tests/fuzz/import_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto importer = farol::building::makeIndoorGmlImporter();
    return farol::building::fuzzImporter(*importer, "map.gml", data, size);
}
