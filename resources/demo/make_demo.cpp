// Writes the demo building's map. For maintainers; everything is the same at every run.

#include "core/building/checks.h"
#include "core/building/geopackage.h"

#include <ogr_spatialref.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "resources/demo/demo_building.h"

namespace {

std::string wellKnownText(int epsg) {
    OGRSpatialReference crs;
    char* text = nullptr;
    if (crs.importFromEPSG(epsg) != OGRERR_NONE || crs.exportToWkt(&text) != OGRERR_NONE) return {};
    std::string result(text);
    CPLFree(text);
    return result;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: farol-demo-map OUT.gpkg\n");
        return 2;
    }
    farol::building::BuildingData data = farol::demo::demoBuilding();
    data.crs = wellKnownText(32629);
    farol::building::Building building(std::move(data));
    for (const auto& finding : farol::building::checkBuilding(building))
        std::fprintf(stderr, "%s: %s\n", finding.rule.c_str(), finding.message.c_str());
    std::error_code ignored;
    std::filesystem::remove(argv[1], ignored);
    auto saved = farol::building::saveBuilding(building, argv[1]);
    if (!saved) std::fprintf(stderr, "%s\n", saved.error().text().c_str());
    return saved ? 0 : 1;
}
