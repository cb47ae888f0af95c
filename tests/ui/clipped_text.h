#pragma once
// Finds what a user could not read to its end.

#include <QStringList>
#include <QWidget>

namespace farol::ui::test {

/// The words of each label, button, tab, title, heading, choice and hint of `top` that need more room than
/// they have, each with its widget. What scrolls, and what users type or files hold, is left aside.
QStringList clippedTexts(const QWidget& top);

} // namespace farol::ui::test
