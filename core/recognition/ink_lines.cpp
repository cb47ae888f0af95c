#include "core/recognition/ink_lines.h"

#include "core/recognition/grey.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace farol::recognition {

namespace {

constexpr int kWorkingSide = 1280;

struct Glyph {
    cv::Rect box;
    double contrast = 0.0;
    double fill = 0.0; ///< share of the box that is ink
    float x() const { return static_cast<float>(box.x) + static_cast<float>(box.width) / 2.0F; }
    float y() const { return static_cast<float>(box.y) + static_cast<float>(box.height) / 2.0F; }
};

int sharedColumns(const cv::Rect& a, const cv::Rect& b) {
    return std::min(a.br().x, b.br().x) - std::max(a.x, b.x);
}

/// The two halves of a stencilled letter: one above the other with a narrow bridge between.
bool halvesOfOne(const cv::Rect& a, const cv::Rect& b) {
    cv::Rect both = a | b;
    int gap = std::max(a.y, b.y) - std::min(a.br().y, b.br().y);
    bool above = gap <= std::max(2, both.height * 16 / 100);
    bool sideBySide = sharedColumns(a, b) >= std::min(a.width, b.width) * 6 / 10;
    // Pieces beside each other (a stencilled 4) are about as tall; a wall beside a letter is not.
    int tall = std::max(a.height, b.height), low = std::min(a.height, b.height);
    if (10 * gap < -both.height && (tall > 3 * low || 10 * both.height > 17 * tall)) return false;
    if (std::max(a.width, b.width) > 6 * std::min(a.width, b.width) + 4) return false;
    // A line of text above another one leaves a far larger gap, and letters are rarely wider than tall.
    return above && sideBySide && both.width <= both.height * 12 / 10;
}

bool inside(const cv::Rect& inner, const cv::Rect& outer) {
    return (inner & outer).area() >= inner.area() * 9 / 10;
}

void joinHalves(std::vector<cv::Rect>& boxes) {
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < boxes.size() && !changed; ++i)
            for (std::size_t j = i + 1; j < boxes.size() && !changed; ++j) {
                if (!halvesOfOne(boxes[i], boxes[j]) && !inside(boxes[i], boxes[j]) &&
                    !inside(boxes[j], boxes[i]))
                    continue;
                boxes[i] |= boxes[j];
                boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(j));
                changed = true;
            }
    }
}

bool leftOf(const cv::Rect& a, const cv::Rect& b) {
    return std::make_tuple(a.x, a.y, a.width, a.height) < std::make_tuple(b.x, b.y, b.width, b.height);
}

/// Pieces of ink with a letter's size; what touches the picture's border may go on outside it.
std::vector<Glyph> glyphsOf(const cv::Mat& grey, const cv::Mat& ink, const cv::Mat& mean) {
    cv::Mat labels, stats, middles;
    int count = cv::connectedComponentsWithStats(ink, labels, stats, middles, 8, CV_32S);
    std::vector<Glyph> glyphs;
    int tallest = grey.rows / 3;
    for (int i = 1; i < count; ++i) {
        cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                     stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
        int area = stats.at<int>(i, cv::CC_STAT_AREA);
        if (area < 8 || box.height > tallest || box.width > tallest || box.width > 4 * box.height + 8)
            continue;
        if (box.x <= 0 || box.y <= 0 || box.br().x >= grey.cols || box.br().y >= grey.rows) continue;
        double fill = static_cast<double>(area) / box.area();
        if (fill < 0.12) continue;
        cv::Mat mask = labels(box) == i;
        double contrast = std::abs(cv::mean(grey(box), mask)[0] - cv::mean(mean(box), mask)[0]);
        if (contrast < 14.0) continue;
        glyphs.push_back({box, contrast, fill});
    }
    return glyphs;
}

/// Joins stencil halves among the glyphs, comparing only those that stand close in x.
std::vector<Glyph> joined(std::vector<Glyph> glyphs) {
    std::sort(glyphs.begin(), glyphs.end(),
              [](const Glyph& a, const Glyph& b) { return leftOf(a.box, b.box); });
    std::vector<bool> gone(glyphs.size(), false);
    for (std::size_t i = 0; i < glyphs.size(); ++i) {
        for (std::size_t j = i + 1; j < glyphs.size() && !gone[i]; ++j) {
            if (glyphs[j].box.x > glyphs[i].box.br().x) break;
            if (gone[j] || !halvesOfOne(glyphs[i].box, glyphs[j].box)) continue;
            glyphs[i].box |= glyphs[j].box;
            glyphs[i].contrast = std::min(glyphs[i].contrast, glyphs[j].contrast);
            gone[j] = true;
        }
    }
    std::vector<Glyph> kept;
    for (std::size_t i = 0; i < glyphs.size(); ++i)
        if (!gone[i]) kept.push_back(glyphs[i]);
    return kept;
}

bool isLetter(const Glyph& glyph) {
    // Letters of a far line touch and make one long piece.
    return glyph.box.height >= 7 && glyph.box.width <= glyph.box.height * 5;
}

bool neighbours(const Glyph& a, const Glyph& b) {
    double tall = std::max(a.box.height, b.box.height);
    double low = std::min(a.box.height, b.box.height);
    if (tall > 1.8 * low) return false;
    int gap = b.box.x - a.box.br().x;
    if (gap > 1.0 * tall || gap < -0.4 * tall) return false;
    // Feet on one line, up to the slant of a plate seen from the side.
    double rise = std::abs(a.box.br().y - b.box.br().y);
    if (rise > 0.28 * tall + 0.25 * std::abs(b.x() - a.x())) return false;
    double stronger = std::max(a.contrast, b.contrast);
    return std::min(a.contrast, b.contrast) > 0.5 * stronger;
}

using Line = std::vector<Glyph>;

std::vector<Line> linesOf(const std::vector<Glyph>& glyphs) {
    std::vector<Line> lines;
    for (const Glyph& glyph : glyphs) {
        if (!isLetter(glyph)) continue;
        Line* best = nullptr;
        for (Line& line : lines)
            if (neighbours(line.back(), glyph) &&
                (best == nullptr || line.back().box.br().x > best->back().box.br().x))
                best = &line;
        if (best != nullptr)
            best->push_back(glyph);
        else
            lines.push_back({glyph});
    }
    return lines;
}

/// A slanted box around the glyphs of one line.
Quad quadAround(const Line& line, double pad) {
    double n = static_cast<double>(line.size());
    double meanX = 0.0, meanFoot = 0.0, xx = 0.0, xy = 0.0;
    for (const Glyph& g : line) {
        meanX += g.x() / n;
        meanFoot += g.box.br().y / n;
    }
    for (const Glyph& g : line) {
        xx += (g.x() - meanX) * (g.x() - meanX);
        xy += (g.x() - meanX) * (g.box.br().y - meanFoot);
    }
    double slope = line.size() > 1 && xx > 0.0 ? std::clamp(xy / xx, -0.4, 0.4) : 0.0;
    if (line.size() == 2 && std::abs(slope) < 0.12) slope = 0.0;
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Glyph& g : line) {
        double base = slope * (g.x() - meanX);
        left = std::min(left, static_cast<double>(g.box.x));
        right = std::max(right, static_cast<double>(g.box.br().x));
        top = std::min(top, g.box.y - base);
        bottom = std::max(bottom, g.box.br().y - base);
    }
    double margin = pad * (bottom - top);
    left -= 1.4 * margin;
    right += 1.4 * margin;
    auto at = [&](double x, double y) { return ImagePoint{x, y + slope * (x - meanX)}; };
    return {at(left, top - margin), at(right, top - margin), at(right, bottom + margin),
            at(left, bottom + margin)};
}

/// A lone glyph is a sign of its own only where the surroundings are empty; a long piece is a whole word of
/// letters that touch.
bool standsAlone(const Glyph& glyph, const cv::Mat& ink) {
    cv::Rect box = glyph.box;
    if (box.width > box.height * 14 / 10) return box.height >= 8 && glyph.fill < 0.68;
    if (box.height < 20) return false;
    int margin = box.height / 2;
    cv::Rect wide =
        cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
        cv::Rect(0, 0, ink.cols, ink.rows);
    int around = cv::countNonZero(ink(wide)) - cv::countNonZero(ink(box));
    return around <= box.area() / 5;
}

double scoreOf(const Line& line) {
    double weakest = 255.0, height = 0.0;
    for (const Glyph& g : line) {
        weakest = std::min(weakest, g.contrast);
        height += g.box.height / static_cast<double>(line.size());
    }
    double uneven = 0.0;
    for (const Glyph& g : line)
        uneven += std::abs(g.box.height - height) / height / static_cast<double>(line.size());
    double length = std::min(1.0, 0.4 + 0.2 * static_cast<double>(line.size()));
    return length * std::min(1.0, weakest / 60.0) * std::min(1.0, height / 16.0) * (1.0 - uneven);
}

void addLines(const cv::Mat& grey, const cv::Mat& mean, bool lightInk, double scale,
              std::vector<InkLine>& found) {
    cv::Mat ink, shifted;
    constexpr double kStep = 12.0; // grey levels above the noise of a camera
    if (lightInk)
        cv::subtract(grey, mean, shifted);
    else
        cv::subtract(mean, grey, shifted);
    cv::threshold(shifted, ink, kStep, 255.0, cv::THRESH_BINARY);
    // Halves are joined by guess, and a digit over the edge of a table is taken for one: lines of the pieces
    // as they are stand beside those of the joined ones.
    std::vector<Glyph> pieces = glyphsOf(grey, ink, mean);
    std::vector<Line> lines = linesOf(joined(pieces));
    std::sort(pieces.begin(), pieces.end(),
              [](const Glyph& a, const Glyph& b) { return leftOf(a.box, b.box); });
    for (Line& line : linesOf(pieces))
        if (line.size() > 1) lines.push_back(std::move(line));
    for (const Line& line : lines) {
        if (line.size() == 1 && !standsAlone(line[0], ink)) continue;
        InkLine one;
        one.quad = quadAround(line, 0.3);
        for (ImagePoint& p : one.quad) p = {p.x / scale, p.y / scale};
        one.glyphs = static_cast<int>(line.size());
        one.lightInk = lightInk;
        one.score = scoreOf(line);
        found.push_back(one);
    }
}

} // namespace

std::vector<cv::Rect> glyphBoxes(const cv::Mat& ink, int smallestArea) {
    cv::Mat labels, stats, middles;
    int count = cv::connectedComponentsWithStats(ink, labels, stats, middles, 8, CV_32S);
    std::vector<cv::Rect> boxes;
    for (int i = 1; i < count; ++i)
        if (stats.at<int>(i, cv::CC_STAT_AREA) >= smallestArea)
            boxes.emplace_back(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                               stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
    std::sort(boxes.begin(), boxes.end(), leftOf);
    joinHalves(boxes);
    std::sort(boxes.begin(), boxes.end(), leftOf);
    return boxes;
}

std::vector<InkLine> inkLines(const cv::Mat& grey) {
    std::vector<InkLine> found;
    if (grey.empty() || std::min(grey.cols, grey.rows) < 16) return found;
    double scale = 1.0;
    cv::Mat small = reduced(grey, kWorkingSide, scale);
    // Two sizes of surroundings: for the letters of a far door plate, and for large digits on a wall.
    for (int reach : {23, 75}) {
        cv::Mat mean;
        cv::boxFilter(small, mean, -1, cv::Size(reach, reach));
        for (bool lightInk : {false, true}) addLines(small, mean, lightInk, scale, found);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const InkLine& a, const InkLine& b) { return a.score > b.score; });
    std::vector<InkLine> kept;
    for (const InkLine& line : found) {
        bool copy = std::any_of(kept.begin(), kept.end(), [&](const InkLine& other) {
            return overlap(boundingBox(other.quad), boundingBox(line.quad)) > 0.5;
        });
        if (!copy) kept.push_back(line);
    }
    return kept;
}

} // namespace farol::recognition
