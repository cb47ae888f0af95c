#include "app/farol-cli/interrupt.h"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace farol::cli {

namespace {

constexpr char kSignal = 's', kQuit = 'q';
std::atomic<int> g_pipe{-1};

// Only what a signal handler may do: a byte into the pipe; the watcher does the rest.
extern "C" void onSignal(int) {
    int saved = errno;
    int descriptor = g_pipe.load();
    if (descriptor >= 0) {
        ssize_t ignored = ::write(descriptor, &kSignal, 1);
        (void)ignored;
    }
    errno = saved;
}

} // namespace

Interrupt::Interrupt(std::function<void()> onInterrupt) : m_onInterrupt(std::move(onInterrupt)) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return; // Ctrl-C then ends the program the plain way
    m_read = ends[0];
    m_write = ends[1];
    g_pipe = m_write;
    struct sigaction action {};
    action.sa_handler = onSignal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
    ::sigaction(SIGINT, &action, &m_oldInterrupt);
    ::sigaction(SIGTERM, &action, &m_oldTerminate);
    m_watcher = std::jthread([this] {
        char byte = kQuit;
        while (::read(m_read, &byte, 1) < 0 && errno == EINTR) {
        }
        if (byte == kSignal) m_onInterrupt();
    });
}

Interrupt::~Interrupt() {
    if (m_read < 0) return;
    ::sigaction(SIGINT, &m_oldInterrupt, nullptr);
    ::sigaction(SIGTERM, &m_oldTerminate, nullptr);
    ssize_t ignored = ::write(m_write, &kQuit, 1);
    (void)ignored;
    m_watcher.join();
    g_pipe = -1;
    ::close(m_read);
    ::close(m_write);
}

} // namespace farol::cli
