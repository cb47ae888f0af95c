#pragma once
// The one place where the threads of a walk meet: frames from the capture thread (a single slot), commands
// from any thread (in order), and what the session thread is to do next. It is one monitor and not a
// LatestValue because the session must wake for a command, a pause or the end as well as for a frame.

#include "core/capture/frame_source.h"
#include "core/session/pacer.h"
#include "core/session/percept.h"
#include "core/session/recorder.h"

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace farol::session {

/// A frame with what the source told while it looked for it; the messages outlive a dropped frame.
struct Parcel {
    capture::Frame frame;
    std::vector<std::string> messages;
};

/// What comes to the session thread beside frames.
using InboxItem = std::variant<Command, capture::SourceEvent>;

struct Work {
    enum class Kind { Items, Frame, StateChanged, Ended, Stopped };
    Kind kind = Kind::Stopped;
    std::vector<InboxItem> items;
    Parcel parcel;
    std::string failure; ///< of Ended: why the source gave up; empty at the plain end of the material
};

class Inbox {
public:
    using Clock = std::function<Pacer::TimePoint()>;

    /// `clock`: the wall clock by which frames are paced.
    explicit Inbox(double speed, Clock clock = &Pacer::TimePoint::clock::now)
        : m_clock(std::move(clock)), m_pacer(speed) {}

    // The capture thread. False: the walk is being stopped.
    bool waitUntilReady();
    bool putNewest(Parcel parcel);   ///< live: an untaken frame is dropped and counted
    bool putWhenFree(Parcel parcel); ///< nothing is lost
    bool putWhenDue(Parcel parcel);  ///< paced by capturedAt; untaken and late frames are dropped and counted
    void finish(std::vector<std::string> messages, std::string failure);
    void setSkipped(std::uint64_t frames);

    // Any thread.
    void post(InboxItem item);
    void pause();
    void resume();
    void stepOnce();
    void setSpeed(double factor);
    void begin();
    void stop();
    bool stopped() const;
    RunState state() const;
    void waitUntilOver();
    std::uint64_t dropped() const;
    std::uint64_t skipped() const;

    // The session thread.
    void setReady();
    Work next();
    void setOver(RunState state);

private:
    RunState stateLocked() const;
    bool frameReadyLocked() const { return m_slot && (!m_paused || m_steps > 0); }
    bool endReadyLocked() const { return m_finished && !m_slot && !m_endTold; }
    void putNewestLocked(Parcel parcel, bool count);
    bool waitForTurnLocked(std::unique_lock<std::mutex>& lock, double capturedAt);

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<Parcel> m_slot;
    std::vector<InboxItem> m_items;
    std::vector<std::string> m_carried; ///< messages of dropped frames
    Clock m_clock;
    Pacer m_pacer;
    std::optional<double> m_lastCapturedAt;
    std::string m_failure;
    std::uint64_t m_dropped = 0, m_skipped = 0;
    int m_steps = 0;
    bool m_begun = false, m_ready = false, m_paused = false, m_toldPaused = false, m_wasPaused = false;
    bool m_finished = false, m_endTold = false, m_stopped = false;
    std::optional<RunState> m_over;
};

} // namespace farol::session
