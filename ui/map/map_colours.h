#pragma once
// The map's colours in a light and a dark window.

#include <QColor>

namespace farol::ui {

struct MapColours {
    QColor outside, floor, corridor, border, wall, text, halo, door, shaft, closed;
    QColor route, routeCasing, passed, fix, fixCasing, destination;
    bool dark = false;

    static MapColours of(bool dark);
    /// From the floor's own colour (0) to the strongest vote (1); text() stays readable on all of them.
    QColor heat(double share) const;
};

} // namespace farol::ui
