#pragma once
// Dark colours for desktops that have none of their own, and for pictures of the window.

#include <QPalette>

namespace farol {

QPalette darkPalette();

} // namespace farol
