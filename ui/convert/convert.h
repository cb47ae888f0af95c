#pragma once
// The only place where core's values become Qt's, and back.

#include "core/base/geometry.h"
#include "core/building/building.h"

#include <QImage>
#include <QPolygonF>
#include <QString>
#include <opencv2/core.hpp>

#include <string>

namespace farol::ui {

inline QString toQString(const std::string& text) {
    return QString::fromStdString(text);
}
inline std::string toUtf8(const QString& text) {
    return text.toStdString();
}

/// A copy of an 8-bit grey, BGR or BGRA picture; null for anything else, so that nobody keeps the frame
/// alive.
QImage toQImage(const cv::Mat& image);
QPolygonF toPolygon(const Quad& quad);
inline QPointF toPoint(ImagePoint p) {
    return {p.x, p.y};
}

/// "1:02.5": minutes and seconds of the walk's own clock.
QString clockText(double seconds);
/// What people call the level: its ref, else its name, else its number.
QString levelLabel(const building::Building& building, double ordinal);
/// "Room 2.14 (level 2)" is made by the views; this is the part before the brackets: the spoken name, with
/// the number on the door when that is another word.
QString regionLabel(const building::Region& region);
/// The spoken name of a region by id, or the id itself when the map does not know it.
QString regionName(const building::Building* building, const RegionId& id);

} // namespace farol::ui
