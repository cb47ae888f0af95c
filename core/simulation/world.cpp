#include "core/simulation/world.h"

#include "core/simulation/hash.h"
#include "core/simulation/light_baker.h"
#include "core/simulation/scene_data.h"
#include "core/simulation/scene_parts.h"
#include "core/simulation/tracer.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace farol::simulation {

namespace {

constexpr std::size_t kMostQuads = 8'000'000; // 1 GB with their surfaces

Result<std::shared_ptr<SceneData>> assemble(std::shared_ptr<const building::Building> building,
                                            const SceneOptions& options,
                                            const recognition::LandmarkLibrary* library) {
    auto scene = std::make_shared<SceneData>();
    scene->building = std::move(building);
    scene->plan = planScene(*scene->building, options.seed, options.windows);
    bool solid = std::any_of(scene->plan.regions.begin(), scene->plan.regions.end(),
                             [](const RegionPlan& plan) { return !plan.polygon.outer.empty(); });
    if (!solid)
        return Error{ErrorCode::InvalidArgument,
                     "no region of the map has an area: there is nothing to walk in",
                     scene->building->data().title};
    scene->styles = makeStyles(*scene->building, options.seed);
    scene->textures = makeMaterials(options.seed);
    // Pictures of a map with thousands of posters are drawn coarser, so that they fit into some hundred
    // megabytes.
    constexpr double kFullSize = 300.0;
    double floors = 0.0;
    for (const RegionPlan& plan : scene->plan.regions) floors += area(plan.polygon);
    double pictures =
        static_cast<double>(scene->building->landmarks().size()) + options.clutter * floors / 12.0;
    scene->pictureScale = std::clamp(std::sqrt(kFullSize / std::max(pictures, 1.0)), 0.3, 1.0);
    planStairs(*scene);
    addRooms(*scene);
    addDrawnWalls(*scene);
    addGround(*scene);
    addLamps(*scene);
    addPortals(*scene, options);
    addStairs(*scene);
    addLifts(*scene);
    addLandmarks(*scene, options, library);
    addClutter(*scene, options);
    if (scene->mesh.quads.size() + scene->leafMesh.quads.size() > kMostQuads)
        return Error{ErrorCode::InvalidArgument,
                     "the map gives a world of " + std::to_string(scene->mesh.quads.size()) +
                         " pieces; at most 8 million fit into memory",
                     scene->building->data().title};
    constexpr std::size_t kMostThings = 65'000; // they are numbered in 16 bits
    if (scene->things.size() > kMostThings)
        return Error{ErrorCode::InvalidArgument,
                     "the map has " + std::to_string(scene->things.size()) +
                         " landmarks and doors; a simulated world holds at most 65000",
                     scene->building->data().title};
    for (std::size_t i = 0; i < scene->mesh.quads.size(); ++i) {
        std::int32_t thing = scene->mesh.surfaces[scene->mesh.surfaceOf[i]].thing;
        if (thing >= 0)
            scene->things[static_cast<std::size_t>(thing)].quads.push_back(static_cast<std::uint32_t>(i));
    }
    return scene;
}

/// Up the middle of the first flight, round on the landing, up the second.
std::vector<StairsPoint> wayOver(const StairsPlan& stairs, Point2 origin, const building::Building& map) {
    double low = map.regions()[stairs.lower].level, high = map.regions()[stairs.upper].level;
    double half = low + (high - low) * stairs.firstSteps / (stairs.firstSteps + stairs.secondSteps);
    double first = stairs.width / 4, second = stairs.width * 3 / 4;
    double end = stairs.landing + stairs.tread * (stairs.firstSteps - 1);
    double start = end - stairs.tread * (stairs.secondSteps - 1), turn = (end + stairs.far) / 2;
    std::vector<StairsPoint> points{{stairs.at(stairs.landing - 0.3, first), low},
                                    {stairs.at(stairs.landing, first), low},
                                    {stairs.at(end, first), half},
                                    {stairs.at(turn, first), half},
                                    {stairs.at(turn, second), half},
                                    {stairs.at(end, second), half},
                                    {stairs.at(start, second), high},
                                    {stairs.at(start - 0.3, second), high}};
    for (StairsPoint& point : points) point.position = point.position + origin;
    return points;
}

} // namespace

Result<void> SceneOptions::check() const {
    if (!(clutter >= 0.0 && clutter <= 3.0))
        return Error{ErrorCode::InvalidArgument, "clutter of a simulated world must lie in 0 to 3", ""};
    return {};
}

const std::shared_ptr<const building::Building>& World::building() const {
    return m_scene->building;
}

double World::footZ(double level) const {
    return m_scene->plan.storeys.footZ(level);
}

std::size_t World::quadCount() const {
    return m_scene->mesh.quads.size() + m_scene->leafMesh.quads.size();
}

std::size_t World::textureBytes() const {
    std::size_t bytes = 0;
    for (const Texture& texture : m_scene->textures) bytes += texture.bytes();
    return bytes;
}

std::vector<StairsPoint> World::stairsWay(const AccessId& access) const {
    const building::Building& map = *m_scene->building;
    const building::Access* found = map.access(access);
    if (!found) return {};
    for (const StairsPlan& stairs : m_scene->stairs) {
        if (map.accesses()[stairs.access].id != access) continue;
        std::vector<StairsPoint> points = wayOver(stairs, m_scene->plan.origin, map);
        bool down = map.regionIndex(found->regionA) == stairs.upper;
        if (down) std::reverse(points.begin(), points.end());
        return points;
    }
    return {};
}

Result<World> buildWorld(std::shared_ptr<const building::Building> building, const SceneOptions& options,
                         const recognition::LandmarkLibrary* library) {
    if (Result<void> fine = options.check(); !fine) return fine.error();
    if (!building) return Error{ErrorCode::InvalidArgument, "there is no building to simulate", ""};
    try {
        auto device = TraceDevice::open();
        if (!device) return device.error();
        auto scene = assemble(std::move(building), options, library);
        if (!scene) return scene.error();
        if (Result<void> lit = bakeLight(**scene, *device); !lit) return lit.error();
        auto tracer = Tracer::build(*device, (*scene)->mesh.vertices, (*scene)->mesh.quads, 0);
        if (!tracer) return tracer.error();
        World world;
        world.m_scene = std::move(*scene);
        world.m_tracer = std::move(*tracer);
        world.m_options = options;
        return world;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::Unavailable, "there is not enough memory for a world of this map", ""};
    } catch (const cv::Exception& failure) {
        return Error{ErrorCode::Internal,
                     std::string("a picture of the world could not be drawn: ") + failure.what(), ""};
    }
}

} // namespace farol::simulation
