#pragma once
// A building one can look at: built from a map, never changed, shared by cameras.

#include "core/base/error.h"
#include "core/building/building.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace farol::recognition {
struct LandmarkLibrary;
}

namespace farol::simulation {

struct SceneData;
class Tracer;

enum class DoorLeaves {
    OpenWhenNear, ///< closed, and swung open before the camera reaches them
    Ajar,         ///< every passable door stands half open
    Closed,
    Open,
};

struct SceneOptions {
    std::uint64_t seed = 1;
    double clutter =
        0.3; ///< things that are not in the map, about so many for each 5 m2 of floor: 0 none, 1 crowded
    bool windows = true; ///< daylight also through outer walls for which the map has no windows
    DoorLeaves doors = DoorLeaves::OpenWhenNear;

    Result<void> check() const;
};

/// A point of the way over a flight of stairs; `level` rises from one ordinal to the next as CameraPose wants
/// it.
struct StairsPoint {
    Point2 position;
    double level = 0.0;
};

/// A cheap handle; copies share one world. Safe to use from any thread.
class World {
public:
    const std::shared_ptr<const building::Building>& building() const;
    const SceneOptions& options() const { return m_options; }
    /// Height of the feet above the world's zero, in metres; between two ordinals in proportion.
    double footZ(double level) const;
    /// The way over the steps that were built for an access between two levels, from its region A to its
    /// region B. Empty where no steps could be built (a lift, or stairs that are no stairwell on the map).
    std::vector<StairsPoint> stairsWay(const AccessId& access) const;
    std::size_t quadCount() const;
    std::size_t textureBytes() const;

    const SceneData& scene() const { return *m_scene; } ///< for the camera
    const Tracer& tracer() const { return *m_tracer; }

private:
    friend Result<World> buildWorld(std::shared_ptr<const building::Building>, const SceneOptions&,
                                    const recognition::LandmarkLibrary*);
    std::shared_ptr<const SceneData> m_scene;
    std::shared_ptr<const Tracer> m_tracer;
    SceneOptions m_options;
};

/// Builds the world of any map: what the map does not say (heights, widths, sizes, looks) is filled in by
/// rule from the seed. Landmarks whose template stands in `library` with a photograph show that photograph.
/// An error when the map has no region with an area, or when it is too large for memory.
Result<World> buildWorld(std::shared_ptr<const building::Building> building, const SceneOptions& options = {},
                         const recognition::LandmarkLibrary* library = nullptr);

} // namespace farol::simulation
