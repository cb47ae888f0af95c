#include "core/routing/wall_walk.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace farol::routing {

using building::Access;
using building::AccessKind;

namespace {

constexpr double kOnWallM = 0.35; // a door stands in a wall this near, which may be thick
constexpr double kSmallRoomM = 6.0;
constexpr double kLongestWallM = 15.0;
constexpr int kMostDoors = 4;
constexpr double kInsideM = 0.5; // where one stands behind the door one came through
/// Two doors that are no further apart than this are not told from each other by "ahead", nor is one that is
/// further round than another when it is not straight ahead itself.
constexpr Radians kApart = fromDegrees(50.0), kStraight = fromDegrees(35.0), kRounder = fromDegrees(20.0);
constexpr double kFurtherM = 3.0; // one that is so much further off is not taken for it
constexpr double kBesideWallM = 1.2;
constexpr double kPassedM = 0.3;

/// The outer walls of a room as one line, counter-clockwise: the room lies on the left of who follows it so.
class Walls {
public:
    explicit Walls(const Polygon& polygon) : m_ring(polygon.outer) {
        if (signedArea(m_ring) < 0.0) std::reverse(m_ring.begin(), m_ring.end());
        for (std::size_t i = 0; i < m_ring.size(); ++i) {
            m_from.push_back(m_length);
            m_length += distance(m_ring[i], m_ring[(i + 1) % m_ring.size()]);
        }
    }

    struct Spot {
        double at = 0.0;
        double gapM = 0.0;
        Point2 along;
    };

    std::optional<Spot> nearest(Point2 p, double mostM) const {
        std::optional<Spot> best;
        for (std::size_t i = 0; i < m_ring.size(); ++i) {
            Point2 a = m_ring[i], b = m_ring[(i + 1) % m_ring.size()];
            double size = distance(a, b);
            if (size <= 0.0) continue;
            Point2 at = nearestOnSegment(p, a, b);
            double gap = distance(p, at);
            if (gap > mostM || (best && gap >= best->gapM)) continue;
            best = Spot{m_from[i] + distance(a, at), gap, (b - a) * (1.0 / size)};
        }
        return best;
    }

    /// With the wall on the right one goes counter-clockwise.
    double way(double from, double to, bool left) const {
        double gone = std::fmod(left ? from - to : to - from, m_length);
        return gone < 0.0 ? gone + m_length : gone;
    }
    double length() const { return m_length; }

private:
    Ring m_ring;
    std::vector<double> m_from;
    double m_length = 0.0;
};

struct Gap {
    const Access* access;
    double at;
};

bool isGap(const Access& access) {
    return (access.kind == AccessKind::Door || access.kind == AccessKind::Opening) && !access.line.empty();
}

std::vector<Gap> gapsIn(const building::Building& building, std::size_t region, const Walls& walls) {
    std::vector<Gap> gaps;
    for (std::size_t index : building.accessesOf(region)) {
        const Access& access = building.accesses()[index];
        if (!isGap(access)) continue;
        if (auto spot = walls.nearest(access.midpoint(), kOnWallM)) gaps.push_back({&access, spot->at});
    }
    return gaps;
}

/// How many doors there are on the way along the wall, with the last one; 0 where an opening ends the wall
/// before it, or the way is too long.
int doorsBefore(const Walls& walls, const std::vector<Gap>& gaps, double from, const Gap& goal, bool left) {
    double way = walls.way(from, goal.at, left);
    if (way > kLongestWallM) return 0;
    int number = 1;
    for (const Gap& gap : gaps) {
        double gone = walls.way(from, gap.at, left);
        if (gap.access == goal.access || gone <= 0.0 || gone >= way) continue;
        if (gap.access->kind == AccessKind::Opening) return 0;
        if (gap.access->kind == goal.access->kind) ++number;
    }
    return number;
}

bool isAmbiguous(const std::vector<Gap>& gaps, const Access& entry, const Access& access, Point2 inward) {
    Point2 here = entry.midpoint() + inward * kInsideM;
    auto bearing = [&](const Access& each) {
        return wrapped(directionOf(each.midpoint() - here) - directionOf(inward));
    };
    double goalM = distance(here, access.midpoint());
    Radians goal = bearing(access);
    return std::any_of(gaps.begin(), gaps.end(), [&](const Gap& gap) {
        bool other = gap.access != &access && gap.access != &entry && gap.access->kind == access.kind;
        if (!other || distance(here, gap.access->midpoint()) > goalM + kFurtherM) return false;
        Radians at = bearing(*gap.access);
        bool near = std::abs(wrapped(at - goal).value) < kApart.value;
        bool rounder = std::abs(goal.value) > kStraight.value &&
                       std::abs(at.value) < std::abs(goal.value) + kRounder.value;
        return near || rounder;
    });
}

const Gap* find(const std::vector<Gap>& gaps, const Access& access) {
    auto found =
        std::find_if(gaps.begin(), gaps.end(), [&](const Gap& gap) { return gap.access == &access; });
    return found == gaps.end() ? nullptr : &*found;
}

} // namespace

std::optional<DoorCount> countAlongWalls(const building::Building& building, std::size_t region,
                                         const Access& entry, const Access& access) {
    // Beside an opening that is walked through there is no wall at hand.
    if (entry.kind != AccessKind::Door || !isGap(entry) || !isGap(access) || &entry == &access)
        return std::nullopt;
    if (distance(entry.midpoint(), access.midpoint()) > kSmallRoomM) return std::nullopt;
    const Polygon& polygon = building.regions()[region].polygon;
    Walls walls(polygon);
    std::vector<Gap> gaps = gapsIn(building, region, walls);
    const Gap *from = find(gaps, entry), *to = find(gaps, access);
    auto outward = directionThrough(polygon, entry);
    if (from == nullptr || to == nullptr || !outward) return std::nullopt;
    if (!isAmbiguous(gaps, entry, access, *outward * -1.0)) return std::nullopt;
    std::optional<DoorCount> best;
    double least = 0.0;
    for (bool left : {false, true}) {
        int number = doorsBefore(walls, gaps, from->at, *to, left);
        double cost = number + walls.way(from->at, to->at, left);
        if (number == 0 || number > kMostDoors || (best && cost >= least)) continue;
        best = DoorCount{number, left};
        least = cost;
    }
    return best;
}

std::optional<WallSpot> wallSpot(const building::Building& building, std::size_t region, const Access& access,
                                 bool left, Point2 here, double sigmaM) {
    Walls walls(building.regions()[region].polygon);
    std::vector<Gap> gaps = gapsIn(building, region, walls);
    const Gap* to = find(gaps, access);
    auto spot = walls.nearest(here, kBesideWallM);
    if (to == nullptr || !spot) return std::nullopt;
    double rest = walls.way(spot->at, to->at, left);
    if (rest > kLongestWallM) return std::nullopt;
    WallSpot found{0, directionOf(left ? spot->along * -1.0 : spot->along), rest};
    for (double off : {0.0, -sigmaM, sigmaM}) {
        double on = left ? -1.0 : 1.0;
        double from =
            std::fmod(spot->at + on * std::min(off + kPassedM, rest - 1e-6) + walls.length(), walls.length());
        int number = doorsBefore(walls, gaps, from, *to, left);
        if (number == 0 || (found.number != 0 && number != found.number)) return std::nullopt;
        found.number = number;
    }
    return found;
}

} // namespace farol::routing
