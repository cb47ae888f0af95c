#pragma once
// Where a map leaves the user's place open (`farol-cli map ambiguity`): regions that look alike with all that
// leads to them, so that the last four landmarks seen cannot tell which of them one is in.

#include "core/building/building.h"

#include <string>
#include <vector>

namespace farol::building {

struct Ambiguity {
    /// Regions of one group hold the same landmarks (by template, else by kind and text), and so do their
    /// neighbours, theirs, and theirs again: three steps back are what four landmarks tell at most. Largest
    /// group first.
    std::vector<std::vector<RegionId>> groups;
    std::vector<RegionId> withoutLandmarks;
    std::size_t confusedPairs = 0; ///< of regions in one group

    struct Suggestion {
        RegionId region;
        std::size_t pairs = 0; ///< told apart by one more landmark of its own kind in this region
    };
    std::vector<Suggestion> suggestions; ///< up to five, the best first
};

Ambiguity findAmbiguity(const Building& building);

} // namespace farol::building
