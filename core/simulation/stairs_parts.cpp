#include "core/simulation/scene_parts.h"

namespace farol::simulation {

Polygon stairsLanding(const SceneData& scene, std::size_t region) {
    return scene.plan.regions[region].polygon;
}
void addStairs(SceneData&) {}
void addLifts(SceneData&) {}
void addClutter(SceneData&, const SceneOptions&) {}

} // namespace farol::simulation
