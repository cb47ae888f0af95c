#include "ui/main_window/localiser_menu.h"

#include "ui/live/walk.h"
#include "ui/settings/settings.h"

#include <QAction>
#include <QActionGroup>

namespace farol::ui {

LocaliserMenu::LocaliserMenu(Walk& walk, Settings& settings, QWidget* parent)
    : QMenu(parent), m_walk(walk), m_choices(new QActionGroup(this)) {
    for (const QString& name : Settings::localisers()) {
        QAction* action = addAction(QString());
        action->setCheckable(true);
        action->setData(name);
        m_choices->addAction(action);
    }
    connect(m_choices, &QActionGroup::triggered, this, [this, &settings](const QAction* action) {
        settings.setLocaliser(action->data().toString());
        m_walk.setLocaliser(action->data().toString());
    });
    choose(settings.localiser());
    retranslate();
}

void LocaliserMenu::choose(const QString& name) {
    for (QAction* action : m_choices->actions()) {
        if (action->data().toString() != name) continue;
        action->setChecked(true);
        m_walk.setLocaliser(name);
    }
}

void LocaliserMenu::retranslate() {
    setTitle(tr("&How the place is worked out"));
    const QList<QString> texts{tr("Filter, for people who are &guided"),
                               tr("Filter, for people who &know their way"), tr("&Voting"),
                               tr("Voting as first &printed")};
    const QList<QAction*> choices = m_choices->actions();
    for (qsizetype i = 0; i < choices.size(); ++i) {
        choices[i]->setText(texts[i]);
        choices[i]->setToolTip(tr("From the next start of a walk"));
        choices[i]->setStatusTip(choices[i]->toolTip());
    }
}

} // namespace farol::ui
