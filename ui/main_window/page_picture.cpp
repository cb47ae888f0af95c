#include "ui/main_window/page_picture.h"

#include <QAbstractButton>
#include <QLabel>
#include <QPainter>
#include <QTabBar>
#include <QToolBar>
#include <QWidget>

#include <algorithm>
#include <vector>

namespace farol::ui {

namespace {

constexpr int kBadge = 20;     // pixels of the picture across
constexpr int kRowHeight = 24; // of the page: parts that begin within so much stand beside each other

struct Part {
    QRect place; ///< in the page
    QString name;
};

/// Words, buttons and what holds buttons explain themselves.
bool isPlain(const QWidget& widget) {
    return qobject_cast<const QLabel*>(&widget) != nullptr ||
           qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
           qobject_cast<const QTabBar*>(&widget) != nullptr ||
           qobject_cast<const QToolBar*>(&widget) != nullptr;
}

bool isPart(const QWidget& widget, const QWidget& page) {
    const qint64 area = qint64(widget.width()) * widget.height();
    return !widget.accessibleName().isEmpty() && widget.isVisibleTo(&page) && !isPlain(widget) &&
           100 * area >= qint64(page.width()) * page.height();
}

std::vector<Part> partsOf(const QWidget& page) {
    std::vector<const QWidget*> found;
    for (const QWidget* child : page.findChildren<QWidget*>())
        if (isPart(*child, page)) found.push_back(child);
    std::vector<Part> parts;
    for (const QWidget* one : found) {
        const bool holdsAnother = std::any_of(found.begin(), found.end(), [&](const QWidget* other) {
            return other != one && one->isAncestorOf(other);
        });
        if (!holdsAnother)
            parts.push_back({QRect(one->mapTo(&page, QPoint(0, 0)), one->size()), one->accessibleName()});
    }
    std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
        const int rowA = a.place.top() / kRowHeight, rowB = b.place.top() / kRowHeight;
        return rowA != rowB ? rowA < rowB : a.place.left() < b.place.left();
    });
    return parts;
}

} // namespace

PagePicture pictureOf(QWidget& page, int width) {
    PagePicture made;
    // Who has not been shown yet has not been given its place either.
    if (!page.isVisible() && page.parentWidget() != nullptr) page.resize(page.parentWidget()->size());
    const QPixmap grabbed = page.grab();
    if (grabbed.isNull() || page.width() <= 0) return made;
    const qreal ratio = grabbed.devicePixelRatio();
    made.picture = grabbed.scaledToWidth(qRound(width * ratio), Qt::SmoothTransformation);
    made.picture.setDevicePixelRatio(ratio);
    const qreal scale = qreal(width) / page.width();
    QPainter painter(&made.picture);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = page.font();
    font.setPixelSize(13);
    font.setBold(true);
    painter.setFont(font);
    for (const Part& part : partsOf(page)) {
        made.parts << part.name;
        const QRectF place(QPointF(part.place.topLeft()) * scale, QSizeF(part.place.size()) * scale);
        // Low lines have their words at the left end.
        const bool low = place.height() < 2 * kBadge;
        const QPointF middle =
            low ? QPointF(place.right() - 1.5 * kBadge, place.center().y()) : place.center();
        const QRectF badge(middle - QPointF(kBadge, kBadge) / 2.0, QSizeF(kBadge, kBadge));
        painter.setPen(QPen(Qt::white, 1.5));
        painter.setBrush(QColor(0xb0, 0x00, 0x30));
        painter.drawEllipse(badge);
        painter.drawText(badge, Qt::AlignCenter, QString::number(made.parts.size()));
    }
    return made;
}

} // namespace farol::ui
