#include "ui/convert/kind_style.h"

#include <cmath>

namespace farol::ui {

namespace {

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& colour) {
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

struct Pair {
    QRgb onLight;
    QRgb onDark;
};

Pair family(Kind kind) {
    switch (kind) {
    case Kind::Door:
    case Kind::Window:
        return {0x0b57a4, 0x7cc0ff};
    case Kind::Stairs:
    case Kind::Elevator:
        return {0x6a2c91, 0xd6a6ff};
    case Kind::Extinguisher:
    case Kind::Hydrant:
        return {0xa3142b, 0xff9a9a};
    case Kind::ExitSign:
        return {0x0b6b2f, 0x74d991};
    case Kind::Sign:
    case Kind::Text:
        return {0x7a4a00, 0xffc766};
    case Kind::Place:
        return {0x00646b, 0x62dce4};
    default:
        return {0x4a4f57, 0xcfd4dc};
    }
}

} // namespace

QColor kindColour(Kind kind, bool dark) {
    const Pair pair = family(kind);
    return QColor::fromRgb(dark ? pair.onDark : pair.onLight);
}

bool isDark(const QPalette& palette) {
    return luminance(palette.color(QPalette::Window)) < 0.2;
}

double contrast(const QColor& a, const QColor& b) {
    const double first = luminance(a);
    const double second = luminance(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

QColor readableOn(const QColor& background) {
    return contrast(background, Qt::black) >= contrast(background, Qt::white) ? QColor(Qt::black)
                                                                              : QColor(Qt::white);
}

} // namespace farol::ui
