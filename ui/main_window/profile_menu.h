#pragma once
// Whose settings count.

#include <QMenu>

class QActionGroup;

namespace farol::ui {

class Settings;

class ProfileMenu : public QMenu {
    Q_OBJECT

public:
    ProfileMenu(Settings& settings, QWidget* parent);

    void retranslate();

private:
    void fill();
    void askName();

    Settings& m_settings;
    QActionGroup* m_group = nullptr;
};

} // namespace farol::ui
