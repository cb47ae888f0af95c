#include "core/routing/corridor_axis.h"
#include "core/routing/door_count.h"
#include "core/routing/route.h"
#include "core/routing/wall_walk.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace farol::routing {

using building::Access;
using building::AccessKind;
using building::Region;

namespace {

constexpr double kAveragedM = 1.5; // over which a walking direction is taken
constexpr double kLeastAveragedM = 0.5;
constexpr double kMergeM = 1.0; // bends this near to an access or to each other are one manoeuvre
constexpr double kTurnRadians = kPi / 6.0 - 1e-6;

/// Bends that are told as one: a turn, or an access with the bends beside it. Indices into the path.
struct Cluster {
    std::size_t first = 0;
    std::size_t last = 0;
    std::optional<std::size_t> portal; ///< which access, if one is in it
    std::size_t at = 0;                ///< where the manoeuvre is said to be
};

class PathWalk {
public:
    PathWalk(const Building& building, const Route& route, const std::vector<std::size_t>& portals)
        : m_building(building), m_route(route), m_portals(portals) {
        measure();
        for (std::size_t k = 0; k < m_portals.size(); ++k) m_alongLeg.push_back(doorsAlongLeg(k));
        for (std::size_t k = 0; k < m_portals.size(); ++k) m_aroundRoom.push_back(doorsAroundRoom(k));
    }

    std::vector<Manoeuvre> manoeuvres() const;

private:
    void measure();
    std::vector<Cluster> clusters() const;
    void clustersOfBends(std::size_t from, std::size_t to, std::vector<Cluster>& found) const;
    std::size_t absorbed(std::size_t portal, bool forward) const;
    Point2 pointAt(double flat) const;
    struct Bend {
        Radians turn;
        std::optional<Radians> behind; ///< of an access
    };
    Bend bendOf(const Cluster& cluster, double low, double high) const;
    std::optional<Radians> behindAccess(std::size_t portal, Point2 out) const;
    double bendAt(std::size_t i) const;
    Manoeuvre passing(std::size_t portal, const Bend& bend) const;
    Manoeuvre end(ManoeuvreKind kind) const;
    double climbOf(std::size_t portal) const;
    bool changesLevel(std::size_t portal) const;
    void addDoorCount(std::size_t portal, Manoeuvre& manoeuvre) const;
    std::optional<DoorCount> doorsAlongLeg(std::size_t portal) const;
    std::optional<DoorCount> doorsAroundRoom(std::size_t portal) const;
    bool followsWall(std::size_t portal) const {
        return portal < m_aroundRoom.size() && m_aroundRoom[portal].has_value();
    }
    std::size_t lastOfRide(std::size_t portal) const;

    const Building& m_building;
    const Route& m_route;
    const std::vector<std::size_t>& m_portals;
    std::vector<double> m_flat; ///< metres on the flat up to each point of the path
    std::vector<double> m_at;   ///< the same with stairs and ramps, as in Manoeuvre::atM
    std::vector<std::optional<DoorCount>> m_alongLeg, m_aroundRoom; ///< of each access, if it is one
};

/// By how much the access changes the level for one who walks: 0 for lifts.
double PathWalk::climbOf(std::size_t portal) const {
    const Access* access = m_building.access(m_route.accesses[portal]);
    const Region* from = m_building.region(m_route.regions[portal]);
    const Region* into = m_building.region(m_route.regions[portal + 1]);
    if (access == nullptr || from == nullptr || into == nullptr || access->kind == AccessKind::Elevator)
        return 0.0;
    return std::abs(from->level - into->level);
}

void PathWalk::measure() {
    for (std::size_t i = 0; i < m_route.path.size(); ++i) {
        // From one level to the next nothing is walked on the flat, wherever stairs come out.
        bool flat = i > 0 && std::abs(m_route.path[i].level - m_route.path[i - 1].level) < 1e-6;
        double gone = flat ? distance(m_route.path[i - 1].position, m_route.path[i].position) : 0.0;
        m_flat.push_back(i == 0 ? 0.0 : m_flat.back() + gone);
    }
    double climbs = 0.0;
    for (std::size_t k = 0; k < m_portals.size(); ++k) climbs += climbOf(k);
    double metresPerLevel =
        climbs > 0.0 && !m_flat.empty() ? (m_route.lengthM - m_flat.back()) / climbs : 0.0;
    m_at = m_flat;
    for (std::size_t k = 0; k < m_portals.size(); ++k)
        for (std::size_t i = m_portals[k] + 1; i < m_at.size(); ++i) m_at[i] += climbOf(k) * metresPerLevel;
}

/// Signed change of direction at an inner point; 0 where the path stands still.
double PathWalk::bendAt(std::size_t i) const {
    if (i == 0 || i + 1 >= m_route.path.size()) return 0.0;
    double level = m_route.path[i].level;
    if (m_route.path[i - 1].level != level || m_route.path[i + 1].level != level) return 0.0;
    Point2 in = m_route.path[i].position - m_route.path[i - 1].position;
    Point2 out = m_route.path[i + 1].position - m_route.path[i].position;
    if (in == Point2{} || out == Point2{}) return 0.0;
    return wrapped(directionOf(out) - directionOf(in)).value;
}

/// The furthest bend that belongs to the access: within reach and nearer to it than to the next access.
std::size_t PathWalk::absorbed(std::size_t portal, bool forward) const {
    std::size_t at = m_portals[portal];
    std::size_t furthest = at;
    // A turn behind stairs or a lift is told for itself: one has found one's bearings by then.
    if (changesLevel(portal)) return forward && at + 1 < m_route.path.size() ? at + 1 : at;
    double here = m_flat[at];
    double reach = kMergeM;
    if (forward && portal + 1 < m_portals.size())
        reach = std::min(reach, (m_flat[m_portals[portal + 1]] - here) / 2.0);
    if (!forward && portal > 0) reach = std::min(reach, (here - m_flat[m_portals[portal - 1]]) / 2.0);
    std::size_t low = portal == 0 ? 1 : m_portals[portal - 1] + 1;
    std::size_t high = portal + 1 < m_portals.size() ? m_portals[portal + 1] : m_route.path.size() - 1;
    if (forward)
        while (furthest + 1 < high && m_flat[furthest + 1] - here <= reach) ++furthest;
    else
        while (furthest > low && here - m_flat[furthest - 1] <= reach) --furthest;
    return furthest;
}

/// Bends strictly between two points of the path, near ones together.
void PathWalk::clustersOfBends(std::size_t from, std::size_t to, std::vector<Cluster>& found) const {
    for (std::size_t i = from + 1; i < to;) {
        Cluster cluster{i, i, std::nullopt, i};
        while (cluster.last + 1 < to && m_flat[cluster.last + 1] - m_flat[cluster.last] <= kMergeM)
            ++cluster.last;
        for (std::size_t j = cluster.first; j <= cluster.last; ++j)
            if (std::abs(bendAt(j)) > std::abs(bendAt(cluster.at))) cluster.at = j;
        found.push_back(cluster);
        i = cluster.last + 1;
    }
}

std::vector<Cluster> PathWalk::clusters() const {
    std::vector<Cluster> found;
    std::size_t done = 0;
    for (std::size_t k = 0; k < m_portals.size(); ++k) {
        Cluster cluster{absorbed(k, false), absorbed(k, true), k, m_portals[k]};
        clustersOfBends(done, cluster.first, found);
        found.push_back(cluster);
        done = cluster.last;
    }
    if (!m_route.path.empty()) clustersOfBends(done, m_route.path.size() - 1, found);
    return found;
}

Point2 PathWalk::pointAt(double flat) const {
    flat = std::clamp(flat, 0.0, m_flat.back());
    auto next = std::lower_bound(m_flat.begin(), m_flat.end(), flat);
    auto i = static_cast<std::size_t>(next - m_flat.begin());
    if (i == 0 || m_flat[i] == m_flat[i - 1]) return m_route.path[i].position;
    double share = (flat - m_flat[i - 1]) / (m_flat[i] - m_flat[i - 1]);
    Point2 a = m_route.path[i - 1].position;
    return a + (m_route.path[i].position - a) * share;
}

/// From the direction before the cluster to the one after it; directions are not taken beyond `low` and
/// `high`, where the neighbouring clusters are.
PathWalk::Bend PathWalk::bendOf(const Cluster& cluster, double low, double high) const {
    double begin = m_flat[cluster.first];
    double finish = m_flat[cluster.last];
    double back = std::clamp(begin - low, kLeastAveragedM, kAveragedM);
    double ahead = std::clamp(high - finish, kLeastAveragedM, kAveragedM);
    Point2 in = m_route.path[cluster.first].position - pointAt(begin - back);
    Point2 out = pointAt(finish + ahead) - m_route.path[cluster.last].position;
    if (length(in) < 1e-6 || length(out) < 1e-6) return {};
    if (cluster.portal) {
        // Who walks in a corridor follows its walls, not the diagonal of the shortest path: a corner of two
        // corridors is a whole turn, and the door in its side wall is one too.
        if (const Region* from = m_building.region(m_route.regions[*cluster.portal]))
            in = walkingDirection(from->polygon, in);
        if (const Region* into = m_building.region(m_route.regions[*cluster.portal + 1]))
            out = walkingDirection(into->polygon, out);
    }
    double turn = wrapped(directionOf(out) - directionOf(in)).value;
    // Right round: which way is told by the bends on the way, not by the sum.
    double bends = 0.0;
    for (std::size_t i = cluster.first; i <= cluster.last; ++i) bends += bendAt(i);
    if (std::abs(bends - turn) > kPi) turn = std::copysign(kPi, bends);
    return {{turn}, cluster.portal ? behindAccess(*cluster.portal, out) : std::nullopt};
}

std::optional<Radians> PathWalk::behindAccess(std::size_t portal, Point2 out) const {
    const Access* access = m_building.access(m_route.accesses[portal]);
    const Region* from = m_building.region(m_route.regions[portal]);
    if (access == nullptr || from == nullptr || changesLevel(portal)) return std::nullopt;
    if (access->kind != AccessKind::Door && access->kind != AccessKind::Opening) return std::nullopt;
    auto through = directionThrough(from->polygon, *access);
    if (!through) return std::nullopt;
    return wrapped(directionOf(out) - directionOf(*through));
}

Manoeuvre PathWalk::end(ManoeuvreKind kind) const {
    bool start = kind == ManoeuvreKind::Start;
    const PathPoint& point = start ? m_route.path.front() : m_route.path.back();
    Manoeuvre manoeuvre;
    manoeuvre.kind = kind;
    manoeuvre.from = manoeuvre.into = start ? m_route.regions.front() : m_route.regions.back();
    manoeuvre.position = point.position;
    manoeuvre.level = manoeuvre.targetLevel = point.level;
    manoeuvre.atM = start ? 0.0 : m_at.back();
    return manoeuvre;
}

bool PathWalk::changesLevel(std::size_t portal) const {
    const Region* from = m_building.region(m_route.regions[portal]);
    const Region* into = m_building.region(m_route.regions[portal + 1]);
    return from != nullptr && into != nullptr && std::abs(from->level - into->level) > 1e-6;
}

/// Which access ends the ride that begins with this one: one stays in the car.
std::size_t PathWalk::lastOfRide(std::size_t portal) const {
    const Access* lift = m_building.access(m_route.accesses[portal]);
    while (lift != nullptr && lift->kind == AccessKind::Elevator && portal + 1 < m_portals.size()) {
        const Access* next = m_building.access(m_route.accesses[portal + 1]);
        const Region* between = m_building.region(m_route.regions[portal + 1]);
        bool inCar =
            !lift->shaft.empty() || (between != nullptr && between->kind == building::RegionKind::Elevator);
        if (next == nullptr || next->kind != AccessKind::Elevator || next->shaft != lift->shaft || !inCar)
            break;
        ++portal;
    }
    return portal;
}

/// In the wall beside the way, from where one began to walk this way.
std::optional<DoorCount> PathWalk::doorsAlongLeg(std::size_t portal) const {
    const Access* access = m_building.access(m_route.accesses[portal]);
    auto region = m_building.regionIndex(m_route.regions[portal]);
    std::size_t begin = portal == 0 ? 0 : m_portals[portal - 1];
    std::size_t from = m_portals[portal];
    if (access == nullptr || !region || from == begin) return std::nullopt;
    for (--from; from > begin && std::abs(bendAt(from)) < kTurnRadians; --from) {
    }
    if (m_route.path[from].level != m_route.path[m_portals[portal]].level) return std::nullopt;
    return countDoors(m_building, *region, *access, m_route.path[from].position);
}

/// Round a small room, from the door that one has come through.
std::optional<DoorCount> PathWalk::doorsAroundRoom(std::size_t portal) const {
    if (portal == 0 || m_alongLeg[portal] || changesLevel(portal - 1) || changesLevel(portal))
        return std::nullopt;
    const Access* entry = m_building.access(m_route.accesses[portal - 1]);
    const Access* access = m_building.access(m_route.accesses[portal]);
    auto region = m_building.regionIndex(m_route.regions[portal]);
    if (entry == nullptr || access == nullptr || !region) return std::nullopt;
    return countAlongWalls(m_building, *region, *entry, *access);
}

void PathWalk::addDoorCount(std::size_t portal, Manoeuvre& manoeuvre) const {
    manoeuvre.alongWall = followsWall(portal);
    const auto& count = manoeuvre.alongWall ? m_aroundRoom[portal] : m_alongLeg[portal];
    // Who follows a wall from the door on has no turn to make behind it.
    if (manoeuvre.behind && followsWall(portal + 1)) manoeuvre.behind = Radians{};
    if (!count) return;
    manoeuvre.side = count->left ? Side::Left : Side::Right;
    manoeuvre.number = count->number;
}

Manoeuvre PathWalk::passing(std::size_t portal, const Bend& bend) const {
    Manoeuvre manoeuvre;
    manoeuvre.access = m_route.accesses[portal];
    manoeuvre.from = m_route.regions[portal];
    manoeuvre.into = m_route.regions[lastOfRide(portal) + 1];
    manoeuvre.position = m_route.path[m_portals[portal]].position;
    manoeuvre.turn = bend.turn;
    manoeuvre.behind = bend.behind;
    manoeuvre.atM = m_at[m_portals[portal]];
    manoeuvre.level = manoeuvre.targetLevel = m_route.path[m_portals[portal]].level;
    if (const Region* into = m_building.region(manoeuvre.into)) manoeuvre.targetLevel = into->level;
    if (std::abs(manoeuvre.targetLevel - manoeuvre.level) > 1e-6)
        manoeuvre.vertical = manoeuvre.targetLevel > manoeuvre.level ? Vertical::Up : Vertical::Down;
    if (const Access* access = m_building.access(manoeuvre.access)) {
        manoeuvre.kind = manoeuvreKindOf(access->kind);
        manoeuvre.steps = access->steps;
    }
    if (changesLevel(portal)) manoeuvre.turn = {};
    addDoorCount(portal, manoeuvre);
    return manoeuvre;
}

std::vector<Manoeuvre> PathWalk::manoeuvres() const {
    std::vector<Manoeuvre> list{end(ManoeuvreKind::Start)};
    std::vector<Cluster> all = clusters();
    std::size_t region = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        double low = i == 0 ? 0.0 : m_flat[all[i - 1].last];
        double high = i + 1 == all.size() ? m_flat.back() : m_flat[all[i + 1].first];
        Bend bend = bendOf(all[i], low, high);
        if (all[i].portal) {
            list.push_back(passing(*all[i].portal, bend));
            region = *all[i].portal + 1;
        } else if (std::abs(bend.turn.value) >= kTurnRadians && !followsWall(region)) {
            Manoeuvre manoeuvre;
            manoeuvre.kind = ManoeuvreKind::Turn;
            manoeuvre.from = manoeuvre.into = m_route.regions[region];
            manoeuvre.position = m_route.path[all[i].at].position;
            manoeuvre.level = manoeuvre.targetLevel = m_route.path[all[i].at].level;
            manoeuvre.turn = bend.turn;
            manoeuvre.atM = m_at[all[i].at];
            list.push_back(manoeuvre);
        }
    }
    list.push_back(end(ManoeuvreKind::Arrive));
    return list;
}

} // namespace

ManoeuvreKind manoeuvreKindOf(AccessKind kind) {
    switch (kind) {
    case AccessKind::Opening:
        return ManoeuvreKind::Opening;
    case AccessKind::Stairs:
        return ManoeuvreKind::Stairs;
    case AccessKind::Elevator:
        return ManoeuvreKind::Elevator;
    case AccessKind::Escalator:
        return ManoeuvreKind::Escalator;
    case AccessKind::Ramp:
        return ManoeuvreKind::Ramp;
    case AccessKind::Door:
    case AccessKind::Window:
    case AccessKind::Other:
        return ManoeuvreKind::Door;
    }
    return ManoeuvreKind::Door;
}

std::vector<Manoeuvre> manoeuvresAlong(const Building& building, const Route& route,
                                       const std::vector<std::size_t>& portals) {
    bool whole = !route.path.empty() && portals.size() == route.accesses.size() &&
                 route.regions.size() == portals.size() + 1;
    if (!whole) return {};
    return PathWalk(building, route, portals).manoeuvres();
}

} // namespace farol::routing
