#include "app/farol/screenshot.h"

#include <QApplication>
#include <QPixmap>

#include <cstdio>

namespace farol {

namespace {

constexpr int kPatienceMs = 180000; // a walk that shows nothing must not keep a script waiting for ever
constexpr int kSettleMs = 200;      // layouts and bars come to rest

} // namespace

Screenshot::Screenshot(ui::MainWindow& window, QString file, int after)
    : QObject(&window), m_window(window), m_file(std::move(file)) {
    connect(&window.page(), &ui::LivePage::frameShown, this, [this, after](int count) {
        if (count >= after) take(0);
    });
    connect(&window.walk(), &ui::Walk::stateChanged, this, [this](session::RunState state) {
        if (state == session::RunState::Ended) take(0);
        if (state == session::RunState::Failed) take(1);
    });
    connect(&window.walk(), &ui::Walk::problem, this, [this] { take(1); });
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this, [this] { take(1); });
    m_patience.start(kPatienceMs);
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
