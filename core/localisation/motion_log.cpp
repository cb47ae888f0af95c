#include "core/localisation/motion_log.h"

#include <algorithm>
#include <cmath>

namespace farol::localisation {

/// The usual speed is the mean of those clearly above standing; it settles within half a minute of walking.
double MotionLog::paceOf(double speed) {
    constexpr double kClearly = 0.35, kSettled = 40.0;
    if (m_usual <= 0.0) m_usual = std::max(speed, 0.5);
    if (speed > 2.5 * m_usual && m_walked < 3.0) m_usual = speed;
    if (speed > kClearly * m_usual) {
        m_walked = std::min(kSettled, m_walked + 1.0);
        m_usual += (speed - m_usual) / m_walked;
    }
    return std::min(speed / m_usual, 2.5);
}

void MotionLog::add(double time, const recognition::Motion& motion) {
    constexpr double kMissedLine = 1.6, kFollows = 0.1;
    double seconds = m_last ? std::max(0.0, time - *m_last) : m_interval;
    bool missed = seconds > kMissedLine * m_interval;
    if (missed)
        m_unseen += seconds - m_interval;
    else
        m_interval += kFollows * (seconds - m_interval);
    m_last = time;
    m_now = time;
    if (motion.turn && std::isfinite(motion.turn->value))
        m_turnDeg += toDegrees(*motion.turn);
    else
        m_unseen += std::min(seconds, m_interval);
    if (motion.speed && std::isfinite(*motion.speed) && *motion.speed >= 0.0) m_pace = paceOf(*motion.speed);
    if (motion.walking == false) m_pace = 0.0;
    m_measured += m_pace * std::min(seconds, kSilenceS);
    m_ready = true;
}

MotionSpan MotionLog::take(double seconds) {
    MotionSpan span;
    span.seconds = seconds;
    if (!known()) return span;
    span.measured = true;
    if (m_ready) {
        // Steps taken between two lines ran ahead on the last pace: made good here.
        double pace = std::max(0.0, m_measured - m_ahead) / std::max(seconds, 0.05);
        span.pace = std::min(pace, 3.0);
        m_ahead = m_measured = 0.0;
    } else {
        span.pace = m_pace;
        m_ahead += m_pace * seconds;
    }
    span.turnDeg = static_cast<float>(m_turnDeg);
    span.unseenSeconds = m_unseen;
    m_turnDeg = m_unseen = 0.0;
    m_ready = false;
    return span;
}

} // namespace farol::localisation
