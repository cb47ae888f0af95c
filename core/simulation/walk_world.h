#pragma once
// The building as something solid: what a body can walk through, and what a cane meets. Level by level and
// region by region; from one region to the next only through accesses.

#include "core/building/building.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace farol::simulation {

struct Segment {
    Point2 a, b;
};

/// An access as one meets it in one of its regions.
struct Passage {
    std::size_t access = 0, from = 0, into = 0;
    building::AccessKind kind = building::AccessKind::Door;
    Segment gap;          ///< its width in the wall; of stairs and lifts, where one steps on
    Point2 outward;       ///< unit vector through the wall, out of `from`; null for stairs and lifts
    double behindM = 0.0; ///< so far behind the side of `from` it is drawn: within a thick wall
    double climb = 0.0;   ///< levels

    bool changesLevel() const;
};

class WalkWorld {
public:
    explicit WalkWorld(std::shared_ptr<const building::Building> building);

    const building::Building& building() const { return *m_building; }
    std::span<const Passage> passagesOf(std::size_t region) const { return m_rooms[region].passages; }

    /// How far one can go that way until something solid, at most `reach`. A closed door is solid, an
    /// opening is not.
    double free(std::size_t region, Point2 from, Radians direction, double reach) const;
    /// The same, and the direction of the wall that ends it, in (-pi/2, pi/2] to the way one goes.
    struct Hit {
        double distance = 0.0;
        Radians wall;
    };
    std::optional<Hit> hit(std::size_t region, Point2 from, Radians direction, double reach) const;
    /// Where a body ends up that wants to go from one point to another: never through a wall, and at its own
    /// radius from one where there is room for that.
    Point2 moved(std::size_t region, Point2 from, Point2 to) const;
    /// The opening through which the step leaves the region, if it does.
    const Passage* crossed(std::size_t region, Point2 from, Point2 to) const;
    bool inside(std::size_t region, Point2 p) const;
    /// A point of the region, at a body's radius from its walls where there is room.
    Point2 standing(std::size_t region, Point2 near) const;
    /// Behind the passage: a point in its `into` that the way through it at `at` leads to.
    Point2 landing(const Passage& passage, Point2 at) const;

    static constexpr double kBodyM = 0.22;

private:
    struct Room {
        std::vector<Segment> solid;
        std::vector<Passage> passages;
    };

    std::optional<Passage> passage(std::size_t access, std::size_t region) const;
    void cutOpenings(std::size_t region);
    Point2 pushedOff(std::size_t region, Point2 p) const;
    bool blocked(std::size_t region, Point2 from, Point2 to) const;

    std::shared_ptr<const building::Building> m_building;
    std::vector<Room> m_rooms;
};

} // namespace farol::simulation
