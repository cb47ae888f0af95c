#pragma once
// The map's colours in a light and a dark window.

#include "core/building/building.h"
#include "ui/map/map_overlay.h"

#include <QColor>

namespace farol::ui {

struct MapColours {
    QColor outside, floor, corridor, border, wall, text, halo, door, shaft, closed;
    QColor route, routeCasing, passed, fix, fixCasing, destination;
    bool dark = false;

    static MapColours of(bool dark);
    /// From the floor's own colour (0) to the strongest vote (1); text() stays readable on all of them.
    QColor heat(double share) const;
    /// A quiet colour for each kind of region; text() stays readable on all of them.
    QColor fill(building::RegionKind kind) const;
};

/// How a marked region is hatched.
struct RegionMarkStyle {
    QColor colour;
    Qt::BrushStyle pattern = Qt::NoBrush;
};
RegionMarkStyle regionMarkStyle(RegionMark mark, bool dark);

} // namespace farol::ui
