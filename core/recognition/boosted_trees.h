#pragma once
// A small boosted-tree classifier over a detector's own cues. The trees are trained by tests/training and
// kept as text in resources/models, which the build compiles in.

#include "core/base/error.h"

#include <span>
#include <string_view>
#include <vector>

namespace farol::recognition {

class BoostedTrees {
public:
    struct Node {
        int cue = -1; ///< -1: a leaf
        float threshold = 0.0F, value = 0.0F;
        int below = 0, above = 0; ///< nodes for cue < threshold, and for the rest
    };
    using Tree = std::vector<Node>;

    /// InvalidArgument where the text is damaged or made for another number of cues.
    static Result<BoostedTrees> parse(std::string_view text, std::size_t cueCount);

    BoostedTrees() = default;
    BoostedTrees(std::vector<Tree> trees, double bias) : m_trees(std::move(trees)), m_bias(bias) {}

    /// Probability in (0, 1) as far as the training pictures go.
    double probability(std::span<const float> cues) const;
    std::string text(std::size_t cueCount) const;

private:
    std::vector<Tree> m_trees;
    double m_bias = 0.0;
};

} // namespace farol::recognition
