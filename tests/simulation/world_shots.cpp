// A contact sheet of a world: twelve pictures from spots along its corridors and halls, to be looked at.
//   world_shots MAP OUT.png [--seed N] [--clutter C] [--singles DIR] [--poses
//   x,y,level,heading_deg[,pitch_deg];...]
//               [--time FRAMES] [--threads N] [--truth FRAMES]
// --time: frames a second on a walk through those spots. --truth: in so many random pictures, how well the
// projected corners of things agree with their pixels.

#include "core/building/geopackage.h"
#include "core/simulation/simulated_camera.h"
#include "core/simulation/world.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "truth_check.h"

using namespace farol;

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

simulation::CameraPose poseAt(Point2 p, double level, double headingDegrees) {
    simulation::CameraPose pose;
    pose.position = p;
    pose.level = level;
    pose.heading = Radians{headingDegrees * kDegree};
    pose.eyeHeightM = 1.45;
    return pose;
}

std::vector<simulation::CameraPose> givenPoses(const std::string& text) {
    std::vector<simulation::CameraPose> poses;
    std::istringstream stream(text);
    for (std::string item; std::getline(stream, item, ';');) {
        double x = 0.0, y = 0.0, level = 0.0, heading = 0.0, pitch = 0.0;
        if (std::sscanf(item.c_str(), "%lf,%lf,%lf,%lf,%lf", &x, &y, &level, &heading, &pitch) < 4) continue;
        poses.push_back(poseAt({x, y}, level, heading));
        poses.back().pitch = Radians{pitch * kDegree};
    }
    return poses;
}

/// Twelve of the regions, corridors and halls first, seen from inside along their longest view.
std::vector<simulation::CameraPose> chosenPoses(const building::Building& map) {
    std::vector<simulation::CameraPose> poses;
    std::vector<const building::Region*> order;
    for (bool ways : {true, false})
        for (const building::Region& region : map.regions()) {
            bool way = region.kind == building::RegionKind::Corridor ||
                       region.kind == building::RegionKind::Hall ||
                       region.kind == building::RegionKind::Stairwell;
            if (way == ways && region.polygon.outer.size() > 2 && area(region.polygon) > 3.0)
                order.push_back(&region);
        }
    std::size_t step = std::max<std::size_t>(1, order.size() / 12);
    for (std::size_t i = 0; i < order.size() && poses.size() < 12; i += step) {
        const building::Region& region = *order[i];
        Point2 p = pointInside(region.polygon);
        double best = 0.0, heading = 0.0;
        for (int k = 0; k < 24; ++k) {
            double angle = k * 15.0, far = 0.0;
            while (far < 40.0 &&
                   contains(region.polygon,
                            p + Point2{std::cos(angle * kDegree), std::sin(angle * kDegree)} * far))
                far += 0.3;
            if (far > best) {
                best = far;
                heading = angle;
            }
        }
        Point2 way{std::cos(heading * kDegree), std::sin(heading * kDegree)};
        for (int back = 0; back < 12 && contains(region.polygon, p - way * 1.3); ++back) p = p - way * 0.3;
        poses.push_back(poseAt(p, region.level, heading));
    }
    return poses;
}

/// Random spots, heights and angles all over the building.
simulation::CameraPose randomPose(const building::Building& map, cv::RNG& random) {
    const auto& regions = map.regions();
    while (true) {
        const building::Region& region =
            regions[static_cast<std::size_t>(random.uniform(0, static_cast<int>(regions.size())))];
        auto box = boundingBox(region.polygon.outer);
        if (!box) continue;
        Point2 p{random.uniform(box->low.x, box->high.x), random.uniform(box->low.y, box->high.y)};
        if (!contains(region.polygon, p)) continue;
        simulation::CameraPose pose = poseAt(p, region.level, random.uniform(0.0, 360.0));
        pose.pitch = Radians{random.uniform(-0.15, 0.15)};
        pose.roll = Radians{random.uniform(-0.08, 0.08)};
        pose.eyeHeightM = random.uniform(1.2, 1.6);
        return pose;
    }
}

int checkTruth(simulation::SimulatedCamera& camera, const building::Building& map, int frames) {
    cv::RNG random(7);
    std::vector<double> gaps;
    std::map<std::string, int> beyond;
    for (int i = 0; i < frames; ++i) {
        auto frame = camera.render(randomPose(map, random));
        if (!frame) return std::fprintf(stderr, "%s\n", frame.error().text().c_str()), 1;
        for (const test::CornerGap& gap : test::cornerGaps(*frame, camera.idPicture())) {
            gaps.push_back(gap.pixels);
            if (gap.pixels > 1.0) ++beyond[std::string(kindName(gap.kind))];
        }
    }
    std::sort(gaps.begin(), gaps.end());
    if (gaps.empty()) return std::fprintf(stderr, "nothing was whole in view\n"), 1;
    std::printf("%zu things in %d pictures: half within %.2f px, 99 %% within %.2f, worst %.2f\n",
                gaps.size(), frames, gaps[gaps.size() / 2], gaps[gaps.size() * 99 / 100], gaps.back());
    for (const auto& [kind, count] : beyond) std::printf("beyond 1 px: %s %d\n", kind.c_str(), count);
    return beyond.empty() ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    std::string singles, poseText;
    simulation::SceneOptions options;
    simulation::CameraOptions lens;
    int frames = 0, truths = 0;
    for (int i = 3; i + 1 < argc; i += 2) {
        std::string word = argv[i], value = argv[i + 1];
        if (word == "--seed") options.seed = std::strtoull(value.c_str(), nullptr, 10);
        if (word == "--clutter") options.clutter = std::atof(value.c_str());
        if (word == "--singles") singles = value;
        if (word == "--poses") poseText = value;
        if (word == "--time") frames = std::atoi(value.c_str());
        if (word == "--truth") truths = std::atoi(value.c_str());
        if (word == "--threads") lens.threads = std::atoi(value.c_str());
    }
    auto loaded = building::loadBuilding(argv[1]);
    if (!loaded) return std::fprintf(stderr, "%s\n", loaded.error().text().c_str()), 1;
    auto start = std::chrono::steady_clock::now();
    auto since = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    auto world = simulation::buildWorld(loaded->building, options);
    if (!world) return std::fprintf(stderr, "%s\n", world.error().text().c_str()), 1;
    std::fprintf(stderr, "built in %.2f s: %zu quads, %.1f MB of texture\n", since(), world->quadCount(),
                 static_cast<double>(world->textureBytes()) / 1e6);
    auto poses = poseText.empty() ? chosenPoses(*loaded->building) : givenPoses(poseText);
    cv::Mat sheet(3 * 360, 4 * 480, CV_8UC3, cv::Scalar::all(20));
    if (truths > 0) lens.distortionK1 = lens.distortionK2 = 0.0; // the check wants straight edges
    auto camera = simulation::SimulatedCamera::create(*world, lens);
    if (!camera) return std::fprintf(stderr, "%s\n", camera.error().text().c_str()), 1;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        camera->restart();
        auto frame = camera->render(poses[i]);
        if (!frame) return std::fprintf(stderr, "%s\n", frame.error().text().c_str()), 1;
        std::printf("%zu: region %s, %zu things\n", i, frame->truth.region.value.c_str(),
                    frame->truth.things.size());
        if (!singles.empty()) cv::imwrite(singles + "/" + std::to_string(i) + ".png", frame->image);
        if (i >= 12) continue;
        cv::Mat small;
        cv::resize(frame->image, small, {480, 360}, 0.0, 0.0, cv::INTER_AREA);
        small.copyTo(sheet(cv::Rect(static_cast<int>(i % 4) * 480, static_cast<int>(i / 4) * 360, 480, 360)));
    }
    cv::imwrite(argv[2], sheet);
    if (frames > 0) {
        start = std::chrono::steady_clock::now();
        std::clock_t cpu = std::clock();
        for (int i = 0; i < frames; ++i) {
            simulation::CameraPose pose = poses[static_cast<std::size_t>(i) % poses.size()];
            pose.time = i / 15.0;
            pose.speed = 1.0;
            pose.heading = Radians{pose.heading.value + 0.05 * (i / static_cast<int>(poses.size()))};
            pose.turnRate = Radians{0.5};
            if (auto frame = camera->render(pose); !frame) return 1;
        }
        std::fprintf(stderr, "%.1f frames a second, %.1f ms CPU a frame\n", frames / since(),
                     1000.0 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / frames);
    }
    return truths > 0 ? checkTruth(*camera, *loaded->building, truths) : 0;
}
