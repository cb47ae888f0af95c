#include "ui/parts/readable_style.h"

#include "ui/convert/kind_style.h"

#include <QPainter>
#include <QStyleOption>

namespace farol::ui {

ReadableStyle::ReadableStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void ReadableStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                  const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool box = element == PE_IndicatorCheckBox;
    if ((!box && element != PE_IndicatorRadioButton) || !isDark(option->palette)) return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(option->palette.color(QPalette::PlaceholderText), 1.2));
    painter->setBrush(Qt::NoBrush);
    const QRectF frame = QRectF(option->rect).adjusted(1, 1, -1, -1);
    if (box)
        painter->drawRoundedRect(frame, 2, 2);
    else
        painter->drawEllipse(frame);
    painter->restore();
}

void ReadableStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                                const QWidget* widget) const {
    QProxyStyle::drawControl(element, option, painter, widget);
    if (element != CE_TabBarTabShape || !(option->state & State_Selected)) return;
    const QRect line(option->rect.left() + 2, option->rect.top(), option->rect.width() - 4, 3);
    painter->fillRect(line, option->palette.color(QPalette::Highlight));
}

} // namespace farol::ui
