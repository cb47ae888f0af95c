#include "tests/bench/heartbeat.h"

#include <QCoreApplication>
#include <QEvent>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <sys/syscall.h>
#include <unistd.h>
#include <utility>

namespace farol::bench {

namespace {

constexpr std::chrono::milliseconds kEvery{5};
const QEvent::Type kQuestion = static_cast<QEvent::Type>(QEvent::registerEventType());

double nowMs() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Milliseconds that a thread of this process has run, and has waited for a processor.
std::pair<double, double> scheduled(long thread) {
    std::ifstream file("/proc/self/task/" + std::to_string(thread) + "/schedstat");
    double run = 0.0, waited = 0.0;
    file >> run >> waited;
    return {run / 1e6, waited / 1e6};
}

} // namespace

Heartbeat::Heartbeat() : m_thread(syscall(SYS_gettid)), m_asker([this] { ask(); }) {}

Heartbeat::~Heartbeat() {
    m_stop = true;
    m_asker.join();
}

void Heartbeat::ask() {
    while (!m_stop) {
        std::this_thread::sleep_for(kEvery);
        if (m_waiting.exchange(true)) continue; // one question at a time
        const auto [run, queued] = scheduled(m_thread);
        m_cpuThen = run;
        m_queuedThen = queued;
        m_askedAt = nowMs();
        QCoreApplication::postEvent(this, new QEvent(kQuestion));
    }
}

bool Heartbeat::event(QEvent* event) {
    if (event->type() != kQuestion) return QObject::event(event);
    const double wall = nowMs() - m_askedAt;
    const auto [run, queued] = scheduled(m_thread);
    m_beats.push_back({wall, std::max(0.0, wall - (queued - m_queuedThen)), run - m_cpuThen});
    m_waiting = false;
    return true;
}

void printBeats(const std::vector<Beat>& beats) {
    if (beats.empty()) return;
    const auto row = [&](const char* name, double Beat::*part) {
        std::vector<double> all;
        for (const Beat& beat : beats) all.push_back(beat.*part);
        std::sort(all.begin(), all.end());
        const auto at = [&](double share) {
            return all[std::min(all.size() - 1,
                                static_cast<std::size_t>(share * static_cast<double>(all.size())))];
        };
        const auto over = all.end() - std::upper_bound(all.begin(), all.end(), 50.0);
        std::printf("| %s | %.1f | %.1f | %.1f | %.1f | %td |\n", name, at(0.5), at(0.99), at(0.999),
                    all.back(), over);
    };
    std::printf("| %zu questions, ms until answered | median | 99th | 99.9th | worst | over 50 |\n",
                beats.size());
    std::printf("|---|---:|---:|---:|---:|---:|\n");
    row("on the clock", &Beat::wallMs);
    row("without waiting for a processor", &Beat::aloneMs);
    row("processor time of the thread", &Beat::cpuMs);
}

} // namespace farol::bench
