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
    double strayAtDoor = 0.09, turnBackPerS = 0.0;
    int strayMost = 3; ///< accesses passed before the walker asks the way again
    double wrongKind = 0.07, misread = 0.15, stale = 0.05;
    double falsePerS = 0.018, clutterPerM2 = 0.035; ///< invented; and real, but not in the map
    double detectionPerS = 0.33;                    ///< of one landmark in full view
    double tooNearM = 0.3;                          ///< nearer, a thing is larger than the picture
    double unevenEyes = 0.0;             ///< some kinds are found up to that share less often than others
    double neverFound = 0.0;             ///< share of landmarks that these detectors always miss
    double slowest = 0.4, fastest = 1.2; ///< metres a second, of a walk
    double swayDeg = 33.0, swayS = 8.2;  ///< of the camera about the way of walking
    double cameraOffDeg = 0.0;           ///< the camera hangs askew
    double lookPerS = 0.018, lookDeg = 115.0;
    double pausePerS = 1.0 / 22.0, pauseMostS = 6.0;
    double lostFlow = 0.05, lostFlowS = 1.0; ///< motion lines without a number; in runs so long
    double turnNoiseDeg = 1.5, turnBiasDeg = 0.0, turnGain = 1.0;
    double speedNoise = 0.12;
    double leastScale = 0.75, mostScale = 1.35; ///< of the measured speed, of a walk
    double roomScaleSigma = 0.0;                ///< near walls flow faster: log, of a region
    double stairsShow = 0.0;                    ///< share of the usual speed that is measured on stairs
    double climbSees = 0.0;                     ///< share of the usual detections on stairs and in lifts
    double looksFirstS = 6.0;                   ///< whoever starts at an unknown place looks about so long
};

/// Habits, eyes and cameras that differ from walk to walk far more than those of one study do: what holds for
/// all of them may hold for people not yet met.
WalkOptions variedWalk(std::uint64_t seed);

struct SimulatedWalk {
    std::string log;   ///< JSON lines
    std::string truth; ///< JSON lines
};

SimulatedWalk simulateWalk(const std::shared_ptr<const building::Building>& building,
                           const WalkOptions& options);

} // namespace farol::test
