#pragma once
// How long does the window's thread not answer? Another thread asks it every few milliseconds.

#include <QObject>

#include <atomic>
#include <thread>
#include <vector>

namespace farol::bench {

struct Beat {
    double wallMs = 0.0;  ///< from the question to its answer
    double aloneMs = 0.0; ///< the same without the time in which other programs had the processor
    double cpuMs = 0.0;   ///< processor time of the thread meanwhile
};

/// Lives in the thread that is asked. The kernel tells how long that thread was ready but had to wait for a
/// processor (schedstat), so that a busy machine is told apart from a busy window.
class Heartbeat : public QObject {
public:
    Heartbeat();
    ~Heartbeat() override;

    void reset() { m_beats.clear(); }
    const std::vector<Beat>& beats() const { return m_beats; }

protected:
    bool event(QEvent* event) override;

private:
    void ask();

    std::vector<Beat> m_beats;
    long m_thread; ///< of the kernel
    std::atomic<bool> m_waiting = false, m_stop = false;
    std::atomic<double> m_askedAt = 0.0, m_queuedThen = 0.0, m_cpuThen = 0.0;
    std::thread m_asker; ///< last: it uses the rest
};

/// "median 0.1, 99th percentile 5.0, worst 20.0"
void printBeats(const std::vector<Beat>& beats);

} // namespace farol::bench
