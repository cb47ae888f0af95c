#pragma once
// Colours of kinds and of text over them. Colour never stands alone: a name or a symbol is always beside it.

#include "core/base/kind.h"

#include <QColor>
#include <QPalette>

namespace farol::ui {

/// One of a few families (doors and stairs, signs and texts, safety, furniture, places), told apart also by
/// people who see few colours. `dark`: for a dark background.
QColor kindColour(Kind kind, bool dark);
bool isDark(const QPalette& palette);
/// WCAG 2 contrast ratio of two opaque colours, 1 to 21.
double contrast(const QColor& a, const QColor& b);
/// Black or white, whichever reads better on `background`.
QColor readableOn(const QColor& background);

} // namespace farol::ui
