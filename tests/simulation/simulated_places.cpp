#include "simulated_places.h"

#include <opencv2/imgproc.hpp>

#include <stdexcept>
#include <utility>

namespace farol::test {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

building::Region region(const char* id, double level, building::RegionKind kind, Point2 low, Point2 high) {
    building::Region out;
    out.id = RegionId(id);
    out.name = id;
    out.level = level;
    out.kind = kind;
    out.polygon.outer = {low, {high.x, low.y}, high, {low.x, high.y}};
    return out;
}

building::Access access(const char* id, building::AccessKind kind, double level, const char* a, const char* b,
                        Polyline line) {
    building::Access out;
    out.id = AccessId(id);
    out.kind = kind;
    out.level = level;
    out.regionA = RegionId(a);
    out.regionB = RegionId(b);
    out.line = std::move(line);
    return out;
}

building::Landmark landmark(const char* id, Kind kind, const char* in, Point2 at, double headingDegrees) {
    building::Landmark out;
    out.id = LandmarkId(id);
    out.kind = kind;
    out.region = RegionId(in);
    out.position = at;
    out.heading = Radians{headingDegrees * kDegree};
    return out;
}

} // namespace

simulation::SceneOptions bareScene(simulation::DoorLeaves doors) {
    simulation::SceneOptions options;
    options.clutter = 0.0;
    options.windows = false;
    options.doors = doors;
    return options;
}

simulation::CameraPose standing(Point2 at, double level, double headingDegrees) {
    simulation::CameraPose pose;
    pose.position = at;
    pose.level = level;
    pose.heading = Radians{headingDegrees * kDegree};
    return pose;
}

simulation::World worldOf(std::shared_ptr<const building::Building> building,
                          const simulation::SceneOptions& options) {
    auto world = simulation::buildWorld(std::move(building), options);
    if (!world) throw std::runtime_error(world.error().text());
    return *world;
}

simulation::World worldOf(building::BuildingData data, const simulation::SceneOptions& options) {
    return worldOf(std::make_shared<const building::Building>(std::move(data)), options);
}

simulation::SimulatedCamera cameraIn(const simulation::World& world,
                                     const simulation::CameraOptions& options) {
    auto camera = simulation::SimulatedCamera::create(world, options);
    if (!camera) throw std::runtime_error(camera.error().text());
    return std::move(*camera);
}

simulation::RenderedFrame look(simulation::SimulatedCamera& camera, const simulation::CameraPose& pose) {
    auto frame = camera.render(pose);
    if (!frame) throw std::runtime_error(frame.error().text());
    return std::move(*frame);
}

const simulation::SeenThing* find(const simulation::FrameTruth& truth, const char* landmark) {
    for (const simulation::SeenThing& thing : truth.things)
        if (thing.landmark == LandmarkId(landmark)) return &thing;
    return nullptr;
}

building::BuildingData corridorMap() {
    using building::AccessKind;
    using building::RegionKind;
    building::BuildingData data;
    data.levels.push_back({0.0, "Ground floor", "0", 0.0, 2.7, {}});
    data.regions.push_back(region("corridor", 0.0, RegionKind::Corridor, {0.0, 0.0}, {16.0, 2.4}));
    data.regions.push_back(region("office", 0.0, RegionKind::Room, {5.0, 2.4}, {11.0, 7.4}));
    data.accesses.push_back(
        access("office-door", AccessKind::Door, 0.0, "corridor", "office", {{7.5, 2.4}, {8.5, 2.4}}));
    data.landmarks.push_back(landmark("red", Kind::Extinguisher, "corridor", {10.0, 2.4}, 270.0));
    data.landmarks.push_back(landmark("show", Kind::Poster, "corridor", {12.0, 2.4}, 270.0));
    data.landmarks.push_back(landmark("other-show", Kind::Poster, "corridor", {6.0, 0.0}, 90.0));
    data.landmarks.push_back(landmark("plate", Kind::Text, "corridor", {9.0, 2.4}, 270.0));
    data.landmarks.back().text = "2.14";
    data.landmarks.push_back(landmark("way-out", Kind::ExitSign, "corridor", {16.0, 1.2}, 180.0));
    data.landmarks.push_back(landmark("snacks", Kind::VendingMachine, "corridor", {13.0, 0.0}, 90.0));
    data.landmarks.push_back(landmark("board", Kind::Picture, "office", {8.0, 7.4}, 270.0));
    return data;
}

building::BuildingData stairsMap() {
    using building::AccessKind;
    using building::RegionKind;
    building::BuildingData data;
    for (double level : {0.0, 1.0}) {
        std::string tag = level < 0.5 ? "low" : "high";
        data.regions.push_back(
            region(("hall-" + tag).c_str(), level, RegionKind::Hall, {-6.0, 0.0}, {0.0, 4.0}));
        data.regions.push_back(
            region(("stairs-" + tag).c_str(), level, RegionKind::Stairwell, {0.0, 0.0}, {6.0, 4.0}));
        data.accesses.push_back(access(("door-" + tag).c_str(), AccessKind::Door, level,
                                       ("hall-" + tag).c_str(), ("stairs-" + tag).c_str(),
                                       {{0.0, 1.0}, {0.0, 2.0}}));
    }
    data.accesses.push_back(
        access("flight", AccessKind::Stairs, 0.0, "stairs-low", "stairs-high", {{3.0, 1.0}}));
    return data;
}

double brightness(const cv::Mat& image, const cv::Rect& part) {
    cv::Mat grey;
    cv::cvtColor(image(part), grey, cv::COLOR_BGR2GRAY);
    return cv::mean(grey)[0];
}

} // namespace farol::test
