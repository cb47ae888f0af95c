#include "ui/map/view_transform.h"

#include <algorithm>
#include <cmath>

namespace farol::ui {

namespace {

constexpr double kMinScale = 0.2;
constexpr double kMaxScale = 400.0;

double bounded(double scale) {
    return std::isfinite(scale) ? std::clamp(scale, kMinScale, kMaxScale) : 20.0;
}

} // namespace

ViewTransform::ViewTransform(Point2 centre, double pixelsPerMetre, QSizeF size)
    : m_centre(isFinite(centre) ? centre : Point2{}),
      m_scale(bounded(pixelsPerMetre)),
      m_size(std::max(1.0, size.width()), std::max(1.0, size.height())) {}

ViewTransform ViewTransform::fitted(const Box2& box, QSizeF size, double marginPx) {
    const double width = std::max(1.0, size.width() - 2 * marginPx);
    const double height = std::max(1.0, size.height() - 2 * marginPx);
    const double scale = std::min(width / std::max(box.width(), 1.0), height / std::max(box.height(), 1.0));
    return {(box.low + box.high) * 0.5, scale, size};
}

QPointF ViewTransform::screenFromMap(Point2 point) const {
    return {m_size.width() / 2 + (point.x - m_centre.x) * m_scale,
            m_size.height() / 2 - (point.y - m_centre.y) * m_scale};
}

Point2 ViewTransform::mapFromScreen(QPointF point) const {
    return {m_centre.x + (point.x() - m_size.width() / 2) / m_scale,
            m_centre.y - (point.y() - m_size.height() / 2) / m_scale};
}

QTransform ViewTransform::painterTransform() const {
    return {m_scale,
            0.0,
            0.0,
            -m_scale,
            m_size.width() / 2 - m_centre.x * m_scale,
            m_size.height() / 2 + m_centre.y * m_scale};
}

ViewTransform ViewTransform::zoomedAt(QPointF anchor, double factor) const {
    const Point2 under = mapFromScreen(anchor);
    const double scale = bounded(m_scale * factor);
    const Point2 centre{under.x - (anchor.x() - m_size.width() / 2) / scale,
                        under.y + (anchor.y() - m_size.height() / 2) / scale};
    return {centre, scale, m_size};
}

ViewTransform ViewTransform::panned(QPointF deltaPx) const {
    return {{m_centre.x - deltaPx.x() / m_scale, m_centre.y + deltaPx.y() / m_scale}, m_scale, m_size};
}

ViewTransform ViewTransform::centredOn(Point2 point) const {
    return {point, m_scale, m_size};
}

ViewTransform ViewTransform::resized(QSizeF size) const {
    return {m_centre, m_scale, size};
}

} // namespace farol::ui
