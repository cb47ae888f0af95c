// Which of several doors is meant: counted along a wall, beside a thing that is felt, or on which side.

#include "core/guidance/cue_step.h"
#include "core/guidance/on_the_way.h"
#include "core/routing/wall_walk.h"

#include <algorithm>
#include <cmath>

namespace farol::guidance {

using routing::Manoeuvre;
using routing::ManoeuvreKind;

namespace {

/// Later than this a door is announced even if it cannot be told which of several it is.
constexpr double kCountingM = 4.0;
constexpr double kBesideM = 1.8; ///< a way too short to walk along a wall
constexpr double kJustEnteredSeconds = 2.0;
constexpr double kEntranceM = 1.2; ///< so near to a door one has just come through it

} // namespace

/// Where the thing to pass is, seen from here: by its number along a wall, or from the way the user faces.
void CueStep::locate(Cue& cue, const Manoeuvre& manoeuvre) const {
    countDoors(*cue.manoeuvre);
    if (!cue.manoeuvre->alongWall) {
        cue.facingWay = facesWay() && !manoeuvre.alongWall;
        orient(cue);
        return;
    }
    // A wall is followed for as long as it takes: no distance, and nothing to be done on the spot.
    cue.facingWay = true;
    cue.soon = false;
    cue.hour.reset();
    cue.mark.reset();
    if (cue.kind == CueKind::Act) cue.kind = CueKind::Prepare;
    if (cue.kind == CueKind::Prepare) cue.distanceM.reset();
}

/// The number that the route knows counts from where its leg begins; here and now it is another one.
void CueStep::countDoors(Manoeuvre& manoeuvre) const {
    if (manoeuvre.side == routing::Side::None) return;
    if (manoeuvre.alongWall) {
        countAlongWall(manoeuvre);
        return;
    }
    bool justEntered = m_progress.regionsPassed > 0 && m_fix.time - m_memory.enteredAt < kJustEnteredSeconds;
    // Before its leg has begun it is the route's own.
    if (m_progress.route && m_progress.route->regions[m_progress.regionsPassed] != manoeuvre.from) return;
    bool turnsBefore = m_progress.next && m_progress.next->kind == ManoeuvreKind::Turn;
    if (m_fix.position && m_fix.level == manoeuvre.level) {
        double sigma = std::max(kStraightM, std::hypot(m_fix.sigmaM, kWalkingSpeed * age()));
        manoeuvre.number =
            m_sure && !turnsBefore ? countedFrom(m_building, manoeuvre, *m_fix.position, sigma) : 0;
    } else if (!justEntered || turnsBefore) {
        manoeuvre.number = 0;
    }
}

/// The door that was come through is where a wall begins to be followed.
bool CueStep::standsInEntrance(const Manoeuvre& manoeuvre) const {
    const routing::Route* route = m_progress.route.get();
    if (route == nullptr || m_progress.regionsPassed == 0) return false;
    const building::Access* entry = m_building.access(route->accesses[m_progress.regionsPassed - 1]);
    if (entry == nullptr || entry->line.empty()) return false;
    if (!m_fix.position) return m_fix.time - m_memory.enteredAt < kJustEnteredSeconds;
    return m_fix.level == manoeuvre.level && distance(*m_fix.position, entry->midpoint()) <= kEntranceM;
}

/// From the entrance as the route counts; further on from the spot, for one who is known to go along a wall.
/// Otherwise nobody can tell which wall is meant.
void CueStep::countAlongWall(Manoeuvre& manoeuvre) const {
    const routing::Route* route = m_progress.route.get();
    if (route != nullptr && route->regions[m_progress.regionsPassed] != manoeuvre.from) return;
    if (standsInEntrance(manoeuvre)) return;
    const building::Access* access = m_building.access(manoeuvre.access);
    auto region = m_building.regionIndex(manoeuvre.from);
    if (placeIsGood() && headingIsGood() && access != nullptr && region && m_fix.level == manoeuvre.level) {
        for (bool left : {false, true}) {
            auto spot = routing::wallSpot(m_building, *region, *access, left, *m_fix.position, m_fix.sigmaM);
            if (!spot || std::abs(wrapped(spot->along - *m_fix.heading).value) > kTurnFirst.value) continue;
            manoeuvre.side = left ? routing::Side::Left : routing::Side::Right;
            manoeuvre.number = spot->number;
            return;
        }
    }
    manoeuvre.alongWall = false;
    manoeuvre.side = routing::Side::None;
    manoeuvre.number = 0;
}

/// Which of several doors it is will be plain some steps further on; until then the next one would be taken.
bool CueStep::waitsForCount(const Manoeuvre& manoeuvre, double measuredM) const {
    if (manoeuvre.side == routing::Side::None || manoeuvre.alongWall || !facesWay()) return false;
    if (!placeIsGood()) {
        bool isNext = m_fix.position && countedFrom(m_building, manoeuvre, *m_fix.position, kStraightM) == 1;
        return !isNext && measuredM > m_options.actDistanceM;
    }
    Manoeuvre counted = manoeuvre;
    countDoors(counted);
    return counted.number == 0 && !mark(manoeuvre) && measuredM > kCountingM;
}

std::optional<Mark> CueStep::mark(const Manoeuvre& manoeuvre) const {
    if (!placeIsGood() || !m_progress.distanceM || m_fix.level != manoeuvre.level) return std::nullopt;
    bool straight = *m_progress.distanceM - distance(manoeuvre.position, *m_fix.position) <= kStraightM;
    return straight ? markBefore(m_building, manoeuvre, *m_fix.position, m_fix.sigmaM) : std::nullopt;
}

/// A door close beside the one that one has come through is on a side, too, though nobody walks along a wall
/// to it; and so is one in the side wall of a corridor that is too wide for its walls to be followed.
void CueStep::setShortSide(Manoeuvre& manoeuvre) const {
    if (!m_progress.route || !manoeuvre.behind || manoeuvre.side != routing::Side::None) return;
    double towards = wrapped(manoeuvre.turn - *manoeuvre.behind).value, before = -kBesideM;
    for (const Manoeuvre& each : m_progress.route->manoeuvres)
        if (each.kind != ManoeuvreKind::Start && each.atM < manoeuvre.atM) before = each.atM;
    const building::Region* from = m_building.region(manoeuvre.from);
    bool along = from != nullptr && from->kind == building::RegionKind::Corridor;
    bool beside = along || manoeuvre.atM - before < kBesideM;
    if (std::abs(towards) < kTurnFirst.value || !beside) return;
    manoeuvre.side = towards > 0.0 ? routing::Side::Left : routing::Side::Right;
    manoeuvre.number = 0;
}

} // namespace farol::guidance
