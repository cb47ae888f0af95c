#include "core/recognition/whole_turn.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace farol::recognition {

namespace {

constexpr int kColumns = 160;    ///< of the cylinder
constexpr int kClearColumns = 3; ///< beside a peak that are still the same peak

template <class Matches>
std::size_t peakOf(const Matches& matches) {
    auto best = std::max_element(matches.begin(), matches.end(),
                                 [](const auto& a, const auto& b) { return a.fit < b.fit; });
    return static_cast<std::size_t>(best - matches.begin());
}

/// Between the columns, from the three fits about the peak.
template <class Matches>
double peakBetween(const Matches& matches, std::size_t peak) {
    double at = matches[peak].dx;
    if (peak == 0 || peak + 1 >= matches.size()) return at;
    double a = matches[peak - 1].fit, b = matches[peak].fit, c = matches[peak + 1].fit;
    double bend = a - 2.0 * b + c;
    return bend < -1e-9 ? at + std::clamp(0.5 * (a - c) / bend, -0.5, 0.5) : at;
}

/// The best fit away from the peak and its slopes.
template <class Matches>
double rivalOf(const Matches& matches, std::size_t peak) {
    auto slopes = [&](std::size_t from, std::size_t to) {
        std::size_t away = std::max(to, peak) - std::min(to, peak);
        return away <= kClearColumns || matches[to].fit <= matches[from].fit;
    };
    std::size_t left = peak, right = peak;
    while (left > 0 && slopes(left, left - 1)) --left;
    while (right + 1 < matches.size() && slopes(right, right + 1)) ++right;
    double best = 0.0;
    for (std::size_t i = 0; i < matches.size(); ++i)
        if (i < left || i > right) best = std::max(best, matches[i].fit);
    return best;
}

} // namespace

void PictureCompass::prepare(cv::Size size, double focalPx) {
    if (size == m_size && focalPx == m_focalPx) return;
    m_size = size;
    m_focalPx = focalPx;
    double halfAngle = std::atan(0.5 * size.width / focalPx);
    m_step = 2.0 * halfAngle / kColumns;
    double tall = 2.0 * std::atan(0.5 * size.height / focalPx * std::cos(halfAngle));
    int rows = std::clamp(static_cast<int>(tall / m_step) / 2 * 2, 8, 2 * kColumns);
    m_mapX.create(rows, kColumns, CV_32F);
    m_mapY.create(rows, kColumns, CV_32F);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < kColumns; ++x) {
            double angle = (x - 0.5 * (kColumns - 1)) * m_step, down = (y - 0.5 * (rows - 1)) * m_step;
            m_mapX.at<float>(y, x) = static_cast<float>(0.5 * (size.width - 1) + focalPx * std::tan(angle));
            m_mapY.at<float>(y, x) =
                static_cast<float>(0.5 * (size.height - 1) + focalPx * down / std::cos(angle));
        }
    }
}

PictureCompass::Edges PictureCompass::withSums(cv::Mat picture) {
    Edges edges{std::move(picture), {}};
    cv::Mat squares = edges.picture.mul(edges.picture), channels[2], sum;
    cv::split(squares, channels);
    cv::integral(channels[0] + channels[1], edges.energies, CV_64F);
    return edges;
}

PictureCompass::Edges PictureCompass::edgesOf(const cv::Mat& grey) const {
    cv::Mat soft, cylinder, parts[2], edges;
    cv::GaussianBlur(grey, soft, {}, 0.35 * grey.cols / kColumns);
    cv::remap(soft, cylinder, m_mapX, m_mapY, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    cv::Scharr(cylinder, parts[0], CV_32F, 1, 0, 1.0 / 32.0);
    cv::Scharr(cylinder, parts[1], CV_32F, 0, 1, 1.0 / 32.0);
    // Strong edges count little more than clear ones, and grain next to nothing.
    constexpr float kGrain = 3.0F;
    for (cv::Mat& part : parts)
        part.forEach<float>(
            [](float& value, const int*) { value *= std::abs(value) / (value * value + kGrain * kGrain); });
    cv::merge(parts, 2, edges);
    return withSums(edges);
}

/// How well `after`, moved by (dx, dy), lies on the window's columns of `before`.
double PictureCompass::fitAt(const Edges& before, const Edges& after, const Window& window, int dx,
                             int dy) const {
    cv::Rect all({}, before.picture.size());
    cv::Rect columns(window.firstColumn, 0, window.lastColumn - window.firstColumn, all.height);
    cv::Rect here = columns & (all - cv::Point(dx, dy)), there = here + cv::Point(dx, dy);
    if (here.empty()) return 0.0;
    auto energy = [](const Edges& edges, const cv::Rect& r) {
        const cv::Mat& sums = edges.energies;
        return sums.at<double>(r.br()) - sums.at<double>(r.y, r.br().x) - sums.at<double>(r.br().y, r.x) +
               sums.at<double>(r.tl());
    };
    double own = energy(before, here), other = energy(after, there);
    if (std::min(own, other) < m_options.leastEdges * here.area()) return 0.0;
    return before.picture(here).dot(after.picture(there)) / std::sqrt(own * other);
}

std::vector<PictureCompass::Match> PictureCompass::profile(const Edges& before, const Edges& after,
                                                           const Window& window) const {
    std::vector<Match> matches;
    for (int dx = window.firstDx; dx <= window.lastDx; ++dx) {
        Match best{0.0, dx, (window.firstDy + window.lastDy) / 2};
        for (int dy = window.firstDy; dy <= window.lastDy; ++dy)
            if (double fit = fitAt(before, after, window, dx, dy); fit > best.fit) best = {fit, dx, dy};
        matches.push_back(best);
    }
    return matches;
}

std::optional<WholeTurn> PictureCompass::turn(const cv::Mat& before, const cv::Mat& after, double focalPx) {
    if (before.empty() || before.size() != after.size() || !(focalPx > 1.0)) return std::nullopt;
    prepare(before.size(), focalPx);
    Edges a = edgesOf(before), b = edgesOf(after);
    auto halved = [](const Edges& edges) {
        cv::Mat half;
        cv::resize(edges.picture, half, {}, 0.5, 0.5, cv::INTER_AREA);
        return withSums(half);
    };
    constexpr int kHalf = kColumns / 2, kMostReach = kHalf * 6 / 10;
    auto halfColumns = [&](double degrees) {
        return static_cast<int>(std::lround(degrees * CV_PI / 180.0 / (2.0 * m_step)));
    };
    int reach = std::min(halfColumns(m_options.mostYawDegrees), kMostReach);
    int nod = std::max(1, halfColumns(m_options.mostPitchDegrees));
    auto coarse = profile(halved(a), halved(b), {-reach, reach, -nod, nod, 0, kHalf});
    std::size_t peak = peakOf(coarse);
    WholeTurn told;
    told.lead = coarse[peak].fit - rivalOf(coarse, peak);
    if (coarse[peak].fit <= 0.0 || told.lead < m_options.leastLead) return std::nullopt;
    int dx = 2 * coarse[peak].dx, dy = 2 * coarse[peak].dy;
    auto fine = profile(a, b, {dx - 3, dx + 3, dy - 2, dy + 2, 0, kColumns});
    std::size_t finest = peakOf(fine);
    told.fit = fine[finest].fit;
    if (told.fit < m_options.leastFit) return std::nullopt;
    double shift = peakBetween(fine, finest), squares = 0.0, weights = 0.0;
    dy = fine[finest].dy;
    // Where the camera moved instead of only turning, what is near moved otherwise than what is far.
    constexpr int kParts = 4, kAside = 8;
    for (int part = 0; part < kParts; ++part) {
        int first = part * kColumns / kParts, last = (part + 1) * kColumns / kParts;
        int common = std::min(last, kColumns - dx) - std::max(first, -dx);
        if (2 * common < last - first) continue; // mostly turned out of the view
        auto own = profile(a, b, {dx - kAside, dx + kAside, dy - 1, dy + 1, first, last});
        std::size_t best = peakOf(own);
        if (own[best].fit < m_options.leastFit) continue;
        double off = peakBetween(own, best) - shift;
        squares += own[best].fit * off * off;
        weights += own[best].fit;
        ++told.parts;
    }
    constexpr double kLeastSpread = 0.5, kUnknownSpread = 2.0; // columns
    double apart = weights > 0.0 ? squares / weights : kUnknownSpread * kUnknownSpread;
    told.spread = std::sqrt(apart + kLeastSpread * kLeastSpread) * m_step;
    if (told.spread > m_options.mostSpreadDegrees * CV_PI / 180.0) return std::nullopt;
    told.yaw = shift * m_step; // the picture moves to the right when the camera turns to the left
    return told;
}

} // namespace farol::recognition
