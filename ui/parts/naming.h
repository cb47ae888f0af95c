#pragma once
// Names and tips as every command and button has them: for the eye, for the status bar, for a screen reader.

#include <QAbstractButton>
#include <QAction>
#include <QKeySequence>

namespace farol::ui {

/// `brief`: on a tool bar. The tip tells the key, too.
inline void nameAction(QAction* action, const QString& text, const QString& brief, const QString& tip) {
    action->setText(text);
    action->setIconText(brief);
    const QString shortcut = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(shortcut.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, shortcut));
    action->setStatusTip(tip);
}

inline void nameButton(QAbstractButton* button, const QString& text, const QString& accessible,
                       const QString& tip) {
    button->setText(text);
    button->setAccessibleName(accessible);
    button->setToolTip(tip);
}

} // namespace farol::ui
