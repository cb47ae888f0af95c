#include "ui/map/floor_picture.h"

#include <algorithm>
#include <cmath>

namespace farol::ui {

namespace {

constexpr double kNearPx = 5.0;
constexpr double kNearM = 0.2;

std::optional<QTransform> byTwo(const PlacedPoint& a, const PlacedPoint& b) {
    const QPointF pixels = b.first - a.first;
    const Point2 metres = b.second - a.second;
    const double square = pixels.x() * pixels.x() + pixels.y() * pixels.y();
    if (std::sqrt(square) < kNearPx || length(metres) < kNearM) return std::nullopt;
    // The lines of a picture run downwards: (x, -y) is turned and scaled by one complex number c + s i.
    const double c = (metres.x * pixels.x() - metres.y * pixels.y()) / square;
    const double s = (metres.x * pixels.y() + metres.y * pixels.x()) / square;
    const double x = a.second.x - (c * a.first.x() + s * a.first.y());
    const double y = a.second.y - (s * a.first.x() - c * a.first.y());
    return QTransform(c, s, s, -c, x, y);
}

std::optional<QTransform> byThree(const std::vector<PlacedPoint>& points) {
    const QPointF a = points[1].first - points[0].first;
    const QPointF b = points[2].first - points[0].first;
    const Point2 u = points[1].second - points[0].second;
    const Point2 v = points[2].second - points[0].second;
    const double area = a.x() * b.y() - a.y() * b.x();
    const bool flat = std::abs(area) < kNearPx * std::max(std::hypot(a.x(), a.y()), std::hypot(b.x(), b.y()));
    if (flat || std::abs(cross(u, v)) < kNearM * std::max(length(u), length(v))) return std::nullopt;
    const double xx = (u.x * b.y() - v.x * a.y()) / area;
    const double xy = (v.x * a.x() - u.x * b.x()) / area;
    const double yx = (u.y * b.y() - v.y * a.y()) / area;
    const double yy = (v.y * a.x() - u.y * b.x()) / area;
    const QPointF p = points[0].first;
    const Point2 q = points[0].second;
    return QTransform(xx, yx, xy, yy, q.x - xx * p.x() - xy * p.y(), q.y - yx * p.x() - yy * p.y());
}

} // namespace

std::optional<QTransform> placedBy(const std::vector<PlacedPoint>& points) {
    if (points.size() == 2) return byTwo(points[0], points[1]);
    if (points.size() == 3) return byThree(points);
    return std::nullopt;
}

QTransform placedIn(const Box2& box, QSize picture) {
    const double wide = std::max(box.width(), 1.0);
    const double tall = std::max(box.height(), 1.0);
    const double scale = std::min(wide / std::max(picture.width(), 1), tall / std::max(picture.height(), 1));
    const double x = box.low.x + (wide - scale * picture.width()) / 2;
    const double y = box.low.y + (tall + scale * picture.height()) / 2;
    return QTransform(scale, 0.0, 0.0, -scale, x, y);
}

} // namespace farol::ui
