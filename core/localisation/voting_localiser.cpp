#include "core/localisation/voting_localiser.h"

#include "core/localisation/vote_counter.h"

#include <algorithm>
#include <cmath>

namespace farol::localisation {

namespace {

constexpr double kLeastVote = 1e-9;

Error outOfRange(const char* message, const char* option) {
    return {ErrorCode::InvalidArgument, message, std::string("voting.") + option};
}

std::map<std::string, double> termsOf(const Ballot& ballot) {
    return {{"Pobj", ballot.pobj},
            {"Pdir", ballot.pdir},
            {"Pf", ballot.pf},
            {"Ppos", ballot.ppos},
            {"Pmaxobj", ballot.pmaxobj},
            {"Pperc", ballot.pperc},
            {"PID", ballot.pid},
            {"Preg", ballot.preg},
            {"Np", static_cast<double>(ballot.np)},
            {"Rp", ballot.rp},
            {"Rv", ballot.rv},
            {"Nv", static_cast<double>(ballot.nv)},
            {"Vreg", ballot.vreg},
            {"Nobj", static_cast<double>(ballot.nobj)}};
}

class VotingLocaliser final : public Localiser {
public:
    VotingLocaliser(std::shared_ptr<const building::Building> building, const VotingOptions& options,
                    std::string name)
        : m_building(building), m_options(options), m_name(std::move(name)), m_counter(building, options) {}

    void start(double time, const std::optional<RegionId>& region) override;
    void setRoute(const RouteContext& route) override;
    Fix update(double time, std::span<const Observation> fresh,
               const std::deque<Observation>& history) override;
    std::string name() const override { return m_name; }

private:
    struct Spot {
        Point2 position;
        double level = 0.0;
        double time = 0.0;
    };

    void vote(const std::deque<Observation>& history, std::size_t freshCount);
    void decide(const std::vector<Ballot>& ballots, std::size_t historySize, double priorConfidence);
    void lose();
    void accept(const Ballot& winner, double confidence);
    void refuse(const std::vector<Ballot>& ballots, std::size_t contenders, const std::string& note);
    void placeAt(const Ballot& winner);
    void followWalking(const Spot& spot);
    void findNear(const std::vector<Ballot>& ballots, double support);
    void publishVotes(const std::vector<Ballot>& ballots);
    double decayFactor() const {
        return std::exp2(-(m_now - m_fix.evidenceTime) / m_options.halfLifeSeconds);
    }
    const RegionId& idOf(std::size_t region) const { return m_building->regions()[region].id; }

    std::shared_ptr<const building::Building> m_building;
    VotingOptions m_options;
    std::string m_name;
    VoteCounter m_counter;
    Situation m_situation;
    Fix m_fix; ///< as of the last evidence; confidence not yet decayed
    double m_now = 0.0;
    bool m_started = false;
    std::size_t m_objectsSeen = 0;
    std::optional<Spot> m_spot;       ///< P2 of the paper, the newest position
    std::optional<Radians> m_walking; ///< from the position before it
};

void VotingLocaliser::start(double time, const std::optional<RegionId>& region) {
    std::vector<std::size_t> route = std::move(m_situation.route);
    std::optional<Point2> nextAccess = m_situation.nextAccess;
    m_situation = {};
    m_situation.route = std::move(route);
    m_situation.nextAccess = nextAccess;
    m_fix = {};
    m_spot.reset();
    m_walking.reset();
    m_objectsSeen = 0;
    m_started = true;
    m_now = std::isfinite(time) ? time : 0.0;
    m_fix.time = m_fix.evidenceTime = m_now;
    if (!region) {
        m_fix.note = "the start is unknown: no landmark seen yet";
    } else if (auto index = m_building->regionIndex(*region)) {
        m_situation.lastRegion = index;
        m_fix.region = *region;
        m_fix.level = m_building->regions()[*index].level;
        m_fix.confidence = m_options.startConfidence;
        m_fix.near.push_back(*region);
        for (std::size_t neighbour : m_counter.neighboursOf(*index)) m_fix.near.push_back(idOf(neighbour));
        m_fix.nearConfidence = (1.0 + m_options.startConfidence) / 2.0;
        m_fix.note = "the start as it was told: no landmark seen yet";
    } else {
        m_fix.note = "the start region " + region->value + " is not in the map";
    }
    if (m_building->landmarks().empty()) {
        m_fix.note = "the map has no landmarks, so nothing that is seen tells where the user is";
    }
}

void VotingLocaliser::setRoute(const RouteContext& route) {
    m_situation.route.clear();
    for (const RegionId& id : route.regions) {
        if (auto index = m_building->regionIndex(id)) m_situation.route.push_back(*index);
    }
    m_situation.nextAccess = route.nextAccess;
    if (m_situation.nextAccess && !isFinite(*m_situation.nextAccess)) m_situation.nextAccess.reset();
}

Fix VotingLocaliser::update(double time, std::span<const Observation> fresh,
                            const std::deque<Observation>& history) {
    if (!m_started) start(time, std::nullopt);
    if (std::isfinite(time)) m_now = std::max(m_now, time);
    if (!fresh.empty()) {
        m_objectsSeen += fresh.size();
        if (history.empty())
            vote(std::deque<Observation>(fresh.begin(), fresh.end()), fresh.size());
        else
            vote(history, fresh.size());
    }
    Fix fix = m_fix;
    fix.time = m_now;
    fix.confidence *= decayFactor();
    fix.nearConfidence *= decayFactor();
    return fix;
}

void VotingLocaliser::vote(const std::deque<Observation>& history, std::size_t freshCount) {
    if (m_building->landmarks().empty()) return;
    std::vector<Ballot> ballots = m_counter.count(m_situation, history, freshCount);
    publishVotes(ballots);
    if (ballots.empty() || ballots.front().vreg <= kLeastVote) {
        // The fix before it stays, at the confidence it has by now.
        m_fix.note = ballots.empty() ? "the map has no landmark identical to what was seen"
                                     : "no region has a vote above zero";
        return;
    }
    double prior = m_fix.confidence * decayFactor();
    m_fix.evidenceTime = m_now;
    decide(ballots, history.size(), prior);
}

/// Steps (c) to (e).
void VotingLocaliser::decide(const std::vector<Ballot>& ballots, std::size_t historySize,
                             double priorConfidence) {
    const Ballot& winner = ballots.front();
    double best = winner.vreg;
    double second = ballots.size() > 1 ? std::max(ballots[1].vreg, 0.0) : 0.0;
    double margin = std::clamp((best - second) / best, 0.0, 1.0);
    double support = std::min(1.0, 0.2 + 0.2 * winner.np);
    std::size_t contenders = 1;
    while (contenders < ballots.size() &&
           ballots[contenders].vreg > best * (1.0 - m_options.doubtfulMargin)) {
        ++contenders;
    }
    m_fix.note.clear();
    auto end = ballots.begin() + static_cast<std::ptrdiff_t>(contenders);
    auto current = std::find_if(ballots.begin(), end, [&](const Ballot& ballot) {
        return ballot.region == m_situation.lastRegion && !m_situation.lost && ballot.np > 0;
    });
    bool unknownStart = !m_situation.lastRegion.has_value();
    if (unknownStart &&
        std::max(m_objectsSeen, historySize) < static_cast<std::size_t>(m_options.minimumObjects)) {
        refuse(ballots, contenders, "too few objects seen since the unknown start");
    } else if (m_options.alwaysAnswers) {
        accept(winner, margin * support);
        if (m_options.lostWithoutObject && winner.np == 0) lose();
    } else if (contenders > 1 && current != end) {
        // A tie says nothing for the region, but nothing against it either.
        accept(*current, std::max(margin * support, priorConfidence / 2.0));
        m_fix.note =
            "doubtful: as likely as " + idOf(ballots[current == ballots.begin() ? 1 : 0].region).value;
    } else if (m_options.lostWithoutObject && winner.np == 0) {
        refuse(ballots, contenders, "");
        lose();
    } else if (contenders > 1) {
        refuse(ballots, contenders, "doubtful: several regions have nearly the same vote");
    } else {
        accept(winner, margin * support);
    }
    findNear(ballots, support);
}

void VotingLocaliser::lose() {
    m_situation.lost = true;
    m_fix.confidence = 0.0;
    m_fix.note = "lost: the region with the highest vote holds none of the objects seen";
}

void VotingLocaliser::accept(const Ballot& winner, double confidence) {
    m_situation.lastRegion = winner.region;
    m_situation.lost = false;
    m_fix.region = idOf(winner.region);
    m_fix.level = m_building->regions()[winner.region].level;
    // Doors look alike: any number of them names no region for sure.
    m_fix.confidence = winner.unmistakable ? confidence : std::min(confidence, m_options.genericConfidence);
    placeAt(winner);
}

void VotingLocaliser::refuse(const std::vector<Ballot>& ballots, std::size_t contenders,
                             const std::string& note) {
    m_situation.position.reset();
    m_fix.region.reset();
    m_fix.position.reset();
    m_fix.heading.reset();
    m_fix.sigmaM = 0.0;
    m_fix.confidence = 0.0;
    m_fix.landmark = {};
    m_fix.note = note;
    m_fix.level = m_building->regions()[ballots.front().region].level;
    for (std::size_t i = 1; i < contenders; ++i) {
        if (m_building->regions()[ballots[i].region].level != m_fix.level) {
            m_fix.level.reset();
            break;
        }
    }
}

/// Step (d): the position of the object with the greatest weight, when no other of the region weighs as much.
void VotingLocaliser::placeAt(const Ballot& winner) {
    m_fix.position.reset();
    m_fix.heading.reset();
    m_fix.sigmaM = 0.0;
    m_fix.landmark = {};
    m_situation.position.reset();
    if (!winner.bestObject || (m_options.positionNeedsUnique && !winner.bestUnique)) return;
    const building::Landmark& object = m_building->landmarks()[*winner.bestObject];
    if (!isFinite(object.position)) return;
    m_fix.position = m_situation.position = object.position;
    m_fix.sigmaM = object.kind == Kind::Place ? m_options.placeSigmaM : m_options.objectSigmaM;
    m_fix.landmark = object.id;
    followWalking({object.position, *m_fix.level, m_now});
    bool looksAlong = m_options.headingFromPlaces && object.kind == Kind::Place && object.heading.has_value();
    m_fix.heading = looksAlong ? object.heading : m_walking;
}

/// The paper's direction vector, from the last position to this one.
void VotingLocaliser::followWalking(const Spot& spot) {
    if (!m_spot || m_spot->level != spot.level) {
        m_spot = spot;
        m_walking.reset();
        return;
    }
    double step = distance(m_spot->position, spot.position);
    if (step < m_options.headingDistanceM) return;
    double reach = m_options.headingMaxSpeed * (spot.time - m_spot->time) + m_options.headingDistanceM;
    bool walked = m_options.headingMaxSpeed <= 0.0 || step <= reach;
    m_walking.reset();
    if (walked) m_walking = directionOf(spot.position - m_spot->position);
    m_spot = spot;
}

void VotingLocaliser::findNear(const std::vector<Ballot>& ballots, double support) {
    m_fix.near.clear();
    std::size_t centre = ballots.front().region;
    if (m_fix.region) centre = *m_situation.lastRegion;
    const auto& neighbours = m_counter.neighboursOf(centre);
    auto isNear = [&](std::size_t region) {
        return region == centre || std::binary_search(neighbours.begin(), neighbours.end(), region);
    };
    m_fix.near.push_back(idOf(centre));
    double inside = 0.0, outside = 0.0;
    for (const Ballot& ballot : ballots) {
        (isNear(ballot.region) ? inside : outside) =
            std::max(isNear(ballot.region) ? inside : outside, ballot.vreg);
        if (ballot.region != centre && isNear(ballot.region) && ballot.vreg > kLeastVote) {
            m_fix.near.push_back(idOf(ballot.region));
        }
    }
    double lead = inside > kLeastVote ? std::clamp((inside - outside) / inside, 0.0, 1.0) : 0.0;
    m_fix.nearConfidence = std::max(m_fix.confidence, lead * support);
}

void VotingLocaliser::publishVotes(const std::vector<Ballot>& ballots) {
    m_fix.votes.clear();
    for (const Ballot& ballot : ballots) {
        if (m_fix.votes.size() >= m_options.votesKept) break;
        if (std::abs(ballot.vreg) <= kLeastVote) continue;
        RegionVote vote;
        vote.region = idOf(ballot.region);
        vote.vote = ballot.vreg;
        vote.terms = termsOf(ballot);
        for (std::size_t landmark : ballot.evidence)
            vote.evidence.push_back(m_building->landmarks()[landmark].id);
        m_fix.votes.push_back(std::move(vote));
    }
}

} // namespace

VotingOptions VotingOptions::literal() {
    VotingOptions options;
    options.clampNeighbourWeight = false;
    options.stayCounts = false;
    options.unmappedObjectsCount = true;
    options.alwaysAnswers = true;
    options.doubtfulMargin = 0.0;
    options.genericsToOverrule = 1;
    options.headingMaxSpeed = 0.0;
    options.headingFromPlaces = false;
    return options;
}

Result<void> VotingOptions::check() const {
    auto isPositive = [](double value) { return std::isfinite(value) && value > 0.0; };
    auto isWeight = [](double value) { return std::isfinite(value) && value >= 0.0; };
    auto isShare = [](double value) { return value >= 0.0 && value <= 1.0; };
    if (!isWeight(componentDeadBandM)) return outOfRange("must be 0 metres or more", "componentDeadBandM");
    if (!isWeight(sameSceneRadiusM)) return outOfRange("must be 0 metres or more", "sameSceneRadiusM");
    if (textTolerance < 0) return outOfRange("an edit distance is 0 or more", "textTolerance");
    if (minimumObjects < 1) return outOfRange("must be 1 or more", "minimumObjects");
    if (genericsToOverrule < 1) return outOfRange("must be 1 or more", "genericsToOverrule");
    if (!isShare(doubtfulMargin)) return outOfRange("must be from 0 to 1", "doubtfulMargin");
    if (!isShare(startConfidence)) return outOfRange("must be from 0 to 1", "startConfidence");
    if (!isShare(genericConfidence)) return outOfRange("must be from 0 to 1", "genericConfidence");
    if (!isWeight(pf) || !isWeight(ppos) || !isWeight(pperc) || !isWeight(pid)) {
        return outOfRange("a weight is 0 or more", "pf, ppos, pperc, pid");
    }
    if (!isPositive(halfLifeSeconds)) return outOfRange("must be above 0 seconds", "halfLifeSeconds");
    if (!isPositive(placeSigmaM) || !isPositive(objectSigmaM)) {
        return outOfRange("must be above 0 metres", "placeSigmaM, objectSigmaM");
    }
    if (!isPositive(headingDistanceM)) return outOfRange("must be above 0 metres", "headingDistanceM");
    if (!isWeight(headingMaxSpeed)) return outOfRange("must be 0 metres a second or more", "headingMaxSpeed");
    return {};
}

std::unique_ptr<Localiser> makeVotingLocaliser(std::shared_ptr<const building::Building> building,
                                               VotingOptions options, std::string name) {
    return std::make_unique<VotingLocaliser>(std::move(building), options, std::move(name));
}

} // namespace farol::localisation
