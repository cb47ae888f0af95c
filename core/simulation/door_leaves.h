#pragma once
// The door leaves of one camera's world: they open before it.

#include "core/simulation/scene_data.h"
#include "core/simulation/tracer.h"
#include "core/simulation/world.h"

namespace farol::simulation {

class DoorLeavesNow {
public:
    static Result<std::unique_ptr<DoorLeavesNow>> make(const World& world);

    /// Brings the leaves into the state that belongs to an eye at this point. `inLift`: between two floors,
    /// where lift doors stay shut.
    void update(Vec3 eye, bool inLift);
    const Mesh& mesh() const { return m_mesh; }
    RTCScene scene() const { return m_tracer->scene(); }

private:
    DoorLeavesNow(const SceneData& scene, DoorLeaves mode)
        : m_scene(scene), m_mesh(scene.leafMesh), m_mode(mode) {}
    int stepsOpen(const Leaf& leaf, Vec3 eye, bool inLift) const;
    void place(std::size_t leaf, int steps);

    static constexpr int kSteps = 24; ///< from closed to open
    const SceneData& m_scene;
    Mesh m_mesh;
    DoorLeaves m_mode;
    std::vector<int> m_open; ///< by leaf
    std::unique_ptr<Tracer> m_tracer;
};

} // namespace farol::simulation
