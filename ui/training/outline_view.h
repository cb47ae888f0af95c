#pragma once
// A picture with the outline of the landmark: four corners to be dragged, or moved by keys, and the points
// that recognition goes by.

#include "core/base/geometry.h"

#include <QImage>
#include <QWidget>

#include <optional>
#include <vector>

namespace farol::ui {

class OutlineView : public QWidget {
    Q_OBJECT

public:
    explicit OutlineView(QWidget* parent = nullptr);

    void setPicture(const QImage& image); ///< the outline stays, inside the picture
    void setOutline(const std::optional<Quad>& outline);
    void setKeypoints(std::vector<ImagePoint> keypoints);
    void setEditable(bool editable);   ///< false: the whole picture counts
    void setHint(const QString& text); ///< where there is no picture
    const std::optional<Quad>& outline() const { return m_outline; }
    int corner() const { return m_corner; }
    /// Of the widget, for a point of the picture.
    QPointF toWidget(ImagePoint point) const;

    QSize sizeHint() const override { return {640, 480}; }
    QSize minimumSizeHint() const override { return {280, 210}; }

Q_SIGNALS:
    void outlineChanged(); ///< by the user

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QRectF area() const;
    ImagePoint toPicture(QPointF at) const;
    void moveCorner(ImagePoint to);
    void choose(int corner);
    void describe();
    void paintOutline(QPainter& painter, const QRectF& area) const;

    QImage m_image;
    std::optional<Quad> m_outline;
    std::vector<ImagePoint> m_keypoints;
    QString m_hint;
    bool m_editable = true;
    int m_corner = 0;
    bool m_dragging = false;
    QPointF m_grip; ///< from the corner to where it was taken hold of
};

} // namespace farol::ui
