// The workstation.

#include "ui/main_window/main_window.h"

#include <QApplication>

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    farol::ui::MainWindow window;
    window.show();
    return QApplication::exec();
}
