#include "ui/parts/frame_view.h"

#include "ui/convert/convert.h"
#include "ui/convert/kind_style.h"
#include "ui/models/words.h"

#include <QEvent>
#include <QPainter>

#include <cmath>

namespace farol::ui {

namespace {

const QColor kBackdrop(0x15181c);
const QColor kTagBack(0, 0, 0, 200);

QString findingText(const recognition::Detection& detection) {
    const QString name = Words::detectionName(detection);
    const QString kind = Phrasebook::kindWord(detection.kind);
    return name.isEmpty() ? kind : QStringLiteral("%1 %2").arg(kind, name);
}

} // namespace

FrameView::FrameView(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setFocusPolicy(Qt::StrongFocus); // so that a screen reader can visit it
    describe();
}

void FrameView::setFrame(const QImage& image) {
    m_image = image;
    describe();
    update();
}

void FrameView::setFindings(std::vector<recognition::Detection> detections,
                            std::vector<recognition::Rejection> rejections) {
    m_detections = std::move(detections);
    m_rejections = std::move(rejections);
    describe();
    update();
}

void FrameView::setShowGrid(bool show) {
    m_showGrid = show;
    update();
}

void FrameView::setShowRejected(bool show) {
    m_showRejected = show;
    update();
}

void FrameView::setSpokenZone(const std::optional<Zone>& zone) {
    if (zone == m_spoken) return;
    m_spoken = zone;
    update();
}

QRectF FrameView::pictureRect() const {
    if (m_image.isNull()) return {};
    const QSizeF size = QSizeF(m_image.size()).scaled(QSizeF(this->size()), Qt::KeepAspectRatio);
    return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

void FrameView::describe() {
    QStringList parts;
    for (const recognition::Detection& detection : m_detections)
        parts << QStringLiteral("%1, %2").arg(findingText(detection),
                                              Phrasebook::zoneWords(detection.zone()));
    const QString text = m_image.isNull()  ? tr("No picture yet")
                         : parts.isEmpty() ? tr("Nothing known is in the picture")
                                           : tr("In the picture: %1").arg(parts.join(QStringLiteral("; ")));
    if (text != accessibleDescription()) setAccessibleDescription(text);
}

QPolygonF FrameView::onScreen(const Quad& quad, const QRectF& area) const {
    QTransform transform;
    transform.translate(area.left(), area.top());
    transform.scale(area.width() / m_image.width(), area.height() / m_image.height());
    return transform.map(toPolygon(quad));
}

void FrameView::paintGrid(QPainter& painter, const QRectF& area) const {
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const QColor& colour : {QColor(0, 0, 0, 110), QColor(255, 255, 255, 120)}) {
        painter.setPen(QPen(colour, 1, Qt::DashLine));
        const double shift =
            colour.red() ? 0.0 : 1.0; // a dark line beside the light one: seen on any picture
        for (const int third : {1, 2}) {
            const double x = area.left() + area.width() * third / 3 + shift;
            const double y = area.top() + area.height() * third / 3 + shift;
            painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
            painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        }
    }
    painter.setRenderHint(QPainter::Antialiasing, true);
}

void FrameView::paintZone(QPainter& painter, const QRectF& area) const {
    const double width = area.width() / 3;
    const double height = area.height() / 3;
    const QRectF zone(area.left() + width * static_cast<int>(m_spoken->column),
                      area.top() + height * static_cast<int>(m_spoken->row), width, height);
    painter.setBrush(QColor(255, 200, 40, 46));
    painter.setPen(QPen(QColor(255, 200, 40), 2.5));
    painter.drawRect(zone.adjusted(1.5, 1.5, -1.5, -1.5));
    painter.setBrush(Qt::NoBrush);
    paintTag(painter, area, zone.bottomLeft() + QPointF(4, -4),
             tr("Spoken: %1").arg(Phrasebook::zoneWords(*m_spoken)), QColor(255, 200, 40));
}

void FrameView::paintTag(QPainter& painter, const QRectF& area, QPointF corner, const QString& text,
                         const QColor& edge) const {
    const QFontMetricsF metrics(painter.font());
    const QString shown = metrics.elidedText(text, Qt::ElideRight, area.width() - 16);
    QRectF box(0, 0, metrics.horizontalAdvance(shown) + 16, metrics.height() + 4);
    box.moveBottomLeft(corner);
    box.moveLeft(std::clamp(box.left(), area.left(), std::max(area.left(), area.right() - box.width())));
    box.moveTop(std::clamp(box.top(), area.top(), std::max(area.top(), area.bottom() - box.height())));
    painter.setPen(Qt::NoPen);
    painter.setBrush(kTagBack);
    painter.drawRoundedRect(box, 3, 3);
    painter.setBrush(edge);
    painter.drawRect(QRectF(box.left(), box.top(), 4, box.height()));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(Qt::white);
    painter.drawText(box.adjusted(10, 0, -4, 0), Qt::AlignVCenter | Qt::AlignLeft, shown);
}

void FrameView::paintDetection(QPainter& painter, const QRectF& area,
                               const recognition::Detection& detection) const {
    const QPolygonF polygon = onScreen(detection.quad, area);
    const QColor colour = kindColour(detection.kind, true);
    painter.setPen(QPen(QColor(0, 0, 0, 170), 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(polygon);
    painter.setPen(QPen(colour, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(polygon);
    const QRectF bounds = polygon.boundingRect();
    paintTag(painter, area, bounds.topLeft() - QPointF(0, 2),
             tr("%1 · %2 %").arg(findingText(detection)).arg(std::lround(detection.score * 100.0)), colour);
}

void FrameView::paintRejection(QPainter& painter, const QRectF& area,
                               const recognition::Rejection& rejection) const {
    const QPolygonF polygon = onScreen(rejection.quad, area);
    const QRectF bounds = polygon.boundingRect();
    if (bounds.width() < 2.0 || bounds.height() < 2.0) return; // no outline was found at all
    painter.setPen(QPen(QColor(0, 0, 0, 150), 2.5, Qt::DashLine));
    painter.drawPolygon(polygon);
    painter.setPen(QPen(QColor(235, 235, 235), 1.2, Qt::DashLine));
    painter.drawPolygon(polygon);
    paintTag(painter, area, bounds.bottomLeft(),
             tr("%1: %2").arg(Phrasebook::kindWord(rejection.kind), Words::rejection(rejection)),
             QColor(150, 150, 150));
}

void FrameView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), kBackdrop);
    if (m_image.isNull()) {
        painter.setPen(QColor(0xd5dae1));
        painter.drawText(
            rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
            tr("No picture yet.\nOpen a camera, a video or a folder of pictures, then press Play."));
    } else {
        const QRectF area = pictureRect();
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(area, m_image);
        painter.setRenderHint(QPainter::Antialiasing);
        if (m_showGrid) paintGrid(painter, area);
        if (m_spoken) paintZone(painter, area);
        if (m_showRejected)
            for (const recognition::Rejection& rejection : m_rejections)
                paintRejection(painter, area, rejection);
        for (const recognition::Detection& detection : m_detections) paintDetection(painter, area, detection);
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void FrameView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        describe();
        update();
    }
    QWidget::changeEvent(event);
}

} // namespace farol::ui
