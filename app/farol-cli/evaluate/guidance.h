#pragma once
// Many walks of a simulated walker who hears nothing but cues, between drawn pairs of places of one map.

#include "app/farol-cli/evaluate/evaluation.h"
#include "core/session/closed_loop.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace farol::cli {

struct PairsOptions {
    int walks = 100;
    std::uint64_t seed = 1;
    session::ClosedLoopOptions loop;
    simulation::TruthDetectionOptions detections;
    /// Empty: the structured cue.
    session::ClosedLoop::Ear ear;
    /// Empty: detections drawn from the truth.
    std::function<Result<session::ClosedLoop::Eye>(std::uint64_t seed)> eye;
};

struct WalkedPair {
    std::string from, to;
    std::uint64_t seed = 0;
    session::ClosedLoopResult result;
};

struct PairsFigures {
    std::vector<WalkedPair> walks;
    double computedSeconds = 0.0; ///< on the wall clock, only to be told

    /// Name and value, in the order of the table.
    std::vector<std::pair<std::string, double>> figures() const;
    /// How the failed ones ended, the commonest first.
    std::vector<std::pair<std::string, int>> failures() const;
};

/// Pairs are rooms, corridors and halls that are joined; stairwells and lifts are passed only.
Result<PairsFigures> walkPairs(const std::shared_ptr<const simulation::WalkWorld>& world,
                               const PairsOptions& options);
EvaluationTable pairsTable(const std::string& title,
                           const std::vector<std::pair<std::string, PairsFigures>>& runs);

} // namespace farol::cli
