#pragma once
// Gradient boosting of small regression trees on the logistic loss: makes what core/recognition/boosted_trees
// reads.

#include "core/recognition/boosted_trees.h"

#include <cstdint>
#include <vector>

namespace farol::training {

struct Sample {
    std::vector<float> cues;
    bool positive = false;
    double weight = 1.0;
    int picture = 0; ///< samples of one picture stay together when parts are held out
};

struct BoostingOptions {
    int trees = 150, depth = 3;
    double shrinkage = 0.08, rowShare = 0.7, cueShare = 0.5, minLeafWeight = 4.0, ridge = 2.0;
    std::uint64_t seed = 1;
};

recognition::BoostedTrees boost(const std::vector<Sample>& samples, const BoostingOptions& options);

} // namespace farol::training
