// Walking freely: those who are guided do not know the way from door to door, they go where they face, along
// walls and through what they meet. The picture's turns and pace tell where that is; the plan tells where it
// cannot be.

#include "core/localisation/quick_math.h"
#include "core/localisation/walker_cloud.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace farol::localisation {

namespace {

constexpr float kDegToRad = 0.01745329F;
/// A door is found by hand: whoever walks past its frame by so much still comes through.
constexpr float kByHandM = 0.35F;
/// Of a direction that is known at best.
constexpr float kLeastYawVariance = 36.0F;
constexpr float kMostYawVariance = 900.0F;
/// Doors, stairs and lifts are taken from so near.
constexpr float kAtHandM = 1.3F;
constexpr float kClimbFromM = 1.7F; // stairs are wide, and so is what is in front of a lift
/// Of stairs and lifts that were told, which are sought: steps are measured to no better.
constexpr float kSoughtFromM = 3.0F;
constexpr float kThroughDeg = 30.0F;

Spot unit(float degrees) {
    float a = degrees * kDegToRad;
    return {std::cos(a), std::sin(a)};
}

} // namespace

/// How likely who is there goes through, against the door that was meant. One who was told of a door cannot
/// know it from its neighbour.
float WalkerCloud::doorShare(std::uint32_t node) const {
    const WalkingOptions& walking = m_options.walking;
    bool leadsOn = m_map->hasGoal() && m_map->leadsOn(node);
    if (!m_told) return leadsOn ? 1.0F : static_cast<float>(walking.throughUnasked);
    if (!m_map->fits(node, *m_told)) return static_cast<float>(walking.throughUnasked);
    return leadsOn ? 1.0F : static_cast<float>(walking.otherDoor);
}

double WalkerCloud::climbRate(std::uint32_t node) const {
    const WalkingOptions& walking = m_options.walking;
    if (m_told) {
        // Who was sent up one flight does not go on up the next one, unless the level was mistaken.
        if (!m_map->fits(node, *m_told)) return walking.climbUntold;
        return m_map->fitsHere(node, *m_told) ? walking.climbRate : walking.climbUnasked;
    }
    return m_map->hasGoal() && m_map->leadsOn(node) ? walking.climbRate : walking.climbUnasked;
}

/// The next door or opening that the way leads through, if it is near enough: on to its other side.
bool WalkerCloud::passThrough(Walker& walker, Spot way, float& metres) {
    std::int32_t best = -1;
    float bestAhead = 0.0F, bestBeside = 0.0F, least = 1e9F;
    for (std::uint32_t index : m_map->nodesOf(walker.region)) {
        const WalkingNode& node = m_map->nodes()[index];
        if (node.across < 0 || node.changesLevel) continue;
        Spot to{node.at.x - walker.at.x, node.at.y - walker.at.y};
        // Where the way meets the line of the door; one drawn as a point lies across the way.
        Spot sill = node.sill;
        if (sill.x == 0.0F && sill.y == 0.0F) sill = {-way.y, way.x};
        float facing = way.x * sill.y - way.y * sill.x; // 0: along the door
        if (std::abs(facing) < 0.2F) continue;
        float ahead = (to.x * sill.y - to.y * sill.x) / facing;
        float beside = (walker.at.x + ahead * way.x - node.at.x) * sill.x +
                       (walker.at.y + ahead * way.y - node.at.y) * sill.y;
        if (ahead > metres + kByHandM || ahead < -2.0F * kByHandM) continue;
        if (std::abs(beside) > node.halfOpenM + kByHandM) continue;
        // Outwards, not back into the region.
        if (node.out.x * way.x + node.out.y * way.y < 0.0F) continue;
        float cost = std::abs(ahead) + std::max(0.0F, std::abs(beside) - node.halfOpenM);
        if (cost >= least) continue;
        least = cost;
        best = static_cast<std::int32_t>(index);
        bestAhead = ahead;
        bestBeside = beside;
    }
    if (best < 0) return false;
    const WalkingNode& node = m_map->nodes()[static_cast<std::size_t>(best)];
    const WalkingNode& beyond = m_map->nodes()[static_cast<std::size_t>(node.across)];
    if (!node.isOpening && m_map->hasGoal()) walker.weight *= doorShare(static_cast<std::uint32_t>(best));
    float room = std::max(0.0F, node.halfOpenM - 0.3F), beside = std::clamp(bestBeside, -room, room);
    walker.region = beyond.region;
    Spot at{beyond.at.x + beside * node.sill.x, beyond.at.y + beside * node.sill.y};
    walker.at = m_map->inside(beyond.region, at) ? at : beyond.at;
    metres -= std::max(0.0F, bestAhead) + gapBetween(node.at, beyond.at);
    return true;
}

/// Along the wall that is met: with as little of a turn as leads on.
void WalkerCloud::slide(Walker& walker, Spot way, float metres) {
    constexpr std::array<float, 4> kTurns{25.0F, 45.0F, 65.0F, 85.0F};
    float sign = m_random.uniform() < 0.5F ? 1.0F : -1.0F;
    for (float turn : kTurns) {
        for (float side : {sign, -sign}) {
            Spot by = unit(side * turn);
            float gone = metres * by.x;
            Spot next{walker.at.x + gone * (way.x * by.x - way.y * by.y),
                      walker.at.y + gone * (way.x * by.y + way.y * by.x)};
            if (!m_map->inside(walker.region, next)) continue;
            walker.at = next;
            walker.weight *= std::exp(-(metres - gone) / static_cast<float>(m_options.walking.alongWallM));
            return;
        }
    }
    walker.weight *= std::exp(-metres / static_cast<float>(m_options.walking.alongWallM));
}

void WalkerCloud::roam(Walker& walker, float metres) {
    constexpr int kMostDoors = 3;
    Spot way = unit(walker.yawDeg - walker.swayDeg);
    for (int i = 0; i < kMostDoors && metres > 0.01F; ++i) {
        Spot next{walker.at.x + metres * way.x, walker.at.y + metres * way.y};
        if (m_map->inside(walker.region, next)) {
            walker.at = next;
            return;
        }
        if (passThrough(walker, way, metres)) continue;
        slide(walker, way, metres);
        return;
    }
}

/// Doors, stairs and lifts within reach are found by hand: taken where they lead on, seldom elsewhere.
void WalkerCloud::mayTake(Walker& walker, bool moving, float seconds) {
    const WalkingOptions& walking = m_options.walking;
    for (std::uint32_t index : m_map->nodesOf(walker.region)) {
        const WalkingNode& node = m_map->nodes()[index];
        float gap = gapBetween(walker.at, node.at);
        if (node.across < 0 || gap > kSoughtFromM) continue;
        bool fits = m_told && m_map->fits(index, *m_told);
        if (gap > (!node.changesLevel ? kAtHandM : fits ? kSoughtFromM : kClimbFromM)) continue;
        bool asked = m_told ? fits : m_map->hasGoal() && m_map->leadsOn(index);
        double door =
            asked ? walking.doorRate * (m_told ? double(doorShare(index)) : 1.0) : walking.doorUnasked;
        auto rate = static_cast<float>(node.changesLevel ? climbRate(index) : door);
        const WalkingNode& beyond = m_map->nodes()[static_cast<std::size_t>(node.across)];
        if (!node.changesLevel) {
            if (!moving || node.isOpening) continue;
            // Whoever comes through faces that way.
            bool known = node.out.x != 0.0F || node.out.y != 0.0F;
            float off = wrappedDeg(walker.yawDeg - quickDirectionDeg(node.out.x, node.out.y)) / kThroughDeg;
            if (known) rate *= std::exp(-0.5F * off * off);
        }
        if (m_random.uniform() > 1.0F - std::exp(-rate * seconds)) continue;
        if (!node.changesLevel) {
            walker.region = beyond.region;
            walker.at = beyond.at;
            return;
        }
        walker.climbTo = node.across;
        walker.climbShows = m_random.uniform() < (node.isLift ? 0.1F : 0.5F);
        walker.climbM = node.crossingM * (0.85F + 0.3F * m_random.uniform());
        return;
    }
}

void WalkerCloud::stride(Walker& walker, const MotionSpan& motion, bool moving, float metres) {
    const WalkingOptions& walking = m_options.walking;
    auto seconds = static_cast<float>(motion.seconds);
    double unseen = motion.measured ? motion.unseenSeconds : motion.seconds;
    auto noise = static_cast<float>(motion.seconds * walking.turnSigmaDeg * walking.turnSigmaDeg +
                                    unseen * walking.unknownTurnSigmaDeg * walking.unknownTurnSigmaDeg);
    float stays = std::exp(-seconds / static_cast<float>(walking.swaySeconds));
    walker.swayDeg = stays * walker.swayDeg + std::sqrt(1.0F - stays * stays) *
                                                  static_cast<float>(walking.bodySwayDeg) * m_random.normal();
    float drawn = std::sqrt(noise) * m_random.normal();
    walker.yawDeg = wrappedDeg(walker.yawDeg + motion.turnDeg + drawn);
    walker.yawVariance = std::clamp(walker.yawVariance + 0.25F * noise, kLeastYawVariance, kMostYawVariance);
    walker.headingDeg = walker.yawDeg;
    if (walker.climbTo >= 0) return;
    if (moving) roam(walker, metres);
    mayTake(walker, moving, seconds);
}

} // namespace farol::localisation
