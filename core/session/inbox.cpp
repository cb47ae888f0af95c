#include "core/session/inbox.h"

#include <iterator>
#include <utility>

namespace farol::session {

namespace {

void prepend(std::vector<std::string>& messages, std::vector<std::string>& earlier) {
    messages.insert(messages.begin(), std::make_move_iterator(earlier.begin()),
                    std::make_move_iterator(earlier.end()));
    earlier.clear();
}

} // namespace

bool Inbox::waitUntilReady() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [&] { return m_stopped || m_ready; });
    return !m_stopped;
}

void Inbox::setReady() {
    {
        std::scoped_lock lock(m_mutex);
        m_ready = true;
    }
    m_changed.notify_all();
}

void Inbox::putNewestLocked(Parcel parcel, bool count) {
    prepend(parcel.messages, m_carried);
    if (m_slot) {
        prepend(parcel.messages, m_slot->messages);
        if (count) ++m_dropped;
    }
    m_lastCapturedAt = parcel.frame.capturedAt;
    m_slot = std::move(parcel);
}

bool Inbox::putNewest(Parcel parcel) {
    {
        std::scoped_lock lock(m_mutex);
        if (m_stopped) return false;
        // A camera that is looked away from during a pause loses nothing that anybody wanted.
        putNewestLocked(std::move(parcel), !m_paused);
    }
    m_changed.notify_all();
    return true;
}

bool Inbox::putWhenFree(Parcel parcel) {
    {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return m_stopped || !m_slot; });
        if (m_stopped) return false;
        putNewestLocked(std::move(parcel), true);
    }
    m_changed.notify_all();
    return true;
}

bool Inbox::waitForTurnLocked(std::unique_lock<std::mutex>& lock, double capturedAt) {
    while (!m_stopped) {
        auto now = m_clock();
        if (m_paused) {
            m_wasPaused = true;
            if (m_steps > 0 && !m_slot) return true;
            m_changed.wait(lock);
            continue;
        }
        if (std::exchange(m_wasPaused, false) && m_lastCapturedAt) m_pacer.restart(*m_lastCapturedAt, now);
        auto due = m_pacer.due(capturedAt, now);
        if (now >= due) return true;
        m_changed.wait_until(lock, due);
    }
    return false;
}

bool Inbox::putWhenDue(Parcel parcel) {
    {
        std::unique_lock lock(m_mutex);
        double capturedAt = parcel.frame.capturedAt;
        if (!waitForTurnLocked(lock, capturedAt)) return false;
        auto now = m_clock();
        // Its age counts from when it was due, not from when it happened to be read.
        parcel.frame.arrivedAt = m_paused ? now : m_pacer.due(capturedAt, now);
        if (m_paused) {
            m_pacer.restart(capturedAt, now);
        } else if (!m_pacer.accept(capturedAt, now)) {
            ++m_dropped;
            m_lastCapturedAt = capturedAt;
            std::move(parcel.messages.begin(), parcel.messages.end(), std::back_inserter(m_carried));
            return true;
        }
        putNewestLocked(std::move(parcel), true);
    }
    m_changed.notify_all();
    return true;
}

void Inbox::finish(std::vector<std::string> messages, std::string failure) {
    {
        std::scoped_lock lock(m_mutex);
        prepend(messages, m_carried);
        // After the last frame, which may still lie in the slot.
        m_carried = std::move(messages);
        m_failure = std::move(failure);
        m_finished = true;
    }
    m_changed.notify_all();
}

void Inbox::setSkipped(std::uint64_t frames) {
    std::scoped_lock lock(m_mutex);
    m_skipped = frames;
}

void Inbox::post(InboxItem item) {
    {
        std::scoped_lock lock(m_mutex);
        if (m_stopped) return;
        m_items.push_back(std::move(item));
    }
    m_changed.notify_all();
}

void Inbox::pause() {
    {
        std::scoped_lock lock(m_mutex);
        m_paused = true;
        m_steps = 0;
    }
    m_changed.notify_all();
}

void Inbox::resume() {
    {
        std::scoped_lock lock(m_mutex);
        m_paused = false;
        m_steps = 0;
    }
    m_changed.notify_all();
}

void Inbox::stepOnce() {
    {
        std::scoped_lock lock(m_mutex);
        m_paused = true;
        ++m_steps;
    }
    m_changed.notify_all();
}

void Inbox::setSpeed(double factor) {
    {
        std::scoped_lock lock(m_mutex);
        m_pacer.setSpeed(factor);
        // Else a frame that was waited for slowly would seem long overdue at the new speed.
        if (m_lastCapturedAt) m_pacer.restart(*m_lastCapturedAt, m_clock());
    }
    m_changed.notify_all();
}

void Inbox::begin() {
    std::scoped_lock lock(m_mutex);
    m_begun = true;
    m_toldPaused = m_paused;
}

void Inbox::stop() {
    {
        std::scoped_lock lock(m_mutex);
        m_stopped = true;
    }
    m_changed.notify_all();
}

bool Inbox::stopped() const {
    std::scoped_lock lock(m_mutex);
    return m_stopped;
}

RunState Inbox::stateLocked() const {
    if (m_over) return *m_over;
    if (m_stopped) return RunState::Ended;
    if (!m_begun) return RunState::Idle;
    return m_paused ? RunState::Paused : RunState::Running;
}

RunState Inbox::state() const {
    std::scoped_lock lock(m_mutex);
    return stateLocked();
}

void Inbox::waitUntilOver() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [&] { return !m_begun || m_stopped || m_over; });
}

std::uint64_t Inbox::dropped() const {
    std::scoped_lock lock(m_mutex);
    return m_dropped;
}

std::uint64_t Inbox::skipped() const {
    std::scoped_lock lock(m_mutex);
    return m_skipped;
}

void Inbox::setOver(RunState state) {
    {
        std::scoped_lock lock(m_mutex);
        m_over = state;
    }
    m_changed.notify_all();
}

Work Inbox::next() {
    std::unique_lock lock(m_mutex);
    auto stateChanged = [&] { return !m_over && m_paused != m_toldPaused; };
    m_changed.wait(lock, [&] {
        return m_stopped || !m_items.empty() || stateChanged() || frameReadyLocked() || endReadyLocked();
    });
    Work work;
    if (m_stopped) return work;
    if (!m_items.empty()) {
        work.kind = Work::Kind::Items;
        work.items = std::exchange(m_items, {});
    } else if (stateChanged()) {
        m_toldPaused = m_paused;
        work.kind = Work::Kind::StateChanged;
    } else if (frameReadyLocked()) {
        work.kind = Work::Kind::Frame;
        work.parcel = *std::exchange(m_slot, std::nullopt);
        if (m_paused) --m_steps;
        lock.unlock();
        m_changed.notify_all();
    } else {
        m_endTold = true;
        work.kind = Work::Kind::Ended;
        work.parcel.messages = std::exchange(m_carried, {});
        work.failure = m_failure;
    }
    return work;
}

} // namespace farol::session
