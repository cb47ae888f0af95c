#pragma once
// Does a walker who knows nothing but what is said arrive? Walker and navigator in one loop on simulated
// time: the walker's pose becomes a percept (drawn from the truth, or from a rendered picture), the percept
// cues, and the cues are what the walker hears. Nothing else passes between them.

#include "core/session/navigator.h"
#include "core/simulation/truth_detections.h"
#include "core/simulation/walker.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace farol::session {

/// What the navigator is told of the place instead of working it out: failures that remain are not the
/// localiser's.
enum class TruePlace { No, Region, Spot };

struct ClosedLoopOptions {
    NavigatorOptions navigator = NavigatorOptions::with("bayes-guided");
    simulation::WalkerOptions walker;
    TruePlace truePlace = TruePlace::No;
    bool knownStart = true; ///< the region, never the spot or the way one faces
    double framesPerSecond = 5.0;
    double hearingSeconds = 1.0; ///< from a cue to what is done on it: it takes time to say
    /// The walk is given up after so many times the route's own time, and this much more.
    double patience = 4.0, patienceSeconds = 120.0;

    Result<void> check() const;
};

/// Why a walk ended.
enum class WalkEnd {
    Arrived,          ///< told so, and true
    ArrivedElsewhere, ///< told so, and false
    NoRoute,          ///< refused by the planner
    Lost,             ///< time was up, and the place was wrong most of the last minute
    NotFound,         ///< time was up; the place was right, but what was told was not found
};

struct ClosedLoopResult {
    WalkEnd end = WalkEnd::NotFound;
    bool arrived = false;          ///< the walker is in the destination at the end
    bool announcedArrival = false; ///< "you have arrived" was said
    double seconds = 0.0, metres = 0.0;
    double shortestM = 0.0, shortestS = 0.0; ///< of the route from the true start
    int wrongRegionSaid = 0;                 ///< places told that were wrong, arrivals included
    int cues = 0;
    std::string reason; ///< in words
};

/// One frame of the loop, for those who watch or write it down.
struct ClosedLoopMoment {
    const simulation::CameraPose& pose;
    const RegionId& region; ///< the true one
    const NavigationStep& step;
};

class ClosedLoop {
public:
    /// What is seen from a pose; `region` is the true one, for eyes that draw from the truth.
    using Eye = std::function<Result<Percept>(const simulation::CameraPose& pose, std::size_t region,
                                              std::uint64_t frame)>;
    /// What the walker takes from a cue; empty: nothing.
    using Ear = std::function<std::optional<simulation::WalkInstruction>(const guidance::Cue& cue)>;

    /// NotFound for places that are not in the map, and for a destination that cannot be reached.
    static Result<std::unique_ptr<ClosedLoop>> create(std::shared_ptr<const simulation::WalkWorld> world,
                                                      const building::Location& from,
                                                      const building::Location& to,
                                                      const ClosedLoopOptions& options, Eye eye);
    ~ClosedLoop();

    void setEar(Ear ear);
    void onMoment(std::function<void(const ClosedLoopMoment&)> handler);
    /// To the end, once. An error is the eye's.
    Result<ClosedLoopResult> run();

private:
    struct Impl;
    explicit ClosedLoop(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// Detections drawn from the truth.
ClosedLoop::Eye truthEye(std::shared_ptr<const simulation::WalkWorld> world,
                         const simulation::TruthDetectionOptions& options);

std::string walkEndName(WalkEnd end);

} // namespace farol::session
