#pragma once
// A picture of a floor plan under the map, and how it lies there.

#include "core/base/geometry.h"

#include <QImage>
#include <QString>
#include <QTransform>

#include <optional>
#include <utility>
#include <vector>

namespace farol::ui {

struct FloorPicture {
    QImage image;
    QTransform toMap; ///< from pixels to metres of the map
    double opacity = 0.6;
    double level = 0.0;
    QString file;
};

/// A point of the picture and where it belongs on the map.
using PlacedPoint = std::pair<QPointF, Point2>;

/// How a picture lies for which two points are known (moved, turned, scaled alike) or three (any parallel
/// one). Empty where the points are too near each other, or three lie on one line.
std::optional<QTransform> placedBy(const std::vector<PlacedPoint>& points);
/// As large as fits, in the middle of a box of the map, north up.
QTransform placedIn(const Box2& box, QSize picture);

} // namespace farol::ui
