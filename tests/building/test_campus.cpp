// The synthetic campuses that other tests and the benchmarks stand on.

#include "core/building/checks.h"
#include "core/building/geopackage.h"
#include "tests/support/campus.h"
#include "tests/support/temporary_folder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace farol::building {
namespace {

using test::campusData;
using test::CampusOptions;
using test::makeCampus;

/// Regions that can be walked to, minding one-way accesses; `backwards`: from which one can be walked to.
std::size_t reached(const Building& building, bool backwards) {
    std::vector<std::size_t> found{0};
    std::vector<bool> seen(building.regions().size(), false);
    seen[0] = true;
    for (std::size_t next = 0; next < found.size(); ++next)
        for (std::size_t index : building.accessesOf(found[next])) {
            const Access& access = building.accesses()[index];
            auto other = building.otherSide(access, found[next]);
            bool forward = building.regions()[found[next]].id == access.regionA;
            OneWay against = forward != backwards ? OneWay::BToA : OneWay::AToB;
            if (!other || seen[*other] || !access.passable() || access.oneWay == against) continue;
            seen[*other] = true;
            found.push_back(*other);
        }
    return found.size();
}

class CampusOfSize : public testing::TestWithParam<std::tuple<std::size_t, double>> {};

TEST_P(CampusOfSize, IsSoundAndWhollyReachable) {
    CampusOptions options;
    options.regions = std::get<0>(GetParam());
    options.turnDegrees = std::get<1>(GetParam());
    options.origin = {595000.0, 4099000.0};
    auto campus = makeCampus(options);
    auto size = static_cast<double>(campus->regions().size());
    EXPECT_NEAR(size, double(options.regions), 0.15 * double(options.regions));
    EXPECT_EQ(reached(*campus, false), campus->regions().size());
    EXPECT_EQ(reached(*campus, true), campus->regions().size()) << "one gets back from everywhere";
    for (const Finding& finding : checkBuilding(*campus))
        EXPECT_EQ(finding.severity, Severity::Note) << finding.rule << ": " << finding.message;
    for (const auto& [from, to] : test::campusPairs(*campus, 50))
        for (const Location* end : {&from, &to})
            EXPECT_TRUE(contains(campus->region(end->region)->polygon, *end->position)) << end->region.value;
}

INSTANTIATE_TEST_SUITE_P(Sizes, CampusOfSize,
                         testing::Combine(testing::Values(100U, 300U, 1000U, 10000U),
                                          testing::Values(0.0, 31.0)));

TEST(Campus, IsSoundWithEverySeed) {
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        for (std::size_t wanted : {100U, 500U}) {
            auto campus = makeCampus({wanted, seed});
            EXPECT_NEAR(double(campus->regions().size()), double(wanted), 0.15 * double(wanted)) << seed;
            EXPECT_EQ(reached(*campus, false), campus->regions().size()) << seed;
            EXPECT_EQ(reached(*campus, true), campus->regions().size()) << seed;
            for (const Finding& finding : checkBuilding(*campus))
                EXPECT_EQ(finding.severity, Severity::Note) << seed << ": " << finding.message;
        }
    }
}

TEST(Campus, HasEverythingThatPlannersMustMind) {
    auto campus = makeCampus({1000});
    std::set<AccessKind> kinds;
    bool oneWay = false, closed = false, restricted = false, columns = false, bent = false, ring = false;
    for (const Access& access : campus->accesses()) {
        kinds.insert(access.kind);
        oneWay = oneWay || access.oneWay != OneWay::No;
        closed = closed || access.closed;
    }
    for (const Region& region : campus->regions()) {
        restricted = restricted || region.restricted;
        columns = columns || region.polygon.holes.size() > 1;
        bent = bent || (region.kind == RegionKind::Corridor && region.polygon.outer.size() == 6);
        ring = ring || (region.kind == RegionKind::Corridor && region.polygon.holes.size() == 1);
    }
    EXPECT_EQ(kinds, (std::set<AccessKind>{AccessKind::Door, AccessKind::Opening, AccessKind::Stairs,
                                           AccessKind::Elevator, AccessKind::Escalator}));
    EXPECT_TRUE(oneWay && closed && restricted && columns && bent && ring);
    EXPECT_GE(campus->levels().size(), 3U);
}

TEST(Campus, IsTheSameForTheSameSeedAndAnotherForAnother) {
    test::TemporaryFolder folder;
    std::vector<std::size_t> sizes;
    std::vector<Point2> places;
    for (std::uint32_t seed : {7U, 7U, 8U}) {
        auto campus = makeCampus({300, seed});
        sizes.push_back(campus->accesses().size());
        places.push_back(campus->accesses()[campus->accesses().size() / 2].midpoint());
    }
    EXPECT_EQ(sizes[0], sizes[1]);
    EXPECT_EQ(places[0], places[1]);
    EXPECT_TRUE(sizes[0] != sizes[2] || !(places[0] == places[2]));
}

TEST(Campus, ComesBackFromAFileAsItWas) {
    test::TemporaryFolder folder;
    CampusOptions options{300};
    options.crs = "EPSG:32629";
    options.origin = {595000.0, 4099000.0};
    auto campus = makeCampus(options);
    std::string path = (folder / "campus.gpkg").string();
    ASSERT_TRUE(saveBuilding(*campus, path).ok());
    auto loaded = loadBuilding(path);
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    EXPECT_TRUE(loaded->warnings.empty());
    ASSERT_EQ(loaded->building->regions().size(), campus->regions().size());
    ASSERT_EQ(loaded->building->accesses().size(), campus->accesses().size());
    for (const Region& region : campus->regions()) {
        const Region* read = loaded->building->region(region.id);
        ASSERT_NE(read, nullptr) << region.id.value;
        EXPECT_EQ(read->polygon.outer, region.polygon.outer) << region.id.value;
        EXPECT_EQ(read->polygon.holes, region.polygon.holes) << region.id.value;
    }
}

} // namespace
} // namespace farol::building
