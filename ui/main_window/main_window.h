#pragma once
// The workstation's window: pages, menus, keys.

#include <QMainWindow>

namespace farol::ui {

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
};

} // namespace farol::ui
