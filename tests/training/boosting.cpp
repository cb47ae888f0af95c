#include "tests/training/boosting.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace farol::training {

namespace {

using recognition::BoostedTrees;

/// Grows one tree on the gradients of the loss.
class TreeGrower {
public:
    TreeGrower(const std::vector<Sample>& samples, const std::vector<double>& gradient,
               const std::vector<double>& curvature, const BoostingOptions& options,
               std::vector<std::size_t> cues)
        : m_samples(samples),
          m_gradient(gradient),
          m_curvature(curvature),
          m_options(options),
          m_cues(std::move(cues)) {}

    BoostedTrees::Tree grow(std::vector<std::size_t> rows) {
        m_tree.clear();
        branch(std::move(rows), 0);
        return std::move(m_tree);
    }

private:
    struct Split {
        double gain = 1e-6;
        int cue = -1;
        float threshold = 0.0F;
    };

    double worth(double g, double h) const { return g * g / (h + m_options.ridge); }

    std::size_t branch(std::vector<std::size_t> rows, int depth) {
        std::size_t at = m_tree.size();
        m_tree.emplace_back();
        double g = 0.0, h = 0.0;
        for (std::size_t i : rows) {
            g += m_gradient[i];
            h += m_curvature[i];
        }
        Split split = depth < m_options.depth ? bestSplit(rows, g, h) : Split{};
        if (split.cue < 0) {
            m_tree[at].value = static_cast<float>(m_options.shrinkage * g / (h + m_options.ridge));
            return at;
        }
        std::vector<std::size_t> below, above;
        for (std::size_t i : rows)
            (m_samples[i].cues[static_cast<std::size_t>(split.cue)] < split.threshold ? below : above)
                .push_back(i);
        m_tree[at].cue = split.cue;
        m_tree[at].threshold = split.threshold;
        std::size_t left = branch(std::move(below), depth + 1);
        std::size_t right = branch(std::move(above), depth + 1);
        m_tree[at].below = static_cast<int>(left);
        m_tree[at].above = static_cast<int>(right);
        return at;
    }

    Split bestSplit(const std::vector<std::size_t>& rows, double g, double h) const {
        Split best;
        std::vector<std::pair<float, std::size_t>> order(rows.size());
        for (std::size_t cue : m_cues) {
            for (std::size_t k = 0; k < rows.size(); ++k) order[k] = {m_samples[rows[k]].cues[cue], rows[k]};
            std::sort(order.begin(), order.end());
            double gb = 0.0, hb = 0.0;
            for (std::size_t k = 0; k + 1 < order.size(); ++k) {
                gb += m_gradient[order[k].second];
                hb += m_curvature[order[k].second];
                if (order[k].first == order[k + 1].first) continue;
                if (hb < m_options.minLeafWeight || h - hb < m_options.minLeafWeight) continue;
                double gain = worth(gb, hb) + worth(g - gb, h - hb) - worth(g, h);
                if (gain > best.gain)
                    best = {gain, static_cast<int>(cue), (order[k].first + order[k + 1].first) / 2.0F};
            }
        }
        return best;
    }

    const std::vector<Sample>& m_samples;
    const std::vector<double>&m_gradient, &m_curvature;
    const BoostingOptions& m_options;
    std::vector<std::size_t> m_cues;
    BoostedTrees::Tree m_tree;
};

double valueOf(const BoostedTrees::Tree& tree, const std::vector<float>& cues) {
    std::size_t at = 0;
    while (tree[at].cue >= 0)
        at = static_cast<std::size_t>(cues[static_cast<std::size_t>(tree[at].cue)] < tree[at].threshold
                                          ? tree[at].below
                                          : tree[at].above);
    return tree[at].value;
}

} // namespace

recognition::BoostedTrees boost(const std::vector<Sample>& samples, const BoostingOptions& options) {
    double yes = 0.0, all = 0.0;
    for (const Sample& s : samples) {
        all += s.weight;
        yes += s.positive ? s.weight : 0.0;
    }
    double bias = std::log(std::max(yes, 1e-3) / std::max(all - yes, 1e-3));
    std::vector<double> sum(samples.size(), bias), gradient(samples.size()), curvature(samples.size());
    std::mt19937_64 random(options.seed);
    std::vector<BoostedTrees::Tree> trees;
    for (int t = 0; t < options.trees && !samples.empty(); ++t) {
        std::vector<std::size_t> rows;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            double p = 1.0 / (1.0 + std::exp(-sum[i]));
            gradient[i] = samples[i].weight * ((samples[i].positive ? 1.0 : 0.0) - p);
            curvature[i] = samples[i].weight * std::max(p * (1.0 - p), 1e-6);
            if (static_cast<double>(random() % 1000) < 1000.0 * options.rowShare) rows.push_back(i);
        }
        std::vector<std::size_t> cues(samples.front().cues.size());
        std::iota(cues.begin(), cues.end(), std::size_t{0});
        for (std::size_t i = cues.size(); i > 1; --i) std::swap(cues[i - 1], cues[random() % i]);
        cues.resize(std::max<std::size_t>(
            1, static_cast<std::size_t>(options.cueShare * static_cast<double>(cues.size()))));
        TreeGrower grower(samples, gradient, curvature, options, std::move(cues));
        trees.push_back(grower.grow(std::move(rows)));
        for (std::size_t i = 0; i < samples.size(); ++i) sum[i] += valueOf(trees.back(), samples[i].cues);
    }
    return BoostedTrees(std::move(trees), bias);
}

} // namespace farol::training
