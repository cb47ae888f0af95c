// Settings that change the window at once, help, the page of the first start, and files that are dropped.

#include "ui/convert/palettes.h"
#include "ui/main_window/help_dialog.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/profile_menu.h"
#include "ui/main_window/welcome_dialog.h"
#include "ui/parts/readable_style.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QPointer>
#include <QUrl>

namespace farol::ui {

void MainWindow::applyLook(const Settings& settings) {
    if (!qobject_cast<ReadableStyle*>(QApplication::style())) QApplication::setStyle(new ReadableStyle);
    if (settings.look() == Look::System)
        QApplication::setPalette(QPalette());
    else
        QApplication::setPalette(settings.look() == Look::Dark ? darkPalette() : lightPalette());
}

void MainWindow::connectSettings() {
    const WindowActions& a = *m_actions;
    m_actions->addToFileMenu(*m_profiles);
    connect(&m_settings, &Settings::lookChanged, this, [this] { applyLook(m_settings); });
    connect(a.help, &QAction::triggered, this, &MainWindow::showHelp);
    connect(a.welcome, &QAction::triggered, this, &MainWindow::welcome);
    m_walk.setAdjust([this](session::SessionOptions& options) {
        options.navigator.guidance = m_settings.guidanceOptions(options.navigator.guidance);
        options.navigator.routing = m_settings.routeOptions(options.navigator.routing);
        options.perception.recogniser = m_settings.recogniserOptions(options.perception.recogniser);
    });
    setAcceptDrops(true);
}

void MainWindow::showHelp() {
    auto* help = findChild<HelpDialog*>();
    if (!help) {
        help = new HelpDialog({m_page, m_mapPage, m_trainingPage}, this);
        help->setAttribute(Qt::WA_DeleteOnClose);
    }
    help->showPage(shownPage());
    help->show();
    help->raise();
    help->activateWindow();
}

void MainWindow::welcome() {
    auto* dialog = new WelcomeDialog(m_settings, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &WelcomeDialog::walkWanted, this, [this] { showPage(Page::Walk); });
    connect(dialog, &WelcomeDialog::mapWanted, this, [this] { showPage(Page::Map); });
    connect(dialog, &WelcomeDialog::landmarksWanted, this, [this] { showPage(Page::Landmarks); });
    connect(dialog, &WelcomeDialog::helpWanted, this, &MainWindow::showHelp);
    dialog->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (shownPage() == Page::Walk && event->mimeData()->hasUrls()) event->acceptProposedAction();
}

/// The Map and the Landmarks page take their own files. A GeoPackage can be a map or a library: the user is
/// asked.
void MainWindow::dropEvent(QDropEvent* event) {
    const QString file = event->mimeData()->urls().value(0).toLocalFile();
    if (file.isEmpty()) return;
    event->acceptProposedAction();
    if (!file.endsWith(QLatin1String(".gpkg"), Qt::CaseInsensitive)) {
        const QFileInfo frames(QDir(file).filePath(QStringLiteral("frames")));
        m_walk.setSource({frames.isDir() ? frames.filePath() : file, 0.0});
        return;
    }
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu->addAction(tr("Open as &map")), &QAction::triggered, this,
            [this, file] { m_walk.loadMap(file); });
    connect(menu->addAction(tr("Open as landmark &library")), &QAction::triggered, this,
            [this, file] { m_walk.loadLibrary(file); });
    menu->popup(mapToGlobal(event->position().toPoint()));
}

} // namespace farol::ui
