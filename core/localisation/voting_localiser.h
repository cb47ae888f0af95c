#pragma once
// The paper's voting (4.2), every weight named as there. Where the paper can be read in two ways, the reading is an
// option; literal() takes it at its word, repaired() is what a careful reader would build (localisation.md section 2,
// field.md section 7).

#include "core/base/error.h"
#include "core/localisation/localiser.h"

namespace farol::localisation {

enum class NeighbourRule { Accesses, AccessesAndWalls };
enum class NeighbourCount { UnionOfNeighbours, BestNeighbour };

struct VotingOptions {
    NeighbourRule neighbours = NeighbourRule::Accesses;
    NeighbourCount nv = NeighbourCount::UnionOfNeighbours;
    bool eachLandmarkOnce = true;      ///< a mapped object explains one history item (multiset)
    bool clampNeighbourWeight = true;  ///< Preg-1 not below 0
    bool stayCounts = true;            ///< Ppos also for the last known region itself
    bool directionUnknownIsOne = true; ///< Pdir of every object while no displacement is known: 1, else 0
    bool directionFromRegion = true;   ///< displacement from the region's centre when only the region is known
    bool lostWithoutObject = true;     ///< winner holds no history object: position unknown
    bool unmappedObjectsCount = false; ///< objects that no landmark of the map can be identical to enter Nobj
    double componentDeadBandM = 0.5;   ///< a vector component smaller than this counts as 0
    double sameSceneRadiusM = 1.0;     ///< PID: "distances of up to 1 metre"
    int textTolerance = 0;             ///< edit distance at which texts are identical
    int minimumObjects = 1;            ///< no fix from an unknown start before that many
    double doubtfulMargin = 0.05;      ///< a smaller lead over the runner-up is no fix of the region

    double pf = 3.0;                   ///< object on the user's level (paper: 3)
    double ppos = 2.0, pperc = 1.5, pid = 2.0;

    static VotingOptions literal();
    static VotingOptions repaired() { return {}; }
    Result<void> check() const;
};

std::unique_ptr<Localiser> makeVotingLocaliser(std::shared_ptr<const building::Building> building,
                                               VotingOptions options = VotingOptions::repaired());

/// Known names for --localiser: "voting", "voting-literal". InvalidArgument names them for any other.
Result<std::unique_ptr<Localiser>> makeLocaliser(const std::string& name,
                                                 std::shared_ptr<const building::Building> building);
std::vector<std::string> localiserNames();

} // namespace farol::localisation
