#pragma once
// The sources of simulated walks: worlds are built and kept here, on whatever thread opens a source.

#include "core/simulation/walk_source.h"

#include <QString>

#include <memory>
#include <mutex>
#include <optional>

namespace farol::ui {

/// What the next walk is like.
struct WalkPlan {
    std::shared_ptr<const building::Building> building;
    RegionId from;
    std::uint64_t seed = 1;
    double mostSeconds = 600.0;
    double afterArrivalS = 6.0; ///< who has arrived is looked at for so long, and may be given another way
};

class SimulatedWalks {
public:
    // From any thread.
    void plan(WalkPlan plan);
    /// A source that walks as planned; slow when the world has to be built first.
    Result<std::unique_ptr<capture::FrameSource>> open();
    /// The newest source; null before the first one.
    std::shared_ptr<simulation::WalkSource> current() const;

private:
    Result<simulation::World> worldOf(const std::shared_ptr<const building::Building>& building);

    std::mutex m_building; ///< one world is built at a time
    std::optional<simulation::World> m_world;

    mutable std::mutex m_mutex; ///< of what follows
    WalkPlan m_plan;
    std::shared_ptr<simulation::WalkSource> m_current;
};

/// "sim:" or "sim:WHERE": a walk without a camera.
bool isSimulation(const QString& source);
/// WHERE of "sim:WHERE".
QString startOfSimulation(const QString& source);

} // namespace farol::ui
