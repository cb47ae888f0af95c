#include "core/session/lookout.h"

#include <condition_variable>
#include <mutex>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace farol::session {

namespace {

class OnTheSpot final : public Lookout {
public:
    bool free() const override { return !m_sight; }
    void begin(Look look) override { m_sight = look(); }
    std::optional<Sight> finished() override { return std::exchange(m_sight, std::nullopt); }
    void wait() override {}

private:
    std::optional<Sight> m_sight;
};

/// Linux keeps a nice value for each thread. Where it cannot be set the thread is as urgent as the others.
void giveWay() {
    constexpr int kNice = 5;
    (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
}

class OnAThread final : public Lookout {
public:
    OnAThread() : m_thread([this] { run(); }) {}
    ~OnAThread() override {
        {
            std::scoped_lock lock(m_mutex);
            m_stopped = true;
        }
        m_changed.notify_all();
    }

    bool free() const override {
        std::scoped_lock lock(m_mutex);
        return !m_look && !m_busy && !m_sight;
    }

    void begin(Look look) override {
        {
            std::scoped_lock lock(m_mutex);
            m_look = std::move(look);
        }
        m_changed.notify_all();
    }

    std::optional<Sight> finished() override {
        std::scoped_lock lock(m_mutex);
        return std::exchange(m_sight, std::nullopt);
    }

    void wait() override {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return m_sight || (!m_look && !m_busy); });
    }

private:
    void run() {
        giveWay();
        std::unique_lock lock(m_mutex);
        for (;;) {
            m_changed.wait(lock, [&] { return m_stopped || m_look; });
            if (m_stopped) return;
            Look look = *std::exchange(m_look, std::nullopt);
            m_busy = true;
            lock.unlock();
            Sight sight = look();
            look = {};
            lock.lock();
            m_busy = false;
            m_sight = std::move(sight);
            m_changed.notify_all();
        }
    }

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<Look> m_look;
    std::optional<Sight> m_sight;
    bool m_busy = false, m_stopped = false;
    std::jthread m_thread; ///< last: it uses all of the above
};

} // namespace

std::unique_ptr<Lookout> lookOnTheSpot() {
    return std::make_unique<OnTheSpot>();
}

std::unique_ptr<Lookout> lookOnAThread() {
    return std::make_unique<OnAThread>();
}

} // namespace farol::session
