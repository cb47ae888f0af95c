#include "app/farol/screenshot.h"

#include "ui/curation/map_actions.h"
#include "ui/curation/plan_panel.h"

#include <QAction>
#include <QApplication>
#include <QPixmap>
#include <QTabWidget>

#include <cstdio>

namespace farol {

namespace {

constexpr int kPatienceMs = 180000; // a walk that shows nothing must not keep a script waiting for ever
constexpr int kSettleMs = 200;      // layouts and bars come to rest

} // namespace

Screenshot::Screenshot(ui::MainWindow& window, const Options& options)
    : QObject(&window), m_options(options), m_window(window), m_file(options.screenshot) {
    if (options.begin.edit.isEmpty())
        watchWalk();
    else
        watchMap();
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this, [this] { take(1); });
    m_patience.start(kPatienceMs);
}

void Screenshot::watchWalk() {
    connect(&m_window.page(), &ui::LivePage::frameShown, this, [this](int count) {
        if (count >= m_options.after) take(0);
    });
    connect(&m_window.walk(), &ui::Walk::stateChanged, this, [this](session::RunState state) {
        if (state == session::RunState::Ended) take(0);
        if (state == session::RunState::Failed) take(1);
    });
    connect(&m_window.walk(), &ui::Walk::problem, this, [this] { take(1); });
}

void Screenshot::watchMap() {
    ui::MapPage& page = m_window.mapPage();
    connect(&page.document(), &ui::MapDocument::opened, this, [this, &page] {
        if (m_options.level) page.plan().view().setLevel(*m_options.level);
        const QStringList panels{QStringLiteral("table"), QStringLiteral("check"), QStringLiteral("route")};
        if (panels.contains(m_options.panel))
            page.tabs().setCurrentIndex(static_cast<int>(panels.indexOf(m_options.panel)));
        if (m_options.alike) page.actions().ambiguity->setChecked(true);
        connect(&m_watch, &QTimer::timeout, this, [this, &page] {
            if (page.settled() && page.plan().view().settled()) take(0);
        });
        m_watch.start(kSettleMs);
    });
    connect(&page.document(), &ui::MapDocument::failed, this, [this] { take(1); });
}

void Screenshot::take(int exitCode) {
    if (m_taken) return;
    m_taken = true;
    QTimer::singleShot(kSettleMs, this, [this, exitCode] {
        const bool saved = m_window.grab().save(m_file);
        if (!saved) std::fprintf(stderr, "farol: %s cannot be written\n", qPrintable(m_file));
        if (exitCode != 0)
            std::fprintf(stderr, "farol: the walk did not come so far; see %s\n", qPrintable(m_file));
        QApplication::exit(saved ? exitCode : 1);
    });
}

} // namespace farol
