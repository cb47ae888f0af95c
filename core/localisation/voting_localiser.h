#pragma once
// The paper's voting (4.2), every weight named as there. Where the paper can be read in two ways, the reading
// is an option; literal() takes it at its word, repaired() is what a careful reader would build
// (localisation.md section 2, field.md section 7).

#include "core/base/error.h"
#include "core/localisation/localiser.h"

namespace farol::localisation {

enum class NeighbourRule { Accesses, AccessesAndWalls };
enum class NeighbourCount { UnionOfNeighbours, BestNeighbour };

/// Defaults are the repaired reading. "Ours" marks what stands nowhere in the paper. The readings of
/// localisation.md section 2 by their numbers: 1 neighbours, 2 nv, 3 eachLandmarkOnce, 4 stayCounts,
/// 5 clampNeighbourWeight, 6 directionUnknownIsOne, 7 directionFromRegion and componentDeadBandM, 8 Pdir = 1
/// + the equal components (one reading only), 9 levelWeightAtStairs, 10 lostWithoutObject, 11 pid and
/// sameSceneRadiusM, 12 pperc and percNeedsObject, 13 tiesByRoute, 14 textTolerance, 15 positionNeedsUnique,
/// 16 minimumObjects, 17 HistoryOptions::capacity, 18 guidance::clockHour().
struct VotingOptions {
    NeighbourRule neighbours = NeighbourRule::Accesses;
    NeighbourCount nv = NeighbourCount::UnionOfNeighbours;
    bool eachLandmarkOnce = true;      ///< a mapped object explains one history item (multiset)
    bool clampNeighbourWeight = true;  ///< Preg-1 not below 0
    bool stayCounts = true;            ///< Ppos also for the last known region itself
    bool directionUnknownIsOne = true; ///< Pdir of every object while no displacement is known: 1, else 0
    bool directionFromRegion = true;  ///< displacement from the region's centre when only the region is known
    bool levelWeightAtStairs = false; ///< Pf also beside stairs and lifts, and when these were seen last
    bool tiesByRoute =
        true; ///< equal votes: the current region, then the earlier on the route; else the lowest id
    bool positionNeedsUnique = true;   ///< no position where another object of the region weighs as much
    bool lostWithoutObject = true;     ///< winner holds no history object: position unknown
    bool unmappedObjectsCount = false; ///< objects that no landmark of the map can be identical to enter Nobj
    bool percNeedsObject =
        false; ///< Pperc only for regions of the route that hold an object identical to the last
    bool alwaysAnswers = false; ///< a doubtful or lost winner is the region all the same, at low confidence
    double componentDeadBandM = 0.5; ///< a vector component smaller than this counts as 0
    double sameSceneRadiusM = 1.0;   ///< PID: "distances of up to 1 metre"
    int textTolerance = 0;        ///< edit distance at which texts are identical (room 2.14 is one from 2.15)
    int minimumObjects = 1;       ///< no fix from an unknown start before that many
    double doubtfulMargin = 0.05; ///< a smaller lead over the runner-up is no fix of the region

    /// Ours, for safety: so many objects known by kind only must have come after one that is unmistakable (by
    /// its template or text in one region only) before they count as "the last detected". With 1, as printed,
    /// a single false door moves the fix out of a region that four unique places agree on: the neighbour's
    /// Pmaxobj of up to 6 also multiplies Rv, so a region that holds one door and adjoins the right one takes
    /// its votes.
    int genericsToOverrule = 2;

    double pf = 3.0; ///< object on the user's level (paper: 3)
    double ppos = 2.0, pperc = 1.5, pid = 2.0;

    double startConfidence = 0.6;    ///< ours: of a start that was told, before the first object
    double genericConfidence = 0.45; ///< ours: the most that objects known by kind only can give
    double halfLifeSeconds =
        30.0; ///< ours: confidence halves in this time without a new object (24 m of walking)
    double placeSigmaM = 1.5, objectSigmaM = 2.0; ///< ours: how far the user is from what was seen
    double headingDistanceM = 1.0;                ///< ours: closer positions give no direction
    double headingMaxSpeed =
        2.0; ///< ours: m/s; farther apart they are two objects seen from one spot; 0: any
    bool headingFromPlaces = true; ///< ours: a view of the spot itself tells which way the camera looks
    std::size_t votesKept = 40;    ///< the highest votes of a fix; the others are counted but not handed on

    static VotingOptions literal();
    static VotingOptions repaired() { return {}; }
    Result<void> check() const;
};

/// Confidence is the lead over the runner-up as a share of the winning vote, times 0.2 + 0.2 for each history
/// object found in the winner (at most 1), halved every `halfLifeSeconds`. Without an unmistakable object in
/// the winner it stays below `genericConfidence`. A region that is only kept because it ties with others has
/// at least half of what it had before. It is not calibrated: it orders fixes, no more.
std::unique_ptr<Localiser> makeVotingLocaliser(std::shared_ptr<const building::Building> building,
                                               VotingOptions options = VotingOptions::repaired(),
                                               std::string name = "voting");

} // namespace farol::localisation
