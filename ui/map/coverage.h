#pragma once
// Where on a floor landmarks can be seen, and from where none can: the places where Farol knows the way by
// counting steps only.

#include "core/building/building.h"

#include <QColor>
#include <QImage>

#include <cstdint>
#include <vector>

namespace farol::ui {

struct CoverageOptions {
    double farM = 8.0;       ///< from farther away a landmark of a usual size is not recognised
    double sizesAway = 20.0; ///< nor one whose width is told from more than so many widths
    double sideways = 1.3;   ///< radians between its front and who sees it
    double cellM = 0.25;     ///< larger on floors that would have more than `mostCells`
    std::size_t mostCells = 400000;
};

/// Squares of one floor, the first in the south-west. How many landmarks are seen from each.
struct LevelCoverage {
    static constexpr std::uint8_t kOutside = 255;

    double level = 0.0;
    Point2 corner;
    double cellM = 0.5;
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> seen; ///< kOutside where no region is
    std::size_t inside = 0, unseen = 0;

    std::uint8_t at(int column, int row) const {
        return seen[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column)];
    }
    std::uint8_t at(Point2 place) const; ///< kOutside beyond the floor
};

struct Coverage {
    std::vector<LevelCoverage> levels;

    const LevelCoverage* level(double ordinal) const;
    double unseenShare() const; ///< of all floors
};

/// A landmark is seen from its own region, and through doors and openings from the next ones, where nothing
/// stands between.
Coverage findCoverage(const building::Building& building, const CoverageOptions& options = {});

/// With a picture of each floor, north up, one pixel a square.
struct CoverageLayer {
    Coverage coverage;
    std::vector<QImage> light, dark; ///< by Coverage::levels
};
CoverageLayer drawCoverage(Coverage coverage);
/// Of a place from which so many landmarks are seen.
QColor coverageColour(int seen, bool dark);

} // namespace farol::ui
