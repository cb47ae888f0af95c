#include "core/session/pacer.h"

#include <algorithm>
#include <cmath>

namespace farol::session {

Pacer::Pacer(double speed) {
    setSpeed(speed);
}

void Pacer::setSpeed(double factor) {
    if (std::isfinite(factor) && factor > 0.0) m_speed = std::clamp(factor, kSlowest, kFastest);
}

Pacer::TimePoint Pacer::due(double capturedAt, TimePoint now) const {
    if (!m_last) return now;
    // A gap of more than an hour is a damaged clock, not something to sit through.
    constexpr double kLongestWait = 3600.0;
    double seconds = (capturedAt - m_last->capturedAt) / m_speed;
    if (!std::isfinite(seconds)) return now;
    seconds = std::clamp(seconds, 0.0, kLongestWait);
    return m_last->due +
           std::chrono::duration_cast<TimePoint::duration>(std::chrono::duration<double>(seconds));
}

bool Pacer::accept(double capturedAt, TimePoint now) {
    TimePoint turn = due(capturedAt, now);
    bool late = now - turn > kTooLate;
    if (late && m_lateInARow >= kMostLateInARow) {
        late = false;
        turn = now;
    }
    m_lateInARow = late ? m_lateInARow + 1 : 0;
    m_last = Mark{turn, capturedAt};
    return !late;
}

void Pacer::restart(double lastCapturedAt, TimePoint now) {
    m_last = Mark{now, lastCapturedAt};
}

} // namespace farol::session
