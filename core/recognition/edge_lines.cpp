#include "core/recognition/edge_lines.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace farol::recognition {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kStepGain = 4.0; ///< of the derivative of a step, in a 3x3 Sobel filter

struct EdgePoint {
    int t = 0;
    float other = 0.0F, strength = 0.0F;
};

struct Chain {
    std::vector<EdgePoint> points;
    bool brighter = false;
};

/// Follows the maxima of `across` from row to row. `along` is the derivative down the rows.
class ChainFollower {
public:
    ChainFollower(const cv::Mat& across, const cv::Mat& along, const EdgeOptions& options)
        : m_across(across),
          m_along(along),
          m_least(static_cast<int>(kStepGain * options.minContrast)),
          m_tilt(static_cast<float>(std::tan((options.maxTiltDegrees + 6.0) * kDegree))),
          m_owner(static_cast<std::size_t>(across.cols), -1) {}

    std::vector<Chain> follow() {
        for (int t = 1; t + 1 < m_across.rows; ++t) followRow(t);
        return std::move(m_chains);
    }

private:
    void followRow(int t) {
        const short* row = m_across.ptr<short>(t);
        const short* down = m_along.ptr<short>(t);
        std::vector<std::pair<int, int>> claims; // column, chain
        for (int x = 1; x + 1 < m_across.cols; ++x) {
            int g = std::abs(row[x]);
            if (g < m_least) continue;
            int sign = row[x] > 0 ? 1 : -1;
            int before = sign * row[x - 1], after = sign * row[x + 1];
            if (g < before || g <= after) continue;
            if (static_cast<float>(std::abs(down[x])) > m_tilt * static_cast<float>(g)) continue;
            float bend = static_cast<float>(2 * g - before - after);
            float offset = bend > 0.0F ? static_cast<float>(after - before) / (2.0F * bend) : 0.0F;
            EdgePoint point{t, static_cast<float>(x) + offset, static_cast<float>(g)};
            int chain = chainNear(x, t, point.other, sign > 0);
            if (chain < 0) {
                chain = static_cast<int>(m_chains.size());
                m_chains.push_back({{}, sign > 0});
            }
            m_chains[static_cast<std::size_t>(chain)].points.push_back(point);
            claims.emplace_back(x, chain);
        }
        for (auto [x, chain] : claims) m_owner[static_cast<std::size_t>(x)] = chain;
    }

    /// The chain that ended within the two rows above, nearest to the column.
    int chainNear(int x, int t, float other, bool brighter) const {
        int best = -1;
        float nearest = 1.6F;
        for (int c = std::max(0, x - 2); c <= std::min(m_across.cols - 1, x + 2); ++c) {
            int chain = m_owner[static_cast<std::size_t>(c)];
            if (chain < 0) continue;
            const Chain& candidate = m_chains[static_cast<std::size_t>(chain)];
            const EdgePoint& last = candidate.points.back();
            float away = std::abs(last.other - other);
            if (candidate.brighter != brighter || last.t >= t || last.t < t - 2 || away >= nearest) continue;
            nearest = away;
            best = chain;
        }
        return best;
    }

    const cv::Mat &m_across, &m_along;
    int m_least;
    float m_tilt;
    std::vector<int> m_owner; ///< the chain that last used a column
    std::vector<Chain> m_chains;
};

EdgeLine fitted(const Chain& chain, std::size_t first, std::size_t last) {
    double n = 0.0, st = 0.0, so = 0.0, stt = 0.0, sto = 0.0, strength = 0.0;
    for (std::size_t i = first; i <= last; ++i) {
        double t = chain.points[i].t, o = chain.points[i].other;
        n += 1.0;
        st += t;
        so += o;
        stt += t * t;
        sto += t * o;
        strength += chain.points[i].strength;
    }
    EdgeLine line;
    double spread = n * stt - st * st;
    line.slope = spread > 0.0 ? (n * sto - st * so) / spread : 0.0;
    line.offset = (so - line.slope * st) / n;
    line.from = chain.points[first].t;
    line.to = chain.points[last].t + 1.0;
    line.drawn = n;
    line.contrast = strength / n / kStepGain;
    line.brighter = chain.brighter;
    return line;
}

/// Splits a chain where it leaves the straight line between its ends.
void split(const Chain& chain, std::size_t first, std::size_t last, const EdgeOptions& options,
           std::vector<EdgeLine>& lines) {
    const EdgePoint& a = chain.points[first];
    const EdgePoint& b = chain.points[last];
    if (b.t - a.t + 1 < options.minLength) return;
    double slope = static_cast<double>(b.other - a.other) / (b.t - a.t);
    double worst = 0.0;
    std::size_t where = first;
    for (std::size_t i = first + 1; i < last; ++i) {
        double away = std::abs(chain.points[i].other - (a.other + slope * (chain.points[i].t - a.t)));
        if (away > worst) {
            worst = away;
            where = i;
        }
    }
    if (worst > 1.4) {
        split(chain, first, where, options, lines);
        split(chain, where, last, options, lines);
        return;
    }
    EdgeLine line = fitted(chain, first, last);
    if (std::abs(line.slope) <= std::tan(options.maxTiltDegrees * kDegree)) lines.push_back(line);
}

std::vector<EdgeLine> linesOf(const cv::Mat& across, const cv::Mat& along, const EdgeOptions& options) {
    std::vector<EdgeLine> lines;
    if (across.rows < 4 || across.cols < 4) return lines;
    for (const Chain& chain : ChainFollower(across, along, options).follow())
        if (static_cast<int>(chain.points.size()) * 3 >= options.minLength * 2)
            split(chain, 0, chain.points.size() - 1, options, lines);
    return lines;
}

} // namespace

EdgeField::EdgeField(const cv::Mat& grey) {
    cv::Mat smooth;
    cv::GaussianBlur(grey, smooth, cv::Size(3, 3), 0.0);
    cv::spatialGradient(smooth, m_dx, m_dy);
}

std::vector<EdgeLine> EdgeField::verticals(const EdgeOptions& options) const {
    return linesOf(m_dx, m_dy, options);
}

std::vector<EdgeLine> EdgeField::horizontals(const EdgeOptions& options) const {
    cv::Mat across, along;
    cv::transpose(m_dy, across);
    cv::transpose(m_dx, along);
    return linesOf(across, along, options);
}

double EdgeField::support(cv::Point2d a, cv::Point2d b, bool upright, int tolerance,
                          double minContrast) const {
    const cv::Mat& across = upright ? m_dx : m_dy;
    double length = std::hypot(b.x - a.x, b.y - a.y);
    int steps = std::clamp(static_cast<int>(length / 3.0), 6, 48);
    int least = static_cast<int>(kStepGain * minContrast);
    int inside = 0, met = 0;
    for (int i = 0; i < steps; ++i) {
        double share = (i + 0.5) / steps;
        int x = cvRound(a.x + (b.x - a.x) * share);
        int y = cvRound(a.y + (b.y - a.y) * share);
        if (x < tolerance || y < tolerance || x + tolerance >= across.cols || y + tolerance >= across.rows)
            continue;
        ++inside;
        for (int k = -tolerance; k <= tolerance; ++k) {
            int g = upright ? across.at<short>(y, x + k) : across.at<short>(y + k, x);
            int other = upright ? m_dy.at<short>(y, x + k) : m_dx.at<short>(y + k, x);
            if (std::abs(g) < least || std::abs(other) > std::abs(g)) continue;
            ++met;
            break;
        }
    }
    return 2 * inside >= steps ? static_cast<double>(met) / inside : 0.0;
}

std::vector<EdgeLine> joinedLines(std::vector<EdgeLine> pieces, double mostGap, double tolerance) {
    std::sort(pieces.begin(), pieces.end(), [](const EdgeLine& a, const EdgeLine& b) {
        return std::make_tuple(-a.drawn, a.offset, a.from) < std::make_tuple(-b.drawn, b.offset, b.from);
    });
    std::vector<EdgeLine> whole;
    std::vector<bool> used(pieces.size(), false);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (used[i]) continue;
        EdgeLine line = pieces[i];
        for (bool grown = true; grown;) {
            grown = false;
            for (std::size_t j = i + 1; j < pieces.size(); ++j) {
                const EdgeLine& p = pieces[j];
                if (used[j] || std::abs(p.at(p.from) - line.at(p.from)) > tolerance ||
                    std::abs(p.at(p.to) - line.at(p.to)) > tolerance)
                    continue;
                double gap = std::max(line.from, p.from) - std::min(line.to, p.to);
                if (gap > std::min(mostGap, 0.6 * (line.drawn + p.drawn))) continue;
                double fresh = std::max(0.0, p.drawn + std::min(gap, 0.0));
                line.contrast = (line.contrast * line.drawn + p.contrast * fresh) / (line.drawn + fresh);
                double head = p.from < line.from ? p.at(p.from) : line.at(line.from);
                double foot = p.to > line.to ? p.at(p.to) : line.at(line.to);
                line.drawn += fresh;
                line.from = std::min(line.from, p.from);
                line.to = std::max(line.to, p.to);
                line.slope = (foot - head) / std::max(line.length(), 1e-6);
                line.offset = head - line.slope * line.from;
                used[j] = grown = true;
            }
        }
        whole.push_back(line);
    }
    return whole;
}

} // namespace farol::recognition
