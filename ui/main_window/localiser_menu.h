#pragma once
// How the next walk works out the place: the filters and the voting, to be compared.

#include <QList>
#include <QMenu>

class QActionGroup;

namespace farol::ui {

class Settings;
class Walk;

class LocaliserMenu : public QMenu {
    Q_OBJECT

public:
    LocaliserMenu(Walk& walk, Settings& settings, QWidget* parent);

    /// For this run of the program only; an unknown name changes nothing.
    void choose(const QString& name);
    void retranslate();

private:
    Walk& m_walk;
    QActionGroup* m_choices;
};

} // namespace farol::ui
