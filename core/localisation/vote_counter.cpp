#include "core/localisation/vote_counter.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace farol::localisation {

namespace {

constexpr std::size_t kMostItems = 64;
constexpr double kTie = 1e-9;

/// One bit for each of the newest items.
std::uint64_t newestItems(std::size_t size, std::size_t count) {
    std::uint64_t mask = 0;
    for (std::size_t i = size - std::min(count, size); i < size; ++i) mask |= std::uint64_t{1} << i;
    return mask;
}

bool isLevelChange(Kind kind) {
    return kind == Kind::Stairs || kind == Kind::Elevator;
}

int signWithDeadBand(double value, double deadBand) {
    return value > deadBand ? 1 : value < -deadBand ? -1 : 0;
}

/// Do the borders run along each other for half a metre? Only for the reading that walls join regions too.
bool shareWall(const building::Region& a, const building::Region& b) {
    constexpr double kGapM = 0.35, kStepM = 0.25;
    constexpr int kSteps = 2;
    int touching = 0;
    const Ring& ring = a.polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        Point2 from = ring[i], along = ring[(i + 1) % ring.size()] - from;
        auto steps = static_cast<int>(std::min(length(along) / kStepM, 1e5));
        for (int k = 0; k < steps; ++k) {
            Point2 p = from + along * ((k + 0.5) / steps);
            if (distanceToPolygon(b.polygon, p) <= kGapM && ++touching >= kSteps) return true;
        }
    }
    return false;
}

bool boxesMeet(const Box2& a, const Box2& b, double gap) {
    return a.low.x <= b.high.x + gap && b.low.x <= a.high.x + gap && a.low.y <= b.high.y + gap &&
           b.low.y <= a.high.y + gap;
}

} // namespace

double regionVote(double preg, double rp, double rv, bool clamp) {
    double neighbourWeight = clamp ? std::max(preg - 1.0, 0.0) : preg - 1.0;
    return preg * rp + neighbourWeight * rv;
}

/// What one count works on: the history, and which landmarks are identical to which of its items.
struct VoteCounter::Tally {
    std::vector<const Observation*> items;
    std::vector<Identity> identities;
    std::vector<Mask> matches; ///< of each landmark
    Mask mapped = 0;           ///< items that some landmark is identical to
    Mask unmistakable = 0;     ///< by template or text, and in one region only
    Mask reference = 0;        ///< items that count as the last detected
    bool levelWeight = false;  ///< Pf applies
    int nobj = 0;
};

VoteCounter::VoteCounter(std::shared_ptr<const building::Building> building, const VotingOptions& options)
    : m_building(std::move(building)), m_options(options) {
    for (const building::Landmark& landmark : m_building->landmarks()) {
        m_identities.push_back(identityOf(landmark));
        m_regionOf.push_back(m_building->regionIndex(landmark.region));
    }
    for (const building::Region& region : m_building->regions()) {
        if (region.level != m_building->regions().front().level) m_severalLevels = true;
    }
    findNeighbours();
}

void VoteCounter::findNeighbours() {
    const auto& regions = m_building->regions();
    m_neighbours.resize(regions.size());
    std::vector<std::optional<Box2>> boxes;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        auto joined = m_building->neighboursOf(i);
        m_neighbours[i].assign(joined.begin(), joined.end());
        boxes.push_back(boundingBox(regions[i].polygon.outer));
    }
    if (m_options.neighbours != NeighbourRule::AccessesAndWalls) return;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        for (std::size_t j = i + 1; j < regions.size(); ++j) {
            if (regions[i].level != regions[j].level || !boxes[i] || !boxes[j]) continue;
            if (!boxesMeet(*boxes[i], *boxes[j], 0.5) || !shareWall(regions[i], regions[j])) continue;
            m_neighbours[i].push_back(j);
            m_neighbours[j].push_back(i);
        }
    }
    for (auto& list : m_neighbours) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
}

VoteCounter::Tally VoteCounter::tally(const Situation& situation, const std::deque<Observation>& history,
                                      std::size_t freshCount) const {
    Tally result;
    std::size_t first = history.size() > kMostItems ? history.size() - kMostItems : 0;
    for (std::size_t i = first; i < history.size(); ++i) {
        result.items.push_back(&history[i]);
        result.identities.push_back(identityOf(history[i].detection));
    }
    result.matches.assign(m_identities.size(), 0);
    for (std::size_t i = 0; i < result.items.size(); ++i) {
        const Identity& seen = result.identities[i];
        bool telling = !seen.templateId.empty() ||
                       (!seen.text.empty() && (seen.kind == Kind::Text || seen.kind == Kind::Sign));
        std::optional<std::size_t> only;
        bool severalRegions = false;
        for (std::size_t landmark = 0; landmark < m_identities.size(); ++landmark) {
            if (!m_regionOf[landmark] || !sameThing(m_identities[landmark], seen, m_options.textTolerance))
                continue;
            result.matches[landmark] |= Mask{1} << i;
            if (only && *only != *m_regionOf[landmark]) severalRegions = true;
            only = m_regionOf[landmark];
        }
        if (only) result.mapped |= Mask{1} << i;
        if (only && telling && !severalRegions) result.unmistakable |= Mask{1} << i;
    }
    result.nobj =
        m_options.unmappedObjectsCount ? static_cast<int>(result.items.size()) : std::popcount(result.mapped);
    result.reference = lastDetected(result, freshCount);
    result.levelWeight = m_severalLevels && situation.known();
    if (m_options.levelWeightAtStairs) return result;
    if (situation.known() && m_building->nearLevelChange(*situation.lastRegion)) result.levelWeight = false;
    for (std::size_t i = result.items.size() - std::min(freshCount, result.items.size());
         i < result.items.size(); ++i) {
        if (isLevelChange(result.items[i]->detection.kind)) result.levelWeight = false;
    }
    return result;
}

VoteCounter::Mask VoteCounter::lastDetected(const Tally& tally, std::size_t freshCount) const {
    Mask fresh = newestItems(tally.items.size(), freshCount);
    if (m_options.genericsToOverrule <= 1 || tally.unmistakable == 0) return fresh;
    if (Mask telling = fresh & tally.unmistakable; telling != 0) return telling;
    auto newest = static_cast<std::size_t>(std::bit_width(tally.unmistakable)) - 1;
    Mask after = newest + 1 < kMostItems ? tally.mapped & (~Mask{0} << (newest + 1)) : 0;
    return std::popcount(after) < m_options.genericsToOverrule ? Mask{1} << newest : fresh;
}

int VoteCounter::directionWeight(const Situation& situation, Point2 object) const {
    int unknown = m_options.directionUnknownIsOne ? 1 : 0;
    if (!situation.known() || !situation.nextAccess) return unknown;
    if (!situation.position && !m_options.directionFromRegion) return unknown;
    Point2 origin = situation.position ? *situation.position
                                       : centroid(m_building->regions()[*situation.lastRegion].polygon);
    Point2 displacement = *situation.nextAccess - origin;
    Point2 direction = object - origin;
    if (!isFinite(displacement) || !isFinite(direction)) return unknown;
    auto same = [&](double a, double b) {
        return signWithDeadBand(a, m_options.componentDeadBandM) ==
               signWithDeadBand(b, m_options.componentDeadBandM);
    };
    return 1 + (same(displacement.x, direction.x) ? 1 : 0) + (same(displacement.y, direction.y) ? 1 : 0);
}

void VoteCounter::weighObjects(const Situation& situation, const Tally& tally, Ballot& ballot) const {
    for (std::size_t landmark : m_building->landmarksOf(ballot.region)) {
        if ((tally.matches[landmark] & tally.reference) == 0) continue;
        double pdir = directionWeight(situation, m_building->landmarks()[landmark].position);
        double pf = 0.0;
        if (tally.levelWeight) {
            double here = m_building->regions()[*situation.lastRegion].level;
            pf = m_building->regions()[ballot.region].level == here ? m_options.pf : 0.0;
        }
        double pobj = pdir + pf;
        if (ballot.bestObject && pobj <= ballot.pobj + kTie) {
            if (pobj >= ballot.pobj - kTie) ballot.bestUnique = false;
            continue;
        }
        ballot.bestObject = landmark;
        ballot.bestUnique = true;
        ballot.pobj = pobj;
        ballot.pdir = pdir;
        ballot.pf = pf;
    }
    ballot.pmaxobj = ballot.pobj;
}

VoteCounter::Mask VoteCounter::explained(const Tally& tally, const std::vector<std::size_t>& landmarks,
                                         Mask wanted) const {
    Mask all = 0;
    for (std::size_t landmark : landmarks) all |= tally.matches[landmark];
    all &= wanted;
    if (!m_options.eachLandmarkOnce) return all;
    // Largest matching by augmenting paths, newest items first; an item once matched stays matched.
    std::vector<int> itemOf(landmarks.size(), -1);
    std::vector<char> visited;
    auto augment = [&](auto&& self, int item) -> bool {
        for (std::size_t k = 0; k < landmarks.size(); ++k) {
            if (visited[k] != 0 || (tally.matches[landmarks[k]] >> item & 1U) == 0) continue;
            visited[k] = 1;
            if (itemOf[k] < 0 || self(self, itemOf[k])) {
                itemOf[k] = item;
                return true;
            }
        }
        return false;
    };
    Mask found = 0;
    for (int item = static_cast<int>(tally.items.size()) - 1; item >= 0; --item) {
        if ((all >> item & 1U) == 0) continue;
        visited.assign(landmarks.size(), 0);
        if (augment(augment, item)) found |= Mask{1} << item;
    }
    return found;
}

int VoteCounter::neighbourObjects(const Tally& tally, std::size_t region, Mask remaining) const {
    std::vector<std::size_t> landmarks;
    int best = 0;
    for (std::size_t neighbour : m_neighbours[region]) {
        if (m_options.nv == NeighbourCount::BestNeighbour) landmarks.clear();
        for (std::size_t landmark : m_building->landmarksOf(neighbour)) {
            if ((tally.matches[landmark] & remaining) != 0) landmarks.push_back(landmark);
        }
        if (m_options.nv == NeighbourCount::BestNeighbour) {
            best = std::max(best, std::popcount(explained(tally, landmarks, remaining)));
        }
    }
    if (m_options.nv == NeighbourCount::BestNeighbour) return best;
    return std::popcount(explained(tally, landmarks, remaining));
}

void VoteCounter::countObjects(const Tally& tally, Ballot& ballot) const {
    for (std::size_t landmark : m_building->landmarksOf(ballot.region)) {
        if (tally.matches[landmark] != 0) ballot.evidence.push_back(landmark);
    }
    Mask here = explained(tally, ballot.evidence, tally.mapped);
    ballot.unmistakable = (here & tally.unmistakable) != 0;
    ballot.np = std::popcount(here);
    ballot.nv = neighbourObjects(tally, ballot.region, tally.mapped & ~here);
    ballot.nobj = tally.nobj;
    ballot.rp = tally.nobj > 0 ? static_cast<double>(ballot.np) / tally.nobj : 0.0;
    ballot.rv = tally.nobj > 0 ? static_cast<double>(ballot.nv) / tally.nobj : 0.0;
}

/// Two objects of one scene that the map has within a metre of each other in this region.
bool VoteCounter::sceneAgrees(const Tally& tally, std::size_t region) const {
    auto landmarks = m_building->landmarksOf(region);
    for (std::size_t a : landmarks) {
        for (std::size_t b : landmarks) {
            if (a == b || tally.matches[a] == 0 || tally.matches[b] == 0) continue;
            Point2 gap = m_building->landmarks()[a].position - m_building->landmarks()[b].position;
            if (!(length(gap) <= m_options.sameSceneRadiusM)) continue;
            for (std::size_t i = 0; i < tally.items.size(); ++i) {
                for (std::size_t j = 0; j < tally.items.size(); ++j) {
                    if (i == j || tally.items[i]->scene != tally.items[j]->scene) continue;
                    if ((tally.matches[a] >> i & 1U) != 0 && (tally.matches[b] >> j & 1U) != 0) return true;
                }
            }
        }
    }
    return false;
}

void VoteCounter::addRegionWeights(const Situation& situation, const Tally& tally, Ballot& ballot) const {
    if (situation.known()) {
        const auto& near = m_neighbours[*situation.lastRegion];
        bool isNear = std::binary_search(near.begin(), near.end(), ballot.region);
        bool stays = m_options.stayCounts && ballot.region == *situation.lastRegion;
        if (isNear || stays) ballot.ppos = m_options.ppos;
    }
    bool onRoute =
        std::find(situation.route.begin(), situation.route.end(), ballot.region) != situation.route.end();
    if (onRoute && (ballot.bestObject || !m_options.percNeedsObject)) ballot.pperc = m_options.pperc;
    if (sceneAgrees(tally, ballot.region)) ballot.pid = m_options.pid;
    ballot.preg = ballot.pmaxobj + ballot.ppos + ballot.pperc + ballot.pid;
    ballot.vreg = regionVote(ballot.preg, ballot.rp, ballot.rv, m_options.clampNeighbourWeight);
}

std::vector<Ballot> VoteCounter::count(const Situation& situation, const std::deque<Observation>& history,
                                       std::size_t freshCount) const {
    Tally work = tally(situation, history, freshCount);
    std::vector<Ballot> ballots;
    if (!m_options.unmappedObjectsCount && (newestItems(work.items.size(), freshCount) & work.mapped) == 0)
        return ballots;
    for (std::size_t region = 0; region < m_building->regions().size(); ++region) {
        Ballot ballot;
        ballot.region = region;
        countObjects(work, ballot);
        if (ballot.np == 0 && ballot.nv == 0) continue;
        weighObjects(situation, work, ballot);
        addRegionWeights(situation, work, ballot);
        ballots.push_back(std::move(ballot));
    }
    auto routeRank = [&](std::size_t region) {
        return std::find(situation.route.begin(), situation.route.end(), region) - situation.route.begin();
    };
    auto better = [&](const Ballot& a, const Ballot& b) {
        // Rounded, so that sums in another order still tie.
        long long voteA = std::llround(a.vreg / kTie), voteB = std::llround(b.vreg / kTie);
        if (voteA != voteB) return voteA > voteB;
        if (!m_options.tiesByRoute)
            return m_building->regions()[a.region].id < m_building->regions()[b.region].id;
        bool currentA = a.region == situation.lastRegion, currentB = b.region == situation.lastRegion;
        if (currentA != currentB) return currentA;
        auto rankA = routeRank(a.region), rankB = routeRank(b.region);
        if (rankA != rankB) return rankA < rankB;
        return m_building->regions()[a.region].id < m_building->regions()[b.region].id;
    };
    std::sort(ballots.begin(), ballots.end(), better);
    return ballots;
}

} // namespace farol::localisation
