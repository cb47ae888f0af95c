#pragma once
// Where the user is, and how sure that is.

#include "core/building/building.h"
#include "core/building/info.h"
#include "core/localisation/observation.h"

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace farol::localisation {

/// A region's score with its named parts (paper 4.2: Pobj, Pmaxobj, Ppos, Pperc, PID, Preg, Rp, Rv, Vreg).
struct RegionVote {
    RegionId region;
    double vote = 0.0;
    std::map<std::string, double> terms;
    std::vector<LandmarkId> evidence; ///< landmarks that match history objects
};

/// `confidence` is 0 to 1. Of VotingLocaliser it is the margin over the runner-up, not a probability: words
/// must be hedged accordingly. `region` empty: not known.
struct Fix {
    double time = 0.0;
    double evidenceTime = 0.0; ///< of the last observation it rests on, or of the start
    /// Position, heading and their deviations are those of `time`, followed since the last observation;
    /// otherwise they are those of `evidenceTime`.
    bool followed = false;
    std::optional<RegionId> region;
    double confidence = 0.0;
    std::vector<RegionId> near; ///< region and neighbours that could be it
    double nearConfidence = 0.0;
    std::optional<double> level;
    std::optional<Point2> position; ///< of the matched object, metres
    double sigmaM = 0.0;            ///< standard deviation of `position`; 0 when there is none
    /// The way the user faces: the camera's own where a trained place was recognised, else the way of walking
    /// from the last two positions.
    std::optional<Radians> heading;
    Radians headingSigma; ///< standard deviation of `heading`; 0 when there is none, or it is not known
    std::vector<RegionVote> votes; ///< highest first, zero votes left out
    LandmarkId landmark;           ///< what `position` rests on
    std::string note; ///< why there is no region, or why it is doubtful; for people who supervise
};

/// What the localiser may know of the plan, made by the session from the route: localisation itself plans
/// nothing.
struct RouteContext {
    std::vector<RegionId> regions;    ///< in walking order from the current one
    std::optional<Point2> nextAccess; ///< where the user is expected to head (paper: the displacement)
    double level = 0.0;
    std::optional<building::Location> destination; ///< told by the user, also while no route is known
};

/// What the user was last told to pass, in order: whoever obeys takes a door where a door was told, the right
/// one or another, and no stairs. Empty: nothing is to be passed.
struct ToldWay {
    struct Passage {
        building::AccessKind kind = building::AccessKind::Door;
        double level = 0.0, targetLevel = 0.0; ///< alike where the level does not change
        bool intoLift = false;                 ///< of a door or opening: a lift's, which nobody mistakes
    };
    std::vector<Passage> passages;
};

/// Deterministic: the same calls give the same fixes. One thread.
class Localiser {
public:
    virtual ~Localiser() = default;

    /// Forget everything; `region` empty: an unknown start.
    virtual void start(double time, const std::optional<RegionId>& region) = 0;
    virtual void setRoute(const RouteContext& route) = 0;
    /// What was just said; holds until the next call. Empty: nobody knows what the user was told, as before
    /// the first call.
    virtual void told(const std::optional<ToldWay>& /*way*/) {}
    /// New, de-duplicated observations (paper: runs when an object was detected) with the history as it is
    /// now. Called once a frame, also with nothing new, so that `time` goes on.
    virtual Fix update(double time, std::span<const Observation> fresh,
                       const std::deque<Observation>& history) = 0;
    virtual void moved(double /*time*/, const recognition::Motion& /*motion*/) {}
    virtual std::string name() const = 0;
};

} // namespace farol::localisation
