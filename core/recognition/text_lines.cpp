#include "core/recognition/text_lines.h"

#include "core/recognition/grey.h"

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace farol::recognition {

namespace {

struct Letter {
    cv::Rect box;
    float x() const { return static_cast<float>(box.x) + static_cast<float>(box.width) / 2.0F; }
    float y() const { return static_cast<float>(box.y) + static_cast<float>(box.height) / 2.0F; }
};

/// Regions of one brightness with a letter's proportions; nested repeats of one letter are taken once.
std::vector<Letter> letters(const cv::Mat& grey) {
    auto smallest = static_cast<int>(std::max(16.0, 6e-5 * static_cast<double>(grey.total())));
    auto largest = static_cast<int>(0.03 * static_cast<double>(grey.total()));
    auto mser = cv::MSER::create(5, smallest, std::max(largest, smallest + 1), 0.3);
    std::vector<std::vector<cv::Point>> regions;
    std::vector<cv::Rect> boxes;
    mser->detectRegions(grey, regions, boxes);
    std::vector<Letter> found;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const cv::Rect& b = boxes[i];
        double aspect = static_cast<double>(b.width) / b.height;
        double fill = static_cast<double>(regions[i].size()) / b.area();
        if (b.height < 8 || b.height > grey.rows / 3 || aspect < 0.08 || aspect > 1.6 || fill < 0.12)
            continue;
        found.push_back({b});
    }
    std::sort(found.begin(), found.end(), [](const Letter& a, const Letter& b) {
        return std::make_tuple(-a.box.area(), a.box.x, a.box.y) <
               std::make_tuple(-b.box.area(), b.box.x, b.box.y);
    });
    std::vector<Letter> kept;
    for (const Letter& letter : found) {
        bool repeat = std::any_of(kept.begin(), kept.end(), [&](const Letter& other) {
            return (letter.box & other.box).area() > 0.6 * letter.box.area() &&
                   letter.box.height > other.box.height / 3;
        });
        if (!repeat) kept.push_back(letter);
    }
    return kept;
}

bool neighbours(const Letter& a, const Letter& b) {
    double tall = std::max(a.box.height, b.box.height);
    double low = std::min(a.box.height, b.box.height);
    if (tall > 1.7 * low) return false;
    if (std::abs(a.y() - b.y()) > 0.45 * tall) return false;
    int gap = std::max(a.box.x, b.box.x) - std::min(a.box.br().x, b.box.br().x);
    return gap < 1.1 * tall && gap > -0.5 * tall;
}

/// A slanted box around the letters of one line.
Quad quadAround(const std::vector<Letter>& line) {
    double n = static_cast<double>(line.size());
    double meanX = 0.0, meanY = 0.0, xx = 0.0, xy = 0.0;
    for (const Letter& l : line) {
        meanX += l.x() / n;
        meanY += l.y() / n;
    }
    for (const Letter& l : line) {
        xx += (l.x() - meanX) * (l.x() - meanX);
        xy += (l.x() - meanX) * (l.y() - meanY);
    }
    double slope = line.size() > 2 && xx > 0.0 ? std::clamp(xy / xx, -0.4, 0.4) : 0.0;
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Letter& l : line) {
        double base = slope * (l.x() - meanX);
        left = std::min(left, static_cast<double>(l.box.x));
        right = std::max(right, static_cast<double>(l.box.br().x));
        top = std::min(top, l.box.y - base);
        bottom = std::max(bottom, l.box.br().y - base);
    }
    double pad = 0.2 * (bottom - top);
    left -= 1.5 * pad;
    right += 1.5 * pad;
    auto at = [&](double x, double y) { return ImagePoint{x, y + slope * (x - meanX)}; };
    return {at(left, top - pad), at(right, top - pad), at(right, bottom + pad), at(left, bottom + pad)};
}

} // namespace

cv::Mat rectified(const cv::Mat& grey, const Quad& quad, int height, int widest) {
    auto side = [&](std::size_t a, std::size_t b) {
        return std::hypot(quad[a].x - quad[b].x, quad[a].y - quad[b].y);
    };
    double high = std::max((side(0, 3) + side(1, 2)) / 2.0, 1.0);
    double wide = std::max((side(0, 1) + side(3, 2)) / 2.0, 1.0);
    cv::Size size(std::clamp(static_cast<int>(std::lround(wide * height / high)), 8, widest), height);
    std::array<cv::Point2f, 4> from;
    for (std::size_t i = 0; i < 4; ++i)
        from[i] = cv::Point2f(static_cast<float>(quad[i].x - 0.5), static_cast<float>(quad[i].y - 0.5));
    auto w = static_cast<float>(size.width) - 0.5F;
    auto h = static_cast<float>(size.height) - 0.5F;
    std::array<cv::Point2f, 4> to{cv::Point2f(-0.5F, -0.5F), cv::Point2f(w, -0.5F), cv::Point2f(w, h),
                                  cv::Point2f(-0.5F, h)};
    cv::Mat out;
    cv::warpPerspective(grey, out, cv::getPerspectiveTransform(from.data(), to.data()), size,
                        height > high ? cv::INTER_CUBIC : cv::INTER_AREA, cv::BORDER_REPLICATE);
    return out;
}

cv::Mat darkOnLight(const cv::Mat& grey) {
    cv::Mat binary;
    double threshold = cv::threshold(grey, binary, 0.0, 255.0, cv::THRESH_BINARY | cv::THRESH_OTSU);
    int band = std::max(1, grey.rows / 16);
    cv::Mat border = cv::Mat::ones(grey.size(), CV_8U) * 255;
    border(cv::Rect(band, band, std::max(1, grey.cols - 2 * band), std::max(1, grey.rows - 2 * band)) &
           cv::Rect(0, 0, grey.cols, grey.rows))
        .setTo(0);
    if (cv::mean(grey, border)[0] >= threshold) return grey;
    cv::Mat inverse;
    cv::bitwise_not(grey, inverse);
    return inverse;
}

std::vector<cv::Range> inkRows(const cv::Mat& plate) {
    cv::Mat ink, profile;
    cv::threshold(plate, ink, 0.0, 1.0, cv::THRESH_BINARY_INV | cv::THRESH_OTSU);
    cv::reduce(ink, profile, 1, cv::REDUCE_SUM, CV_32S);
    std::vector<cv::Range> rows;
    int start = -1;
    // A line has ink in most of its rows; two pixels of dirt are none.
    int least = std::max(2, plate.cols / 200);
    for (int y = 0; y <= plate.rows; ++y) {
        bool inked = y < plate.rows && profile.at<int>(y) >= least;
        if (inked && start < 0) start = y;
        if (!inked && start >= 0) {
            // The dot of an i stands apart from its line by a gap far smaller than the line.
            if (!rows.empty() && start - rows.back().end <= std::max(2, rows.back().size() / 6))
                rows.back().end = y;
            else
                rows.emplace_back(start, y);
            start = -1;
        }
    }
    std::erase_if(rows, [&](const cv::Range& r) { return r.size() < std::max(6, plate.rows / 14); });
    return rows;
}

std::vector<Quad> lettersInLines(const cv::Mat& grey, int fewestLetters) {
    double scale = 1.0;
    cv::Mat small = reduced(grey, 1280, scale);
    std::vector<Letter> all = letters(small);
    std::sort(all.begin(), all.end(), [](const Letter& a, const Letter& b) {
        return std::make_tuple(a.box.x, a.box.y, a.box.width) <
               std::make_tuple(b.box.x, b.box.y, b.box.width);
    });
    std::vector<std::vector<Letter>> lines;
    for (const Letter& letter : all) {
        std::vector<Letter>* best = nullptr;
        for (auto& line : lines)
            if (neighbours(line.back(), letter) &&
                (best == nullptr || line.back().box.x > best->back().box.x))
                best = &line;
        if (best != nullptr)
            best->push_back(letter);
        else
            lines.push_back({letter});
    }
    std::erase_if(lines, [&](const auto& line) { return static_cast<int>(line.size()) < fewestLetters; });
    std::stable_sort(lines.begin(), lines.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    std::vector<Quad> quads;
    for (const auto& line : lines) {
        Quad quad = quadAround(line);
        for (ImagePoint& p : quad) p = {p.x / scale, p.y / scale};
        quads.push_back(quad);
    }
    return quads;
}

} // namespace farol::recognition
