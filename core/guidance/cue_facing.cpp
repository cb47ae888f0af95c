// Which way the user faces, and where from there the way goes on.

#include "core/guidance/clock.h"
#include "core/guidance/cue_step.h"
#include "core/guidance/on_the_way.h"
#include "core/routing/door_count.h"

#include <cmath>

namespace farol::guidance {

using routing::Manoeuvre;
using routing::ManoeuvreKind;

namespace {

constexpr Radians kGoodFacing = fromDegrees(25.0), kFollowedFacing = fromDegrees(35.0);
/// The first point of a way that is this far off tells in which direction it begins.
constexpr double kFacingM = 1.0;
/// So near to what one came through by mistake one has not turned yet.
constexpr double kBackM = 3.0;
/// So near to a door what counts is in which wall it is, not where its middle lies.
constexpr double kAtDoorM = 1.5;
/// An order to turn is for somebody who is not turning already: so long within so much of a direction.
constexpr Radians kSteadyTurn = fromDegrees(30.0);
constexpr double kSteadySeconds = 1.0;
constexpr double kTurningSeconds = 4.0; ///< to hear of a turn and to make it
/// Who faces this far from the way for so long goes wrong; but first the words and the turn take their time.
constexpr Radians kAway = fromDegrees(100.0);
constexpr double kAwaySeconds = 2.0, kTurnedBySeconds = 7.0;

} // namespace

/// Only from a measured way of walking, while the user follows the route, and only when what is ahead is far
/// enough away for its direction to mean something.
std::optional<int> CueStep::hourTo(const Manoeuvre& manoeuvre) const {
    bool along = m_memory.advance && m_memory.advance->along;
    if (!m_sure || !along || !m_fix.heading || !m_fix.position || age() > kFreshSeconds) return std::nullopt;
    if (!m_fix.level || *m_fix.level != manoeuvre.level) return std::nullopt;
    // A followed heading is always fresh, but not always good.
    if (m_fix.followed && !headingIsGood()) return std::nullopt;
    Point2 ahead = manoeuvre.position - *m_fix.position;
    if (length(ahead) < 2.0 * m_fix.sigmaM || length(ahead) < 1.0) return std::nullopt;
    return clockHour(directionOf(ahead) - *m_fix.heading);
}

/// A heading that is followed all the while, of somebody who does not turn now.
bool CueStep::headingIsGood() const {
    bool known = m_usable && m_fix.followed && m_fix.heading && m_fix.position &&
                 m_fix.headingSigma.value > 0.0 && m_fix.headingSigma.value <= kFollowedFacing.value;
    return known && m_memory.steady && m_fix.time - m_memory.steady->since >= kSteadySeconds;
}

void CueStep::followHeading() {
    if (!m_fix.followed || !m_fix.heading) {
        m_memory.steady.reset();
        return;
    }
    bool turned = !m_memory.steady ||
                  std::abs(wrapped(*m_fix.heading - m_memory.steady->heading).value) > kSteadyTurn.value;
    if (turned) m_memory.steady = {*m_fix.heading, m_fix.time};
    std::optional<Radians> way;
    if (headingIsGood() && m_progress.route && m_progress.next && m_fix.level) {
        bool along = true;
        way = onward(*m_progress.next, along);
    }
    bool away = way && std::abs(wrapped(*way - *m_fix.heading).value) > kAway.value;
    if (!away)
        m_memory.awaySince.reset();
    else if (!m_memory.awaySince)
        m_memory.awaySince = m_fix.time;
}

/// Steadily, and not because the words to turn are still under way.
bool CueStep::facesAway() const {
    double told = m_memory.routeToldAt.value_or(m_memory.enteredAt);
    return m_memory.awaySince && m_fix.time - *m_memory.awaySince >= kAwaySeconds &&
           m_fix.time - told >= kTurnedBySeconds;
}

/// Where to turn to: through the door at hand, straight to what comes next, or along the way. `along` tells
/// that it is the last.
std::optional<Radians> CueStep::onward(const Manoeuvre& next, bool& along) const {
    along = false;
    double gap = distance(next.position, *m_fix.position);
    if (auto through = throughOf(next); through && gap <= kAtDoorM) return through;
    bool straight = m_progress.distanceM && *m_progress.distanceM - gap <= kStraightM;
    if (straight && gap >= 2.0 * m_fix.sigmaM && gap >= kFacingM)
        return directionOf(next.position - *m_fix.position);
    along = true;
    return wayDirection(*m_progress.route, *m_fix.position, *m_fix.level);
}

/// Words for somebody whose facing is known: whoever faces elsewhere is turned first, and sides count from
/// there.
void CueStep::orient(Cue& cue) const {
    std::optional<Manoeuvre>& first =
        cue.manoeuvre && cue.manoeuvre->kind == ManoeuvreKind::Start && cue.next ? cue.next : cue.manoeuvre;
    if (!first || !m_progress.route || !headingIsGood() || m_fix.level != first->level) return;
    if (cue.priority != CuePriority::Answer && turnsNow()) return;
    auto off = [&](Radians direction) { return wrapped(direction - *m_fix.heading); };
    auto way = wayDirection(*m_progress.route, *m_fix.position, *m_fix.level);
    bool along = true;
    auto onwards = onward(*first, along);
    if (!onwards || !way) return;
    cue.facingWay = true;
    cue.hour.reset();
    cue.turnFirst.reset();
    const routing::Side counted = first->side;
    const int number = first->number;
    bool onSide = first->side != routing::Side::None;
    if (std::abs(off(*way).value) < kTurnFirst.value && (onSide || along)) return;
    if (!along) {
        first->side = routing::Side::None;
        first->number = 0;
    }
    Radians turn = off(*onwards);
    if (std::abs(turn.value) >= kTurnFirst.value)
        cue.turnFirst = turn;
    else if (!along)
        cue.hour = clockHour(turn);
    // A door that lies ahead may still be in the wall beside.
    auto through = along ? std::nullopt : throughOf(*first);
    Radians wall = through ? wrapped(*through - (cue.turnFirst ? *onwards : *m_fix.heading)) : Radians{};
    if (std::abs(wall.value) < kTurnFirst.value || std::abs(wall.value) > kPi - kTurnFirst.value) return;
    first->side = wall.value > 0.0 ? routing::Side::Left : routing::Side::Right;
    if (first->side == counted) first->number = number;
    cue.hour.reset();
}

/// Words to turn, or a turn behind a door, are just being followed.
bool CueStep::turnsNow() const {
    auto lately = [&](double since) { return m_fix.time - since < kTurningSeconds; };
    bool entered = m_memory.regionIndex.value_or(0) > 0 && lately(m_memory.enteredAt);
    return entered || (m_memory.turnToldAt && lately(*m_memory.turnToldAt));
}

/// The direction straight through a door or an opening.
std::optional<Radians> CueStep::throughOf(const Manoeuvre& gap) const {
    const building::Access* access = m_building.access(gap.access);
    const building::Region* from = m_building.region(gap.from);
    if (gap.kind != ManoeuvreKind::Door && gap.kind != ManoeuvreKind::Opening) return std::nullopt;
    if (access == nullptr || from == nullptr) return std::nullopt;
    auto through = routing::directionThrough(from->polygon, *access);
    return through ? std::optional(directionOf(*through)) : std::nullopt;
}

/// Only a trained place tells which way one faces, and walking the wrong way does; the way of walking from
/// two rough positions is no ground for an order to turn.
std::optional<Radians> CueStep::facing() const {
    if (!m_usable || age() > kFreshSeconds) return std::nullopt;
    if (m_progress.walking) {
        // Who has turned round meanwhile walks that way no more.
        bool turned = m_fix.followed && m_fix.heading &&
                      std::abs(wrapped(*m_progress.walking - *m_fix.heading).value) > kTurnFirst.value;
        if (!turned) return m_progress.walking;
    }
    const building::Landmark* seen = m_building.landmark(m_fix.landmark);
    if (seen == nullptr || seen->kind != Kind::Place) return std::nullopt;
    return m_fix.heading;
}

/// How far the user has to turn to face the way that begins here.
std::optional<Radians> CueStep::turnFirst() const {
    // Who has just come through a door has it behind.
    bool behind = m_progress.backAgain && m_sure && age() <= kFreshSeconds && m_progress.distanceM &&
                  *m_progress.distanceM <= kBackM && m_fix.sigmaM <= m_options.maxSigmaForActM;
    if (behind) return Radians{kPi};
    std::optional<Radians> now = facing();
    if (!now || !m_fix.position || !m_progress.route) return std::nullopt;
    const std::vector<routing::PathPoint>& path = m_progress.route->path;
    for (const routing::PathPoint& point : path) {
        if (point.level != path.front().level || point.level != m_fix.level) return std::nullopt;
        Point2 ahead = point.position - path.front().position;
        if (length(ahead) < kFacingM) continue;
        Radians turn = wrapped(directionOf(ahead) - *now);
        return std::abs(turn.value) >= kTurnFirst.value ? std::optional(turn) : std::nullopt;
    }
    return std::nullopt;
}

/// Which side is left is known of somebody who walks along the way, or has just come through its last door.
bool CueStep::facesWay() const {
    if (m_memory.facesWay && m_memory.version == m_progress.routeVersion) return true;
    if (facing()) return true; // turnFirst() says the rest
    bool moving = m_progress.replanned && m_fix.heading && m_fix.headingSigma.value > 0.0 &&
                  m_fix.headingSigma.value <= kGoodFacing.value && m_fix.position && m_fix.level;
    if (!moving || age() > kFreshSeconds || !m_progress.route) return false;
    auto way = wayDirection(*m_progress.route, *m_fix.position, *m_fix.level);
    return way && std::abs(wrapped(*way - *m_fix.heading).value) < kTurnFirst.value;
}

} // namespace farol::guidance
