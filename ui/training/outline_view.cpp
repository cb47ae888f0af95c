#include "ui/training/outline_view.h"

#include "ui/convert/convert.h"

#include <QAccessible>
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace farol::ui {

namespace {

constexpr double kReach = 22.0; // pixels around a corner in which it can be taken hold of
constexpr double kHandle = 7.0;
const QColor kBackdrop(0x15181c);
const QColor kLine(0x40c8ff);
const QColor kChosen(0xffd33d);

} // namespace

OutlineView::OutlineView(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    describe();
}

void OutlineView::setPicture(const QImage& image) {
    m_image = image;
    if (m_outline && !image.isNull())
        for (ImagePoint& p : *m_outline) {
            p.x = std::clamp(p.x, 0.0, static_cast<double>(image.width()));
            p.y = std::clamp(p.y, 0.0, static_cast<double>(image.height()));
        }
    describe();
    update();
}

void OutlineView::setOutline(const std::optional<Quad>& outline) {
    m_outline = outline;
    describe();
    update();
}

void OutlineView::setKeypoints(std::vector<ImagePoint> keypoints) {
    m_keypoints = std::move(keypoints);
    update();
}

void OutlineView::setEditable(bool editable) {
    m_editable = editable;
    describe();
    update();
}

void OutlineView::setHint(const QString& text) {
    m_hint = text;
    update();
}

QRectF OutlineView::area() const {
    if (m_image.isNull()) return {};
    const QSizeF size = QSizeF(m_image.size()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
    return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

QPointF OutlineView::toWidget(ImagePoint point) const {
    const QRectF area = this->area();
    if (area.isEmpty()) return {};
    return area.topLeft() +
           QPointF(point.x * area.width() / m_image.width(), point.y * area.height() / m_image.height());
}

ImagePoint OutlineView::toPicture(QPointF at) const {
    const QRectF area = this->area();
    const QPointF inside = at - area.topLeft();
    return {inside.x() * m_image.width() / area.width(), inside.y() * m_image.height() / area.height()};
}

void OutlineView::moveCorner(ImagePoint to) {
    to.x = std::clamp(to.x, 0.0, static_cast<double>(m_image.width()));
    to.y = std::clamp(to.y, 0.0, static_cast<double>(m_image.height()));
    (*m_outline)[static_cast<std::size_t>(m_corner)] = to;
    describe();
    update();
    Q_EMIT outlineChanged();
}

void OutlineView::choose(int corner) {
    m_corner = corner;
    describe();
    update();
}

void OutlineView::describe() {
    QString text;
    if (m_image.isNull()) {
        text = tr("No picture yet");
    } else if (!m_editable || !m_outline) {
        text = tr("The whole picture counts");
    } else {
        const QStringList names{tr("top left"), tr("top right"), tr("bottom right"), tr("bottom left")};
        const ImagePoint at = (*m_outline)[static_cast<std::size_t>(m_corner)];
        text = tr("Corner %1, %2, is %3 to the right and %4 down")
                   .arg(m_corner + 1)
                   .arg(names.at(m_corner))
                   .arg(std::lround(at.x))
                   .arg(std::lround(at.y));
    }
    if (text == accessibleDescription()) return;
    setAccessibleDescription(text);
    if (hasFocus()) {
        QAccessibleEvent event(this, QAccessible::DescriptionChanged);
        QAccessible::updateAccessibility(&event);
    }
}

void OutlineView::paintOutline(QPainter& painter, const QRectF& area) const {
    QPolygonF polygon;
    for (const ImagePoint& p : *m_outline) polygon << toWidget(p);
    QPainterPath outside;
    outside.addRect(area);
    QPainterPath inside;
    inside.addPolygon(polygon);
    inside.closeSubpath();
    painter.fillPath(outside.subtracted(inside), QColor(0, 0, 0, 110));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 180), 4));
    painter.drawPolygon(polygon);
    painter.setPen(QPen(kLine, 2));
    painter.drawPolygon(polygon);
    for (int i = 0; i < 4; ++i) {
        const bool chosen = i == m_corner;
        painter.setPen(QPen(Qt::black, 1.5));
        painter.setBrush(chosen ? kChosen : kLine);
        const double size = chosen && hasFocus() ? kHandle + 3 : kHandle;
        painter.drawEllipse(polygon[i], size, size);
        // Away from the middle, so that the number does not cover what the corner is set on.
        const QPointF middle = polygon.boundingRect().center();
        QPointF away = polygon[i] - middle;
        const double length = std::max(1.0, std::hypot(away.x(), away.y()));
        QRectF tag(0, 0, 18, 18);
        tag.moveCenter(polygon[i] + away * (20.0 / length));
        tag.moveLeft(std::clamp(tag.left(), 0.0, width() - tag.width()));
        tag.moveTop(std::clamp(tag.top(), 0.0, height() - tag.height()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(0, 0, 0, 190));
        painter.drawRoundedRect(tag, 3, 3);
        painter.setPen(Qt::white);
        painter.drawText(tag, Qt::AlignCenter, QString::number(i + 1));
    }
}

void OutlineView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), kBackdrop);
    if (m_image.isNull()) {
        painter.setPen(QColor(0xd5dae1));
        painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, m_hint);
    } else {
        const QRectF where = area();
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(where, m_image);
        painter.setRenderHint(QPainter::Antialiasing);
        if (m_editable && m_outline) paintOutline(painter, where);
        painter.setPen(QPen(QColor(0, 0, 0, 160), 1));
        painter.setBrush(QColor(120, 255, 120));
        for (const ImagePoint& point : m_keypoints) painter.drawEllipse(toWidget(point), 2.2, 2.2);
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void OutlineView::mousePressEvent(QMouseEvent* event) {
    if (!m_editable || !m_outline || m_image.isNull() || event->button() != Qt::LeftButton)
        return QWidget::mousePressEvent(event);
    double nearest = kReach;
    int found = -1;
    for (int i = 0; i < 4; ++i) {
        const QPointF apart = event->position() - toWidget((*m_outline)[static_cast<std::size_t>(i)]);
        if (const double far = std::hypot(apart.x(), apart.y()); far <= nearest) {
            nearest = far;
            found = i;
            m_grip = apart;
        }
    }
    if (found < 0) return;
    m_dragging = true;
    choose(found);
}

void OutlineView::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging) moveCorner(toPicture(event->position() - m_grip));
}

void OutlineView::mouseReleaseEvent(QMouseEvent* /*event*/) {
    m_dragging = false;
}

void OutlineView::keyPressEvent(QKeyEvent* event) {
    if (!m_editable || !m_outline || m_image.isNull()) return QWidget::keyPressEvent(event);
    if (event->key() >= Qt::Key_1 && event->key() <= Qt::Key_4) return choose(event->key() - Qt::Key_1);
    const double by = event->modifiers() & Qt::ShiftModifier ? 1.0 : 8.0;
    ImagePoint at = (*m_outline)[static_cast<std::size_t>(m_corner)];
    switch (event->key()) {
    case Qt::Key_Left:
        at.x -= by;
        break;
    case Qt::Key_Right:
        at.x += by;
        break;
    case Qt::Key_Up:
        at.y -= by;
        break;
    case Qt::Key_Down:
        at.y += by;
        break;
    default:
        return QWidget::keyPressEvent(event);
    }
    moveCorner(at);
}

void OutlineView::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    update();
}

void OutlineView::focusOutEvent(QFocusEvent* event) {
    m_dragging = false;
    QWidget::focusOutEvent(event);
    update();
}

void OutlineView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) describe();
    QWidget::changeEvent(event);
}

} // namespace farol::ui
