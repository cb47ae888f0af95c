#include "core/recognition/door_cues.h"

#include "core/recognition/door_outlines.h"
#include "core/recognition/grey.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace farol::recognition {

namespace {

constexpr int kWorkingSide = 480;
constexpr int kColumns = 6, kRows = 10; ///< the leaf is looked at in cells

/// Means over upright boxes of colour and of edge strength, in constant time each.
class BoxMeans {
public:
    enum Channel { Light, A, B, Across, Down };

    BoxMeans(const cv::Mat& bgr, const EdgeField& field) {
        cv::Mat lab, channels[3], strength;
        cv::cvtColor(bgr, lab, cv::COLOR_BGR2Lab);
        cv::split(lab, channels);
        for (int i = 0; i < 3; ++i) cv::integral(channels[i], m_sums[static_cast<std::size_t>(i)], CV_32S);
        cv::convertScaleAbs(field.dx(), strength, 0.25);
        cv::integral(strength, m_sums[Across], CV_32S);
        cv::convertScaleAbs(field.dy(), strength, 0.25);
        cv::integral(strength, m_sums[Down], CV_32S);
        m_size = bgr.size();
    }

    /// Empty where more than half of the box is outside the picture.
    std::optional<std::array<float, 5>> around(cv::Point2d centre, double width, double height) const {
        int x0 = static_cast<int>(std::lround(centre.x - width / 2.0)),
            x1 = x0 + std::max(1, static_cast<int>(width));
        int y0 = static_cast<int>(std::lround(centre.y - height / 2.0)),
            y1 = y0 + std::max(1, static_cast<int>(height));
        int whole = (x1 - x0) * (y1 - y0);
        x0 = std::clamp(x0, 0, m_size.width);
        x1 = std::clamp(x1, 0, m_size.width);
        y0 = std::clamp(y0, 0, m_size.height);
        y1 = std::clamp(y1, 0, m_size.height);
        int area = (x1 - x0) * (y1 - y0);
        if (2 * area < whole || area == 0) return std::nullopt;
        std::array<float, 5> means{};
        for (std::size_t i = 0; i < means.size(); ++i) {
            const cv::Mat& s = m_sums[i];
            int sum = s.at<int>(y1, x1) - s.at<int>(y0, x1) - s.at<int>(y1, x0) + s.at<int>(y0, x0);
            means[i] = static_cast<float>(sum) / static_cast<float>(area);
        }
        return means;
    }

private:
    std::array<cv::Mat, 5> m_sums;
    cv::Size m_size;
};

/// The mean of some cells.
struct Patch {
    std::array<double, 5> sum{};
    int count = 0;

    void add(const std::optional<std::array<float, 5>>& cell) {
        if (!cell) return;
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += (*cell)[i];
        ++count;
    }
    double mean(std::size_t channel) const { return count > 0 ? sum[channel] / count : -1.0; }
    double chroma() const { return count > 0 ? std::hypot(mean(1) - 128.0, mean(2) - 128.0) : -1.0; }
};

/// Difference in colour; -1 where one of the two is outside the picture.
double between(const Patch& a, const Patch& b) {
    if (a.count == 0 || b.count == 0) return -1.0;
    return std::sqrt(std::pow(a.mean(0) - b.mean(0), 2) + std::pow(a.mean(1) - b.mean(1), 2) +
                     std::pow(a.mean(2) - b.mean(2), 2));
}

class CueMaker {
public:
    CueMaker(const EdgeField& field, const BoxMeans& means, cv::Size size)
        : m_field(field), m_means(means), m_size(size) {}

    DoorCues cuesOf(const DoorOutline& outline) {
        m_outline = &outline;
        m_width = outline.width();
        m_height = outline.height();
        m_next = 0;
        m_cues = {};
        lookAround();
        addShape();
        addOutline();
        addColours();
        addTexture();
        return m_cues;
    }

private:
    void put(double value) { m_cues[m_next++] = static_cast<float>(value); }

    void putOrdered(double a, double b) {
        put(std::min(a, b));
        put(std::max(a, b));
    }

    /// u across, v down: 0 to 1 inside the outline.
    cv::Point2d at(double u, double v) const {
        const auto& q = m_outline->quad;
        cv::Point2d top = q[0] + (q[1] - q[0]) * u, foot = q[3] + (q[2] - q[3]) * u;
        return top + (foot - top) * v;
    }

    Patch patch(double u0, double u1, double v0, double v1, int columns, int rows) const {
        Patch patch;
        double w = (u1 - u0) / columns, h = (v1 - v0) / rows;
        for (int c = 0; c < columns; ++c)
            for (int r = 0; r < rows; ++r)
                patch.add(
                    m_means.around(at(u0 + (c + 0.5) * w, v0 + (r + 0.5) * h), w * m_width, h * m_height));
        return patch;
    }

    void lookAround() {
        for (int r = 0; r < kRows; ++r)
            for (int c = 0; c < kColumns; ++c) {
                double u = 0.06 + 0.88 * (c + 0.5) / kColumns, v = 0.03 + 0.94 * (r + 0.5) / kRows;
                auto cell = m_means.around(at(u, v), 0.85 * 0.88 * m_width / kColumns,
                                           0.85 * 0.94 * m_height / kRows);
                m_cells[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] =
                    cell.value_or(std::array<float, 5>{});
                m_inside[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = cell.has_value();
            }
        m_leftWall = patch(-0.34, -0.12, 0.1, 0.9, 1, 4);
        m_rightWall = patch(1.12, 1.34, 0.1, 0.9, 1, 4);
        m_above = patch(0.1, 0.9, -0.10, -0.04, 3, 1);
        m_floor = patch(0.1, 0.9, 1.02, 1.07, 3, 1);
        m_leaf = cells(0, kColumns, 0, kRows);
    }

    Patch cells(int c0, int c1, int r0, int r1) const {
        Patch sum;
        for (int r = r0; r < r1; ++r)
            for (int c = c0; c < c1; ++c)
                if (m_inside[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)])
                    sum.add(m_cells[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)]);
        return sum;
    }

    double cell(int r, int c, std::size_t channel) const {
        return m_cells[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)][channel];
    }

    void addShape() {
        const auto& q = m_outline->quad;
        put(m_height / m_width);
        put(m_height / m_size.height);
        put(m_width / m_size.width);
        put((q[2].y + q[3].y) / 2.0 / m_size.height);
        put((q[0].y + q[1].y) / 2.0 / m_size.height);
        put(m_outline->topSeen ? 1.0 : 0.0);
        put(m_outline->footSeen ? 1.0 : 0.0);
        double left = (q[3].x - q[0].x) / std::max(q[3].y - q[0].y, 1.0);
        double right = (q[2].x - q[1].x) / std::max(q[2].y - q[1].y, 1.0);
        put(std::abs(left - right));
        put(std::abs(left + right) / 2.0);
        double lintel = (q[1].y - q[0].y) / std::max(q[1].x - q[0].x, 1.0);
        double foot = (q[2].y - q[3].y) / std::max(q[2].x - q[3].x, 1.0);
        put(std::abs(lintel));
        put(std::abs(lintel - foot));
        put(std::abs((q[0].x + q[1].x + q[2].x + q[3].x) / 4.0 / m_size.width - 0.5));
    }

    double upright(double u, double v0, double v1) const {
        return m_field.support(at(u, v0), at(u, v1), true, 1, 4.0);
    }
    double level(double v, double u0, double u1) const {
        return m_field.support(at(u0, v), at(u1, v), false, 1, 4.0);
    }

    void addOutline() {
        putOrdered(m_outline->leftJamb, m_outline->rightJamb);
        put(m_outline->lintel);
        put(m_outline->foot);
        putOrdered(upright(0.0, -0.14, -0.02), upright(1.0, -0.14, -0.02)); // walls go on above, doors do not
        putOrdered(upright(0.0, 1.02, 1.10), upright(1.0, 1.02, 1.10));
        putOrdered(level(0.0, -0.25, -0.03), level(0.0, 1.03, 1.25)); // cupboards in a row
        double frameLeft = 0.0, frameRight = 0.0;
        for (double off : {0.05, 0.08, 0.11, 0.14}) {
            frameLeft = std::max(frameLeft, upright(-off, 0.05, 0.95));
            frameRight = std::max(frameRight, upright(1.0 + off, 0.05, 0.95));
        }
        putOrdered(frameLeft, frameRight);
        frameLeft = frameRight = 0.0;
        for (double off : {0.05, 0.08, 0.11}) {
            frameLeft = std::max(frameLeft, upright(off, 0.05, 0.95));
            frameRight = std::max(frameRight, upright(1.0 - off, 0.05, 0.95));
        }
        putOrdered(frameLeft, frameRight);
    }

    void addColours() {
        putOrdered(between(m_leaf, m_leftWall), between(m_leaf, m_rightWall));
        put(between(m_leftWall, m_rightWall));
        put(between(m_leaf, m_above));
        put(between(m_leaf, m_floor));
        put(between(cells(0, kColumns / 2, 0, kRows), cells(kColumns / 2, kColumns, 0, kRows)));
        put(between(cells(0, kColumns, 0, kRows / 2), cells(0, kColumns, kRows / 2, kRows)));
        put(between(cells(0, kColumns, kRows - 2, kRows), cells(0, kColumns, 3, kRows - 3)));
        putOrdered(between(m_above, m_leftWall), between(m_above, m_rightWall));
        double light = 0.0, chroma = 0.0;
        int count = 0;
        for (int r = 0; r < kRows; ++r)
            for (int c = 0; c < kColumns; ++c) {
                light += std::pow(cell(r, c, 0) - m_leaf.mean(0), 2);
                chroma +=
                    std::pow(cell(r, c, 1) - m_leaf.mean(1), 2) + std::pow(cell(r, c, 2) - m_leaf.mean(2), 2);
                ++count;
            }
        put(std::sqrt(light / count));
        put(std::sqrt(chroma / count));
        put(m_leaf.mean(0));
        put(m_leaf.chroma());
        Patch walls = m_leftWall;
        for (std::size_t i = 0; i < walls.sum.size(); ++i) walls.sum[i] += m_rightWall.sum[i];
        walls.count += m_rightWall.count;
        put(walls.mean(0));
        put(walls.chroma());
        put(walls.mean(BoxMeans::Across));
        put(walls.mean(BoxMeans::Down));
    }

    void addTexture() {
        double across = m_leaf.mean(BoxMeans::Across), down = m_leaf.mean(BoxMeans::Down);
        put(across);
        put(down);
        double widest = 0.0,
               second = 0.0; // edges over the whole width: drawers, the two doors of a refrigerator
        for (double v = 0.12; v < 0.93; v += 0.03) {
            double line = level(v, 0.08, 0.92);
            if (line > widest)
                widest = line;
            else
                second = std::max(second, line);
        }
        put(widest);
        put(second);
        double tallest = 0.0; // over the whole height: a cupboard's two doors
        for (double u = 0.2; u < 0.81; u += 0.04) tallest = std::max(tallest, upright(u, 0.05, 0.95));
        put(tallest);
        double handle = 0.0, most = 0.0;
        for (int r = 0; r < kRows; ++r)
            for (int c = 0; c < kColumns; ++c) {
                double busy = cell(r, c, BoxMeans::Across) + cell(r, c, BoxMeans::Down);
                most = std::max(most, busy);
                bool there = r >= 4 && r <= 7 && (c == 0 || c == kColumns - 1);
                if (there) handle = std::max(handle, busy);
            }
        put(handle / std::max(across + down, 0.5));
        put(most / std::max(across + down, 0.5));
        Patch lower = cells(0, kColumns, kRows / 2, kRows);
        put(lower.mean(BoxMeans::Across) + lower.mean(BoxMeans::Down));
    }

    const EdgeField& m_field;
    const BoxMeans& m_means;
    cv::Size m_size;
    const DoorOutline* m_outline = nullptr;
    double m_width = 0.0, m_height = 0.0;
    std::size_t m_next = 0;
    DoorCues m_cues{};
    std::array<std::array<std::array<float, 5>, kColumns>, kRows> m_cells{};
    std::array<std::array<bool, kColumns>, kRows> m_inside{};
    Patch m_leftWall, m_rightWall, m_above, m_floor, m_leaf;
};

} // namespace

std::vector<DoorCandidate> doorCandidates(const cv::Mat& image, const DoorCueOptions& options) {
    std::vector<DoorCandidate> candidates;
    cv::Mat colour = colourOf(image);
    if (colour.empty() || std::min(colour.cols, colour.rows) < 32) return candidates;
    double scale = 1.0;
    cv::Mat small = reduced(colour, kWorkingSide, scale), grey;
    if (std::min(small.cols, small.rows) < 32) return candidates;
    cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
    EdgeField field(grey);
    std::vector<DoorOutline> outlines = doorOutlines(field, options);
    if (outlines.empty()) return candidates;
    BoxMeans means(small, field);
    CueMaker maker(field, means, small.size());
    for (const DoorOutline& outline : outlines) {
        DoorCandidate candidate;
        for (std::size_t i = 0; i < 4; ++i)
            candidate.quad[i] = {(outline.quad[i].x + 0.5) / scale, (outline.quad[i].y + 0.5) / scale};
        candidate.cues = maker.cuesOf(outline);
        candidate.topSeen = outline.topSeen;
        candidate.footSeen = outline.footSeen;
        candidates.push_back(candidate);
    }
    return candidates;
}

} // namespace farol::recognition
