#include "ui/parts/readable_style.h"

#include "ui/convert/kind_style.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QStyleOption>

namespace farol::ui {

namespace {

const QColor kDarkFrame(0x6d7683); // three times as bright as what it frames

} // namespace

ReadableStyle::ReadableStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void ReadableStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                  const QWidget* widget) const {
    const bool dark = isDark(option->palette);
    // Fusion lays a veil of the same blue over the words.
    if (element == PE_FrameFocusRect && qobject_cast<const QAbstractItemView*>(widget))
        return drawRowFocus(option, painter);
    if (element == PE_FrameTabBarBase && dark) return; // a white line otherwise; the page has a frame
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (!dark) return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    const QRectF frame = QRectF(option->rect).adjusted(1, 1, -1, -1);
    switch (element) {
    case PE_IndicatorCheckBox:
        painter->setPen(QPen(option->palette.color(QPalette::PlaceholderText), 1.2));
        painter->drawRoundedRect(frame, 2, 2);
        break;
    case PE_IndicatorRadioButton:
        painter->setPen(QPen(option->palette.color(QPalette::PlaceholderText), 1.2));
        painter->drawEllipse(frame);
        break;
    case PE_FrameLineEdit: // with the keyboard it has a blue one
        if (!(option->state & State_HasFocus)) drawFrame(option->rect, element, painter);
        break;
    case PE_Frame:
        drawFrame(option->rect, element, painter);
        break;
    default:
        break;
    }
    painter->restore();
}

void ReadableStyle::drawFrame(const QRect& rect, PrimitiveElement element, QPainter* painter) {
    painter->setPen(QPen(kDarkFrame, 1.0));
    const double round = element == PE_Frame ? 0.0 : 2.0;
    painter->drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), round, round);
}

void ReadableStyle::drawRowFocus(const QStyleOption* option, QPainter* painter) {
    const bool chosen = option->state & State_Selected;
    painter->save();
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(option->palette.color(chosen ? QPalette::HighlightedText : QPalette::Highlight), 1.0,
                         Qt::DotLine));
    painter->drawRect(QRectF(option->rect).adjusted(1.5, 1.5, -1.5, -1.5));
    painter->restore();
}

/// A number's field draws its frame itself.
void ReadableStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                       QPainter* painter, const QWidget* widget) const {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    if (control != CC_SpinBox || !isDark(option->palette) || option->state & State_HasFocus) return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    drawFrame(option->rect, PE_FrameLineEdit, painter);
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
