#pragma once
// Light and dark colours, for desktops that have none of their own and for users who choose.

#include <QPalette>

namespace farol::ui {

QPalette darkPalette();
QPalette lightPalette();

} // namespace farol::ui
