#pragma once
// A planned way through the building, as structure: words are made in ui/speech.

#include "core/base/error.h"
#include "core/building/building.h"
#include "core/building/info.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace farol::routing {

using building::Building;
using building::Location;

enum class ManoeuvreKind { Start, Door, Opening, Stairs, Elevator, Escalator, Ramp, Turn, Arrive };
enum class Vertical { None, Up, Down };
enum class Side { None, Left, Right };

/// How an access of this kind is passed; a window or an unknown kind counts as a door.
ManoeuvreKind manoeuvreKindOf(building::AccessKind kind);

/// One thing to do on the way. `turn` is how the walking direction changes there, from the path's own
/// geometry (counter-clockwise, so left, is positive); 0 on Start and Arrive, and on stairs, lifts and
/// escalators, which may turn as they like. A lift's `into` and `targetLevel` are those of the whole ride:
/// the level to choose.
struct Manoeuvre {
    ManoeuvreKind kind = ManoeuvreKind::Start;
    AccessId access; ///< the access passed; empty on Start, Turn and Arrive
    RegionId from;   ///< the region one is in before
    RegionId into;   ///< the region one is in afterwards (the same for Turn and Arrive)
    Point2 position;
    double level = 0.0;       ///< before a change of level
    double targetLevel = 0.0; ///< after it
    Radians turn;
    Vertical vertical = Vertical::None;
    std::optional<int> steps;
    /// Of a door or opening in a wall one walks along: on which side it comes, and as which of its kind
    /// there, counted from where one began to walk that way.
    Side side = Side::None;
    int number = 0;
    /// Of a door in a small room with several: `side` is the wall to follow from the door one has come
    /// through, round corners too, and `number` counts from there.
    bool alongWall = false;
    /// Of a door or opening: how the way goes on behind it, from straight through (counter-clockwise); the
    /// rest of `turn` is the turn towards it. Empty where the map does not tell how it stands.
    std::optional<Radians> behind{};
    double atM = 0.0; ///< walking distance from the start of the route
};

struct PathPoint {
    Point2 position;
    double level = 0.0;
};

/// regions.size() == accesses.size() + 1. `path` runs from start to goal; points of one level form its
/// polyline.
struct Route {
    std::string planner; ///< "optimal" or "greedy"
    std::vector<RegionId> regions;
    std::vector<AccessId> accesses;
    std::vector<PathPoint> path;
    std::vector<Manoeuvre> manoeuvres;
    double lengthM = 0.0;
    double seconds = 0.0;

    bool passes(const RegionId& region) const;
};

/// What can keep one from a way.
enum class Obstacle { Stairs, Elevator, Escalator, Walkway, Ramp, Narrow, Restricted, Closed, OneWay };

/// Why there is no way from one region to another, as structure: words are made in ui/models.
struct NoRoute {
    struct Barrier {
        Obstacle obstacle = Obstacle::Closed;
        RegionId from, into; ///< between which it stands
    };

    RegionId from, to;
    std::vector<Obstacle> anyOf; ///< each would do by itself, and all are to be avoided
    std::vector<Barrier> past;   ///< else all of these stand on the way
    bool joined() const { return !anyOf.empty() || !past.empty(); } ///< by anything at all
};

/// The profile of who walks: what may be used, and how long it takes. Speeds in metres a second on the flat.
/// Closed accesses are never used.
struct RouteOptions {
    double walkingSpeed = 0.8;           ///< of a blind walker, for `seconds`
    double doorSeconds = 4.0;            ///< to find and pass a door
    double narrowDoorSeconds = 0.0;      ///< more than that, for one narrower than narrowDoorM
    double stairsSecondsPerLevel = 20.0; ///< steps within a level: their part of 18 steps, 9 where not told
    double escalatorSecondsPerLevel = 20.0;
    double walkwaySeconds = 0.0;          ///< to step on and off an escalator that stays on its level
    double rampSeconds = 0.0;             ///< beside the walk up or down
    double elevatorSeconds = 45.0;        ///< waiting and riding one level; waited for once a ride
    double elevatorSecondsPerLevel = 5.0; ///< each further level of the same ride
    double storeyHeightM = 3.0;           ///< where the map tells no elevations
    double narrowDoorM = 0.8;             ///< doors and openings whose width is told are narrow below this
    bool avoidStairs = false;
    bool avoidElevator = false;
    bool avoidEscalator = false;
    bool avoidWalkway = false; ///< moving walkways
    bool avoidRamp = false;
    bool avoidNarrow = false;
    bool avoidRestricted = false; ///< one may still start or end in such a region

    Result<void> check() const;
};

/// Thread-safe once built: plan() is const.
class Planner {
public:
    virtual ~Planner() = default;
    /// NotFound with the reason in words when there is no way ("room 2.14 can be reached by stairs only,
    /// which are to be avoided"). Start and goal in one region: a route without accesses, unless it is
    /// shorter to leave the region and come back.
    virtual Result<Route> plan(const Location& from, const Location& to) const = 0;
};

/// The least seconds there are (RouteOptions), walking within the regions' polygons. Doors and narrow
/// openings are crossed in their middle. Openings 1.2 m wide or more (drawn as a straight line, or a point
/// with width_m on a border) are crossed anywhere 0.4 m or more from their ends; in their middle where they
/// go one way only or lead into what is barred. Makes its graph at once; the building should be planned in
/// many times.
std::unique_ptr<Planner> makeOptimalPlanner(std::shared_ptr<const Building> building,
                                            RouteOptions options = {});
/// The paper's 4.1 as printed: next access by direction and distance to the destination, dead ends struck out
/// and restarted, levels joined by common stairs or lifts. Not the shortest way; for comparison.
std::unique_ptr<Planner> makeGreedyPlanner(std::shared_ptr<const Building> building,
                                           RouteOptions options = {});

/// Turns, doors and level changes along a path. `portals` are the indices into `path` of the accesses, in
/// order. A turn is one from 30 degrees on; bends within 1 m of an access belong to its manoeuvre, and bends
/// within 1 m of each other are one turn. What `lengthM` has beyond the path's flat length is walked on
/// stairs, ramps and escalators.
std::vector<Manoeuvre> manoeuvresAlong(const Building& building, const Route& route,
                                       const std::vector<std::size_t>& portals);

std::string manoeuvreKindName(ManoeuvreKind kind);

} // namespace farol::routing
