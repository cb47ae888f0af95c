#pragma once
// Ctrl-C and SIGTERM ask the walk to end; a second one ends the program at once.

#include <csignal>
#include <functional>
#include <thread>

namespace farol::cli {

/// While it lives, the first signal calls `onInterrupt` on a thread of its own. One at a time in the program.
class Interrupt {
public:
    explicit Interrupt(std::function<void()> onInterrupt);
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

private:
    std::function<void()> m_onInterrupt;
    int m_read = -1, m_write = -1;
    struct sigaction m_oldInterrupt {
    }, m_oldTerminate{};
    std::jthread m_watcher;
};

} // namespace farol::cli
