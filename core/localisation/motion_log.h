#pragma once
// The picture's own motion, gathered between the filter's steps, in units of the user's usual pace.

#include "core/localisation/walker_cloud.h"
#include "core/recognition/detection.h"

#include <deque>
#include <optional>

namespace farol::localisation {

/// The scale of the speed is not known: a walk's own usual speed is taken for 1.
class MotionLog {
public:
    /// `paceTrust`: of the pace of who walks, see WalkingOptions.
    explicit MotionLog(double paceTrust = 1.0) : m_paceTrust(paceTrust) {}
    void clear() { *this = MotionLog(m_paceTrust); }
    void add(double time, const recognition::Motion& motion);
    void now(double time) { m_now = time; }
    /// What is known of the next `seconds`; turns that were measured are handed out once.
    MotionSpan take(double seconds);
    /// Does the picture tell motion at all, now and then?
    bool known() const { return m_last && m_now - *m_last < kSilenceS; }
    /// It did, and has stopped to: covered, or put away.
    bool blind() const { return m_last && m_now - *m_last >= kSilenceS; }

private:
    static constexpr double kSilenceS = 3.0;

    double paceOf(double speed);

    double m_paceTrust = 1.0;
    std::optional<double> m_last; ///< of the last line
    double m_now = 0.0;
    double m_pace = 1.0;         ///< last measured
    double m_usual = 0.0;        ///< the walk's own usual speed, in the scale of the lines
    std::deque<double> m_speeds; ///< that it rests on
    double m_turnDeg = 0.0;
    double m_turnRate = 0.0; ///< degrees a second, last measured; fading while nothing is
    double m_unseen = 0.0;   ///< seconds whose turn is not known
    double m_shown = 0.0;    ///< seconds whose turn is known, since the last step
    double m_interval = 1.0; ///< usual time from line to line
    double m_ahead = 0.0;    ///< of `pace` seconds handed out before they were measured
    double m_measured = 0.0; ///< pace times seconds since the last step
    bool m_ready = false;    ///< a line came since
};

} // namespace farol::localisation
