#include "core/guidance/cue_step.h"

namespace farol::guidance {

using routing::Manoeuvre;
using routing::ManoeuvreKind;

namespace {

constexpr double kIntoLiftSeconds = 10.0; ///< to find its button and wait for it
constexpr double kWaitsSeconds = 4.0;     ///< in which nobody who walks is not half a metre on
constexpr double kRideSeconds = 6.0;      ///< the order to ride holds

} // namespace

/// One ride over several levels is one manoeuvre; on the way through, one stays in the car.
bool CueStep::staysInLift(const Manoeuvre& manoeuvre) const {
    if (manoeuvre.kind != ManoeuvreKind::Elevator || !m_progress.route) return false;
    const Manoeuvre* before = nullptr;
    for (const Manoeuvre& each : m_progress.route->manoeuvres) {
        if (each.access == manoeuvre.access && each.from == manoeuvre.from) break;
        before = &each;
    }
    return before != nullptr && before->kind == ManoeuvreKind::Elevator && before->into == manoeuvre.into;
}

/// What was told outside some time ago is told in the car once more.
void CueStep::forgetRide(const Manoeuvre& ride) {
    if (ride.kind != ManoeuvreKind::Elevator || toldRecently(m_memory.told, keyOf(ride), kRideSeconds))
        return;
    m_memory.told.erase(keyOf(ride));
    m_memory.acted.erase(keyOf(ride));
}

/// Nothing in a lift's car tells that one is in it. Who was sent there some time ago may be, and waits to
/// hear what to do inside.
bool CueStep::tellRide(const Manoeuvre& door) {
    const std::optional<Manoeuvre>& ride = m_progress.afterNext;
    if (!ride || ride->kind != ManoeuvreKind::Elevator || ride->from != door.into) return false;
    auto sent = m_memory.acted.find(keyOf(door));
    bool mayBeInside = sent != m_memory.acted.end() && m_fix.time - sent->second >= kIntoLiftSeconds &&
                       !toldRecently(m_memory.told, keyOf(door), kIntoLiftSeconds);
    bool getsOn = m_memory.advance && m_memory.advance->along &&
                  m_fix.time - m_memory.advance->spotTime <= kWaitsSeconds;
    if (!mayBeInside || getsOn ||
        toldRecently(m_memory.told, keyOf(*ride), 2.0 * m_options.repeatAfterSeconds))
        return false;
    addManoeuvre(routeCue(CueKind::Act, CuePriority::Prepare, kRideSeconds), *ride, std::nullopt);
    Cue& cue = m_cues.back();
    cue.validIn.push_back(door.from);
    cue.turnFirst.reset(); // the buttons are found by hand
    cue.hour.reset();
    return true;
}

} // namespace farol::guidance
