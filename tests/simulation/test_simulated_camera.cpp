#include "core/recognition/door_detector.h"
#include "core/simulation/lens.h"
#include "core/simulation/path_camera.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulated_places.h"
#include "truth_check.h"

namespace farol::simulation {
namespace {

using test::bareScene;
using test::cameraIn;
using test::find;
using test::look;
using test::standing;
using test::worldOf;

bool same(const cv::Mat& a, const cv::Mat& b) {
    return a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

/// A walk with turns, so that all of exposure, blur and shake have work to do.
std::vector<cv::Mat> walk(const World& world, CameraOptions options) {
    options.shake = Shake::Chest;
    auto camera = cameraIn(world, options);
    std::vector<cv::Mat> frames;
    for (int i = 0; i < 4; ++i) {
        CameraPose pose = standing({3.0 + i * 1.5, 1.2}, 0.0, 20.0 * i);
        pose.time = i * 0.5;
        pose.speed = 1.1;
        pose.turnRate = Radians{0.7};
        frames.push_back(look(camera, pose).image);
    }
    return frames;
}

TEST(SimulatedCamera, GivesTheSameBytesAtAnyThreadCount) {
    SceneOptions scene;
    scene.clutter = 0.5;
    auto world = worldOf(test::corridorMap(), scene);
    CameraOptions options;
    options.size = {322, 243}; // not a whole number of packets
    options.threads = 1;
    auto first = walk(world, options), again = walk(world, options);
    options.threads = 2;
    auto two = walk(world, options);
    options.threads = 5;
    auto five = walk(world, options);
    options.seed = 2;
    auto other = walk(world, options);
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_TRUE(same(first[i], again[i])) << i;
        EXPECT_TRUE(same(first[i], two[i])) << i;
        EXPECT_TRUE(same(first[i], five[i])) << i;
        EXPECT_FALSE(same(first[i], other[i])) << i;
    }
    EXPECT_FALSE(same(first[0], first[1]));
}

TEST(SimulatedCamera, StartsAgainAsIfNothingHadBeen) {
    auto world = worldOf(test::corridorMap());
    auto camera = cameraIn(world);
    auto pose = standing({3.0, 1.2}, 0.0, 0.0);
    cv::Mat first = look(camera, pose).image;
    EXPECT_FALSE(same(first, look(camera, pose).image)); // other noise
    camera.restart();
    EXPECT_TRUE(same(first, look(camera, pose).image));
}

TEST(SimulatedCamera, RefusesAPoseThatIsNone) {
    auto camera = cameraIn(worldOf(test::corridorMap()));
    CameraPose pose = standing({1.0, 1.0}, 0.0, 0.0);
    pose.position.x = std::nan("");
    EXPECT_FALSE(camera.render(pose).ok());
    pose = standing({1.0, 1.0}, 0.0, 0.0);
    pose.eyeHeightM = 40.0;
    EXPECT_FALSE(camera.render(pose).ok());
}

TEST(SimulatedCamera, SeesThingsWhereTheyAre) {
    auto camera = cameraIn(worldOf(test::corridorMap()));
    auto frame = look(camera, standing({12.0, 0.4}, 0.0, 90.0));
    const SeenThing* poster = find(frame.truth, "show");
    ASSERT_NE(poster, nullptr);
    EXPECT_EQ(poster->kind, Kind::Poster);
    EXPECT_NEAR(poster->rangeM, 1.95, 0.1);
    EXPECT_NEAR(poster->bearing.value, 0.0, 0.02);
    EXPECT_NEAR(poster->angle.value, 0.0, 0.1);
    EXPECT_GT(poster->visibleShare, 0.95);
    EXPECT_NEAR(boundingBox(poster->quad).centre().x, 320.0, 3.0);
    // Something on the left has a positive bearing; an extinguisher is red.
    frame = look(camera, standing({10.6, 0.6}, 0.0, 90.0));
    const SeenThing* red = find(frame.truth, "red");
    ASSERT_NE(red, nullptr);
    EXPECT_GT(red->bearing.value, 0.15);
    ImageBox box = boundingBox(red->quad);
    cv::Rect shoulder(static_cast<int>(box.x + 0.3 * box.width), static_cast<int>(box.y + 0.25 * box.height),
                      static_cast<int>(0.4 * box.width), static_cast<int>(0.06 * box.height) + 1);
    cv::Scalar colour = cv::mean(frame.image(shoulder));
    EXPECT_GT(colour[2], 1.8 * colour[1]);
}

TEST(SimulatedCamera, TellsTheTruthAboutAHiddenThing) {
    auto data = test::corridorMap();
    auto camera = cameraIn(worldOf(data));
    auto pose = standing({8.0, 5.0}, 0.0, 270.0); // in the office, behind the closed door
    for (const SeenThing& thing : look(camera, pose).truth.things)
        EXPECT_TRUE(thing.landmark.empty()) << thing.landmark.value;
    // Half beyond the edge of the picture: about half is seen.
    pose = standing({12.0, 0.4}, 0.0, 90.0 - 31.5);
    const FrameTruth truth = look(camera, pose).truth;
    const SeenThing* poster = find(truth, "show");
    ASSERT_NE(poster, nullptr);
    EXPECT_NEAR(poster->visibleShare, 0.5, 0.12);
}

TEST(SimulatedCamera, OutsideAllRegionsShowsTheBuildingAndNamesNoRegion) {
    auto camera = cameraIn(worldOf(test::corridorMap()));
    auto frame = look(camera, standing({-14.0, 1.2}, 0.0, 0.0));
    EXPECT_TRUE(frame.truth.region.empty());
    EXPECT_TRUE(frame.truth.things.empty());
    double sky = test::brightness(frame.image, {0, 0, 640, 60});
    EXPECT_GT(sky, 140.0);
    // Far above all storeys, and deep below, there is a picture too.
    for (double level : {40.0, -40.0})
        EXPECT_TRUE(look(camera, standing({4.0, 1.2}, level, 0.0)).truth.things.size() < 20);
}

TEST(SimulatedCamera, ProjectedCornersAgreeWithTheIdPicture) {
    auto data = test::corridorMap();
    for (int i = 0; i < 8; ++i) {
        building::Landmark poster = data.landmarks[1];
        poster.id = LandmarkId("more-" + std::to_string(i));
        poster.position.x = i < 2 ? 3.0 + 1.5 * i : 9.3 + 0.9 * i;
        data.landmarks.push_back(poster);
    }
    CameraOptions straight;
    straight.distortionK1 = straight.distortionK2 = 0.0;
    auto camera = cameraIn(worldOf(data), straight);
    int checked = 0;
    for (int i = 0; i < 40; ++i) {
        CameraPose pose = standing({1.5 + 0.33 * i, 0.5 + 0.03 * i}, 0.0, 40.0 + 2.5 * i);
        pose.pitch = Radians{0.01 * (i % 7 - 3)};
        pose.roll = Radians{0.015 * (i % 5 - 2)};
        RenderedFrame frame = look(camera, pose);
        for (const test::CornerGap& gap : test::cornerGaps(frame, camera.idPicture())) {
            EXPECT_LE(gap.pixels, 1.0) << "picture " << i << ", " << kindName(gap.kind);
            ++checked;
        }
    }
    EXPECT_GT(checked, 20);
}

TEST(SimulatedCamera, LensBendsRaysAndPointsAlike) {
    Lens lens({640, 480}, 63.0, -0.2, 0.05);
    for (double x : {0.5, 100.0, 320.0, 639.5}) {
        for (double y : {0.5, 240.0, 479.5}) {
            ImagePoint ray = lens.rayOf({x, y});
            auto back = lens.project(ray.x * 3.0, ray.y * 3.0, 3.0);
            ASSERT_TRUE(back.has_value());
            EXPECT_NEAR(back->x, x, 0.02);
            EXPECT_NEAR(back->y, y, 0.02);
        }
    }
    EXPECT_FALSE(lens.project(0.1, 0.1, -1.0).has_value());
}

TEST(SimulatedCamera, SmearsWhatMoves) {
    auto world = worldOf(test::corridorMap());
    CameraOptions options;
    options.noise = 0.0;
    auto camera = cameraIn(world, options);
    auto sharpness = [](const cv::Mat& image) {
        cv::Mat grey, edges;
        cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
        cv::Sobel(grey, edges, CV_32F, 1, 0);
        return cv::norm(edges, cv::NORM_L2);
    };
    CameraPose pose = standing({12.0, 0.4}, 0.0, 90.0);
    double still = sharpness(look(camera, pose).image);
    pose.turnRate = Radians{1.2};
    double turning = sharpness(look(camera, pose).image);
    pose.turnRate = Radians{0.0};
    pose.speed = 1.2; // straight at the wall: little moves sideways
    double walking = sharpness(look(camera, pose).image);
    EXPECT_LT(turning, 0.75 * still);
    EXPECT_GT(walking, turning);
}

TEST(SimulatedCamera, AdaptsToTheLightWithSomeDelay) {
    auto world = worldOf(test::corridorMap());
    CameraOptions dark;
    dark.lightsOut = true;
    auto lit = cameraIn(world), unlit = cameraIn(world, dark);
    auto pose = standing({3.0, 1.2}, 0.0, 0.0);
    double bright = test::brightness(look(lit, pose).image, {0, 0, 640, 480});
    double dim = test::brightness(look(unlit, pose).image, {0, 0, 640, 480});
    EXPECT_GT(bright, 80.0);
    EXPECT_LT(dim, 0.75 * bright);

    // From a window into the corridor: dark at first.
    auto camera = cameraIn(worldOf(test::corridorMap()));
    CameraPose outside = standing({-6.0, 1.2}, 0.0, 180.0);
    look(camera, outside);
    pose.time = 0.05;
    double first = test::brightness(look(camera, pose).image, {0, 0, 640, 480});
    for (int i = 0; i < 20; ++i) {
        pose.time += 0.2;
        look(camera, pose);
    }
    pose.time += 0.2;
    EXPECT_GT(test::brightness(look(camera, pose).image, {0, 0, 640, 480}), first + 15.0);
}

TEST(SimulatedCamera, ShowsADoorThatTheDetectorTakesForOne) {
    SceneOptions scene = bareScene();
    int found = 0, asked = 0, truths = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        scene.seed = seed;
        auto camera = cameraIn(worldOf(test::corridorMap(), scene));
        for (double aside : {-0.9, 0.0, 0.9}) {
            CameraPose pose = standing({8.0 + aside, -0.2 + 0.4}, 0.0, 90.0 + 25.0 * aside);
            auto frame = look(camera, pose);
            for (const SeenThing& thing : frame.truth.things) {
                if (thing.access != AccessId("office-door") || thing.visibleShare < 0.6) continue;
                ++truths;
                auto seen = recognition::detectDoors(frame.image);
                ++asked;
                found += std::any_of(
                    seen.detections.begin(), seen.detections.end(), [&](const recognition::Detection& door) {
                        return overlap(boundingBox(door.quad), boundingBox(thing.quad)) > 0.5;
                    });
            }
        }
    }
    EXPECT_GT(truths, 6);
    EXPECT_GT(found, 0) << "of " << asked;
}

TEST(PathCamera, DeliversAFrameForEachPoseAndSkipsWhatIsNone) {
    auto world = worldOf(test::corridorMap());
    CameraPose from = standing({2.0, 1.2}, 0.0, 90.0), to = standing({4.0, 1.2}, 0.0, 0.0);
    auto poses = walkThrough({from, to}, 1.0, 2.0);
    ASSERT_GT(poses.size(), 4U);
    EXPECT_EQ(poses.front().heading.value, from.heading.value);
    EXPECT_NEAR(poses.back().position.x, 4.0, 1e-9);
    poses[1].position.x = std::nan("");
    std::size_t count = poses.size();
    PathCamera source(cameraIn(world), poses);
    int skipped = 0;
    source.onEvent([&](const capture::SourceEvent&) { ++skipped; });
    std::uint64_t delivered = 0;
    double last = -1.0;
    while (auto frame = source.next()) {
        EXPECT_EQ(frame->index, delivered++);
        EXPECT_GT(frame->capturedAt, last);
        last = frame->capturedAt;
        EXPECT_EQ(frame->size(), (ImageSize{640, 480}));
        EXPECT_EQ(source.truth().region, RegionId("corridor"));
    }
    EXPECT_EQ(delivered, count - 1);
    EXPECT_EQ(skipped, 1);
    EXPECT_EQ(source.skippedFrames(), 1U);
}

} // namespace
} // namespace farol::simulation
