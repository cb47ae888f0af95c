// Whatever bytes claim to be a GeoPackage: reading, checking and planning end with a value or an Error, never
// otherwise.
#include "core/building/checks.h"
#include "core/building/geopackage.h"
#include "core/building/info.h"
#include "core/routing/route.h"

#include <cpl_vsi.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const char* path = "/vsimem/fuzz.gpkg";
    // The file lives in memory and only borrows the bytes.
    VSILFILE* file = VSIFileFromMemBuffer(path, const_cast<GByte*>(data), size, FALSE);
    if (file == nullptr) return 0;
    VSIFCloseL(file);
    auto loaded = farol::building::loadBuilding(path);
    if (loaded.ok()) {
        const farol::building::Building& building = *loaded->building;
        (void)farol::building::checkBuilding(building);
        (void)farol::building::describe(building);
        auto planner = farol::routing::makeOptimalPlanner(loaded->building);
        (void)planner->plan({building.regions().front().id, std::nullopt},
                            {building.regions().back().id, std::nullopt});
    } else if (loaded.error().message.empty()) {
        std::abort(); // an error always says what is wrong
    }
    VSIUnlink(path);
    return 0;
}
