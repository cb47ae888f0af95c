#include "ui/main_window/profile_menu.h"

#include "ui/settings/settings.h"

#include <QAction>
#include <QActionGroup>
#include <QInputDialog>
#include <QMessageBox>

namespace farol::ui {

ProfileMenu::ProfileMenu(Settings& settings, QWidget* parent) : QMenu(parent), m_settings(settings) {
    connect(this, &QMenu::aboutToShow, this, &ProfileMenu::fill);
    connect(&settings, &Settings::profileChanged, this, &ProfileMenu::fill);
    retranslate();
}

void ProfileMenu::fill() {
    clear();
    delete m_group;
    m_group = new QActionGroup(this);
    for (const QString& name : m_settings.profiles()) {
        QString text = name.isEmpty() ? tr("Usual") : name;
        QAction* action = addAction(text.replace(QLatin1Char('&'), QLatin1String("&&")));
        action->setCheckable(true);
        action->setChecked(name == m_settings.profile());
        action->setStatusTip(tr("Use the settings of %1").arg(text));
        m_group->addAction(action);
        // Later: the menu is filled anew by it.
        connect(
            action, &QAction::triggered, &m_settings, [this, name] { m_settings.useProfile(name); },
            Qt::QueuedConnection);
    }
    addSeparator();
    connect(addAction(tr("&New user…")), &QAction::triggered, this, &ProfileMenu::askName);
}

void ProfileMenu::askName() {
    auto* ask = new QInputDialog(parentWidget());
    ask->setAttribute(Qt::WA_DeleteOnClose);
    ask->setWindowTitle(tr("New user"));
    ask->setLabelText(tr("Name; the new user begins with the settings as they are now:"));
    connect(ask, &QInputDialog::textValueSelected, this, [this](const QString& text) {
        const QString name = text.trimmed();
        if (name.isEmpty() || m_settings.useProfile(name)) return;
        auto* box = new QMessageBox(QMessageBox::Warning, tr("New user"),
                                    tr("“%1” cannot be used as a name: it must not hold a slash.").arg(name),
                                    QMessageBox::Ok, parentWidget());
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
    });
    ask->open();
}

void ProfileMenu::retranslate() {
    setTitle(tr("&User"));
    fill();
}

} // namespace farol::ui
