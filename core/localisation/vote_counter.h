#pragma once
// Steps (a) and (b) of the paper's 4.2: the weights of the objects and the votes of the regions. No state of
// a walk.

#include "core/localisation/identity.h"
#include "core/localisation/voting_localiser.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace farol::localisation {

/// What the voting knows of the user before an object is weighed. Regions and landmarks by their index in the
/// building.
struct Situation {
    std::optional<std::size_t> lastRegion; ///< empty: never known
    bool lost = false;                     ///< then the last region is no help
    std::optional<Point2> position;
    std::optional<Point2> nextAccess;
    std::vector<std::size_t> route; ///< regions in walking order

    bool known() const { return lastRegion.has_value() && !lost; }
};

/// The vote of one region, every part named as in the paper.
struct Ballot {
    std::size_t region = 0;
    double pobj = 0, pdir = 0, pf = 0; ///< of the object with the greatest weight
    double pmaxobj = 0, ppos = 0, pperc = 0, pid = 0, preg = 0;
    int np = 0, nv = 0, nobj = 0;
    double rp = 0, rv = 0, vreg = 0;
    std::optional<std::size_t> bestObject; ///< landmark of Pmaxobj
    bool unmistakable = false;         ///< an object known by template or text, here only, is in the history
    bool bestUnique = false;           ///< no other identical landmark of the region weighs as much
    std::vector<std::size_t> evidence; ///< landmarks identical to history objects
};

/// Vreg = Preg x Rp + (Preg - 1) x Rv. `clamp`: the second factor not below 0.
double regionVote(double preg, double rp, double rv, bool clamp);

class VoteCounter {
public:
    VoteCounter(std::shared_ptr<const building::Building> building, const VotingOptions& options);

    /// Ballots of all regions that hold history objects or adjoin such regions, best first. Ties: the current
    /// region, then the earlier on the route, then the lower id. `freshCount` of the newest history items are
    /// the last detected; none when the map knows nothing like them (unless such objects count).
    std::vector<Ballot> count(const Situation& situation, const std::deque<Observation>& history,
                              std::size_t freshCount) const;
    const std::vector<std::size_t>& neighboursOf(std::size_t region) const { return m_neighbours[region]; }

private:
    using Mask = std::uint64_t; ///< one bit per history item, bit 0 the oldest
    struct Tally;

    void findNeighbours();
    Tally tally(const Situation& situation, const std::deque<Observation>& history,
                std::size_t freshCount) const;
    Mask lastDetected(const Tally& tally, std::size_t freshCount) const;
    void weighObjects(const Situation& situation, const Tally& tally, Ballot& ballot) const;
    int directionWeight(const Situation& situation, Point2 object) const;
    void countObjects(const Tally& tally, Ballot& ballot) const;
    int neighbourObjects(const Tally& tally, std::size_t region, Mask remaining) const;
    bool sceneAgrees(const Tally& tally, std::size_t region) const;
    void addRegionWeights(const Situation& situation, const Tally& tally, Ballot& ballot) const;
    /// Which of `wanted` the landmarks explain, each landmark once or any number of times.
    Mask explained(const Tally& tally, const std::vector<std::size_t>& landmarks, Mask wanted) const;

    std::shared_ptr<const building::Building> m_building;
    VotingOptions m_options;
    std::vector<Identity> m_identities;                 ///< of each landmark
    std::vector<std::optional<std::size_t>> m_regionOf; ///< of each landmark
    std::vector<std::vector<std::size_t>> m_neighbours;
    bool m_severalLevels = false;
};

} // namespace farol::localisation
