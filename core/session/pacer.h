#pragma once
// When a frame of recorded material is due on the wall clock. A value: the caller tells the time, so it is
// tested without waiting.

#include <chrono>
#include <cstdint>
#include <optional>

namespace farol::session {

class Pacer {
public:
    using TimePoint = std::chrono::steady_clock::time_point;

    explicit Pacer(double speed = 1.0);

    /// From now on; what lies between the last frame and now keeps its old speed's due time.
    void setSpeed(double factor);
    double speed() const { return m_speed; }
    /// When this frame is due; the first one is due at once.
    TimePoint due(double capturedAt, TimePoint now) const;
    /// The frame's turn has come. False: it is so late that it is dropped. When reading itself cannot keep
    /// up, not every frame is dropped: after a few the clock starts anew from the present.
    bool accept(double capturedAt, TimePoint now);
    /// A pause ends, or a single step was made: the next frame comes one period after `now`.
    void restart(double lastCapturedAt, TimePoint now);

    static constexpr std::chrono::milliseconds kTooLate{200};
    static constexpr int kMostLateInARow = 4;
    static constexpr double kSlowest = 0.05, kFastest = 1000.0;

private:
    struct Mark {
        TimePoint due;
        double capturedAt = 0.0;
    };
    double m_speed = 1.0;
    std::optional<Mark> m_last;
    int m_lateInARow = 0;
};

} // namespace farol::session
