// farol-campus REGIONS OUT.gpkg [SEED [TURN_DEGREES]]: a synthetic campus as a building file.

#include "core/building/geopackage.h"
#include "tests/support/campus.h"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
    if (argc < 3 || argc > 5) {
        std::fprintf(stderr, "usage: farol-campus REGIONS OUT.gpkg [SEED [TURN_DEGREES]]\n");
        return 2;
    }
    farol::test::CampusOptions options;
    options.regions = static_cast<std::size_t>(std::strtoul(argv[1], nullptr, 10));
    if (argc > 3) options.seed = static_cast<std::uint32_t>(std::strtoul(argv[3], nullptr, 10));
    if (argc > 4) options.turnDegrees = std::atof(argv[4]);
    options.crs = "EPSG:32629";
    options.origin = {595000.0, 4099000.0};
    auto saved = farol::building::saveBuilding(*farol::test::makeCampus(options), argv[2]);
    if (!saved) std::fprintf(stderr, "farol-campus: %s\n", saved.error().text().c_str());
    return saved ? 0 : 1;
}
