#include "ui/convert/palettes.h"

namespace farol::ui {

namespace {

struct Colours {
    QRgb window, base, alternate, text, grey, hint, button, link, tip;
};

constexpr Colours kDark{0xff24282e, 0xff1b1e23, 0xff24282e, 0xfff2f4f7, 0xff8a94a3,
                        0xff8a94a3, 0xff323943, 0xff7cc0ff, 0xff323943};
constexpr Colours kLight{0xffefefef, 0xffffffff, 0xfff6f7f9, 0xff101216, 0xff8a8f98,
                         0xff6a707a, 0xfff4f4f4, 0xff0b57b5, 0xffffffff};

QPalette paletteOf(const Colours& colours) {
    QPalette palette;
    const std::pair<QPalette::ColorRole, QRgb> roles[]{{QPalette::Window, colours.window},
                                                       {QPalette::WindowText, colours.text},
                                                       {QPalette::Base, colours.base},
                                                       {QPalette::AlternateBase, colours.alternate},
                                                       {QPalette::ToolTipBase, colours.tip},
                                                       {QPalette::ToolTipText, colours.text},
                                                       {QPalette::PlaceholderText, colours.hint},
                                                       {QPalette::Text, colours.text},
                                                       {QPalette::Button, colours.button},
                                                       {QPalette::ButtonText, colours.text},
                                                       {QPalette::BrightText, 0xffffffff},
                                                       {QPalette::Link, colours.link},
                                                       {QPalette::Highlight, 0xff1f6fc4},
                                                       {QPalette::HighlightedText, 0xffffffff}};
    for (const auto& [role, colour] : roles) palette.setColor(role, QColor::fromRgb(colour));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor::fromRgb(colours.grey));
    return palette;
}

} // namespace

QPalette darkPalette() {
    return paletteOf(kDark);
}

QPalette lightPalette() {
    return paletteOf(kLight);
}

} // namespace farol::ui
