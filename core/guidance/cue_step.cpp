#include "core/guidance/cue_step.h"

#include "core/base/text.h"
#include "core/building/sayable.h"
#include "core/guidance/clock.h"
#include "core/guidance/on_the_way.h"

#include <algorithm>
#include <cmath>

namespace farol::guidance {

using routing::Manoeuvre;
using routing::ManoeuvreKind;

namespace {

/// An order to act does not cut off the announcement of the same manoeuvre, unless it is due at once.
constexpr double kActAfterPrepareSeconds = 4.0;
constexpr double kActAtOnceSeconds = 3.0;
constexpr double kActAtOnceM = 1.0;
/// Nor does it cut off the beginning of the route, which tells it, too.
constexpr double kActAfterStartSeconds = 9.0;
/// Nobody is told to keep moving so shortly before the next announcement.
constexpr double kNoReassuranceM = 3.0;
/// Who is on the stairs or in the lift is not sent there again.
constexpr double kOnStairsSeconds = 60.0;
/// What follows within this distance is told in the same breath.
constexpr double kCompoundM = 4.0;
/// The length of the way is told although the spot in the start region is unknown once it is longer than
/// this.
constexpr double kLongWayM = 20.0;
/// "Move forward" needs something seen within this time.
constexpr double kReassureEvidenceSeconds = 10.0;
/// Metres nearer to the destination from one observation to the next that count as moving along the route.
constexpr double kAdvanceM = 0.5;
constexpr double kStandingSeconds = 4.0; ///< in which nobody who walks is not half a metre on

/// Below, an order may be told to one who is behind its door already; and from the order to having gone
/// through.
constexpr double kWellKnown = 0.8;
constexpr double kOnTheHandleSeconds = 20.0;
constexpr double kActSeconds = 4.0, kPrepareSeconds = 6.0, kStartSeconds = 15.0, kReassureSeconds = 4.0,
                 kArrivalSeconds = 20.0, kOffRouteSeconds = 8.0, kRefusalSeconds = 20.0;
/// Who walks this far off the direction of the way does not walk along it.
constexpr Radians kAgainst = fromDegrees(110.0);
/// Who has been told nothing since a place was entered, and does not get on, waits for a word; who does not
/// get on is told again, less and less often.
constexpr double kUntoldSeconds = 5.0, kSeldomSeconds = 60.0;

bool changesLevel(ManoeuvreKind kind) {
    return kind == ManoeuvreKind::Stairs || kind == ManoeuvreKind::Elevator ||
           kind == ManoeuvreKind::Escalator;
}

/// The manoeuvre to tell together with the one before it. After stairs and lifts one has to find one's
/// bearings first.
std::optional<Manoeuvre> inTheSameBreath(const Manoeuvre& first, const std::optional<Manoeuvre>& second) {
    if (!second || second->kind == ManoeuvreKind::Start) return std::nullopt;
    // Behind the last door one is there, however far its middle is.
    if (second->kind == ManoeuvreKind::Arrive && first.kind != ManoeuvreKind::Turn) return second;
    if (changesLevel(first.kind) || first.alongWall) return std::nullopt;
    return second->atM - first.atM <= kCompoundM ? second : std::nullopt;
}

} // namespace

CueStep::CueStep(const building::Building& building, const GuidanceOptions& options, SchedulerMemory& memory,
                 std::uint64_t frame, const localisation::Fix& fix, const Progress& progress)
    : m_building(building),
      m_options(options),
      m_memory(memory),
      m_frame(frame),
      m_fix(fix),
      m_progress(progress) {
    m_usable = fix.region.has_value() && (fix.confidence >= options.usableConfidence ||
                                          fix.nearConfidence >= options.usableNearConfidence);
    m_sure = m_usable && fix.confidence >= options.sureConfidence;
}

Cue CueStep::cueOf(CueKind kind, CuePriority priority, double seconds) const {
    Cue cue;
    cue.kind = kind;
    cue.priority = priority;
    cue.frame = m_frame;
    cue.time = m_fix.time;
    cue.validUntil = m_fix.time + seconds;
    cue.sure = m_sure;
    return cue;
}

Cue CueStep::routeCue(CueKind kind, CuePriority priority, double seconds) const {
    Cue cue = cueOf(kind, priority, seconds);
    cue.routeVersion = m_progress.routeVersion;
    return cue;
}

/// Words on which somebody walks through a door at once, if one is at hand.
bool CueStep::ordersSomething(const Cue& cue) const {
    bool begins = cue.kind == CueKind::RouteStart || cue.kind == CueKind::OffRoute;
    bool near = !m_progress.distanceM || *m_progress.distanceM <= m_options.actDistanceM + kActAtOnceM;
    return cue.manoeuvre && (cue.kind == CueKind::Act || (begins && near));
}

void CueStep::add(Cue cue) {
    if (ordersSomething(cue)) {
        m_memory.doubtfulOrderAt.reset();
        if (m_fix.confidence < kWellKnown) m_memory.doubtfulOrderAt = m_fix.time;
    }
    if (cue.routeVersion != 0) {
        m_routeTold = true;
        m_memory.routeToldAt = m_fix.time;
        m_memory.remainingWhenTold = m_progress.remainingM;
    }
    m_cues.push_back(std::move(cue));
}

void CueStep::nameRegion(Cue& cue, const RegionId& region) const {
    cue.region = region;
    cue.regionName = nameOf(region);
    if (const building::Region* known = m_building.region(region)) cue.regionKind = known->kind;
}

/// Of a destination that the map does not have nothing but its id is known.
std::string CueStep::nameOf(const RegionId& region) const {
    const building::Region* known = m_building.region(region);
    if (known != nullptr) return building::sayableName(*known, m_options.language);
    return building::isSayable(region.value) ? region.value : std::string();
}

std::string CueStep::levelName(double ordinal, bool asOnButtons) const {
    const building::Level* level = m_building.level(ordinal);
    if (level == nullptr) return formatNumber(ordinal);
    const std::string name = building::nameIn(*level, m_options.language);
    const std::string& first = asOnButtons ? level->ref : name;
    const std::string& second = asOnButtons ? name : level->ref;
    if (building::isSayable(first)) return first;
    return building::isSayable(second) ? second : formatNumber(ordinal);
}

std::string CueStep::keyOf(const Manoeuvre& manoeuvre) const {
    return routing::manoeuvreKindName(manoeuvre.kind) + " " + manoeuvre.access.value + " " +
           formatNumber(manoeuvre.atM);
}

bool CueStep::toldRecently(const std::map<std::string, double>& times, const std::string& key,
                           double seconds) const {
    auto found = times.find(key);
    return found != times.end() && m_fix.time - found->second < seconds;
}

bool CueStep::distanceIsGood() const {
    return m_sure && m_progress.distanceM &&
           std::hypot(m_fix.sigmaM, kWalkingSpeed * age()) <= m_options.maxSigmaForDistanceM;
}

bool CueStep::placeIsGood() const {
    return m_sure && m_fix.position &&
           std::hypot(m_fix.sigmaM, kWalkingSpeed * age()) <= m_options.maxSigmaForDistanceM;
}

/// What a manoeuvre leads into, what follows at once, and where it still holds.
void CueStep::fillManoeuvre(Cue& cue, const Manoeuvre& manoeuvre,
                            const std::optional<Manoeuvre>& after) const {
    cue.manoeuvre = manoeuvre;
    cue.next = inTheSameBreath(manoeuvre, after);
    setShortSide(*cue.manoeuvre);
    if (cue.next) setShortSide(*cue.next);
    cue.staying = staysInLift(manoeuvre);
    if (cue.region.empty()) nameRegion(cue, manoeuvre.into);
    if (const building::Region* from = m_building.region(manoeuvre.from)) cue.fromKind = from->kind;
    if (const building::Region* into = m_building.region(manoeuvre.into)) {
        cue.intoName = building::sayableName(*into, m_options.language);
        cue.intoKind = into->kind;
    }
    // What to do in a lift is heard inside it.
    if (cue.next && cue.next->kind == ManoeuvreKind::Elevator &&
        cue.intoKind == building::RegionKind::Elevator)
        cue.next.reset();
    if (manoeuvre.targetLevel != manoeuvre.level || changesLevel(manoeuvre.kind)) {
        cue.levelName = levelName(manoeuvre.targetLevel, manoeuvre.kind == ManoeuvreKind::Elevator);
    }
    if (!manoeuvre.from.empty()) cue.validIn = {manoeuvre.from};
}

void CueStep::addManoeuvre(Cue cue, const Manoeuvre& manoeuvre, const std::optional<Manoeuvre>& after) {
    fillManoeuvre(cue, manoeuvre, after);
    locate(cue, manoeuvre);
    if (m_building.region(manoeuvre.into) != nullptr) m_memory.announcedInto[manoeuvre.into] = m_fix.time;
    m_memory.told[keyOf(manoeuvre)] = m_fix.time;
    if (cue.turnFirst) m_memory.turnToldAt = m_fix.time;
    if (cue.kind == CueKind::RouteStart || cue.kind == CueKind::OffRoute) {
        bool starts = cue.manoeuvre->kind == ManoeuvreKind::Start && cue.next;
        const Manoeuvre& first = starts ? *cue.next : *cue.manoeuvre;
        m_memory.startToldSide = cue.facingWay || first.side == routing::Side::None;
    }
    // What was told from far off is announced once more.
    bool far = cue.kind == CueKind::Prepare && m_progress.distanceM &&
               *m_progress.distanceM > m_options.prepareDistanceM + kNoReassuranceM;
    if ((cue.kind == CueKind::Prepare && !far) || cue.kind == CueKind::Act)
        m_memory.prepared.insert(keyOf(manoeuvre));
    if (cue.kind == CueKind::Act) m_memory.acted[keyOf(manoeuvre)] = m_fix.time;
    // Stairs and lifts are told once more by themselves, with their steps and the level.
    if (cue.next && !changesLevel(cue.next->kind)) {
        m_memory.told[keyOf(*cue.next)] = m_fix.time;
        m_memory.followed[keyOf(*cue.next)] = m_fix.time;
        m_memory.prepared.insert(keyOf(*cue.next));
    } else if (cue.next && m_memory.acted.contains(keyOf(manoeuvre))) {
        m_memory.prepared.insert(keyOf(*cue.next)); // no announcement between one order and the next
    }
    add(std::move(cue));
}

void CueStep::tellRoute() {
    followHeading();
    bool newRoute = m_progress.routeVersion != m_memory.version;
    if (newRoute) {
        // Nothing of the old route is left over.
        m_memory.version = m_progress.routeVersion;
        m_memory.regionIndex.reset();
        m_memory.told.clear();
        m_memory.acted.clear();
        m_memory.followed.clear();
        m_memory.prepared.clear();
        m_memory.announcedInto.clear();
        m_memory.routeToldAt.reset();
        m_memory.remainingWhenTold.reset();
        m_memory.arrivedToldAt.reset();
        m_memory.advance.reset();
        m_memory.startedAt.reset();
        m_memory.facesWay = false;
        m_memory.repeats = 0;
    }
    switch (m_progress.travel) {
    case Travel::NoDestination:
    case Travel::NoFix:
        break;
    case Travel::Unreachable:
        if (newRoute) tellRefusal();
        break;
    case Travel::Arrived:
        tellArrival();
        break;
    case Travel::OffRoute:
        tellOffRoute();
        break;
    case Travel::OnRoute:
        followAdvance();
        if (newRoute)
            tellStart();
        else
            tellManoeuvre();
        break;
    }
}

void CueStep::tellRefusal() {
    bool known = m_building.region(m_progress.destination) != nullptr;
    Cue cue = routeCue(m_progress.replanned ? CueKind::OffRoute : CueKind::NoRoute, CuePriority::OffRoute,
                       kRefusalSeconds);
    cue.reason = known ? CueReason::DestinationUnreachable : CueReason::DestinationUnknown;
    cue.detail = m_progress.reason;
    nameRegion(cue, m_progress.destination);
    add(std::move(cue));
}

Cue CueStep::arrivalCue() const {
    bool there = m_progress.route && m_progress.route->accesses.empty();
    Cue cue =
        routeCue(there ? CueKind::AlreadyThere : CueKind::Arrived, CuePriority::Arrival, kArrivalSeconds);
    if (m_progress.doubtful) cue.sure = false;
    nameRegion(cue, m_progress.destination);
    cue.validIn = {m_progress.destination};
    return cue;
}

void CueStep::tellArrival() {
    if (m_memory.arrivedToldAt && m_memory.regionIndex == m_progress.regionsPassed) return;
    // Who was thought to be out again meanwhile may not have heard it.
    if (m_memory.arrivedToldAt && m_fix.time - *m_memory.arrivedToldAt < m_options.repeatAfterSeconds) return;
    m_memory.regionIndex = m_progress.regionsPassed;
    m_memory.arrivedToldAt = m_fix.time;
    Cue cue = arrivalCue();
    // Who was sent through a door by a guess, and was there already, may have his hand on its handle.
    cue.stop = m_memory.doubtfulOrderAt && m_fix.time - *m_memory.doubtfulOrderAt <= kOnTheHandleSeconds;
    add(std::move(cue));
}

void CueStep::tellStart() {
    m_memory.regionIndex = m_progress.regionsPassed;
    m_memory.enteredAt = m_fix.time;
    m_memory.startedAt = m_fix.time;
    Cue cue = routeCue(CueKind::RouteStart, CuePriority::Prepare, kStartSeconds);
    nameRegion(cue, m_progress.destination);
    double length = m_progress.route->lengthM;
    if (m_fix.position || length >= kLongWayM) cue.distanceM = length;
    cue.turnFirst = turnFirst();
    cue.firstM = firstM();
    // Right before a door the beginning of the way is the order to go through it.
    bool near = m_progress.distanceM && *m_progress.distanceM <= m_options.actDistanceM + kActAtOnceM;
    if (near && m_progress.next) m_memory.acted[keyOf(*m_progress.next)] = m_fix.time;
    if (m_progress.next)
        addManoeuvre(std::move(cue), *m_progress.next, m_progress.afterNext);
    else
        add(std::move(cue));
}

bool CueStep::isSoon() const {
    return m_progress.distanceM && *m_progress.distanceM <= m_options.prepareDistanceM + kNoReassuranceM;
}

/// Without it, whoever is told to go through a door takes the nearest one.
std::optional<double> CueStep::firstM() const {
    bool far = distanceIsGood() && *m_progress.distanceM > m_options.prepareDistanceM;
    return far ? m_progress.distanceM : std::nullopt;
}

void CueStep::tellOffRoute() {
    m_memory.regionIndex = m_progress.regionsPassed;
    m_memory.enteredAt = m_fix.time;
    bool toldNow =
        m_memory.offRouteToldAt && m_fix.time - *m_memory.offRouteToldAt < m_options.offRouteRepeatSeconds;
    // The new way has to be told in any case; that the old one was left, not again and again.
    Cue cue = toldNow ? routeCue(CueKind::Prepare, CuePriority::Prepare, kPrepareSeconds)
                      : routeCue(CueKind::OffRoute, CuePriority::OffRoute, kOffRouteSeconds);
    if (!toldNow) m_memory.offRouteToldAt = m_fix.time;
    cue.deviation = m_progress.deviation;
    cue.turnFirst = turnFirst();
    (toldNow ? cue.distanceM : cue.firstM) = firstM();
    cue.soon = isSoon();
    if (m_progress.next)
        addManoeuvre(std::move(cue), *m_progress.next, m_progress.afterNext);
    else if (!toldNow)
        add(std::move(cue));
}

/// Is the user getting nearer to the destination from one observation to the next?
void CueStep::followAdvance() {
    if (!m_progress.remainingM) {
        m_memory.advance.reset();
        return;
    }
    double remaining = *m_progress.remainingM;
    std::optional<SchedulerMemory::Advance>& last = m_memory.advance;
    if (!last) last = {spotTime(), remaining, m_fix.position, false};
    if (last->spotTime == spotTime()) return;
    // Steps that are too short to tell are added up.
    double gone = last->remainingM - remaining;
    bool stands = spotTime() - last->spotTime > kStandingSeconds;
    bool against = walksAgainstTheWay(last->at);
    if (std::abs(gone) < kAdvanceM && !stands && !against) return;
    last = {spotTime(), remaining, m_fix.position, gone >= kAdvanceM && !against};
    // Who comes back from beyond has the door on the other side.
    if (last->along || against) m_memory.facesWay = last->along;
}

/// From that spot to this one, whatever that does to the distance that is left.
bool CueStep::walksAgainstTheWay(const std::optional<Point2>& from) const {
    if (!from || !m_fix.position || !m_fix.level || !m_progress.route) return false;
    Point2 step = *m_fix.position - *from;
    auto way = wayDirection(*m_progress.route, *m_fix.position, *m_fix.level);
    return way && length(step) >= kAdvanceM &&
           std::abs(wrapped(directionOf(step) - *way).value) > kAgainst.value;
}

void CueStep::tellManoeuvre() {
    bool here = m_usable && *m_fix.region == m_progress.route->regions[m_progress.regionsPassed];
    if (!here || !m_progress.next) return;
    const Manoeuvre& next = *m_progress.next;
    bool entered = m_memory.regionIndex != m_progress.regionsPassed;
    if (entered) {
        bool onward = m_memory.regionIndex && *m_memory.regionIndex + 1 == m_progress.regionsPassed;
        // Which way one faces behind stairs and lifts nobody knows.
        const building::Region* before =
            m_building.region(m_progress.route->regions[m_memory.regionIndex.value_or(0)]);
        m_memory.facesWay = onward && before != nullptr && before->level == m_fix.level;
        m_memory.regionIndex = m_progress.regionsPassed;
        m_memory.enteredAt = m_fix.time;
        m_memory.repeats = 0;
        forgetRide(next);
    }
    if (tellRide(next)) return;
    if (m_progress.distanceM)
        tellMeasured(next);
    else
        tellUnmeasured(next);
    if (!m_routeTold) tellAgain(next);
}

/// Silence is an answer to nobody who stands and waits.
void CueStep::tellAgain(const Manoeuvre& next) {
    const auto& advance = m_memory.advance;
    bool getsOn = advance && advance->along && m_fix.time - advance->spotTime <= 2.0 * kStandingSeconds;
    if (getsOn) m_memory.repeats = 0;
    bool climbs = changesLevel(next.kind) && toldRecently(m_memory.told, keyOf(next), kOnStairsSeconds);
    bool passed = next.kind == ManoeuvreKind::Turn && !m_progress.distanceM; // or will be felt
    if ((getsOn && !facesAway()) || climbs || passed) return;
    double wait = std::min(kSeldomSeconds, std::ldexp(m_options.repeatAfterSeconds, m_memory.repeats));
    if (!m_memory.told.contains(keyOf(next))) wait = kUntoldSeconds;
    double since = std::max(m_memory.enteredAt, m_memory.routeToldAt.value_or(m_memory.enteredAt));
    if (m_fix.time - since < wait && !facesAway()) return;
    if (!facesAway()) ++m_memory.repeats;
    Cue cue = routeCue(CueKind::Prepare, CuePriority::Prepare, kPrepareSeconds);
    if (distanceIsGood()) cue.distanceM = m_progress.distanceM;
    cue.soon = isSoon();
    cue.hour = hourTo(next);
    addManoeuvre(std::move(cue), next, m_progress.afterNext);
}

void CueStep::tellMeasured(const Manoeuvre& next) {
    // Beyond it, the way says that it is reached.
    double beeline = m_fix.position && m_fix.level == next.level
                         ? distance(*m_fix.position, next.position) - m_fix.sigmaM
                         : 0.0;
    double measured = std::max(*m_progress.distanceM, beeline);
    double expected = std::max(0.0, measured - kWalkingSpeed * age());
    std::string key = keyOf(next);
    bool near = measured <= m_options.actDistanceM && age() <= kFreshSeconds;
    // An object can be recognised from several metres away: its place on the map is not where the user
    // stands.
    if (near && m_fix.sigmaM <= m_options.maxSigmaForActM) {
        double repeatAfter = changesLevel(next.kind) ? kOnStairsSeconds : m_options.repeatAfterSeconds;
        double pause = measured <= kActAtOnceM ? kActAtOnceSeconds : kActAfterPrepareSeconds;
        auto toldAt = m_memory.told.find(key);
        // Whoever stands in the door already would look for another one ahead.
        double startPause = measured <= kActAtOnceM ? m_options.repeatAfterSeconds : kActAfterStartSeconds;
        bool startIsToldNow = toldAt != m_memory.told.end() && toldAt->second == m_memory.startedAt &&
                              m_fix.time - toldAt->second < startPause;
        bool holdBack = toldRecently(m_memory.told, key, pause) || startIsToldNow ||
                        toldRecently(m_memory.acted, key, repeatAfter);
        // Which of several doors it is has been told at the first of them.
        holdBack =
            holdBack || (next.alongWall && toldRecently(m_memory.told, key, m_options.repeatAfterSeconds));
        if (holdBack || tellWhatFollows(next, measured)) return;
        Cue cue = next.alongWall ? routeCue(CueKind::Prepare, CuePriority::Prepare, kPrepareSeconds)
                                 : routeCue(CueKind::Act, CuePriority::ActNow, kActSeconds);
        addManoeuvre(std::move(cue), next, m_progress.afterNext);
    } else if (expected <= m_options.prepareDistanceM) {
        bool again = near && !toldRecently(m_memory.told, key, m_options.repeatAfterSeconds);
        // What only the beginning of the route has told is announced like everything else, but not the very
        // same a moment later.
        double pause = m_memory.startToldSide ? m_options.repeatAfterSeconds : kActAfterStartSeconds;
        bool prepared = m_memory.prepared.contains(key) || toldRecently(m_memory.told, key, pause);
        if (prepared && !again) return;
        if (waitsForCount(next, measured)) return;
        Cue cue = routeCue(CueKind::Prepare, CuePriority::Prepare, kPrepareSeconds);
        if (distanceIsGood()) cue.distanceM = measured;
        cue.hour = hourTo(next);
        cue.mark = mark(next);
        addManoeuvre(std::move(cue), next, m_progress.afterNext);
    } else {
        tellReassurance(expected);
    }
}

/// Of an opening that was told together with the one before it, nothing is left to say: what matters is what
/// comes behind, while there is time to say it. A door has to be found and opened; whoever hears of the
/// stairs behind it looks for stairs.
bool CueStep::tellWhatFollows(const Manoeuvre& next, double measuredM) {
    const std::optional<Manoeuvre>& after = m_progress.afterNext;
    bool isGap = next.kind == ManoeuvreKind::Opening;
    bool isTold = toldRecently(m_memory.followed, keyOf(next), m_options.repeatAfterSeconds);
    if (!isGap || !isTold || !after || after->kind == ManoeuvreKind::Arrive || after->from != next.into ||
        !inTheSameBreath(next, after))
        return false;
    m_memory.acted[keyOf(next)] = m_fix.time;
    Cue cue = routeCue(CueKind::Prepare, CuePriority::Prepare, kPrepareSeconds);
    if (distanceIsGood()) cue.distanceM = measuredM + after->atM - next.atM;
    addManoeuvre(std::move(cue), *after, std::nullopt);
    m_cues.back().validIn.push_back(next.from);
    return true;
}

/// The way from where the region is entered to the manoeuvre, from the route's geometry.
std::optional<double> CueStep::legLength(const Manoeuvre& manoeuvre) const {
    std::optional<double> entry;
    for (const Manoeuvre& each : m_progress.route->manoeuvres) {
        if (each.atM >= manoeuvre.atM && entry) break;
        if (each.kind == ManoeuvreKind::Turn || each.atM > manoeuvre.atM) continue;
        if (each.access != manoeuvre.access || each.access.empty()) entry = each.atM;
    }
    if (!entry) return std::nullopt;
    return manoeuvre.atM - *entry;
}

/// Only the region is known: the manoeuvre is told on entering it, and again when it should have been
/// reached.
void CueStep::tellUnmeasured(const Manoeuvre& next) {
    double walked = kWalkingSpeed * (m_fix.time - m_memory.enteredAt);
    const Manoeuvre* due = &next;
    std::optional<Manoeuvre> after = m_progress.afterNext;
    bool turnIsOld = next.kind == ManoeuvreKind::Turn && m_memory.told.contains(keyOf(next)) &&
                     !toldRecently(m_memory.told, keyOf(next), m_options.repeatAfterSeconds);
    if (turnIsOld && after && after->from == next.from) {
        due = &*m_progress.afterNext; // a bend told long ago is passed by now, or will be felt
        after.reset();
    }
    std::optional<double> length = legLength(*due);
    double leg = length.value_or(0.0);
    std::string key = keyOf(*due);
    auto told = m_memory.told.find(key);
    if (told != m_memory.told.end()) {
        double since = m_fix.time - std::max(told->second, m_memory.routeToldAt.value_or(told->second));
        bool isSeen = unseen() <= kReassureEvidenceSeconds;
        if (since < m_options.repeatAfterSeconds || !isSeen || due->kind == ManoeuvreKind::Turn) return;
        if (leg - walked > m_options.prepareDistanceM) {
            tellReassurance(leg - walked);
            return;
        }
    }
    bool atOnce = told == m_memory.told.end() && leg <= m_options.actDistanceM;
    Cue cue = atOnce ? routeCue(CueKind::Act, CuePriority::ActNow, kActSeconds)
                     : routeCue(CueKind::Prepare, CuePriority::Prepare, kPrepareSeconds);
    cue.soon = length && leg - walked <= m_options.prepareDistanceM + kNoReassuranceM;
    addManoeuvre(std::move(cue), *due, after);
}

void CueStep::tellReassurance(double aheadM) {
    if (aheadM <= m_options.prepareDistanceM + kNoReassuranceM || unseen() > kReassureEvidenceSeconds) return;
    bool far = m_memory.remainingWhenTold && m_progress.remainingM &&
               *m_memory.remainingWhenTold - *m_progress.remainingM >= m_options.reassureEveryM;
    bool late = !(m_memory.remainingWhenTold && m_progress.remainingM) && m_memory.routeToldAt &&
                m_fix.time - *m_memory.routeToldAt >= m_options.reassureEverySeconds;
    if (!far && !late) return;
    Cue cue = routeCue(CueKind::Reassure, CuePriority::Reassurance, kReassureSeconds);
    if (distanceIsGood()) cue.distanceM = m_progress.distanceM;
    cue.validIn = {*m_fix.region};
    nameRegion(cue, m_progress.next->into);
    add(std::move(cue));
}

} // namespace farol::guidance
