// The workstation.

#include "app/farol/kiosk_program.h"
#include "app/farol/options.h"
#include "app/farol/screenshot.h"
#include "core/base/memory.h"
#include "ui/main_window/main_window.h"

#include <QApplication>
#include <QIcon>
#include <QTemporaryDir>
#include <QTimer>

int main(int argc, char** argv) {
    if (farol::wantsKeeping(argc, argv)) return farol::keepKioskRunning(argc, argv);
    farol::keepHeapSmall();
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("farol"));
    QApplication::setApplicationDisplayName(QStringLiteral("Farol"));
    QApplication::setApplicationVersion(QStringLiteral(FAROL_VERSION));
    QApplication::setDesktopFileName(QStringLiteral("farol"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/farol/icons/farol.svg")));
    QApplication::setStyle(
        QStringLiteral("Fusion")); // the same look, and a palette that dark desktops can set
    const farol::Options options = farol::optionsFrom(QApplication::arguments());

    if (options.kiosk) return farol::runKiosk(options);

    // A picture or a self-test neither follows nor changes what the user has set.
    const QTemporaryDir scratch;
    const bool aside = options.selfTest || !options.screenshot.isEmpty();
    farol::ui::Settings settings(aside ? scratch.filePath(QStringLiteral("settings.ini")) : QString());
    if (!options.language.isEmpty()) settings.setLanguage(options.language.left(2));
    if (options.dark) settings.setLook(farol::ui::Look::Dark);
    farol::ui::MainWindow::applyLanguage(settings);
    farol::ui::MainWindow::applyLook(settings);

    farol::ui::MainWindow window(settings);
    if (options.size) window.resize(*options.size);
    if (!options.screenshot.isEmpty()) new farol::Screenshot(window, options);
    window.show();
    int failures = 0;
    if (options.selfTest) {
        QObject::connect(&window.walk(), &farol::ui::Walk::problem, &window, [&] { ++failures; });
        auto* watch = new QTimer(&window);
        QObject::connect(watch, &QTimer::timeout, &window, [&] {
            if (!window.walk().loading()) window.close();
        });
        watch->start(100);
    }
    if (settings.firstRun() && !aside && options.begin.map.isEmpty() && options.begin.source.isEmpty() &&
        options.begin.edit.isEmpty())
        window.welcome();
    window.begin(options.begin);
    const int code = QApplication::exec();
    return failures > 0 ? 1 : code;
}
