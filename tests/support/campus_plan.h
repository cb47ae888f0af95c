#pragma once
// The plan of one floor of a synthetic building: corridors, and the rows of rooms along them.

#include "core/base/geometry.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace farol::test {

/// Its own arithmetic, so that a seed means the same campus with every standard library.
class CampusRandom {
public:
    explicit CampusRandom(std::uint32_t seed) : m_engine(seed) {}

    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(m_engine()) / 4294967296.0);
    }
    int whole(int low, int high) { return static_cast<int>(between(low, high + 1)); }
    bool chance(double share) { return between(0.0, 1.0) < share; }

private:
    std::mt19937 m_engine;
};

enum class PlanShape { Straight, Bent, Ring };
enum class SlotKind { Room, Toilet, Hall, Stairwell, Lift };

struct Slot {
    SlotKind kind = SlotKind::Room;
    double width = 0.0;
};

/// Rooms side by side along a corridor. `start` lies on the corridor's side, `inward` leads away from it. The
/// fixed slots come first and are the same on every floor; rooms fill the rest.
struct RoomRow {
    Point2 start;
    Point2 along, inward; ///< unit vectors
    double length = 0.0, depth = 0.0;
    std::size_t corridor = 0;
    std::vector<Slot> fixed;
    std::optional<Ring> corner; ///< a room beyond the last one, to be reached through it

    Point2 at(double along_, double inward_) const { return start + along * along_ + inward * inward_; }
};

struct FloorPlan {
    std::vector<Polygon> corridors; ///< each joined to the next by a wide opening
    std::vector<Polyline> joints;   ///< of corridors i and i + 1
    std::vector<RoomRow> rows;      ///< the first begins with the entrance hall, whose far side is the front
    double width = 0.0, depth = 0.0;
    std::optional<Polyline> sideDoor; ///< where the last corridor ends at the eastern wall
};

/// Lower left corner at (0, 0), the front along y = 0.
FloorPlan floorPlan(PlanShape shape, bool small, CampusRandom& random);

Ring rectangle(double x0, double y0, double x1, double y1);

} // namespace farol::test
