#pragma once
// Fusion, where dark windows leave something hard to see: the frame of boxes to tick, and which tab is
// chosen.

#include <QProxyStyle>

namespace farol::ui {

class ReadableStyle : public QProxyStyle {
    Q_OBJECT

public:
    ReadableStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

} // namespace farol::ui
