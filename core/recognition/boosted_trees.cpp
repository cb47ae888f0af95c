#include "core/recognition/boosted_trees.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <string>

namespace farol::recognition {

namespace {

constexpr std::size_t kMostTrees = 5000, kMostNodes = 1000;

Error damaged(const std::string& what) {
    return {ErrorCode::InvalidArgument, "the classifier's trees are damaged: " + what, "trees"};
}

/// Children stand behind their parent, so a walk down always ends.
bool sound(const BoostedTrees::Tree& tree, std::size_t cueCount) {
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const BoostedTrees::Node& node = tree[i];
        if (!std::isfinite(node.threshold) || !std::isfinite(node.value)) return false;
        if (node.cue < 0) continue;
        auto behind = [&](int child) {
            return child > static_cast<int>(i) && child < static_cast<int>(tree.size());
        };
        if (node.cue >= static_cast<int>(cueCount) || !behind(node.below) || !behind(node.above))
            return false;
    }
    return !tree.empty();
}

} // namespace

Result<BoostedTrees> BoostedTrees::parse(std::string_view text, std::size_t cueCount) {
    std::istringstream in{std::string(text)};
    in.imbue(std::locale::classic());
    std::string word;
    int version = 0;
    std::size_t cues = 0, count = 0;
    BoostedTrees made;
    if (!(in >> word >> version >> cues >> count >> made.m_bias) || word != "farol-trees" || version != 1)
        return damaged("the first line is not that of such a file");
    if (cues != cueCount)
        return damaged("made for " + std::to_string(cues) + " cues, not " + std::to_string(cueCount));
    if (count > kMostTrees) return damaged("too many trees");
    for (std::size_t t = 0; t < count; ++t) {
        std::size_t nodes = 0;
        if (!(in >> nodes) || nodes == 0 || nodes > kMostNodes) return damaged("a tree without end");
        Tree tree(nodes);
        for (Node& node : tree) {
            if (!(in >> node.cue)) return damaged("it ends too early");
            if (node.cue < 0)
                in >> node.value;
            else
                in >> node.threshold >> node.below >> node.above;
            if (!in) return damaged("it ends too early");
        }
        if (!sound(tree, cueCount)) return damaged("a node points nowhere");
        made.m_trees.push_back(std::move(tree));
    }
    return made;
}

double BoostedTrees::probability(std::span<const float> cues) const {
    double sum = m_bias;
    for (const Tree& tree : m_trees) {
        std::size_t at = 0;
        while (tree[at].cue >= 0) {
            const Node& node = tree[at];
            bool below = cues[static_cast<std::size_t>(node.cue)] < node.threshold;
            at = static_cast<std::size_t>(below ? node.below : node.above);
        }
        sum += tree[at].value;
    }
    return 1.0 / (1.0 + std::exp(-sum));
}

std::string BoostedTrees::text(std::size_t cueCount) const {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::setprecision(6) << "farol-trees 1 " << cueCount << ' ' << m_trees.size() << ' ' << m_bias
        << '\n';
    for (const Tree& tree : m_trees) {
        out << tree.size();
        for (const Node& node : tree) {
            if (node.cue < 0)
                out << " -1 " << node.value;
            else
                out << ' ' << node.cue << ' ' << node.threshold << ' ' << node.below << ' ' << node.above;
        }
        out << '\n';
    }
    return out.str();
}

} // namespace farol::recognition
