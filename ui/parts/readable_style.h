#pragma once
// Fusion, where it leaves something hard to see: in dark windows the frames of fields, lists and boxes to
// tick, and which tab is chosen; in all of them the words of a chosen row that has the keyboard.

#include <QProxyStyle>

namespace farol::ui {

class ReadableStyle : public QProxyStyle {
    Q_OBJECT

public:
    ReadableStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;

private:
    static void drawFrame(const QRect& rect, PrimitiveElement element, QPainter* painter);
    static void drawRowFocus(const QStyleOption* option, QPainter* painter);
};

} // namespace farol::ui
