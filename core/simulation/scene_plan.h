#pragma once
// The plan made ready for building: borders with their walls, and where doors, openings and windows cut them.
// In metres from the world's origin.

#include "core/building/building.h"
#include "core/simulation/plan_pieces.h"
#include "core/simulation/storeys.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace farol::simulation {

/// A hole in a wall: metres along its edge, heights above the floor.
struct Cut {
    double from = 0.0, to = 0.0;
    double bottom = 0.0, top = 0.0;
};

struct PlanEdge : BorderEdge {
    std::vector<Cut> cuts;
    std::vector<std::pair<double, double>> outer; ///< metres along, where nothing indoors lies behind it
};

/// What lies on the side of a line that `keep` points to.
struct HalfPlane {
    Point2 onLine, keep;
};

struct RegionPlan {
    std::size_t region = 0;
    Polygon polygon; ///< tidied; empty for a region without an area
    Point2 axis{1.0, 0.0};
    std::vector<PlanEdge> edges;
    bool outside = false;
    double floorLift = 0.0; ///< millimetres that keep overlapping floors apart
    /// Of a stairwell: what keeps its ceiling where flights go up, and its floor where they come from below.
    std::optional<HalfPlane> ceilingKept, floorKept;
};

/// One access in the walls. The opening runs from `a` to `b`; `normal` points into `into`.
struct Portal {
    std::size_t access = 0;
    building::AccessKind kind = building::AccessKind::Door;
    Point2 a, b;
    Point2 along, normal;
    double width = 0.9;
    double sill = 0.0, head = 2.05;
    double front = 0.05, back = -0.05;      ///< faces of the two walls along `normal`
    std::optional<std::size_t> into, outOf; ///< regions
    std::optional<std::size_t> landmark;    ///< a window that is one
    bool fullHeight = false;
    bool lift = false; ///< leads into a lift car
};

struct ScenePlan {
    Point2 origin; ///< map coordinates of the world's origin
    Storeys storeys;
    std::vector<RegionPlan> regions; ///< by region index
    std::vector<Portal> portals;
};

/// `windows`: also cut windows into outer walls of rooms and halls, by rule.
ScenePlan planScene(const building::Building& building, std::uint64_t seed, bool windows);

} // namespace farol::simulation
