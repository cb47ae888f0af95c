#include "core/recognition/stairs_cues.h"

#include "core/recognition/edge_lines.h"
#include "core/recognition/grey.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace farol::recognition {

namespace {

constexpr int kWorkingSide = 480;
constexpr std::size_t kMostEdges = 110; ///< a row is sought among the longest ones
constexpr double kLeastGap = 5.0;       ///< pixels between two steps

double overlapOf(const EdgeLine& a, const EdgeLine& b) {
    return std::min(a.to, b.to) - std::max(a.from, b.from);
}

/// How far `lower` runs below `upper`, in the middle of what they share.
double gapBetween(const EdgeLine& upper, const EdgeLine& lower) {
    double x = (std::max(upper.from, lower.from) + std::min(upper.to, lower.to)) / 2.0;
    return lower.at(x) - upper.at(x);
}

/// May `lower` be the next nosing below `upper`?
bool follows(const EdgeLine& upper, const EdgeLine& lower, double most) {
    double shared = overlapOf(upper, lower);
    if (shared < 0.6 * std::min(upper.length(), lower.length())) return false;
    if (upper.length() > 1.6 * lower.length() || lower.length() > 2.2 * upper.length()) return false;
    if (std::abs(upper.slope - lower.slope) > 0.12) return false;
    double gap = gapBetween(upper, lower);
    return gap >= kLeastGap && gap <= most;
}

/// The best way to end a row with a pair of edges.
struct Ending {
    double score = 0.0;
    int before = -1; ///< the edge above the pair; -1 where the row begins with the pair
    double gap = 0.0;
};

/// The row of edges whose gaps grow steadily downwards: the most edges, the smoothest growth.
class RowSeeker {
public:
    RowSeeker(const std::vector<EdgeLine>& lines, double most) : m_lines(lines), m_most(most) {}

    std::vector<std::size_t> seek() {
        std::size_t n = m_lines.size();
        m_endings.assign(n, std::vector<Ending>(n));
        std::vector<std::vector<std::size_t>> above(n);
        std::pair<std::size_t, std::size_t> best{0, 0};
        double bestScore = 0.0;
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t i = 0; i < j; ++i) {
                if (!follows(m_lines[i], m_lines[j], m_most)) continue;
                above[j].push_back(i);
                Ending& ending = m_endings[i][j];
                ending.gap = gapBetween(m_lines[i], m_lines[j]);
                ending.score = weight(i) + weight(j);
                for (std::size_t k : above[i]) extend(ending, k, i, j);
                if (ending.score > bestScore) {
                    bestScore = ending.score;
                    best = {i, j};
                }
            }
        }
        return bestScore > 0.0 ? walkBack(best) : std::vector<std::size_t>{};
    }

private:
    double weight(std::size_t i) const { return 0.6 + 0.4 * std::min(1.0, m_lines[i].contrast / 20.0); }

    void extend(Ending& ending, std::size_t k, std::size_t i, std::size_t j) const {
        const Ending& before = m_endings[k][i];
        double growth = std::log(ending.gap / before.gap);
        if (growth < -0.30 || growth > 0.50) return;
        double rough = std::abs(growth - 0.08) / 0.30;
        double score = before.score + weight(j) - 0.35 * rough;
        if (score > ending.score) {
            ending.score = score;
            ending.before = static_cast<int>(k);
        }
    }

    std::vector<std::size_t> walkBack(std::pair<std::size_t, std::size_t> end) const {
        std::vector<std::size_t> row{end.second, end.first};
        for (int k = m_endings[end.first][end.second].before; k >= 0;) {
            std::size_t above = static_cast<std::size_t>(k);
            row.push_back(above);
            int next = m_endings[above][row[row.size() - 2]].before;
            k = next;
        }
        std::reverse(row.begin(), row.end());
        return row;
    }

    const std::vector<EdgeLine>& m_lines;
    double m_most;
    std::vector<std::vector<Ending>> m_endings;
};

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

/// Mean, and standard deviation over mean.
std::pair<double, double> spreadOf(const std::vector<double>& values) {
    double n = static_cast<double>(values.size());
    if (values.empty()) return {0.0, 0.0};
    double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double square = 0.0;
    for (double v : values) square += (v - mean) * (v - mean);
    return {mean, std::abs(mean) > 1e-9 ? std::sqrt(square / n) / std::abs(mean) : 0.0};
}

/// Straight line through (i, values[i]): slope and root mean square distance.
std::pair<double, double> trendOf(const std::vector<double>& values) {
    double n = static_cast<double>(values.size());
    if (values.size() < 2) return {0.0, 0.0};
    double si = n * (n - 1.0) / 2.0, sii = (n - 1.0) * n * (2.0 * n - 1.0) / 6.0, sv = 0.0, siv = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        sv += values[i];
        siv += static_cast<double>(i) * values[i];
    }
    double slope = (n * siv - si * sv) / (n * sii - si * si);
    double offset = (sv - slope * si) / n;
    double square = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        double away = values[i] - offset - slope * static_cast<double>(i);
        square += away * away;
    }
    return {slope, std::sqrt(square / n)};
}

struct Shape {
    std::vector<double> gaps, lengths, contrasts, lefts, rights, slopes, logs;
    double top = 0.0, bottom = 0.0, shared = 0.0;
};

Shape shapeOf(const std::vector<EdgeLine>& row) {
    Shape shape;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const EdgeLine& line = row[i];
        shape.lengths.push_back(line.length());
        shape.contrasts.push_back(line.contrast);
        shape.lefts.push_back(line.from);
        shape.rights.push_back(line.to);
        shape.slopes.push_back(line.slope);
        if (i == 0) continue;
        shape.gaps.push_back(gapBetween(row[i - 1], line));
        shape.logs.push_back(std::log(shape.gaps.back()));
        shape.shared += overlapOf(row[i - 1], line) / std::max(row[i - 1].length(), line.length());
    }
    shape.shared /= static_cast<double>(std::max<std::size_t>(1, shape.gaps.size()));
    shape.top = row.front().at((row.front().from + row.front().to) / 2.0);
    shape.bottom = row.back().at((row.back().from + row.back().to) / 2.0);
    return shape;
}

/// The two corners each of the uppermost and the lowest edge, drawn out to the median ends.
std::array<cv::Point2d, 4> cornersOf(const std::vector<EdgeLine>& row, const Shape& shape) {
    auto [growLeft, roughLeft] = trendOf(shape.lefts);
    auto [growRight, roughRight] = trendOf(shape.rights);
    double middle = (static_cast<double>(row.size()) - 1.0) / 2.0;
    double left = median(shape.lefts), right = median(shape.rights);
    auto end = [&](const EdgeLine& line, double x) { return cv::Point2d(x, line.at(x)); };
    return {end(row.front(), left - growLeft * middle), end(row.front(), right - growRight * middle),
            end(row.back(), right + growRight * middle), end(row.back(), left + growLeft * middle)};
}

cv::Mat regionMask(const std::array<cv::Point2d, 4>& corners, cv::Size size) {
    cv::Mat mask = cv::Mat::zeros(size, CV_8U);
    std::vector<cv::Point> polygon;
    for (const cv::Point2d& p : corners)
        polygon.emplace_back(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y)));
    cv::fillConvexPoly(mask, polygon, cv::Scalar(255));
    return mask;
}

/// Strong edges across and along the steps inside the region: (pixels of risers, pixels of uprights, all).
std::array<double, 3> densities(const EdgeField& field, const cv::Mat& mask) {
    double across = 0.0, upright = 0.0, all = 0.0;
    for (int y = 0; y < mask.rows; y += 2) {
        const short* dx = field.dx().ptr<short>(y);
        const short* dy = field.dy().ptr<short>(y);
        const uchar* in = mask.ptr<uchar>(y);
        for (int x = 0; x < mask.cols; ++x) {
            if (in[x] == 0) continue;
            all += 1.0;
            int h = std::abs(dy[x]), v = std::abs(dx[x]);
            if (std::max(h, v) < 40) continue;
            if (h > 2 * v) across += 1.0;
            if (v > h) upright += 1.0;
        }
    }
    return {across, upright, std::max(all, 1.0)};
}

/// How much of the length of the region's long edges of this polarity is not in the row.
double strayShare(const std::vector<EdgeLine>& lines, const std::vector<EdgeLine>& row, const cv::Mat& mask) {
    double all = 0.0, own = 0.0;
    for (const EdgeLine& line : lines) {
        double x = (line.from + line.to) / 2.0;
        cv::Point at(static_cast<int>(x), static_cast<int>(line.at(x)));
        if (at.x < 0 || at.y < 0 || at.x >= mask.cols || at.y >= mask.rows || mask.at<uchar>(at) == 0)
            continue;
        all += line.drawn * std::min(line.contrast, 30.0);
    }
    for (const EdgeLine& line : row) own += line.drawn * std::min(line.contrast, 30.0);
    return std::max(0.0, all - own) / std::max(all + own, 1.0);
}

/// Tread and riser are lit differently; the two sides of a tile's joint are not. In grey levels, the median
/// edge.
double stepContrast(const cv::Mat& grey, const std::vector<EdgeLine>& row, double gap) {
    std::vector<double> steps;
    double reach = std::clamp(0.22 * gap, 2.0, 10.0);
    for (const EdgeLine& line : row) {
        double sum = 0.0;
        int count = 0;
        for (double x = line.from + 1.0; x < line.to; x += 3.0) {
            int column = static_cast<int>(x);
            int above = static_cast<int>(std::lround(line.at(x) - reach));
            int below = static_cast<int>(std::lround(line.at(x) + reach));
            if (above < 0 || below >= grey.rows || column < 0 || column >= grey.cols) continue;
            sum += static_cast<double>(grey.at<uchar>(above, column)) - grey.at<uchar>(below, column);
            ++count;
        }
        if (count > 0) steps.push_back(std::abs(sum) / count);
    }
    return median(steps);
}

StairsCues cuesOf(const cv::Mat& grey, const EdgeField& field, const std::vector<EdgeLine>& lines,
                  const std::vector<EdgeLine>& row, const Shape& shape,
                  const std::array<cv::Point2d, 4>& corners) {
    cv::Size size = field.dx().size();
    cv::Mat mask = regionMask(corners, size);
    auto [across, upright, all] = densities(field, mask);
    auto [growth, roughness] = trendOf(shape.logs);
    auto [contrast, contrastSpread] = spreadOf(shape.contrasts);
    auto [length, lengthSpread] = spreadOf(shape.lengths);
    auto [leftTrend, leftRough] = trendOf(shape.lefts);
    auto [rightTrend, rightRough] = trendOf(shape.rights);
    double n = static_cast<double>(row.size());
    double drawn = 0.0;
    for (const EdgeLine& line : row) drawn += line.drawn / line.length();
    double worstStep = 0.0;
    for (std::size_t i = 1; i < shape.logs.size(); ++i)
        worstStep = std::max(worstStep, std::abs(shape.logs[i] - shape.logs[i - 1] - growth));
    double height = std::max(shape.bottom - shape.top, 1.0);
    double gap = median(shape.gaps);
    const double cues[] = {n,
                           growth,
                           roughness,
                           worstStep,
                           length / size.width,
                           lengthSpread,
                           height / size.height,
                           shape.bottom / size.height,
                           shape.top / size.height,
                           contrast,
                           contrastSpread,
                           length / gap,
                           shape.shared,
                           (rightTrend - leftTrend) / gap,
                           (leftRough + rightRough) / length,
                           across / all * gap,
                           upright / std::max(across, 1.0),
                           strayShare(lines, row, mask),
                           drawn / n,
                           stepContrast(grey, row, gap)};
    StairsCues out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<float>(cues[i]);
    return out;
}

} // namespace

std::vector<StairsCandidate> stairsCandidates(const cv::Mat& image) {
    std::vector<StairsCandidate> candidates;
    cv::Mat grey = greyOf(image);
    if (grey.empty() || std::min(grey.cols, grey.rows) < 48) return candidates;
    double scale = 1.0;
    cv::Mat small = reduced(grey, kWorkingSide, scale);
    EdgeField field(small);
    EdgeOptions options;
    options.minLength = std::max(10, small.cols / 20);
    options.minContrast = 4.0;
    std::vector<EdgeLine> pieces = field.horizontals(options);
    for (bool brighter : {false, true}) {
        std::vector<EdgeLine> lines;
        std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(lines),
                     [&](const EdgeLine& l) { return l.brighter == brighter; });
        lines = joinedLines(std::move(lines), 0.12 * small.cols, 3.0);
        std::erase_if(lines, [&](const EdgeLine& l) { return l.length() < 0.09 * small.cols; });
        if (lines.size() > kMostEdges) lines.resize(kMostEdges);
        std::sort(lines.begin(), lines.end(), [](const EdgeLine& a, const EdgeLine& b) {
            double ya = a.at((a.from + a.to) / 2.0), yb = b.at((b.from + b.to) / 2.0);
            return std::make_tuple(ya, a.from, a.to) < std::make_tuple(yb, b.from, b.to);
        });
        std::vector<EdgeLine> row;
        for (std::size_t i : RowSeeker(lines, 0.3 * small.rows).seek()) row.push_back(lines[i]);
        if (row.size() < 4) continue;
        Shape shape = shapeOf(row);
        auto corners = cornersOf(row, shape);
        StairsCandidate candidate;
        candidate.cues = cuesOf(small, field, lines, row, shape, corners);
        candidate.edges = static_cast<int>(row.size());
        candidate.widthShare = median(shape.lengths) / small.cols;
        for (std::size_t i = 0; i < 4; ++i)
            candidate.quad[i] = {(corners[i].x + 0.5) / scale, (corners[i].y + 0.5) / scale};
        candidates.push_back(candidate);
    }
    return candidates;
}

} // namespace farol::recognition
