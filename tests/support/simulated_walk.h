#pragma once
// A person with a camera walks through a building, strays, pauses, looks about, and is now and then carried
// elsewhere unseen; detectors miss, confuse, misread and invent. The log is in the form of `locate`, the
// truth beside it in the form of data/walks. The rates are those written down in the localisation study.

#include "core/building/building.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace farol::test {

struct WalkOptions {
    std::uint64_t seed = 1;
    double unknownStart = 0.3, kidnap = 0.15; ///< probabilities, of a walk
    double strayAtDoor = 0.09;
    double wrongKind = 0.07, misread = 0.15, stale = 0.05;
    double falsePerS = 0.018, clutterPerM2 = 0.035; ///< invented; and real, but not in the map
    double detectionPerS = 0.33;                    ///< of one landmark in full view
    double lostFlow = 0.05;                         ///< motion lines without a number
};

struct SimulatedWalk {
    std::string log;   ///< JSON lines
    std::string truth; ///< JSON lines
};

SimulatedWalk simulateWalk(const std::shared_ptr<const building::Building>& building,
                           const WalkOptions& options);

} // namespace farol::test
