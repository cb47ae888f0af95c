#include "core/building/geopackage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulated_places.h"

namespace farol::simulation {
namespace {

using test::bareScene;
using test::cameraIn;
using test::find;
using test::look;
using test::standing;
using test::worldOf;

/// Mean absolute difference of two pictures in grey values.
double difference(const cv::Mat& a, const cv::Mat& b) {
    return cv::norm(a, b, cv::NORM_L1) / (3.0 * static_cast<double>(a.total()));
}

TEST(World, RefusesAMapWithoutAnyFloor) {
    building::BuildingData data;
    auto none = buildWorld(std::make_shared<const building::Building>(data));
    ASSERT_FALSE(none.ok());
    EXPECT_THAT(none.error().message, testing::HasSubstr("no region of the map has an area"));

    data.regions.resize(1);
    data.regions[0].id = RegionId("line");
    data.regions[0].polygon.outer = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
    EXPECT_FALSE(buildWorld(std::make_shared<const building::Building>(data)).ok());
    EXPECT_FALSE(buildWorld(nullptr).ok());
}

TEST(World, RefusesOptionsThatMakeNoSense) {
    SceneOptions options;
    options.clutter = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(options.check().ok());
    auto world = worldOf(test::corridorMap());
    CameraOptions camera;
    camera.raysPerPixel = 3;
    EXPECT_FALSE(SimulatedCamera::create(world, camera).ok());
    camera = {};
    camera.size = {0, 480};
    EXPECT_FALSE(SimulatedCamera::create(world, camera).ok());
}

TEST(World, OfOneRoomIsARoom) {
    building::BuildingData data;
    data.regions.resize(1);
    data.regions[0].id = RegionId("room");
    data.regions[0].polygon.outer = {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0}, {0.0, 4.0}};
    auto world = worldOf(data);
    auto camera = cameraIn(world);
    for (double heading : {0.0, 90.0, 200.0}) {
        RenderedFrame frame = look(camera, standing({2.5, 2.0}, 0.0, heading));
        EXPECT_EQ(frame.truth.region, RegionId("room"));
        double light = test::brightness(frame.image, {0, 0, 640, 480});
        EXPECT_GT(light, 60.0);
        EXPECT_LT(light, 230.0);
    }
}

TEST(World, OfADamagedMapStillGivesPictures) {
    building::BuildingData data = test::corridorMap();
    // Overlapping regions, a bow tie, a door without width far from any wall, a door of no width, an unknown
    // side, landmarks nowhere, and coordinates that are no numbers.
    data.regions.push_back(data.regions[1]);
    data.regions.back().id = RegionId("office-again");
    building::Region bow = data.regions[0];
    bow.id = RegionId("bow");
    bow.polygon.outer = {{20.0, 0.0}, {24.0, 4.0}, {24.0, 0.0}, {20.0, 4.0}};
    data.regions.push_back(bow);
    building::Access odd = data.accesses[0];
    odd.id = AccessId("pinhole");
    odd.line = {{6.0, 2.4}, {6.0, 2.4}};
    odd.widthM = 0.0;
    data.accesses.push_back(odd);
    odd.id = AccessId("lost");
    odd.line = {{300.0, 2.4}};
    data.accesses.push_back(odd);
    odd.id = AccessId("one-sided");
    odd.regionB = RegionId("nobody");
    odd.line = {{0.0, 1.0}, {0.0, 1.8}};
    data.accesses.push_back(odd);
    odd.id = AccessId("nan");
    odd.line = {{std::nan(""), 1.0}};
    data.accesses.push_back(odd);
    building::Landmark stray = data.landmarks[0];
    stray.id = LandmarkId("stray");
    stray.region = RegionId("nobody");
    stray.position = {1.0e7, -4.0};
    data.landmarks.push_back(stray);
    stray.position = {std::nan(""), 0.0};
    stray.id = LandmarkId("nan");
    data.landmarks.push_back(stray);
    data.walls.push_back({0.0, {{5.2, 3.0}, {10.0, 6.0}, {std::nan(""), 0.0}}, {}});

    SceneOptions options;
    options.clutter = 1.0;
    auto world = worldOf(data, options);
    auto camera = cameraIn(world);
    for (Point2 at : {Point2{2.0, 1.2}, Point2{8.0, 5.0}, Point2{22.0, 1.0}})
        EXPECT_GT(test::brightness(look(camera, standing(at, 0.0, 30.0)).image, {0, 0, 640, 480}), 30.0);
}

TEST(World, IsSeenThroughAnOpenDoorAndNotThroughAClosedOne) {
    auto pose = standing({8.0, 0.8}, 0.0, 90.0);
    auto closed = worldOf(test::corridorMap(), bareScene(DoorLeaves::Closed));
    auto open = worldOf(test::corridorMap(), bareScene(DoorLeaves::Open));
    auto outside = cameraIn(closed), inside = cameraIn(open);
    EXPECT_EQ(find(look(outside, pose).truth, "board"), nullptr);
    const FrameTruth truth = look(inside, pose).truth;
    const SeenThing* board = find(truth, "board");
    ASSERT_NE(board, nullptr);
    EXPECT_NEAR(board->rangeM, 6.6, 0.15);
    EXPECT_GT(board->visibleShare, 0.5);
}

TEST(World, OpensDoorsBeforeWhoComesNear) {
    auto world = worldOf(test::corridorMap(), bareScene(DoorLeaves::OpenWhenNear));
    auto camera = cameraIn(world);
    EXPECT_EQ(find(look(camera, standing({4.0, 1.2}, 0.0, 30.0)).truth, "board"), nullptr);
    EXPECT_NE(find(look(camera, standing({8.0, 1.5}, 0.0, 90.0)).truth, "board"), nullptr);
    // A door that is locked stays shut.
    auto data = test::corridorMap();
    data.accesses[0].closed = true;
    auto locked = cameraIn(worldOf(data, bareScene(DoorLeaves::OpenWhenNear)));
    EXPECT_EQ(find(look(locked, standing({8.0, 1.5}, 0.0, 90.0)).truth, "board"), nullptr);
}

TEST(World, WithoutMeasuresHeadingsOrNamedSidesIsMuchTheSame) {
    auto data = test::corridorMap();
    data.levels.clear();
    for (building::Landmark& landmark : data.landmarks) {
        landmark.heading.reset();
        landmark.region = RegionId();
        landmark.position.y += landmark.position.y < 1.0 ? 0.05 : -0.05; // on the border it might be either's
    }
    data.accesses[0].line = {{8.0, 2.4}}; // a point instead of a width
    data.accesses[0].regionA = data.accesses[0].regionB = RegionId();
    auto camera = cameraIn(worldOf(data, bareScene(DoorLeaves::Open)));
    auto through = look(camera, standing({8.0, 0.8}, 0.0, 90.0)).truth;
    EXPECT_NE(find(through, "board"), nullptr);
    auto along = look(camera, standing({1.0, 0.6}, 0.0, 5.0)).truth;
    for (const char* id : {"red", "show", "plate", "way-out", "snacks"})
        EXPECT_NE(find(along, id), nullptr) << id;
}

TEST(World, LooksTheSameForTheSameSeedAndDifferentForAnother) {
    auto pose = standing({2.0, 1.2}, 0.0, 0.0);
    SceneOptions options;
    auto first = worldOf(test::corridorMap(), options), again = worldOf(test::corridorMap(), options);
    options.seed = 2;
    auto other = worldOf(test::corridorMap(), options);
    auto a = cameraIn(first), b = cameraIn(again), c = cameraIn(other);
    cv::Mat seen = look(a, pose).image;
    EXPECT_EQ(difference(seen, look(b, pose).image), 0.0);
    EXPECT_GT(difference(seen, look(c, pose).image), 5.0);
}

TEST(World, PostersDifferAndSharedTemplatesAreAlike) {
    auto data = test::corridorMap();
    data.landmarks.clear();
    for (int i = 0; i < 4; ++i) {
        building::Landmark poster;
        poster.id = LandmarkId("poster-" + std::to_string(i));
        poster.kind = Kind::Poster;
        poster.region = RegionId("corridor");
        poster.position = {2.0 + 2.0 * i + (i > 2 ? 4.0 : 0.0), 0.0};
        poster.widthM = 0.6;
        poster.tallM = 0.8;
        if (i < 2) poster.templateId = TemplateId("shared");
        data.landmarks.push_back(poster);
    }
    CameraOptions still;
    still.noise = 0.0;
    still.jpegQuality = 0;
    still.adaptExposure = false;
    auto camera = cameraIn(worldOf(data), still);
    std::vector<cv::Mat> posters;
    for (const building::Landmark& poster : data.landmarks)
        posters.push_back(look(camera, standing({poster.position.x, 1.6}, 0.0, 270.0))
                              .image(cv::Rect(250, 160, 140, 160))
                              .clone());
    EXPECT_LT(difference(posters[0], posters[1]), 12.0);
    EXPECT_GT(difference(posters[1], posters[2]), 25.0);
    EXPECT_GT(difference(posters[2], posters[3]), 25.0);
}

TEST(World, HasStairsThatLeadFromFloorToFloor) {
    auto world = worldOf(test::stairsMap(), bareScene(DoorLeaves::Closed));
    auto way = world.stairsWay(AccessId("flight"));
    ASSERT_GE(way.size(), 4U);
    EXPECT_EQ(way.front().level, 0.0);
    EXPECT_EQ(way.back().level, 1.0);
    auto camera = cameraIn(world);
    for (std::size_t i = 1; i < way.size(); ++i) {
        EXPECT_GE(way[i].level, way[i - 1].level);
        EXPECT_TRUE(contains(world.building()->region(RegionId("stairs-low"))->polygon, way[i].position));
        // Nobody's eyes are in the concrete: there is something to see at every point of the way.
        Point2 step = way[i].position - way[i - 1].position;
        auto pose =
            standing((way[i].position + way[i - 1].position) * 0.5, (way[i].level + way[i - 1].level) / 2,
                     directionOf(step).value * 180.0 / 3.14159265358979);
        EXPECT_GT(test::brightness(look(camera, pose).image, {0, 0, 640, 480}), 40.0) << i;
    }
    EXPECT_TRUE(world.stairsWay(AccessId("door-low")).empty());
    EXPECT_TRUE(world.stairsWay(AccessId("unknown")).empty());
}

TEST(World, OfAMapWithLevelsInTheWrongOrderHasThemAboveEachOther) {
    auto data = test::stairsMap();
    data.levels.push_back({0.0, "", "", 10.0, 2.7, {}});
    data.levels.push_back({1.0, "", "", 3.0, std::nan(""), {}});
    auto world = worldOf(data);
    EXPECT_GT(world.footZ(1.0), world.footZ(0.0) + 2.0);
    EXPECT_NEAR(world.footZ(0.5), (world.footZ(0.0) + world.footZ(1.0)) / 2, 1e-9);
}

TEST(World, OfTheDemoBuildingIsBuiltWhole) {
    auto demo = building::loadBuilding(std::string(FAROL_SOURCE_DIR) + "/resources/demo/demo.gpkg");
    ASSERT_TRUE(demo.ok()) << demo.error().text();
    auto world = worldOf(demo->building, SceneOptions{});
    EXPECT_GT(world.quadCount(), 10000U);
    EXPECT_LT(world.textureBytes(), 250'000'000U);
    for (const building::Access& access : demo->building->accesses()) {
        bool stairs = access.kind == building::AccessKind::Stairs;
        EXPECT_EQ(world.stairsWay(access.id).empty(), !stairs) << access.id.value;
    }
}

} // namespace
} // namespace farol::simulation
