// What the chain behind the picture costs, on a building of a size that people work in.

#include "core/localisation/scene_context.h"
#include "core/session/json_lines.h"
#include "core/session/navigator.h"

#include <opencv2/imgproc.hpp>

#include <benchmark/benchmark.h>
#include <string>

namespace farol::bench {

namespace {

using building::Access;
using building::AccessKind;
using building::BuildingData;
using building::Landmark;
using building::Region;

std::string regionName(int row, int column) {
    return "r" + std::to_string(row) + "-" + std::to_string(column);
}

void addDoor(BuildingData& data, const std::string& a, const std::string& b, Point2 from, Point2 to) {
    Access door;
    door.id = AccessId(a + "/" + b);
    door.kind = AccessKind::Door;
    door.regionA = RegionId(a);
    door.regionB = RegionId(b);
    door.line = {from, to};
    data.accesses.push_back(std::move(door));
}

/// Rooms of 5 m in a square, doors to all four sides, an extinguisher in each.
std::shared_ptr<const building::Building> gridBuilding(int side) {
    constexpr double kRoomM = 5.0;
    BuildingData data;
    data.levels.push_back({});
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            double x = column * kRoomM;
            double y = row * kRoomM;
            Region region;
            region.id = RegionId(regionName(row, column));
            region.polygon.outer = {{x, y}, {x + kRoomM, y}, {x + kRoomM, y + kRoomM}, {x, y + kRoomM}};
            Landmark landmark;
            landmark.id = LandmarkId("l" + region.id.value);
            landmark.kind = Kind::Extinguisher;
            landmark.templateId = TemplateId("t" + std::to_string((row * side + column) % 40));
            landmark.region = region.id;
            landmark.position = {x + 1.0, y + 1.0};
            data.landmarks.push_back(std::move(landmark));
            if (column + 1 < side)
                addDoor(data, region.id.value, regionName(row, column + 1), {x + kRoomM, y + 2.0},
                        {x + kRoomM, y + 3.0});
            if (row + 1 < side)
                addDoor(data, region.id.value, regionName(row + 1, column), {x + 2.0, y + kRoomM},
                        {x + 3.0, y + kRoomM});
            data.regions.push_back(std::move(region));
        }
    }
    return std::make_shared<const building::Building>(std::move(data));
}

session::Percept perceptAt(std::uint64_t frame) {
    session::Percept percept;
    percept.frame = frame;
    percept.time = static_cast<double>(frame) / 15.0;
    percept.scene = static_cast<int>(frame / 10);
    percept.size = {1280, 720};
    recognition::Detection detection;
    detection.kind = Kind::Extinguisher;
    detection.templateId = TemplateId("t" + std::to_string(frame / 20 % 40));
    detection.quad = quadOf({300.0, 200.0, 80.0, 160.0});
    detection.image = percept.size;
    detection.score = 0.9;
    percept.detections.push_back(std::move(detection));
    return percept;
}

void advanceNavigator(benchmark::State& state) {
    auto navigator = session::Navigator::create(gridBuilding(static_cast<int>(state.range(0))));
    if (!navigator) return state.SkipWithError(navigator.error().text().c_str());
    (*navigator)->start(0.0, RegionId("r0-0"));
    (*navigator)->setDestination(building::Location{RegionId(regionName(0, 3)), std::nullopt});
    std::uint64_t frame = 0;
    for (auto _ : state) benchmark::DoNotOptimize((*navigator)->advance(perceptAt(frame++)));
}
BENCHMARK(advanceNavigator)->Name("Navigator/advance")->Arg(5)->Arg(15)->Arg(30);

void planRoute(benchmark::State& state) {
    auto side = static_cast<int>(state.range(0));
    auto planner = routing::makeOptimalPlanner(gridBuilding(side));
    building::Location from{RegionId("r0-0"), std::nullopt};
    building::Location to{RegionId(regionName(side - 1, side - 1)), std::nullopt};
    for (auto _ : state) benchmark::DoNotOptimize(planner->plan(from, to));
}
BENCHMARK(planRoute)->Name("Planner/optimal")->Arg(5)->Arg(15)->Arg(30)->Unit(benchmark::kMillisecond);

void writeLines(benchmark::State& state) {
    session::NavigationStep step;
    step.percept = perceptAt(7);
    for (int i = 0; i < 20; ++i)
        step.fix.votes.push_back({RegionId(regionName(0, i)), 1.0 / (i + 1), {{"Pobj", 3.0}}, {}});
    for (auto _ : state) benchmark::DoNotOptimize(session::linesOf(step, nullptr));
}
BENCHMARK(writeLines)->Name("Json/lines_of_a_frame");

void readPercept(benchmark::State& state) {
    std::string text = session::dumped(session::perceptJson(perceptAt(7)));
    for (auto _ : state) benchmark::DoNotOptimize(session::perceptFromJson(*session::parsedJson(text)));
}
BENCHMARK(readPercept)->Name("Json/read_percept");

void observeScene(benchmark::State& state) {
    cv::Mat image(720, 1280, CV_8UC3);
    cv::randu(image, 0, 255);
    localisation::SceneContext scene;
    for (auto _ : state) benchmark::DoNotOptimize(scene.observe(image));
}
BENCHMARK(observeScene)->Name("Scene/observe_1280x720")->Unit(benchmark::kMillisecond);

} // namespace

} // namespace farol::bench
