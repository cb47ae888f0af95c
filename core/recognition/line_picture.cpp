#include "core/recognition/line_picture.h"

#include "core/recognition/flat_plate.h"
#include "core/recognition/ink_lines.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <climits>
#include <cmath>

namespace farol::recognition {

namespace {

/// Shares outside 0 to 1 lie outside the quad.
ImagePoint between(const Quad& quad, double u, double v) {
    auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
    return {mix(mix(quad[0].x, quad[1].x, u), mix(quad[3].x, quad[2].x, u), v),
            mix(mix(quad[0].y, quad[1].y, u), mix(quad[3].y, quad[2].y, u), v)};
}

Quad part(const Quad& quad, double left, double top, double right, double bottom) {
    return {between(quad, left, top), between(quad, right, top), between(quad, right, bottom),
            between(quad, left, bottom)};
}

double side(const Quad& quad, std::size_t a, std::size_t b) {
    return std::hypot(quad[a].x - quad[b].x, quad[a].y - quad[b].y);
}

struct Ink {
    cv::Mat mask;              ///< 255 where ink of the lines is
    std::vector<cv::Rect> cut; ///< pieces that reach the border
    double ground = 255.0, dark = 0.0;
};

/// The line around a plate, or one that runs along a side of it, is no letter.
bool isFrame(const cv::Rect& box, int area, cv::Size plate) {
    double fill = static_cast<double>(area) / box.area();
    if (box.width > 0.8 * plate.width && box.height > 0.6 * plate.height) return fill < 0.4;
    bool lying = box.width > 0.75 * plate.width && box.height < 0.15 * plate.height;
    bool standing = box.height > 0.75 * plate.height && box.width < 0.05 * plate.width;
    return lying || standing;
}

/// Ink of a flat plate, dark on light, without the pieces that reach its border. What is ink is decided in
/// `middle`: further out may be the wall beside a plate.
Ink inkOf(const cv::Mat& flat, const cv::Rect& middle) {
    Ink ink;
    cv::Mat all, near;
    double level = cv::threshold(flat(middle), near, 0.0, 255.0, cv::THRESH_BINARY_INV | cv::THRESH_OTSU);
    cv::threshold(flat, all, level, 255.0, cv::THRESH_BINARY_INV);
    ink.ground = cv::mean(flat(middle), near == 0)[0];
    ink.dark = cv::countNonZero(near) > 0 ? cv::mean(flat(middle), near)[0] : ink.ground;
    cv::Mat labels, stats, middles;
    int count = cv::connectedComponentsWithStats(all, labels, stats, middles, 8, CV_32S);
    std::vector<unsigned char> keep(static_cast<std::size_t>(count), 0);
    int smallest = std::max(6, flat.rows * flat.rows / 1200);
    for (int i = 1; i < count; ++i) {
        int x = stats.at<int>(i, cv::CC_STAT_LEFT), y = stats.at<int>(i, cv::CC_STAT_TOP);
        int w = stats.at<int>(i, cv::CC_STAT_WIDTH), h = stats.at<int>(i, cv::CC_STAT_HEIGHT);
        int area = stats.at<int>(i, cv::CC_STAT_AREA);
        if (area < smallest) continue;
        bool border = x <= 1 || y <= 1 || x + w >= flat.cols - 1 || y + h >= flat.rows - 1;
        if (border)
            ink.cut.emplace_back(x, y, w, h);
        else if (!isFrame(cv::Rect(x, y, w, h), area, flat.size()))
            keep[static_cast<std::size_t>(i)] = 255;
    }
    ink.mask = cv::Mat(flat.size(), CV_8U);
    for (int y = 0; y < flat.rows; ++y)
        for (int x = 0; x < flat.cols; ++x)
            ink.mask.at<unsigned char>(y, x) = keep[static_cast<std::size_t>(labels.at<int>(y, x))];
    return ink;
}

/// How steep the edges are: a step of one pixel of the original picture gives about 1, the more blurred the
/// less. Independent of the contrast, unlike the sharpness of a whole picture.
double steepness(const cv::Mat& flat, const Ink& ink, double enlarged) {
    cv::Mat dx, dy, strength, edge;
    cv::Sobel(flat, dx, CV_32F, 1, 0, 3, 0.125);
    cv::Sobel(flat, dy, CV_32F, 0, 1, 3, 0.125);
    cv::magnitude(dx, dy, strength);
    cv::morphologyEx(ink.mask, edge, cv::MORPH_GRADIENT, cv::Mat());
    int pixels = cv::countNonZero(edge);
    double contrast = ink.ground - ink.dark;
    if (pixels == 0 || contrast < 1.0) return 0.0;
    return cv::mean(strength, edge)[0] / contrast * std::max(1.0, enlarged);
}

/// Top and bottom of every line by the boxes of its glyphs.
std::vector<cv::Range> rowsOf(const std::vector<cv::Rect>& glyphs, int rows) {
    cv::Mat used = cv::Mat::zeros(rows, 1, CV_8U);
    for (const cv::Rect& box : glyphs) used.rowRange(box.y, box.br().y).setTo(1);
    std::vector<cv::Range> lines;
    int start = -1;
    for (int y = 0; y <= rows; ++y) {
        bool inked = y < rows && used.at<unsigned char>(y) != 0;
        if (inked && start < 0) start = y;
        if (!inked && start >= 0) {
            // The dot of an i stands apart from its line by a gap far smaller than the line.
            if (!lines.empty() && start - lines.back().end <= std::max(1, lines.back().size() / 6))
                lines.back().end = y;
            else
                lines.emplace_back(start, y);
            start = -1;
        }
    }
    std::erase_if(lines, [&](const cv::Range& r) { return r.size() < rows / 12; });
    return lines;
}

void countGlyphs(LinePicture& line, const std::vector<cv::Rect>& boxes, const cv::Range& rows) {
    double height = rows.size();
    for (const cv::Rect& box : boxes) {
        if (box.y < rows.start || box.br().y > rows.end) continue;
        bool small = box.height < 0.3 * height && box.width < 0.4 * height;
        bool atFoot = box.br().y > rows.start + 0.8 * height && box.y > rows.start + 0.6 * height;
        if (!small)
            ++line.glyphs;
        else if (atFoot)
            ++line.dots;
    }
}

/// Share of ink, and holes in it larger than noise.
void lookAtShape(LinePicture& line, const cv::Mat& mask) {
    line.fill = static_cast<double>(cv::countNonZero(mask)) /
                std::max<double>(1.0, static_cast<double>(mask.total()));
    cv::Mat inner = mask(cv::Rect(mask.cols * 3 / 10, mask.rows * 3 / 10, std::max(1, mask.cols * 4 / 10),
                                  std::max(1, mask.rows * 4 / 10)));
    line.middle = static_cast<double>(cv::countNonZero(inner)) / static_cast<double>(inner.total());
    std::vector<std::vector<cv::Point>> contours;
    std::vector<cv::Vec4i> tree;
    cv::findContours(mask, contours, tree, cv::RETR_CCOMP, cv::CHAIN_APPROX_SIMPLE);
    double least = mask.rows * mask.rows / 200.0;
    for (std::size_t i = 0; i < contours.size(); ++i)
        if (tree[i][3] >= 0 && cv::contourArea(contours[i]) >= least) ++line.holes;
}

/// A space is far wider than the gaps between the letters of a word, however widely those are set.
void lookForGap(LinePicture& line, const std::vector<cv::Rect>& boxes, const cv::Rect& box) {
    std::vector<int> gaps;
    int end = box.x;
    for (const cv::Rect& b : boxes) { // from left to right
        if ((b & box) != b) continue;
        if (end > box.x) gaps.push_back(b.x - end);
        end = std::max(end, b.br().x);
    }
    if (gaps.size() < 2) return;
    std::sort(gaps.begin(), gaps.end());
    int usual = std::max(1, gaps[(gaps.size() - 1) / 2]);
    line.gap = gaps.back() > 0.4 * box.height && gaps.back() > 3 * usual;
}

/// Does the line go on outside the plate? What reaches from top to bottom is the plate's edge, no letter.
void lookBeside(LinePicture& line, const Ink& ink, const cv::Rect& box) {
    for (const cv::Rect& piece : ink.cut) {
        bool edge = piece.y <= 1 && piece.br().y >= ink.mask.rows - 1;
        int shared = std::min(piece.br().y, box.br().y) - std::max(piece.y, box.y);
        int gap = std::max(piece.x, box.x) - std::min(piece.br().x, box.br().x);
        if (shared < box.height * 4 / 10 || gap > box.height * 6 / 10) continue;
        // A plate's own edge stands further off than one letter from the next.
        line.besideEdge = line.besideEdge || (edge && 4 * gap <= box.height);
        if (edge) continue;
        line.alone = false;
        if (piece.height > box.height * 14 / 10) continue;
        line.cutLeft = line.cutLeft || piece.x <= 1;
        line.cutRight = line.cutRight || piece.br().x >= ink.mask.cols - 1;
    }
}

/// Stretched so that ground is white and ink black, what is no ink of the line painted over.
cv::Mat cleaned(const cv::Mat& flat, const Ink& ink, const cv::Rect& box, int margin) {
    cv::Mat stretched, near, grown;
    double span = std::max(1.0, ink.ground - ink.dark);
    flat(box).convertTo(stretched, CV_8U, 255.0 / span * 1.1, -ink.dark * 255.0 / span * 1.1);
    int reach = std::max(3, box.height / 10) | 1;
    cv::dilate(ink.mask(box), grown, cv::getStructuringElement(cv::MORPH_ELLIPSE, {reach, reach}));
    stretched.setTo(255, grown == 0);
    cv::copyMakeBorder(stretched, near, margin, margin, margin, margin, cv::BORDER_CONSTANT, cv::Scalar(255));
    return near;
}

/// The line that stands in `box` of the flat plate; `rows` are its top and bottom.
LinePicture pictured(const cv::Mat& flat, const Ink& ink, const std::vector<cv::Rect>& boxes,
                     const cv::Rect& box, const Quad& plate, double high, int height) {
    LinePicture line;
    line.letterPx = box.height * high / flat.rows;
    line.contrast = ink.ground - ink.dark;
    line.sharpness = steepness(flat(box), {ink.mask(box), {}, ink.ground, ink.dark}, flat.rows / high);
    countGlyphs(line, boxes, cv::Range(box.y, box.br().y));
    lookForGap(line, boxes, box);
    lookAtShape(line, ink.mask(box));
    lookBeside(line, ink, box);
    line.aspect = static_cast<double>(box.width) / box.height;
    line.quad =
        part(plate, static_cast<double>(box.x) / flat.cols, static_cast<double>(box.y) / flat.rows,
             static_cast<double>(box.br().x) / flat.cols, static_cast<double>(box.br().y) / flat.rows);
    cv::Mat clean = cleaned(flat, ink, box, box.height / 3);
    double scale = static_cast<double>(height) / box.height;
    cv::resize(clean, line.picture, cv::Size(), scale, scale, scale < 1.0 ? cv::INTER_AREA : cv::INTER_CUBIC);
    cv::GaussianBlur(line.picture, line.soft, cv::Size(), height / 24.0);
    return line;
}

/// Grows a line's box to both sides by pieces of its own height that stand no more than a word's gap away.
cv::Rect grown(cv::Rect box, const std::vector<cv::Rect>& pieces) {
    for (bool changed = true; changed;) {
        changed = false;
        for (const cv::Rect& piece : pieces) {
            if ((piece & box) == piece) continue;
            int shared = std::min(piece.br().y, box.br().y) - std::max(piece.y, box.y);
            int gap = std::max(piece.x, box.x) - std::min(piece.br().x, box.br().x);
            bool letter = piece.height > 0.45 * box.height && piece.height < 1.25 * box.height &&
                          shared > 0.75 * std::min(piece.height, box.height) && gap < 0.75 * box.height;
            bool mark = piece.height <= 0.45 * box.height && shared == piece.height && gap < 0.3 * box.height;
            if (!letter && !mark) continue;
            box |= piece;
            changed = true;
        }
    }
    return box;
}

/// Boxes of the glyphs between two rows, from left to right, parted where a gap is far wider than any space:
/// the columns of a table are no one line.
std::vector<cv::Rect> wordsApart(const std::vector<cv::Rect>& boxes, const cv::Range& rows) {
    std::vector<cv::Rect> lines;
    for (const cv::Rect& b : boxes) {
        if (b.y < rows.start || b.br().y > rows.end) continue;
        if (lines.empty() || b.x - lines.back().br().x > 3 * rows.size() / 2)
            lines.push_back(b);
        else
            lines.back() |= b;
    }
    return lines;
}

/// Does the middle of a box in the flat picture of `strip` lie on the plate?
bool standsOn(const Quad& plate, const Quad& strip, cv::Size flat, const cv::Rect& box) {
    ImagePoint middle =
        between(strip, (box.x + box.width / 2.0) / flat.width, (box.y + box.height / 2.0) / flat.height);
    std::vector<cv::Point2f> outline;
    for (const ImagePoint& corner : plate)
        outline.emplace_back(static_cast<float>(corner.x), static_cast<float>(corner.y));
    return cv::pointPolygonTest(outline, {static_cast<float>(middle.x), static_cast<float>(middle.y)},
                                false) >= 0;
}

/// A line does not go on behind what stands from top to bottom beside it: a post, or the wall beside a plate.
void withinPosts(std::vector<cv::Rect>& boxes, const std::vector<cv::Rect>& cut, const cv::Rect& core,
                 int rows) {
    int left = 0, right = INT_MAX;
    for (const cv::Rect& piece : cut) {
        if (10 * piece.height < 9 * rows) continue;
        if (piece.br().x <= core.x) left = std::max(left, piece.br().x);
        if (piece.x >= core.br().x) right = std::min(right, piece.x);
    }
    std::erase_if(boxes, [&](const cv::Rect& b) { return b.x < left || b.br().x > right; });
}

} // namespace

Quad drawnIn(const Quad& quad, double x, double y) {
    return part(quad, x, y, 1.0 - x, 1.0 - y);
}

std::vector<LinePicture> linesOfPlate(const cv::Mat& grey, const Quad& plate, int height) {
    std::vector<LinePicture> lines;
    double high = (side(plate, 0, 3) + side(plate, 1, 2)) / 2.0;
    double wide = (side(plate, 0, 1) + side(plate, 3, 2)) / 2.0;
    if (!(high >= 6.0 && wide >= 4.0) || wide > 40.0 * high) return lines;
    int rows = std::clamp(static_cast<int>(high * 2.0), 2 * height, 5 * height);
    cv::Mat flat = darkOnLight(rectified(grey, plate, rows, 2400));
    int band = std::min(flat.rows, flat.cols) / 8;
    Ink ink = inkOf(flat, cv::Rect(band, band, flat.cols - 2 * band, flat.rows - 2 * band));
    std::vector<cv::Rect> boxes = glyphBoxes(ink.mask, 4);
    for (const cv::Range& range : rowsOf(boxes, flat.rows)) {
        for (const cv::Rect& box : wordsApart(boxes, range)) {
            std::vector<cv::Rect> own = boxes;
            std::erase_if(own, [&](const cv::Rect& b) { return (b & box) != b; });
            lines.push_back(pictured(flat, ink, own, box, plate, high, height));
        }
    }
    return lines;
}

std::optional<LinePicture> wholeLine(const cv::Mat& grey, const Quad& quad, bool lightInk, int height,
                                     const std::optional<Quad>& plate) {
    constexpr double kBeside = 3.0; // of the quad's height: the longest that a line is followed at once
    double high = (side(quad, 0, 3) + side(quad, 1, 2)) / 2.0;
    double wide = (side(quad, 0, 1) + side(quad, 3, 2)) / 2.0;
    if (!(high >= 6.0 && wide >= 3.0) || wide > 40.0 * high) return std::nullopt;
    double beside = kBeside * high / wide;
    Quad strip = part(quad, -beside, 0.0, 1.0 + beside, 1.0);
    cv::Mat flat = rectified(grey, strip, 2 * height, 4000);
    if (lightInk) cv::bitwise_not(flat, flat);
    auto start = static_cast<int>(flat.cols * beside / (1.0 + 2.0 * beside));
    cv::Rect middle(start, 0, std::max(1, flat.cols - 2 * start), flat.rows);
    Ink ink = inkOf(flat, middle);
    std::vector<cv::Rect> boxes = glyphBoxes(ink.mask, 4);
    if (plate)
        std::erase_if(boxes, [&](const cv::Rect& b) { return !standsOn(*plate, strip, flat.size(), b); });
    cv::Rect box;
    for (const cv::Rect& b : boxes)
        if ((b & middle).area() > b.area() / 2 && b.height > 0.3 * flat.rows) box |= b;
    if (box.area() == 0) return std::nullopt;
    withinPosts(boxes, ink.cut, box, flat.rows);
    box = grown(box, boxes);
    // What is no part of the line is wall, frame or another line: it is not painted.
    std::erase_if(boxes, [&](const cv::Rect& b) { return (b & box) != b; });
    LinePicture line = pictured(flat, ink, boxes, box, strip, high, height);
    return line;
}

} // namespace farol::recognition
