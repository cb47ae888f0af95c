#pragma once
// The picture the camera sees, with what was found in it.

#include "core/base/zone.h"
#include "core/recognition/detection.h"

#include <QImage>
#include <QWidget>

#include <optional>
#include <vector>

namespace farol::ui {

class FrameView : public QWidget {
    Q_OBJECT

public:
    explicit FrameView(QWidget* parent = nullptr);

    void setFrame(const QImage& image);
    void setFindings(std::vector<recognition::Detection> detections,
                     std::vector<recognition::Rejection> rejections);
    void setShowGrid(bool show);
    void setShowRejected(bool show);
    /// The zone of the object that was spoken last; empty: none.
    void setSpokenZone(const std::optional<Zone>& zone);
    const std::optional<Zone>& spokenZone() const { return m_spoken; }
    /// Where the picture lies in the widget, with bars left, right, above or below.
    QRectF pictureRect() const;

    QSize sizeHint() const override { return {560, 420}; }
    QSize minimumSizeHint() const override { return {240, 180}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void paintGrid(QPainter& painter, const QRectF& area) const;
    void paintZone(QPainter& painter, const QRectF& area) const;
    void paintDetection(QPainter& painter, const QRectF& area, const recognition::Detection& detection) const;
    void paintRejection(QPainter& painter, const QRectF& area, const recognition::Rejection& rejection) const;
    void paintTag(QPainter& painter, const QRectF& area, QPointF corner, const QString& text,
                  const QColor& edge) const;
    QPolygonF onScreen(const Quad& quad, const QRectF& area) const;
    void describe();

    QImage m_image;
    std::vector<recognition::Detection> m_detections;
    std::vector<recognition::Rejection> m_rejections;
    std::optional<Zone> m_spoken;
    bool m_showGrid = true;
    bool m_showRejected = false;
};

} // namespace farol::ui
