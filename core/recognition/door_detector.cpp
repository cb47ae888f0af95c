#include "core/recognition/door_detector.h"

#include "core/recognition/grey.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace farol::recognition {

namespace {

constexpr int kWorkingSide = 480;

/// A near-vertical edge, x as a line in y.
struct Jamb {
    double x = 0.0, slope = 0.0; ///< x at y = 0, and its change a row
    double top = 0.0, bottom = 0.0;
    double drawn = 0.0; ///< rows of it that are really edge

    double at(double y) const { return x + slope * y; }
    double length() const { return bottom - top; }
};

struct Lintel {
    cv::Point2d left, right;

    double at(double x) const {
        double span = right.x - left.x;
        return span > 0.0 ? left.y + (right.y - left.y) * (x - left.x) / span : left.y;
    }
};

struct Door {
    std::array<cv::Point2d, 4> quad;
    double jambs = 0.0, lintel = 0.0, contrast = 0.0, evenness = 0.0;
    double score = 0.0;
    const char* doubt = nullptr; ///< why it is no door after all
    double doubtValue = 0.0;
};

struct Lines {
    std::vector<Jamb> jambs;
    std::vector<Lintel> lintels;
};

Jamb jambFrom(const cv::Vec4f& s) {
    Jamb jamb;
    cv::Point2d a(s[0], s[1]), b(s[2], s[3]);
    if (a.y > b.y) std::swap(a, b);
    jamb.top = a.y;
    jamb.bottom = b.y;
    jamb.slope = (b.x - a.x) / std::max(b.y - a.y, 1e-6);
    jamb.x = a.x - jamb.slope * a.y;
    jamb.drawn = b.y - a.y;
    return jamb;
}

/// Handles, hinges and signs cut an edge into pieces: those in line are one.
std::vector<Jamb> joined(std::vector<Jamb> pieces, double mostGap) {
    std::sort(pieces.begin(), pieces.end(), [](const Jamb& a, const Jamb& b) {
        return std::make_tuple(-a.drawn, a.x, a.top) < std::make_tuple(-b.drawn, b.x, b.top);
    });
    std::vector<Jamb> whole;
    std::vector<bool> used(pieces.size(), false);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (used[i]) continue;
        Jamb jamb = pieces[i];
        for (bool grown = true; grown;) {
            grown = false;
            for (std::size_t j = i + 1; j < pieces.size(); ++j) {
                const Jamb& p = pieces[j];
                if (used[j]) continue;
                bool inLine = std::abs(p.at(p.top) - jamb.at(p.top)) < 3.0 &&
                              std::abs(p.at(p.bottom) - jamb.at(p.bottom)) < 3.0;
                double gap = std::max(jamb.top, p.top) - std::min(jamb.bottom, p.bottom);
                if (!inLine || gap > mostGap) continue;
                jamb.drawn += std::max(0.0, p.length() + std::min(gap, 0.0));
                cv::Point2d head = p.top < jamb.top ? cv::Point2d(p.at(p.top), p.top)
                                                    : cv::Point2d(jamb.at(jamb.top), jamb.top);
                cv::Point2d foot = p.bottom > jamb.bottom ? cv::Point2d(p.at(p.bottom), p.bottom)
                                                          : cv::Point2d(jamb.at(jamb.bottom), jamb.bottom);
                jamb.slope = (foot.x - head.x) / std::max(foot.y - head.y, 1e-6);
                jamb.x = head.x - jamb.slope * head.y;
                jamb.top = head.y;
                jamb.bottom = foot.y;
                used[j] = grown = true;
            }
        }
        whole.push_back(jamb);
    }
    return whole;
}

Lines linesOf(const cv::Mat& grey, const DoorDetectorOptions& options) {
    std::vector<cv::Vec4f> segments;
    cv::createLineSegmentDetector(cv::LSD_REFINE_STD)->detect(grey, segments);
    std::vector<Jamb> pieces;
    Lines lines;
    for (const cv::Vec4f& s : segments) {
        double dx = std::abs(s[2] - s[0]);
        double dy = std::abs(s[3] - s[1]);
        double length = std::hypot(dx, dy);
        if (length < 0.03 * grey.rows) continue;
        double fromVertical = std::atan2(dx, dy) * 180.0 / kPi;
        if (fromVertical <= options.maxTiltDegrees) pieces.push_back(jambFrom(s));
        if (90.0 - fromVertical <= 1.5 * options.maxTiltDegrees) {
            Lintel lintel{{s[0], s[1]}, {s[2], s[3]}};
            if (lintel.left.x > lintel.right.x) std::swap(lintel.left, lintel.right);
            lines.lintels.push_back(lintel);
        }
    }
    lines.jambs = joined(std::move(pieces), 0.12 * grey.rows);
    std::erase_if(lines.jambs, [&](const Jamb& j) {
        return j.length() < 0.8 * options.minHeightShare * grey.rows || j.drawn < 0.6 * j.length();
    });
    std::sort(lines.jambs.begin(), lines.jambs.end(), [](const Jamb& a, const Jamb& b) {
        return std::make_tuple(a.x, a.top, a.bottom) < std::make_tuple(b.x, b.top, b.bottom);
    });
    return lines;
}

/// How much of the way between the jambs is lintel, at the height of the given piece.
double lintelShare(const std::vector<Lintel>& lintels, const Lintel& level, double left, double right) {
    std::vector<std::pair<double, double>> spans;
    for (const Lintel& l : lintels) {
        double from = std::max(l.left.x, left);
        double to = std::min(l.right.x, right);
        if (to <= from) continue;
        if (std::abs(l.at(from) - level.at(from)) < 3.0 && std::abs(l.at(to) - level.at(to)) < 3.0)
            spans.emplace_back(from, to);
    }
    std::sort(spans.begin(), spans.end());
    double covered = 0.0, reached = left;
    for (auto [from, to] : spans) {
        covered += std::max(0.0, to - std::max(from, reached));
        reached = std::max(reached, to);
    }
    return covered / (right - left);
}

cv::Scalar meanOf(const cv::Mat& lab, double left, double top, double right, double bottom) {
    cv::Rect box(cv::Point(static_cast<int>(left), static_cast<int>(top)),
                 cv::Point(static_cast<int>(right), static_cast<int>(bottom)));
    box &= cv::Rect(0, 0, lab.cols, lab.rows);
    return box.area() > 0 ? cv::mean(lab(box)) : cv::Scalar(-1.0, -1.0, -1.0);
}

double difference(const cv::Scalar& a, const cv::Scalar& b) {
    if (a[0] < 0.0 || b[0] < 0.0) return 0.0;
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                     (a[2] - b[2]) * (a[2] - b[2]));
}

/// Shelves, showcases and vending machines have a door's shape but are full of things.
double edgeShare(const cv::Mat& lab, double left, double top, double right, double bottom) {
    cv::Rect box(cv::Point(static_cast<int>(left), static_cast<int>(top)),
                 cv::Point(static_cast<int>(right), static_cast<int>(bottom)));
    box &= cv::Rect(0, 0, lab.cols, lab.rows);
    if (box.area() == 0) return 0.0;
    cv::Mat light, edges;
    cv::extractChannel(lab(box), light, 0);
    cv::Canny(light, edges, 40.0, 100.0);
    return static_cast<double>(cv::countNonZero(edges)) / box.area();
}

/// The leaf differs from the wall on both sides, and is alike in itself.
void lookAtLeaf(const cv::Mat& lab, Door& door) {
    double left = (door.quad[0].x + door.quad[3].x) / 2.0;
    double right = (door.quad[1].x + door.quad[2].x) / 2.0;
    double top = (door.quad[0].y + door.quad[1].y) / 2.0;
    double bottom = (door.quad[2].y + door.quad[3].y) / 2.0;
    double w = right - left;
    double h = bottom - top;
    double margin = 0.12 * w; // a door frame's width
    cv::Scalar leafLeft = meanOf(lab, left + margin, top + 0.1 * h, left + 0.45 * w, bottom - 0.1 * h);
    cv::Scalar leafRight = meanOf(lab, right - 0.45 * w, top + 0.1 * h, right - margin, bottom - 0.1 * h);
    cv::Scalar wallLeft = meanOf(lab, left - 0.35 * w, top + 0.1 * h, left - margin, bottom - 0.1 * h);
    cv::Scalar wallRight = meanOf(lab, right + margin, top + 0.1 * h, right + 0.35 * w, bottom - 0.1 * h);
    double against = std::max(difference(leafLeft, wallLeft), difference(leafRight, wallRight));
    double weaker = std::min(difference(leafLeft, wallLeft), difference(leafRight, wallRight));
    door.contrast = std::clamp((0.5 * against + 0.5 * weaker) / 40.0, 0.0, 1.0);
    door.evenness = std::clamp(1.0 - difference(leafLeft, leafRight) / 40.0, 0.0, 1.0);
    double busy = edgeShare(lab, left + margin, top + 0.08 * h, right - margin, bottom - 0.08 * h);
    double fall = difference(meanOf(lab, left + margin, top + 0.1 * h, right - margin, top + 0.45 * h),
                             meanOf(lab, left + margin, top + 0.72 * h, right - margin, top + 0.86 * h));
    // The end of a corridor: its lower part is floor, and on one side it is lit like the wall beside it.
    bool corridor = fall > 35.0 && weaker < 35.0;
    if (busy > 0.14) {
        door.doubt = "busy_leaf";
        door.doubtValue = busy;
    } else if (corridor) {
        door.doubt = "corridor_end";
        door.doubtValue = fall;
    }
}

std::optional<Door> doorFrom(const Jamb& l, const Jamb& r, const Lintel& level, const Lines& lines,
                             cv::Size size, const DoorDetectorOptions& options) {
    double middle = (level.left.y + level.right.y) / 2.0;
    double left = l.at(middle);
    double right = r.at(middle);
    double bottom = std::min(std::max(l.bottom, r.bottom), static_cast<double>(size.height));
    double topLeft = level.at(left);
    double topRight = level.at(right);
    double height = bottom - (topLeft + topRight) / 2.0;
    double width = (right - left + r.at(bottom) - l.at(bottom)) / 2.0;
    if (width < 8.0 || height < options.minHeightShare * size.height) return std::nullopt;
    double aspect = height / width;
    if (aspect < options.minAspect || aspect > options.maxAspect) return std::nullopt;
    // Doors stand on the floor and jambs end at the lintel: windows, boards and pillars do not.
    if (bottom < 0.72 * size.height) return std::nullopt;
    if (std::abs(l.bottom - r.bottom) > 0.15 * height) return std::nullopt;
    if (std::abs(l.top - topLeft) > 0.08 * height || std::abs(r.top - topRight) > 0.08 * height)
        return std::nullopt;
    Door door;
    door.lintel = lintelShare(lines.lintels, level, left, right);
    if (door.lintel < 0.5) return std::nullopt;
    auto drawn = [&](const Jamb& j) { return std::min(1.0, j.drawn / height); };
    door.jambs = std::min(drawn(l), drawn(r));
    door.quad = {cv::Point2d(l.at(topLeft), topLeft), cv::Point2d(r.at(topRight), topRight),
                 cv::Point2d(r.at(bottom), bottom), cv::Point2d(l.at(bottom), bottom)};
    return door;
}

std::vector<Door> doorsAmong(const Lines& lines, const cv::Mat& lab, const DoorDetectorOptions& options) {
    std::vector<Door> doors;
    for (std::size_t i = 0; i < lines.jambs.size(); ++i) {
        for (std::size_t j = i + 1; j < lines.jambs.size(); ++j) {
            const Jamb& l = lines.jambs[i];
            const Jamb& r = lines.jambs[j];
            double width = r.at(lab.rows / 2.0) - l.at(lab.rows / 2.0);
            if (width < 0.1 * lab.cols || std::abs(l.top - r.top) > 0.2 * lab.rows) continue;
            std::optional<Door> best;
            for (const Lintel& level : lines.lintels) {
                if (level.right.x < l.at(level.right.y) || level.left.x > r.at(level.left.y)) continue;
                if (level.right.x - level.left.x < 0.2 * width) continue;
                auto door = doorFrom(l, r, level, lines, lab.size(), options);
                if (!door) continue;
                lookAtLeaf(lab, *door);
                door->score =
                    0.3 * door->jambs + 0.3 * door->lintel + 0.25 * door->contrast + 0.15 * door->evenness;
                if (!best || door->score > best->score) best = door;
            }
            if (best) doors.push_back(*best);
        }
    }
    std::stable_sort(doors.begin(), doors.end(),
                     [](const Door& a, const Door& b) { return a.score > b.score; });
    return doors;
}

Quad inFullPicture(const Door& door, double scale) {
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i)
        quad[i] = {(door.quad[i].x + 0.5) / scale, (door.quad[i].y + 0.5) / scale};
    return quad;
}

} // namespace

Result<void> DoorDetectorOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    if (!(minHeightShare > 0.0 && minHeightShare <= 1.0))
        return wrong("a share lies between 0 and 1", "minHeightShare");
    if (!(maxTiltDegrees > 0.0 && maxTiltDegrees < 45.0))
        return wrong("a tilt lies between 0 and 45 degrees", "maxTiltDegrees");
    if (!(minAspect > 0.0 && maxAspect > minAspect))
        return wrong("the greatest aspect must be above the least", "maxAspect");
    if (!(minScore >= 0.0 && minScore <= 1.0)) return wrong("a score lies between 0 and 1", "minScore");
    return {};
}

DetectorResult detectDoors(const cv::Mat& image, const DoorDetectorOptions& options) {
    DetectorResult result;
    cv::Mat colour = colourOf(image);
    if (colour.empty() || std::min(colour.cols, colour.rows) < 32) return result;
    double scale = 1.0;
    cv::Mat small = reduced(colour, kWorkingSide, scale);
    cv::Mat lab, grey;
    cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
    cv::cvtColor(small, lab, cv::COLOR_BGR2Lab);
    for (const Door& door : doorsAmong(linesOf(grey, options), lab, options)) {
        Quad quad = inFullPicture(door, scale);
        // The leaf, its frame and the frame's shadow are one door.
        bool copy =
            std::any_of(result.detections.begin(), result.detections.end(), [&](const Detection& kept) {
                return overlap(boundingBox(kept.quad), boundingBox(quad)) > 0.4;
            });
        if (copy) continue;
        if (door.doubt != nullptr || door.score < options.minScore) {
            bool doubted = door.doubt != nullptr;
            result.rejections.push_back({"doors",
                                         Kind::Door,
                                         {},
                                         quad,
                                         doubted ? door.doubt : "low_score",
                                         doubted ? door.doubtValue : door.score});
            continue;
        }
        Detection detection;
        detection.kind = Kind::Door;
        detection.quad = quad;
        detection.image = {image.cols, image.rows};
        detection.score = std::min(door.score, 1.0);
        result.detections.push_back(std::move(detection));
    }
    if (result.rejections.size() > 20) result.rejections.resize(20); // the best few tell enough
    return result;
}

} // namespace farol::recognition
