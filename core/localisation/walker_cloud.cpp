#include "core/localisation/walker_cloud.h"

#include "core/localisation/quick_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace farol::localisation {

namespace {

constexpr float kRadToDeg = 57.29578F;
constexpr float kYawUnknown = 8000.0F; // square degrees: as good as no idea
constexpr double kStandsBelow = 0.2;   // of the usual pace
constexpr float kGraceS = 1.2F;
constexpr float kDrawnYawDeg = 15.0F; // of a direction drawn by chance, for what lies between two of them
constexpr float kNeutral = 0.6F;      // what the right guess gets in the mean where turns tell something

float directionDeg(Spot from, Spot to) {
    return quickDirectionDeg(to.x - from.x, to.y - from.y);
}

std::size_t walkersFor(std::size_t regions) {
    return std::min<std::size_t>(2000 + 7 * regions / 5, 14000);
}

} // namespace

float wrappedDeg(float degrees) {
    if (!(std::abs(degrees) < 1080.0F))
        return std::isfinite(degrees) ? std::remainder(degrees, 360.0F) : 0.0F;
    while (degrees > 180.0F) degrees -= 360.0F;
    while (degrees <= -180.0F) degrees += 360.0F;
    return degrees;
}

WalkerCloud::WalkerCloud(std::shared_ptr<WalkingMap> map, const BayesOptions& options)
    : m_map(std::move(map)),
      m_options(options),
      m_random(options.seed),
      m_capacity(options.walkers > 0 ? options.walkers : walkersFor(m_map->building().regions().size())) {
    clear(options.seed);
}

void WalkerCloud::clear(std::uint64_t seed) {
    m_walkers.clear();
    m_random = Random(seed);
    m_speed = m_options.walking.speed;
    m_speedSpread = m_options.walking.speedSpread;
    m_motionKnown = false;
    m_watch = 1;
    m_told.reset();
}

float WalkerCloud::drawSpeed() {
    const WalkingOptions& walking = m_options.walking;
    if (m_random.uniformDouble() < walking.hurryShare)
        return static_cast<float>(walking.fastest +
                                  (walking.hurrySpeed - walking.fastest) * m_random.uniformDouble());
    double speed = m_speed + m_speedSpread * double(m_random.normal());
    return static_cast<float>(std::clamp(speed, walking.slowest, walking.hurrySpeed));
}

void WalkerCloud::spread(std::size_t count, double weight, std::optional<std::uint32_t> region,
                         std::uint8_t watch) {
    if (count == 0) return;
    double offset = m_random.uniformDouble();
    for (std::size_t i = 0; i < count; ++i) {
        Walker walker;
        walker.watch = watch;
        // Evenly over the map, not at random: no region is forgotten by chance.
        double share = (static_cast<double>(i) + offset) / static_cast<double>(count);
        walker.region = region ? *region : m_map->regionAtShare(share);
        float u = m_random.uniform(), v = m_random.uniform();
        walker.at = m_map->spotIn(walker.region, u, v);
        walker.speed = drawSpeed();
        walker.follows = double(m_random.uniform()) < m_options.walking.followShare;
        walker.stands = m_random.uniform() < 0.4F;
        walker.weight = static_cast<float>(weight / static_cast<double>(count));
        if (m_options.walking.free) {
            walker.yawDeg = walker.headingDeg = 360.0F * m_random.uniform() - 180.0F;
            walker.yawVariance = kDrawnYawDeg * kDrawnYawDeg;
        } else {
            choose(walker, -1);
            walker.yawDeg = walker.headingDeg;
        }
        m_walkers.push_back(walker);
    }
}

Walker WalkerCloud::born(const BirthPose& pose, float weight) {
    Walker walker;
    walker.watch = m_watch;
    walker.region = pose.region;
    walker.at = pose.at;
    walker.speed = drawSpeed();
    walker.weight = weight;
    walker.follows = m_random.uniform() < 0.6F;
    constexpr int kTries = 3; // somewhere the camera looks to, if there is such a way
    for (int i = 0; i < kTries && !m_options.walking.free; ++i) {
        choose(walker, -1);
        if (std::abs(wrappedDeg(walker.headingDeg - pose.yawDeg)) < 60.0F) break;
        walker.follows = walker.follows && m_random.uniform() < 0.5F;
    }
    walker.yawDeg = pose.yawDeg;
    walker.yawVariance = 100.0F;
    return walker;
}

void WalkerCloud::reconsider() {
    if (m_options.walking.free) return;
    for (Walker& walker : m_walkers) {
        walker.follows = double(m_random.uniform()) < m_options.walking.followShare;
        if (walker.climbTo < 0) choose(walker, -1);
    }
}

void WalkerCloud::headFor(Walker& walker, std::int32_t node, Spot target) {
    walker.node = node;
    walker.target = target;
    if (gapBetween(walker.at, target) < 0.05F) return;
    float heading = directionDeg(walker.at, target);
    if (std::abs(wrappedDeg(heading - walker.headingDeg)) > 25.0F) walker.graceS = kGraceS;
    walker.headingDeg = heading;
}

void WalkerCloud::choose(Walker& walker, std::int32_t from) {
    if (m_map->hasGoal() && walker.follows) {
        double stray = from >= 0 ? m_options.walking.strayAtNode : 0.0;
        if (double(m_random.uniform()) < stray)
            walker.follows = false;
        else
            return chooseWay(walker);
    }
    wander(walker, from);
}

void WalkerCloud::chooseWay(Walker& walker) {
    constexpr float kDoubtM = 0.6F; // people do not measure
    if (walker.region == m_map->goalRegion() && m_map->straight(walker.region, walker.at, m_map->goalSpot()))
        return headFor(walker, Walker::kToSpot, m_map->goalSpot());
    auto nodes = m_map->nodesOf(walker.region);
    m_weights.assign(nodes.size(), WalkingMap::kUnreachable);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const WalkingNode& node = m_map->nodes()[nodes[i]];
        float gap = gapBetween(walker.at, node.at);
        bool standsAtCorner = node.across < 0 && gap < 0.05F;
        if (standsAtCorner || !m_map->leadsOn(nodes[i])) continue;
        m_weights[i] = m_map->toGoal(nodes[i]) + gap + kDoubtM * m_random.uniform();
    }
    constexpr int kTries = 8; // sight lines cost time in regions with many corners: the nearest way first
    std::int32_t best = -1;
    for (int i = 0; i < kTries && best < 0; ++i) {
        auto least = std::min_element(m_weights.begin(), m_weights.end());
        if (least == m_weights.end() || *least >= WalkingMap::kUnreachable) break;
        std::uint32_t candidate = nodes[static_cast<std::size_t>(least - m_weights.begin())];
        if (m_map->straight(walker.region, walker.at, m_map->nodes()[candidate].at))
            best = static_cast<std::int32_t>(candidate);
        *least = WalkingMap::kUnreachable;
    }
    if (best < 0) {
        walker.follows = false;
        return wander(walker, -1);
    }
    const WalkingNode& node = m_map->nodes()[static_cast<std::size_t>(best)];
    float beside = node.halfWidthM * 0.5F * (2.0F * m_random.uniform() - 1.0F);
    headFor(walker, best, {node.at.x + beside * node.along.x, node.at.y + beside * node.along.y});
}

/// How gladly a wanderer walks to each of some nodes of the region: ahead rather than back, near rather than
/// far. The last weight is that of a spot in the region.
float WalkerCloud::weighNodes(const Walker& walker, std::int32_t from) {
    constexpr std::size_t kMost = 24; // of a region with very many doors, some by chance
    auto nodes = m_map->nodesOf(walker.region);
    std::size_t stride = nodes.size() / kMost + 1;
    std::size_t first =
        stride > 1 ? static_cast<std::size_t>(m_random.uniform() * static_cast<float>(stride)) : 0;
    m_nodes.clear();
    m_weights.clear();
    float sum = 0.0F;
    for (std::size_t i = first; i < nodes.size(); i += stride) {
        const WalkingNode& node = m_map->nodes()[nodes[i]];
        float gap = gapBetween(walker.at, node.at);
        if (gap < 0.05F && node.across < 0) continue;
        float turn = wrappedDeg(directionDeg(walker.at, node.at) - walker.headingDeg) / kRadToDeg;
        float weight = std::exp(1.2F * (std::cos(turn) - 1.0F)) / (1.0F + 0.1F * gap);
        if (static_cast<std::int32_t>(nodes[i]) == from)
            weight *= static_cast<float>(m_options.walking.straightBack);
        m_nodes.push_back(nodes[i]);
        m_weights.push_back(weight);
        sum += weight;
    }
    float inside = nodes.size() <= 1 || from < 0 ? 0.6F * std::max(sum, 0.1F) : 0.15F * sum;
    m_weights.push_back(inside + 1e-6F);
    return sum + m_weights.back();
}

void WalkerCloud::wander(Walker& walker, std::int32_t from) {
    float sum = weighNodes(walker, from);
    constexpr int kTries = 4;
    for (int i = 0; i < kTries; ++i) {
        float pick = m_random.uniform() * sum;
        std::size_t chosen = 0;
        while (chosen < m_nodes.size() && pick >= m_weights[chosen]) pick -= m_weights[chosen++];
        if (chosen == m_nodes.size()) break;
        const WalkingNode& node = m_map->nodes()[m_nodes[chosen]];
        if (m_map->straight(walker.region, walker.at, node.at)) {
            float beside = node.halfWidthM * 0.5F * (2.0F * m_random.uniform() - 1.0F);
            return headFor(walker, static_cast<std::int32_t>(m_nodes[chosen]),
                           {node.at.x + beside * node.along.x, node.at.y + beside * node.along.y});
        }
        sum -= std::exchange(m_weights[chosen], 0.0F);
    }
    float u = m_random.uniform(), v = m_random.uniform();
    headFor(walker, Walker::kToSpot, m_map->spotIn(walker.region, u, v));
}

/// Straying is rare, but has to be represented: drawn oftener than it happens, and weighed down for it.
void WalkerCloud::changeMind(Walker& walker, double seconds) {
    constexpr double kOftener = 5.0;
    const WalkingOptions& walking = m_options.walking;
    if (!m_map->hasGoal() || walker.climbTo >= 0) return;
    if (walker.follows) {
        double strays = walking.strayRate * seconds;
        if (m_random.uniformDouble() < kOftener * strays) {
            walker.weight /= static_cast<float>(kOftener);
            walker.follows = false;
            choose(walker, -1);
        } else {
            walker.weight *= static_cast<float>((1.0 - strays) / (1.0 - kOftener * strays));
        }
    } else if (m_random.uniformDouble() < walking.returnRate * seconds) {
        walker.follows = true;
        choose(walker, -1);
    }
}

void WalkerCloud::arrive(Walker& walker) {
    if (walker.node < 0) {
        if (walker.follows && walker.region == m_map->goalRegion()) {
            if (m_options.walking.guided) return wander(walker, -1); // not told of the arrival yet
            walker.node = Walker::kResting;
            return;
        }
        return choose(walker, -1);
    }
    const WalkingNode& node = m_map->nodes()[static_cast<std::size_t>(walker.node)];
    if (node.across < 0) return choose(walker, walker.node);
    const WalkingNode& beyond = m_map->nodes()[static_cast<std::size_t>(node.across)];
    if (node.changesLevel) {
        walker.climbTo = node.across;
        walker.climbShows = m_random.uniform() < (node.isLift ? 0.1F : 0.5F);
        walker.climbM = node.crossingM * (0.85F + 0.3F * m_random.uniform());
        return;
    }
    walker.region = beyond.region;
    walker.at = {walker.target.x + beyond.at.x - node.at.x, walker.target.y + beyond.at.y - node.at.y};
    choose(walker, node.across);
}

void WalkerCloud::climb(Walker& walker, float metres) {
    const WalkingNode& beyond = m_map->nodes()[static_cast<std::size_t>(walker.climbTo)];
    walker.climbM -= metres;
    if (walker.climbM < beyond.crossingM / 2.0F && walker.region != beyond.region) {
        walker.region = beyond.region;
        walker.at = beyond.at;
    }
    if (walker.climbM > 0.0F) return;
    std::int32_t from = walker.climbTo;
    walker.region = beyond.region;
    walker.at = beyond.at;
    walker.climbTo = -1;
    if (m_options.walking.free) return;
    walker.graceS = kGraceS;
    walker.yawVariance = 1e6F;
    choose(walker, from);
    // The next flight of stairs, or the same lift going on: no walk lies between.
    constexpr float kLandingM = 2.5F;
    bool goesOn = walker.node >= 0 && m_map->nodes()[static_cast<std::size_t>(walker.node)].changesLevel;
    if (goesOn && gapBetween(walker.at, walker.target) < kLandingM) arrive(walker);
}

void WalkerCloud::walk(Walker& walker, float metres) {
    constexpr int kMostLegs = 4;
    for (int i = 0; i < kMostLegs && metres > 0.0F && walker.node != Walker::kResting; ++i) {
        if (walker.climbTo >= 0) return climb(walker, metres);
        float gap = gapBetween(walker.at, walker.target);
        if (gap > metres) {
            walker.at.x += (walker.target.x - walker.at.x) * metres / gap;
            walker.at.y += (walker.target.y - walker.at.y) * metres / gap;
            return;
        }
        metres -= gap;
        walker.at = walker.target;
        arrive(walker);
    }
}

/// Standing for long is what people do in lifts and at the goal, seldom in between. On stairs the picture may
/// tell steps or nothing of use: each climber takes one of the two for granted.
float WalkerCloud::standingWeight(Walker& walker, const MotionSpan& motion, bool moving) {
    constexpr float kOnset = 0.15F, kStaysPerS = 0.8F, kMovesOnStairs = 0.35F;
    bool mayStand = walker.climbTo >= 0 ? !walker.climbShows : walker.node == Walker::kResting;
    auto seconds = static_cast<float>(motion.seconds);
    if (moving) {
        walker.stands = false;
        return mayStand ? std::pow(kMovesOnStairs, seconds) : 1.0F;
    }
    float weight = 1.0F;
    if (m_options.walking.guided) mayStand = true; // whoever waits for a word stands anywhere
    if (!mayStand) weight = walker.stands ? std::pow(kStaysPerS, seconds) : kOnset;
    walker.stands = true;
    return weight;
}

/// The way of walking has changed, or has to show itself again: is the camera about there?
float WalkerCloud::settle(Walker& walker) {
    const WalkingOptions& walking = m_options.walking;
    auto sway = static_cast<float>(walking.swaySigmaDeg * walking.swaySigmaDeg);
    if (walker.yawVariance > kYawUnknown) {
        walker.yawDeg = walker.headingDeg;
        walker.yawVariance = sway;
        return 1.0F;
    }
    auto away = static_cast<float>(walking.looksAway);
    float off = wrappedDeg(walker.yawDeg - walker.headingDeg), variance = walker.yawVariance + sway;
    float likely =
        away * std::sqrt(variance) / 143.62F + (1.0F - away) * quickExp(-0.5F * off * off / variance);
    if (std::abs(off) < 75.0F) {
        float kept = sway / variance;
        walker.yawDeg = wrappedDeg(walker.headingDeg + kept * off);
        walker.yawVariance *= kept;
    }
    return likely * 24.0F / std::sqrt(variance);
}

/// The camera sways about the way of walking and comes back to it within seconds: a measured turn tells both
/// whether the walker's own turn was the user's and where the camera looks now.
float WalkerCloud::turn(Walker& walker, const MotionSpan& motion, bool moving) {
    const WalkingOptions& walking = m_options.walking;
    auto seconds = static_cast<float>(motion.seconds);
    auto noise =
        static_cast<float>(motion.seconds * walking.turnSigmaDeg * walking.turnSigmaDeg +
                           motion.unseenSeconds * walking.unknownTurnSigmaDeg * walking.unknownTurnSigmaDeg);
    bool wasTurning = walker.graceS > 0.0F;
    walker.graceS = std::max(0.0F, walker.graceS - seconds);
    bool known = walker.yawVariance <= kYawUnknown;
    if (!moving || walker.climbTo >= 0 || walker.graceS > 0.0F || wasTurning || !known) {
        walker.yawDeg = wrappedDeg(walker.yawDeg + motion.turnDeg);
        walker.yawVariance += noise;
        if (!moving) walker.graceS = std::max(walker.graceS, 0.3F);
        bool settles = moving && walker.climbTo < 0 && walker.graceS <= 0.0F;
        return settles ? settle(walker) : moving ? kNeutral : 1.0F;
    }
    auto sway = static_cast<float>(walking.swaySigmaDeg * walking.swaySigmaDeg);
    float stays = std::exp(-seconds / static_cast<float>(walking.swaySeconds));
    float off = wrappedDeg(walker.yawDeg - walker.headingDeg), p = walker.yawVariance;
    float jitter = sway * (1.0F - stays * stays);
    float variance = (1.0F - stays) * (1.0F - stays) * p + jitter + noise;
    float surprise = wrappedDeg(motion.turnDeg - (stays - 1.0F) * off);
    auto away = static_cast<float>(walking.looksAway);
    float fits = (1.0F - away) * quickExp(-0.5F * surprise * surprise / variance);
    float jumps = away * std::sqrt(variance) / 71.8F;
    if (fits < jumps) {
        walker.yawDeg = wrappedDeg(walker.yawDeg + motion.turnDeg);
        walker.yawVariance = p + noise;
    } else {
        float together = stays * (stays - 1.0F) * p + jitter, gain = together / variance;
        walker.yawDeg = wrappedDeg(walker.headingDeg + stays * off + gain * surprise);
        walker.yawVariance = std::max(1.0F, stays * stays * p + jitter - gain * together);
    }
    return (fits + jumps) * std::sqrt(jitter / variance);
}

double WalkerCloud::advance(const MotionSpan& motion, const SensorModel& sensors, double missTrust) {
    const WalkingOptions& walking = m_options.walking;
    m_motionKnown = motion.measured;
    auto seconds = static_cast<float>(motion.seconds);
    float starts = 1.0F - std::exp(-static_cast<float>(walking.goRate) * seconds);
    float stops = 1.0F - std::exp(-static_cast<float>(walking.stopRate) * seconds);
    double before = 0.0, after = 0.0;
    auto missing = static_cast<float>(missTrust * motion.shownSeconds);
    for (Walker& walker : m_walkers) {
        before += double(walker.weight);
        if (!walking.free) changeMind(walker, motion.seconds);
        bool moving = motion.pace >= kStandsBelow;
        if (!motion.measured) {
            if (m_random.uniform() < (walker.stands ? starts : stops)) walker.stands = !walker.stands;
            moving = !walker.stands;
        }
        float noise = 1.0F + static_cast<float>(walking.distanceSigma) * m_random.normal();
        float metres =
            moving ? walker.speed * seconds * static_cast<float>(motion.pace) * std::max(0.0F, noise) : 0.0F;
        if (motion.measured) walker.weight *= standingWeight(walker, motion, moving);
        if (walker.climbTo >= 0)
            climb(walker, walker.speed * seconds * std::max(0.0F, noise));
        else if (!walking.free)
            walk(walker, metres);
        if (walking.free) {
            stride(walker, motion, moving, metres);
        } else if (motion.measured) {
            float fits = turn(walker, motion, moving);
            walker.weight *= std::pow(std::max(1e-4F, fits), static_cast<float>(walking.headingTrust));
        }
        after += double(walker.weight);
        float drift = 0.02F * std::sqrt(seconds) * m_random.normal();
        walker.speed = std::clamp(walker.speed + drift, static_cast<float>(walking.slowest),
                                  static_cast<float>(walking.hurrySpeed));
        if (missing > 0.0F && walker.climbTo < 0) {
            float missed = m_rates.rateAt(sensors, walker.region, walker.at, gazeOf(walker));
            walker.weight *= quickExp(-missing * missed);
        }
    }
    return before > 0.0 && after > 0.0 ? after / before : 1.0;
}

Gaze WalkerCloud::gazeOf(const Walker& walker) const {
    const WalkingOptions& walking = m_options.walking;
    if (m_motionKnown && walker.yawVariance < kYawUnknown) {
        constexpr float kAnyShare = 0.04F;
        return {walker.yawDeg, walker.yawVariance, kAnyShare};
    }
    if (walker.climbTo >= 0) return {walker.headingDeg, 0.0F, 1.0F};
    auto any = static_cast<float>(walker.stands ? walking.lookShareStanding : walking.lookShareGoing);
    return {walker.headingDeg, static_cast<float>(walking.swaySigmaDeg * walking.swaySigmaDeg), any};
}

void WalkerCloud::face(Walker& walker, const Cause& cause) const {
    constexpr float kFarOff = 60.0F;
    if (!m_motionKnown || walker.yawVariance > kYawUnknown || std::abs(cause.offDeg) > kFarOff) return;
    float gain = walker.yawVariance / (walker.yawVariance + cause.variance);
    walker.yawDeg = wrappedDeg(walker.yawDeg + gain * cause.offDeg);
    walker.yawVariance *= 1.0F - gain;
}

double WalkerCloud::totalWeight() const {
    double sum = 0.0;
    for (const Walker& walker : m_walkers) sum += double(walker.weight);
    return sum;
}

void WalkerCloud::scale(double factor) {
    for (Walker& walker : m_walkers) walker.weight = static_cast<float>(double(walker.weight) * factor);
}

double WalkerCloud::meanSpeed() const {
    double sum = 0.0, total = 0.0;
    for (const Walker& walker : m_walkers) {
        sum += double(walker.weight) * double(walker.speed);
        total += double(walker.weight);
    }
    return total > 0.0 ? sum / total : m_options.walking.speed;
}

void WalkerCloud::changeWatch(double weight) {
    m_watch = m_watch == 1 ? 2 : 1;
    for (Walker& walker : m_walkers)
        if (walker.watch == m_watch) walker.watch = 0;
    spread(watchCapacity(), weight, std::nullopt, m_watch);
}

void WalkerCloud::renew() {
    // In the order of their watches, without a change of order within one.
    std::array<std::size_t, 4> begin{};
    for (const Walker& walker : m_walkers) ++begin[walker.watch + 1U];
    for (std::size_t w = 1; w < begin.size(); ++w) begin[w] += begin[w - 1];
    auto needsRoom = [&](std::size_t w) {
        std::size_t count = begin[w + 1] - begin[w], most = w == 0 ? m_capacity : watchCapacity();
        if (count == 0) return false;
        if (count > most + most / 4) return true;
        double sum = 0.0, squares = 0.0;
        for (const Walker& walker : m_walkers) {
            if (walker.watch != w) continue;
            sum += double(walker.weight);
            squares += double(walker.weight) * double(walker.weight);
        }
        constexpr double kEnough = 0.5;
        return sum > 0.0 && sum * sum / squares <= kEnough * static_cast<double>(count);
    };
    std::array<bool, 3> renews{needsRoom(0), needsRoom(1), needsRoom(2)};
    if (!renews[0] && !renews[1] && !renews[2]) return;
    m_sorted.resize(m_walkers.size());
    std::array<std::size_t, 4> next = begin;
    for (const Walker& walker : m_walkers) m_sorted[next[walker.watch]++] = walker;
    m_walkers.clear();
    for (std::size_t w = 0; w < renews.size(); ++w) {
        if (renews[w]) {
            renew(begin[w], begin[w + 1], w == 0 ? m_capacity : watchCapacity());
        } else {
            m_walkers.insert(m_walkers.end(), m_sorted.begin() + static_cast<std::ptrdiff_t>(begin[w]),
                             m_sorted.begin() + static_cast<std::ptrdiff_t>(begin[w + 1]));
        }
    }
    m_speed = meanSpeed();
}

/// The unlikely are drawn oftener than their weight asks for, and keep a smaller one: so the second best
/// guess, needed when the first fails, is not forgotten. By regions: walkers of one region are much alike, so
/// a region gets walkers by a root of its share, however often they are drawn anew.
void WalkerCloud::renew(std::size_t first, std::size_t last, std::size_t capacity) {
    double sum = 0.0, total = 0.0, kept = 0.0;
    m_shares.resize(m_map->building().regions().size(), 0.0F);
    for (std::size_t i = first; i < last; ++i) {
        sum += double(m_sorted[i].weight);
        m_shares[m_sorted[i].region] += m_sorted[i].weight;
    }
    auto power = static_cast<float>(m_options.evenness);
    m_sums.resize(last - first);
    for (std::size_t i = first; i < last && sum > 0.0; ++i) {
        const Walker& walker = m_sorted[i];
        float share = m_shares[walker.region];
        if (share > 0.0F) { // not yet a factor: made one at the first walker of the region
            share = -std::pow(share / static_cast<float>(sum), -power);
            m_shares[walker.region] = share;
        }
        total += double(walker.weight) / sum * double(-share);
        m_sums[i - first] = total;
    }
    for (std::size_t i = first; i < last; ++i) m_shares[m_sorted[i].region] = 0.0F;
    if (!(total > 0.0)) return;
    std::size_t begun = m_walkers.size();
    double step = total / static_cast<double>(capacity), at = step * m_random.uniformDouble();
    for (std::size_t i = first; i < last; ++i) {
        double upTo = m_sums[i - first], each = upTo - (i > first ? m_sums[i - first - 1] : 0.0);
        for (; at < upTo; at += step) {
            m_walkers.push_back(m_sorted[i]);
            // Drawn each/step times in the mean; together they keep the weight they had.
            m_walkers.back().weight = static_cast<float>(double(m_sorted[i].weight) * step / each);
            kept += double(m_walkers.back().weight);
        }
    }
    for (std::size_t i = begun; kept > 0.0 && i < m_walkers.size(); ++i)
        m_walkers[i].weight = static_cast<float>(double(m_walkers[i].weight) * sum / kept);
}

} // namespace farol::localisation
