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
    for (std::size_t i = 0; i < scene->mesh.quads.size(); ++i) {
        std::int32_t thing = scene->mesh.surfaces[scene->mesh.surfaceOf[i]].thing;
        if (thing >= 0)
            scene->things[static_cast<std::size_t>(thing)].quads.push_back(static_cast<std::uint32_t>(i));
    }
    return scene;
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
    auto a = map.regionIndex(found->regionA), b = map.regionIndex(found->regionB);
    if (!a || !b) return {};
    for (const StairsWay& way : m_scene->stairs) {
        bool up = way.lower == *a && way.upper == *b, down = way.lower == *b && way.upper == *a;
        if (!up && !down) continue;
        std::vector<StairsPoint> points;
        for (const WayPoint& point : way.points) points.push_back({point.position, point.level});
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
