#include "core/recognition/door_outlines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace farol::recognition {

namespace {

constexpr std::size_t kMostJambs = 44, kMostLevels = 90;

/// A line across the door: y at the left and at the right jamb.
struct Level {
    double left = 0.0, right = 0.0, support = 0.0;
    bool seen = true;
};

double crossing(const EdgeLine& jamb, const EdgeLine& level) {
    // x = o1 + s1 y and y = o2 + s2 x
    double y = (level.offset + level.slope * jamb.offset) / (1.0 - level.slope * jamb.slope);
    return y;
}

cv::Point2d onJamb(const EdgeLine& jamb, double y) {
    return {jamb.at(y), y};
}

class OutlineFinder {
public:
    OutlineFinder(const EdgeField& field, const DoorCueOptions& options)
        : m_field(field), m_options(options), m_size(field.dx().size()) {
        EdgeOptions upright{options.maxTiltDegrees, 5.0, std::max(8, m_size.height / 30)};
        m_jambs = strongest(joinedLines(longest(field.verticals(upright)), 0.15 * m_size.height), kMostJambs,
                            0.5 * options.minHeightShare * m_size.height);
        std::sort(m_jambs.begin(), m_jambs.end(), [&](const EdgeLine& a, const EdgeLine& b) {
            double y = m_size.height / 2.0;
            return std::make_tuple(a.at(y), a.from, a.to) < std::make_tuple(b.at(y), b.from, b.to);
        });
        EdgeOptions level{24.0, 5.0, std::max(8, m_size.width / 30)};
        m_levels = strongest(joinedLines(longest(field.horizontals(level)), 0.1 * m_size.width), kMostLevels,
                             0.03 * m_size.width);
    }

    std::vector<DoorOutline> find() {
        std::vector<DoorOutline> found;
        for (std::size_t i = 0; i < m_jambs.size(); ++i)
            for (std::size_t j = i + 1; j < m_jambs.size(); ++j) addPair(m_jambs[i], m_jambs[j], found);
        std::stable_sort(found.begin(), found.end(), [](const DoorOutline& a, const DoorOutline& b) {
            return a.outlined() > b.outlined();
        });
        std::vector<DoorOutline> kept;
        for (const DoorOutline& one : found) {
            if (kept.size() >= m_options.most) break;
            bool copy =
                std::any_of(kept.begin(), kept.end(), [&](const DoorOutline& k) { return near(k, one); });
            if (!copy) kept.push_back(one);
        }
        return kept;
    }

private:
    static std::vector<EdgeLine> longest(std::vector<EdgeLine> lines) {
        return strongest(std::move(lines), 500, 0.0);
    }

    static std::vector<EdgeLine> strongest(std::vector<EdgeLine> lines, std::size_t most, double least) {
        std::erase_if(lines,
                      [&](const EdgeLine& l) { return l.length() < least || l.drawn < 0.45 * l.length(); });
        auto weight = [](const EdgeLine& l) { return l.drawn * std::min(l.contrast, 25.0); };
        std::sort(lines.begin(), lines.end(), [&](const EdgeLine& a, const EdgeLine& b) {
            return std::make_tuple(-weight(a), a.offset, a.from) <
                   std::make_tuple(-weight(b), b.offset, b.from);
        });
        if (lines.size() > most) lines.resize(most);
        return lines;
    }

    static bool near(const DoorOutline& a, const DoorOutline& b) {
        double tolerance = std::max(3.0, 0.03 * a.height());
        for (std::size_t i = 0; i < 4; ++i)
            if (std::abs(a.quad[i].x - b.quad[i].x) > tolerance ||
                std::abs(a.quad[i].y - b.quad[i].y) > tolerance)
                return false;
        return true;
    }

    void addPair(const EdgeLine& l, const EdgeLine& r, std::vector<DoorOutline>& found) const {
        double high = std::max(l.from, r.from), low = std::min(l.to, r.to);
        double longer = std::max(l.length(), r.length());
        if (low - high < 0.4 * longer || longer < 0.8 * m_options.minHeightShare * m_size.height) return;
        double middle = (high + low) / 2.0;
        double width = r.at(middle) - l.at(middle);
        double tall = std::max(l.to, r.to) - std::min(l.from, r.from);
        if (width < 0.06 * m_size.width || tall > 1.2 * m_options.maxAspect * width || tall < 0.8 * width)
            return;
        std::vector<Level> tops = levelsAt(l, r, width, true);
        std::vector<Level> feet = levelsAt(l, r, width, false);
        for (const Level& top : tops)
            for (const Level& foot : feet)
                if (auto outline = outlineOf(l, r, top, foot)) found.push_back(*outline);
    }

    /// Where the door may begin (or end): at an edge across, at the picture's border, where the jambs end.
    std::vector<Level> levelsAt(const EdgeLine& l, const EdgeLine& r, double width, bool top) const {
        double H = m_size.height;
        double first = top ? std::min(l.from, r.from) : std::min(l.to, r.to);
        double last = top ? std::max(l.from, r.from) : std::max(l.to, r.to);
        double middle = (std::max(l.from, r.from) + std::min(l.to, r.to)) / 2.0;
        std::vector<Level> levels;
        for (const EdgeLine& line : m_levels) {
            double yl = crossing(l, line), yr = crossing(r, line), y = (yl + yr) / 2.0;
            if (top ? y > middle : y < middle) continue;
            if (y < first - 0.06 * H || y > last + 0.06 * H || yl < 0.0 || yr < 0.0 || yl >= H || yr >= H)
                continue;
            double shared = std::min(line.to, r.at(yr)) - std::max(line.from, l.at(yl));
            if (shared < 0.3 * width) continue;
            double support = m_field.support(onJamb(l, yl), onJamb(r, yr), false, 2, 4.0);
            if (support >= (top ? 0.5 : 0.35)) levels.push_back({yl, yr, support, true});
        }
        std::stable_sort(levels.begin(), levels.end(),
                         [](const Level& a, const Level& b) { return a.support > b.support; });
        if (levels.size() > 3) levels.resize(3);
        if (top && first < 0.03 * H) levels.push_back({1.0, 1.0, 0.4, false});
        if (!top && last > 0.95 * H) levels.push_back({H - 2.0, H - 2.0, 0.4, false});
        if (!top && last <= 0.95 * H && last > 0.6 * H && last - first < 0.12 * H)
            levels.push_back({l.to, r.to, 0.0, true});
        return levels;
    }

    std::optional<DoorOutline> outlineOf(const EdgeLine& l, const EdgeLine& r, const Level& top,
                                         const Level& foot) const {
        DoorOutline outline;
        outline.quad = {onJamb(l, top.left), onJamb(r, top.right), onJamb(r, foot.right),
                        onJamb(l, foot.left)};
        outline.topSeen = top.seen;
        outline.footSeen = foot.seen;
        outline.lintel = top.support;
        outline.foot = foot.support;
        double width = outline.width(), height = outline.height();
        if (width < 10.0 || height < m_options.minHeightShare * m_size.height) return std::nullopt;
        double aspect = height / width;
        bool whole = top.seen && foot.seen;
        if (aspect > m_options.maxAspect ||
            aspect < (whole ? m_options.minAspect : 0.75 * m_options.minAspect))
            return std::nullopt;
        if (!top.seen && !foot.seen && aspect < m_options.minAspect) return std::nullopt;
        outline.leftJamb = m_field.support(outline.quad[0], outline.quad[3], true, 2, 4.0);
        outline.rightJamb = m_field.support(outline.quad[1], outline.quad[2], true, 2, 4.0);
        if (std::min(outline.leftJamb, outline.rightJamb) < 0.35) return std::nullopt;
        if (outline.leftJamb + outline.rightJamb + outline.lintel < 1.5) return std::nullopt;
        return outline;
    }

    const EdgeField& m_field;
    const DoorCueOptions& m_options;
    cv::Size m_size;
    std::vector<EdgeLine> m_jambs, m_levels;
};

} // namespace

double DoorOutline::width() const {
    return (quad[1].x - quad[0].x + quad[2].x - quad[3].x) / 2.0;
}

double DoorOutline::height() const {
    return (quad[3].y - quad[0].y + quad[2].y - quad[1].y) / 2.0;
}

std::vector<DoorOutline> doorOutlines(const EdgeField& field, const DoorCueOptions& options) {
    if (std::min(field.dx().cols, field.dx().rows) < 32) return {};
    return OutlineFinder(field, options).find();
}

} // namespace farol::recognition
