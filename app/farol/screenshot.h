#pragma once
// Takes a picture of the window after so many frames, or when nothing more comes, and ends the program.

#include "app/farol/options.h"
#include "ui/main_window/main_window.h"

#include <QObject>
#include <QTimer>

namespace farol {

class Screenshot : public QObject {
    Q_OBJECT

public:
    Screenshot(ui::MainWindow& window, const Options& options);

private:
    void watchWalk();
    void watchMap();
    void take(int exitCode);

    const Options m_options;
    ui::MainWindow& m_window;
    QString m_file;
    QTimer m_patience, m_watch;
    bool m_taken = false;
};

} // namespace farol
