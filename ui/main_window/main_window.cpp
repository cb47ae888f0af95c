#include "ui/main_window/main_window.h"

namespace farol::ui {

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {}

} // namespace farol::ui
