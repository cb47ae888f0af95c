// Saves one map again and again, a new version each time, until it is killed: see check_killed_saves.py.
//   save_loop MAP.gpkg
// Says "begin N" before and "done N" after each save. Version N has 200 + N % 50 rooms, and says N in the
// layer farol, so that half an old and half a new file would be noticed.
#include "core/building/geopackage.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using namespace farol;
using namespace farol::building;

BuildingData versionOf(int version) {
    BuildingData data;
    data.title = "Version " + std::to_string(version);
    data.properties["version"] = std::to_string(version);
    data.levels = {{0.0, "Ground", "0", std::nullopt, std::nullopt, {}}};
    int rooms = 200 + version % 50;
    for (int i = 0; i < rooms; ++i) {
        Region region;
        region.id = RegionId("R" + std::to_string(i));
        region.name = "Room " + std::to_string(i) + " of " + std::to_string(version);
        region.kind = RegionKind::Room;
        double x = 5.0 * (i % 20), y = 4.0 * (i / 20);
        region.polygon.outer = {{x, y}, {x + 5, y}, {x + 5, y + 4}, {x, y + 4}};
        region.extra["version"] = std::int64_t{version};
        data.regions.push_back(region);
        if (i % 20 == 0) continue;
        Access door;
        door.id = AccessId("D" + std::to_string(i));
        door.regionA = RegionId("R" + std::to_string(i - 1));
        door.regionB = region.id;
        door.line = {{x, y + 1}, {x, y + 2}};
        data.accesses.push_back(door);
    }
    return data;
}

int startOf(const std::string& path) {
    auto loaded = loadBuilding(path);
    if (!loaded) return loaded.error().code == ErrorCode::NotFound ? 0 : -1;
    auto found = loaded->building->data().properties.find("version");
    return found == loaded->building->data().properties.end() ? -1 : std::atoi(found->second.c_str());
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    int version = startOf(argv[1]);
    if (version < 0) {
        std::fprintf(stderr, "the file is no map of this program\n");
        return 1;
    }
    for (;;) {
        Building next(versionOf(++version));
        std::printf("begin %d\n", version);
        std::fflush(stdout);
        if (auto saved = saveBuilding(next, argv[1]); !saved) {
            std::fprintf(stderr, "%s\n", saved.error().text().c_str());
            return 1;
        }
        std::printf("done %d\n", version);
        std::fflush(stdout);
    }
}
