#pragma once
// Map space (metres, x east, y north) and screen space (pixels of the widget, x right, y down).

#include "core/base/geometry.h"

#include <QPointF>
#include <QSizeF>
#include <QTransform>

namespace farol::ui {

/// A value: every change answers a new one. The scale stays between 0.2 and 400 pixels a metre.
class ViewTransform {
public:
    ViewTransform() = default;
    ViewTransform(Point2 centre, double pixelsPerMetre, QSizeF size);

    /// The whole box with a margin in pixels. An empty or broken box gives a plain view around its corner.
    static ViewTransform fitted(const Box2& box, QSizeF size, double marginPx);

    QPointF screenFromMap(Point2 point) const;
    Point2 mapFromScreen(QPointF point) const;
    double pixelsPerMetre() const { return m_scale; }
    Point2 centre() const { return m_centre; }
    QSizeF size() const { return m_size; }
    /// For painters that draw in metres.
    QTransform painterTransform() const;

    /// The map point under `anchor` stays under it.
    ViewTransform zoomedAt(QPointF anchor, double factor) const;
    ViewTransform panned(QPointF deltaPx) const;
    ViewTransform centredOn(Point2 point) const;
    ViewTransform resized(QSizeF size) const;

    friend bool operator==(const ViewTransform&, const ViewTransform&) = default;

private:
    Point2 m_centre;
    double m_scale = 20.0;
    QSizeF m_size{1.0, 1.0};
};

} // namespace farol::ui
