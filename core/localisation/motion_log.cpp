#include "core/localisation/motion_log.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace farol::localisation {

namespace {

constexpr double kTurnStaysS = 0.3;
constexpr double kMostTurns = 3.0, kMostSpeed = 1e6, kLeastUsual = 0.1;

} // namespace

/// The usual speed is the mean of those clearly above standing, of the last minute of walking; a wild
/// one among them changes nothing for long.
double MotionLog::paceOf(double speed) {
    constexpr double kClearly = 0.35, kOften = 0.8, kStands = 0.2, kWild = 2.5;
    constexpr std::size_t kSettled = 60, kFew = 5, kYoung = 10;
    // Who stood at first and walks now: what was measured before was noise.
    if (m_usual > 0.0 && speed > kWild * m_usual && m_speeds.size() < kYoung)
        std::erase_if(m_speeds, [&](double each) { return each < kClearly * speed; });
    if (speed > 0.0 && (m_speeds.size() < kFew || speed >= kStands * m_usual)) {
        m_speeds.push_back(speed);
        if (m_speeds.size() > kSettled) m_speeds.pop_front();
    }
    if (m_speeds.empty()) return 0.0;
    std::vector<double> sorted(m_speeds.begin(), m_speeds.end());
    std::sort(sorted.begin(), sorted.end());
    double quick = sorted[static_cast<std::size_t>(kOften * static_cast<double>(sorted.size() - 1))];
    double sum = 0.0, count = 0.0;
    for (double each : sorted) {
        if (each <= kClearly * quick || each > kWild * quick) continue;
        sum += each;
        count += 1.0;
    }
    m_usual = sum / count; // `quick` itself is always among them
    // Of the first few, all may be standing: what a walk measures at all is not known then.
    if (sorted.size() < kFew) m_usual = std::max(m_usual, kLeastUsual);
    double pace = std::min(speed / m_usual, kWild);
    return pace > kClearly ? std::pow(pace, m_paceTrust) : pace;
}

void MotionLog::add(double time, const recognition::Motion& motion) {
    constexpr double kMissedLine = 1.6, kFollows = 0.1, kFollowsDown = 0.4;
    double seconds = m_last ? std::max(0.0, time - *m_last) : m_interval;
    bool missed = seconds > kMissedLine * m_interval;
    if (missed)
        m_unseen += seconds - m_interval;
    else
        m_interval += (seconds < m_interval ? kFollowsDown : kFollows) * (seconds - m_interval);
    m_last = time;
    m_now = time;
    // Nobody turns round three times between two pictures: such a number is no measurement.
    if (motion.turn && std::abs(motion.turn->value) <= kMostTurns * 2.0 * kPi) {
        m_turnDeg += toDegrees(*motion.turn);
        m_turnRate = seconds > 0.0 ? toDegrees(*motion.turn) / seconds : 0.0;
        m_shown += std::min(seconds, m_interval);
    } else {
        // Whoever was turning goes on for a moment: nearer to the truth than a sudden stop.
        double unseen = std::min(seconds, m_interval), stays = std::exp(-unseen / kTurnStaysS);
        m_turnDeg += m_turnRate * kTurnStaysS * (1.0 - stays);
        m_turnRate *= stays;
        m_unseen += unseen;
    }
    if (motion.speed && *motion.speed >= 0.0 && *motion.speed <= kMostSpeed) m_pace = paceOf(*motion.speed);
    if (motion.walking == false) m_pace = 0.0;
    m_measured += m_pace * std::min(seconds, kSilenceS);
    m_ready = true;
}

MotionSpan MotionLog::take(double seconds) {
    MotionSpan span;
    span.seconds = seconds;
    span.shownSeconds = blind() ? 0.0 : seconds; // of a camera that never told motion nothing is known
    if (!known()) return span;
    // Lines that come seldom are not missing yet.
    constexpr double kOften = 0.4;
    if (m_interval < kOften) span.shownSeconds = m_shown;
    m_shown = 0.0;
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
