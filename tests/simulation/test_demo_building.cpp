#include "core/building/checks.h"
#include "core/building/geopackage.h"
#include "tests/support/same_building.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "resources/demo/demo_building.h"

namespace farol {
namespace {

building::BuildingData shipped() {
    auto loaded = building::loadBuilding(FAROL_SOURCE_DIR "/resources/demo/demo.gpkg");
    EXPECT_TRUE(loaded.ok()) << (loaded ? "" : loaded.error().text());
    if (!loaded) return {};
    EXPECT_TRUE(loaded->warnings.empty());
    return loaded->building->data();
}

template <class Items>
void sortById(Items& items) {
    std::sort(items.begin(), items.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
}

TEST(DemoBuilding, TheShippedMapIsWhatTheProgramDraws) {
    building::BuildingData drawn = demo::demoBuilding(), file = shipped();
    for (building::BuildingData* each : {&drawn, &file}) {
        sortById(each->regions);
        sortById(each->accesses);
        sortById(each->landmarks);
    }
    drawn.crs = file.crs;
    drawn.properties = file.properties;
    test::expectSame(drawn, file);
}

TEST(DemoBuilding, NothingIsWrongWithIt) {
    building::Building building(shipped());
    auto findings = building::checkBuilding(building);
    for (const building::Finding& finding : findings) ADD_FAILURE() << finding.message;
    EXPECT_EQ(building::components(building).size(), 1U);
}

TEST(DemoBuilding, EveryPlaceHasAPortugueseName) {
    building::BuildingData data = shipped();
    EXPECT_EQ(data.languages, (std::vector<std::string>{"en", "pt"}));
    for (const building::Region& region : data.regions) {
        auto found = region.extra.find("name_pt");
        ASSERT_NE(found, region.extra.end()) << region.id.value;
        ASSERT_TRUE(std::holds_alternative<std::string>(found->second));
        EXPECT_FALSE(std::get<std::string>(found->second).empty()) << region.id.value;
    }
}

} // namespace
} // namespace farol
