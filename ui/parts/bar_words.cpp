#include "ui/parts/bar_words.h"

#include <QAction>
#include <QEvent>
#include <QToolBar>
#include <QToolButton>

#include <utility>
#include <vector>

namespace farol::ui {

BarWords::BarWords(QToolBar& bar, QList<QList<QAction*>> groups)
    : QObject(&bar), m_bar(bar), m_groups(std::move(groups)), m_measure(new QToolButton) {
    m_measure->setAutoRaise(true);
    m_measure->setParent(&bar);
    m_measure->hide();
    m_bar.installEventFilter(this);
}

bool BarWords::eventFilter(QObject* watched, QEvent* event) {
    // Of its own changes it hears as well, as a request for layout: then everything fits, and nothing
    // changes.
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest) fit();
    return QObject::eventFilter(watched, event);
}

void BarWords::fit() {
    std::vector<std::pair<QList<QToolButton*>, int>> groups; // and the width of their words
    int wanted = m_bar.sizeHint().width();
    for (const QList<QAction*>& actions : std::as_const(m_groups)) {
        QList<QToolButton*> buttons;
        int words = 0;
        for (QAction* action : actions) {
            auto* button = qobject_cast<QToolButton*>(m_bar.widgetForAction(action));
            if (button == nullptr) continue;
            buttons << button;
            const int width = sizeOf(*button, Qt::ToolButtonTextBesideIcon).width() -
                              sizeOf(*button, Qt::ToolButtonIconOnly).width();
            words += width;
            if (button->toolButtonStyle() == Qt::ToolButtonIconOnly) wanted += width;
        }
        groups.emplace_back(std::move(buttons), words);
    }
    for (const auto& [buttons, words] : groups) {
        const bool room = wanted <= m_bar.width();
        if (!room) wanted -= words;
        const Qt::ToolButtonStyle style = room ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly;
        for (QToolButton* button : buttons)
            if (button->toolButtonStyle() != style) button->setToolButtonStyle(style);
    }
}

QSize BarWords::sizeOf(const QToolButton& button, Qt::ToolButtonStyle style) const {
    m_measure->setFont(button.font());
    m_measure->setIconSize(button.iconSize());
    m_measure->setIcon(button.icon());
    m_measure->setText(button.text());
    m_measure->setToolButtonStyle(style);
    return m_measure->sizeHint();
}

} // namespace farol::ui
