#include "ui/map/coverage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace farol::ui {

namespace {

constexpr int kNoRegion = -1;

/// One floor in squares: whose each is, and through which of them one sees from region to region.
class Floor {
public:
    Floor(const building::Building& building, double level, const CoverageOptions& options)
        : m_building(building), m_options(options) {
        m_cover.level = level;
        Box2 box;
        if (!bounds(level, box)) return;
        const double area = std::max(box.width() * box.height(), 1e-6);
        const double most = static_cast<double>(options.mostCells);
        m_cover.cellM = std::max(options.cellM, std::sqrt(area / most));
        m_cover.corner = box.low;
        m_cover.columns = static_cast<int>(std::ceil(box.width() / m_cover.cellM)) + 1;
        m_cover.rows = static_cast<int>(std::ceil(box.height() / m_cover.cellM)) + 1;
        const std::size_t cells =
            static_cast<std::size_t>(m_cover.columns) * static_cast<std::size_t>(m_cover.rows);
        m_cover.seen.assign(cells, LevelCoverage::kOutside);
        m_region.assign(cells, kNoRegion);
        m_gap.assign(cells, false);
        fillRegions(level);
        fillGaps(level);
    }

    void add(const building::Landmark& landmark) {
        if (m_cover.seen.empty()) return;
        const double far = landmark.widthM ? std::min(m_options.farM, m_options.sizesAway * *landmark.widthM)
                                           : m_options.farM;
        const auto home = m_building.regionIndex(landmark.region);
        const int cells = static_cast<int>(std::ceil(far / m_cover.cellM));
        const int column = columnOf(landmark.position.x);
        const int row = rowOf(landmark.position.y);
        for (int y = std::max(0, row - cells); y <= std::min(m_cover.rows - 1, row + cells); ++y)
            for (int x = std::max(0, column - cells); x <= std::min(m_cover.columns - 1, column + cells);
                 ++x) {
                std::uint8_t& seen = m_cover.seen[index(x, y)];
                if (seen >= LevelCoverage::kOutside - 1) continue;
                if (home && isSeen(landmark, static_cast<int>(*home), middle(x, y), far)) ++seen;
            }
    }

    LevelCoverage take() {
        for (const std::uint8_t seen : m_cover.seen) {
            m_cover.inside += seen != LevelCoverage::kOutside;
            m_cover.unseen += seen == 0;
        }
        return std::move(m_cover);
    }

private:
    bool bounds(double level, Box2& box) const {
        bool any = false;
        for (const building::Region& region : m_building.regions()) {
            const auto its = region.level == level ? boundingBox(region.polygon.outer) : std::nullopt;
            if (!its) continue;
            box.low =
                any ? Point2{std::min(box.low.x, its->low.x), std::min(box.low.y, its->low.y)} : its->low;
            box.high = any ? Point2{std::max(box.high.x, its->high.x), std::max(box.high.y, its->high.y)}
                           : its->high;
            any = true;
        }
        return any;
    }

    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_cover.columns) +
               static_cast<std::size_t>(column);
    }
    int columnOf(double x) const {
        return static_cast<int>(std::floor((x - m_cover.corner.x) / m_cover.cellM));
    }
    int rowOf(double y) const { return static_cast<int>(std::floor((y - m_cover.corner.y) / m_cover.cellM)); }
    Point2 middle(int column, int row) const {
        return m_cover.corner + Point2{(column + 0.5) * m_cover.cellM, (row + 0.5) * m_cover.cellM};
    }
    bool onFloor(int column, int row) const {
        return column >= 0 && row >= 0 && column < m_cover.columns && row < m_cover.rows;
    }

    void fillRegions(double level) {
        for (std::size_t i = 0; i < m_building.regions().size(); ++i) {
            const building::Region& region = m_building.regions()[i];
            const auto box = region.level == level ? boundingBox(region.polygon.outer) : std::nullopt;
            if (!box) continue;
            for (int row = rowOf(box->low.y); row <= std::min(rowOf(box->high.y), m_cover.rows - 1); ++row)
                for (int column = columnOf(box->low.x);
                     column <= std::min(columnOf(box->high.x), m_cover.columns - 1); ++column) {
                    if (!contains(region.polygon, middle(column, row))) continue;
                    m_region[index(column, row)] = static_cast<int>(i);
                    m_cover.seen[index(column, row)] = 0;
                }
        }
    }

    /// One sees through doors, openings and windows; a wall between two regions is thinner than a metre.
    void fillGaps(double level) {
        for (const building::Access& access : m_building.accesses()) {
            if (access.level != level || access.closed || access.changesLevel() || access.line.empty())
                continue;
            for (std::size_t i = 0; i < access.line.size(); ++i) {
                const Point2 a = access.line[i > 0 ? i - 1 : 0];
                const Point2 b = access.line[i];
                const double reach = std::max(0.5, 0.75 * m_cover.cellM);
                for (int row = rowOf(std::min(a.y, b.y) - reach); row <= rowOf(std::max(a.y, b.y) + reach);
                     ++row)
                    for (int column = columnOf(std::min(a.x, b.x) - reach);
                         column <= columnOf(std::max(a.x, b.x) + reach); ++column)
                        if (onFloor(column, row) && distanceToSegment(middle(column, row), a, b) <= reach)
                            m_gap[index(column, row)] = true;
            }
        }
    }

    bool isSeen(const building::Landmark& landmark, int home, Point2 eye, double far) const {
        const Point2 out = eye - landmark.position;
        const double away = length(out);
        if (away > far) return false;
        if (landmark.kind == Kind::Place) return away <= 2.0; // a view from the spot itself
        if (landmark.heading && away > m_cover.cellM &&
            std::abs(std::remainder(directionOf(out).value - landmark.heading->value, 2.0 * kPi)) >
                m_options.sideways)
            return false;
        return isFree(landmark.position, eye, home);
    }

    /// From a landmark, which may hang on the wall itself, to an eye.
    bool isFree(Point2 from, Point2 to, int home) const {
        const double away = distance(from, to);
        const int steps = std::max(1, static_cast<int>(std::ceil(2.0 * away / m_cover.cellM)));
        int in = home;
        for (int i = 1; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            const Point2 at = from + (to - from) * share;
            const int column = columnOf(at.x);
            const int row = rowOf(at.y);
            if (!onFloor(column, row)) return false;
            const std::size_t cell = index(column, row);
            if (m_region[cell] == in || share * away < std::max(0.4, m_cover.cellM)) continue;
            if (!m_gap[cell]) return false;
            if (m_region[cell] != kNoRegion) in = m_region[cell];
        }
        return in == m_region[index(columnOf(to.x), rowOf(to.y))];
    }

    const building::Building& m_building;
    const CoverageOptions& m_options;
    LevelCoverage m_cover;
    std::vector<int> m_region;
    std::vector<bool> m_gap;
};

} // namespace

std::uint8_t LevelCoverage::at(Point2 place) const {
    const int column = static_cast<int>(std::floor((place.x - corner.x) / cellM));
    const int row = static_cast<int>(std::floor((place.y - corner.y) / cellM));
    const bool there = column >= 0 && row >= 0 && column < columns && row < rows;
    return there ? at(column, row) : kOutside;
}

const LevelCoverage* Coverage::level(double ordinal) const {
    const auto found = std::find_if(levels.begin(), levels.end(),
                                    [ordinal](const LevelCoverage& level) { return level.level == ordinal; });
    return found == levels.end() ? nullptr : &*found;
}

double Coverage::unseenShare() const {
    std::size_t inside = 0;
    std::size_t unseen = 0;
    for (const LevelCoverage& level : levels) {
        inside += level.inside;
        unseen += level.unseen;
    }
    return inside > 0 ? static_cast<double>(unseen) / static_cast<double>(inside) : 0.0;
}

namespace {

/// The first line of a picture is the north. Unseen places are striped: colour never stands alone.
QImage drawn(const LevelCoverage& level, bool dark) {
    QImage image(level.columns, level.rows, QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    for (int row = 0; row < level.rows; ++row)
        for (int column = 0; column < level.columns; ++column) {
            const std::uint8_t seen = level.at(column, row);
            if (seen == LevelCoverage::kOutside) continue;
            QColor colour = coverageColour(seen, dark);
            if (seen == 0 && (column + row) % 3 != 0) colour.setAlpha(40);
            image.setPixelColor(column, level.rows - 1 - row, colour);
        }
    return image;
}

} // namespace

QColor coverageColour(int seen, bool dark) {
    if (seen == 0) return dark ? QColor(255, 120, 120, 150) : QColor(163, 20, 43, 130);
    if (seen == 1) return dark ? QColor(90, 190, 230, 55) : QColor(0, 110, 170, 40);
    return dark ? QColor(90, 190, 230, 170) : QColor(0, 110, 170, 150);
}

CoverageLayer drawCoverage(Coverage coverage) {
    CoverageLayer layer;
    for (const LevelCoverage& level : coverage.levels) {
        layer.light.push_back(drawn(level, false));
        layer.dark.push_back(drawn(level, true));
    }
    layer.coverage = std::move(coverage);
    return layer;
}

Coverage findCoverage(const building::Building& building, const CoverageOptions& options) {
    std::vector<double> ordinals;
    for (const building::Region& region : building.regions()) ordinals.push_back(region.level);
    std::sort(ordinals.begin(), ordinals.end());
    ordinals.erase(std::unique(ordinals.begin(), ordinals.end()), ordinals.end());
    Coverage coverage;
    for (const double ordinal : ordinals) {
        Floor floor(building, ordinal, options);
        for (const building::Landmark& landmark : building.landmarks())
            if (landmark.level == ordinal) floor.add(landmark);
        coverage.levels.push_back(floor.take());
    }
    return coverage;
}

} // namespace farol::ui
