#pragma once
// Hands the newest value from one thread to another through a single slot: an older value that nobody took is
// dropped and counted, so a slow consumer never works on stale frames and a producer never waits.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>

namespace farol {

/// Thread-safe. Any number of producers and consumers; each value is taken once at most.
template <class T>
class LatestValue {
public:
    /// Puts a value in the slot. An untaken one is dropped and counted. Ignored after close().
    void put(T value) {
        {
            std::scoped_lock lock(m_mutex);
            if (m_closed) return;
            if (m_value) ++m_dropped;
            m_value = std::move(value);
        }
        m_changed.notify_all();
    }

    /// Waits until the slot is free, then puts: for sources that must not lose a frame (files, replay).
    /// False when the mailbox was closed meanwhile.
    bool putWhenFree(T value) {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return m_closed || !m_value; });
        if (m_closed) return false;
        m_value = std::move(value);
        lock.unlock();
        m_changed.notify_all();
        return true;
    }

    /// Waits for a value. Empty once the mailbox is closed and drained.
    std::optional<T> take() {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return m_closed || m_value; });
        return takeLocked(lock);
    }

    /// Empty at once when there is nothing.
    std::optional<T> tryTake() {
        std::unique_lock lock(m_mutex);
        return takeLocked(lock);
    }

    /// No more values come: waiting consumers wake up once the slot is drained.
    void close() {
        {
            std::scoped_lock lock(m_mutex);
            m_closed = true;
        }
        m_changed.notify_all();
    }

    bool closed() const {
        std::scoped_lock lock(m_mutex);
        return m_closed;
    }

    std::uint64_t dropped() const {
        std::scoped_lock lock(m_mutex);
        return m_dropped;
    }

private:
    std::optional<T> takeLocked(std::unique_lock<std::mutex>& lock) {
        std::optional<T> value = std::exchange(m_value, std::nullopt);
        lock.unlock();
        if (value) m_changed.notify_all();
        return value;
    }

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<T> m_value;
    std::uint64_t m_dropped = 0;
    bool m_closed = false;
};

} // namespace farol
