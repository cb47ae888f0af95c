#pragma once
// Takes a picture of the window after so many frames, or when nothing more comes, and ends the program.

#include "ui/main_window/main_window.h"

#include <QObject>
#include <QTimer>

namespace farol {

class Screenshot : public QObject {
    Q_OBJECT

public:
    Screenshot(ui::MainWindow& window, QString file, int after);

private:
    void take(int exitCode);

    ui::MainWindow& m_window;
    QString m_file;
    QTimer m_patience;
    bool m_taken = false;
};

} // namespace farol
