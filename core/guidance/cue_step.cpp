#include "core/guidance/cue_step.h"

#include "core/base/text.h"
#include "core/guidance/clock.h"

#include <algorithm>
#include <cmath>

namespace farol::guidance {

using routing::Manoeuvre;
using routing::ManoeuvreKind;

namespace {

/// Below, a fix is no ground for any instruction.
constexpr double kUsableConfidence = 0.05;
/// How fast a position gets stale: the pace of a blind walker (routing::RouteOptions).
constexpr double kWalkingSpeed = 0.8;
/// An order to act rests on a position no older than this: 1.6 m of walking.
constexpr double kFreshSeconds = 2.0;
/// An order to act does not cut off the announcement of the same manoeuvre.
constexpr double kActAfterPrepareSeconds = 3.0;
/// What follows within this distance is told in the same breath.
constexpr double kCompoundM = 4.0;
/// The length of the way is told although the spot in the start region is unknown once it is longer than
/// this.
constexpr double kLongWayM = 20.0;
/// "Move forward" needs something seen within this time.
constexpr double kReassureEvidenceSeconds = 10.0;
constexpr double kAnnouncedIntoSeconds = 60.0;
/// Metres nearer to the destination from one observation to the next that count as moving along the route.
constexpr double kAdvanceM = 0.5;

constexpr double kActSeconds = 4.0, kPrepareSeconds = 6.0, kStartSeconds = 15.0, kReassureSeconds = 4.0,
                 kArrivalSeconds = 20.0, kOffRouteSeconds = 8.0, kUnsureSeconds = 6.0, kLocatedSeconds = 6.0,
                 kDetectionSeconds = 3.0, kTextSeconds = 4.0, kRefusalSeconds = 20.0;
constexpr double kSureScore = 0.5;
/// The first point of a way that is this far off tells in which direction it begins.
constexpr double kFacingM = 1.0;
/// Below, the user faces the way well enough to just walk.
constexpr Radians kTurnFirst = fromDegrees(60.0);

bool changesLevel(ManoeuvreKind kind) {
    return kind == ManoeuvreKind::Stairs || kind == ManoeuvreKind::Elevator ||
           kind == ManoeuvreKind::Escalator;
}

/// The manoeuvre to tell together with the one before it. After stairs and lifts one has to find one's
/// bearings first.
std::optional<Manoeuvre> inTheSameBreath(const Manoeuvre& first, const std::optional<Manoeuvre>& second) {
    if (!second || changesLevel(first.kind) || second->kind == ManoeuvreKind::Start) return std::nullopt;
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
    m_usable = fix.region.has_value() && fix.confidence >= kUsableConfidence;
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

void CueStep::add(Cue cue) {
    if (cue.routeVersion != 0) {
        m_routeTold = true;
        m_memory.routeToldAt = m_fix.time;
        m_memory.remainingWhenTold = m_progress.remainingM;
    }
    m_cues.push_back(std::move(cue));
}

void CueStep::nameRegion(Cue& cue, const RegionId& region) const {
    cue.region = region;
    const building::Region* known = m_building.region(region);
    cue.regionName = known != nullptr ? building::spokenName(*known) : region.value;
}

std::string CueStep::levelName(double ordinal, bool asOnButtons) const {
    const building::Level* level = m_building.level(ordinal);
    if (level == nullptr) return formatNumber(ordinal);
    const std::string& first = asOnButtons ? level->ref : level->name;
    const std::string& second = asOnButtons ? level->name : level->ref;
    if (!first.empty()) return first;
    return second.empty() ? formatNumber(ordinal) : second;
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

/// Only from a measured way of walking, while the user follows the route, and only when what is ahead is far
/// enough away for its direction to mean something.
std::optional<int> CueStep::hourTo(const Manoeuvre& manoeuvre) const {
    bool along = m_memory.advance && m_memory.advance->along;
    if (!m_sure || !along || !m_fix.heading || !m_fix.position || age() > kFreshSeconds) return std::nullopt;
    if (!m_fix.level || *m_fix.level != manoeuvre.level) return std::nullopt;
    Point2 ahead = manoeuvre.position - *m_fix.position;
    if (length(ahead) < 2.0 * m_fix.sigmaM || length(ahead) < 1.0) return std::nullopt;
    return clockHour(directionOf(ahead) - *m_fix.heading);
}

/// How far the user has to turn to face the way that begins here. Only a trained place tells which way one
/// faces; the way of walking from two rough positions is no ground for such an order.
std::optional<Radians> CueStep::turnFirst() const {
    if (!m_usable || !m_fix.heading || !m_fix.position || age() > kFreshSeconds || !m_progress.route)
        return std::nullopt;
    const building::Landmark* seen = m_building.landmark(m_fix.landmark);
    if (seen == nullptr || seen->kind != Kind::Place) return std::nullopt;
    const std::vector<routing::PathPoint>& path = m_progress.route->path;
    for (const routing::PathPoint& point : path) {
        if (point.level != path.front().level || point.level != m_fix.level) return std::nullopt;
        Point2 ahead = point.position - path.front().position;
        if (length(ahead) < kFacingM) continue;
        Radians turn = wrapped(directionOf(ahead) - *m_fix.heading);
        return std::abs(turn.value) >= kTurnFirst.value ? std::optional(turn) : std::nullopt;
    }
    return std::nullopt;
}

/// A cue about a manoeuvre: what it leads into, what follows at once, and where it still holds.
void CueStep::addManoeuvre(Cue cue, const Manoeuvre& manoeuvre, const std::optional<Manoeuvre>& after) {
    cue.manoeuvre = manoeuvre;
    cue.next = inTheSameBreath(manoeuvre, after);
    if (cue.region.empty()) nameRegion(cue, manoeuvre.into);
    if (const building::Region* into = m_building.region(manoeuvre.into)) {
        cue.intoName = building::spokenName(*into);
        m_memory.announcedInto[manoeuvre.into] = m_fix.time;
    }
    if (manoeuvre.targetLevel != manoeuvre.level || changesLevel(manoeuvre.kind)) {
        cue.levelName = levelName(manoeuvre.targetLevel, manoeuvre.kind == ManoeuvreKind::Elevator);
    }
    if (!manoeuvre.from.empty()) cue.validIn = {manoeuvre.from};
    m_memory.told[keyOf(manoeuvre)] = m_fix.time;
    if (cue.kind == CueKind::Act) m_memory.acted[keyOf(manoeuvre)] = m_fix.time;
    // Stairs and lifts are told once more by themselves, with their steps and the level.
    if (cue.next && !changesLevel(cue.next->kind)) m_memory.told[keyOf(*cue.next)] = m_fix.time;
    add(std::move(cue));
}

void CueStep::tellRoute() {
    bool newRoute = m_progress.routeVersion != m_memory.version;
    if (newRoute) {
        // Nothing of the old route is left over.
        m_memory.version = m_progress.routeVersion;
        m_memory.regionIndex.reset();
        m_memory.told.clear();
        m_memory.acted.clear();
        m_memory.announcedInto.clear();
        m_memory.routeToldAt.reset();
        m_memory.remainingWhenTold.reset();
        m_memory.arrivedToldAt.reset();
        m_memory.advance.reset();
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

void CueStep::tellArrival() {
    bool there = m_progress.route && m_progress.route->accesses.empty();
    if (m_memory.arrivedToldAt && m_memory.regionIndex == m_progress.regionsPassed) return;
    m_memory.regionIndex = m_progress.regionsPassed;
    if (m_memory.arrivedToldAt && m_fix.time - *m_memory.arrivedToldAt < m_options.repeatAfterSeconds) return;
    m_memory.arrivedToldAt = m_fix.time;
    Cue cue =
        routeCue(there ? CueKind::AlreadyThere : CueKind::Arrived, CuePriority::Arrival, kArrivalSeconds);
    nameRegion(cue, m_progress.destination);
    cue.validIn = {m_progress.destination};
    add(std::move(cue));
}

void CueStep::tellStart() {
    m_memory.regionIndex = m_progress.regionsPassed;
    m_memory.enteredAt = m_fix.time;
    Cue cue = routeCue(CueKind::RouteStart, CuePriority::Prepare, kStartSeconds);
    nameRegion(cue, m_progress.destination);
    double length = m_progress.route->lengthM;
    if (m_fix.position || length >= kLongWayM) cue.distanceM = length;
    cue.turnFirst = turnFirst();
    if (m_progress.next)
        addManoeuvre(std::move(cue), *m_progress.next, m_progress.afterNext);
    else
        add(std::move(cue));
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
    cue.turnFirst = turnFirst();
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
    if (!last)
        last = {m_fix.evidenceTime, remaining, false};
    else if (last->evidenceTime != m_fix.evidenceTime) {
        last = {m_fix.evidenceTime, remaining, last->remainingM - remaining >= kAdvanceM};
    }
}

void CueStep::tellManoeuvre() {
    bool here = m_usable && *m_fix.region == m_progress.route->regions[m_progress.regionsPassed];
    if (!here || !m_progress.next) return;
    const Manoeuvre& next = *m_progress.next;
    bool entered = m_memory.regionIndex != m_progress.regionsPassed;
    if (entered) {
        m_memory.regionIndex = m_progress.regionsPassed;
        m_memory.enteredAt = m_fix.time;
    }
    if (!m_progress.distanceM) {
        tellUnmeasured(next);
        return;
    }
    double measured = *m_progress.distanceM;
    double expected = std::max(0.0, measured - kWalkingSpeed * age());
    std::string key = keyOf(next);
    bool isTold = m_memory.told.contains(key);
    bool near = measured <= m_options.actDistanceM && age() <= kFreshSeconds;
    // An object can be recognised from several metres away: its place on the map is not where the user
    // stands.
    if (near && m_fix.sigmaM <= m_options.maxSigmaForActM) {
        bool holdBack = toldRecently(m_memory.told, key, kActAfterPrepareSeconds) ||
                        toldRecently(m_memory.acted, key, m_options.repeatAfterSeconds);
        if (holdBack) return;
        Cue cue = routeCue(CueKind::Act, CuePriority::ActNow, kActSeconds);
        addManoeuvre(std::move(cue), next, m_progress.afterNext);
    } else if (expected <= m_options.prepareDistanceM) {
        bool again = near && !toldRecently(m_memory.told, key, m_options.repeatAfterSeconds);
        if (isTold && !again) return;
        Cue cue = routeCue(CueKind::Prepare, CuePriority::Prepare, kPrepareSeconds);
        if (distanceIsGood()) cue.distanceM = measured;
        cue.hour = hourTo(next);
        addManoeuvre(std::move(cue), next, m_progress.afterNext);
    } else {
        tellReassurance(expected);
    }
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
    double leg = legLength(*due).value_or(0.0);
    std::string key = keyOf(*due);
    auto told = m_memory.told.find(key);
    if (told != m_memory.told.end()) {
        double since = m_fix.time - std::max(told->second, m_memory.routeToldAt.value_or(told->second));
        bool isSeen = age() <= kReassureEvidenceSeconds;
        if (since < m_options.repeatAfterSeconds || !isSeen || due->kind == ManoeuvreKind::Turn) return;
        if (leg - walked > m_options.prepareDistanceM) {
            tellReassurance(leg - walked);
            return;
        }
    }
    bool atOnce = told == m_memory.told.end() && leg <= m_options.actDistanceM;
    Cue cue = atOnce ? routeCue(CueKind::Act, CuePriority::ActNow, kActSeconds)
                     : routeCue(CueKind::Prepare, CuePriority::Prepare, kPrepareSeconds);
    addManoeuvre(std::move(cue), *due, after);
}

void CueStep::tellReassurance(double aheadM) {
    if (aheadM <= m_options.prepareDistanceM || age() > kReassureEvidenceSeconds) return;
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

namespace {

/// Empty: the look around is over and found nothing.
std::optional<SweepStep> following(SweepStep step) {
    switch (step) {
    case SweepStep::Right:
        return SweepStep::Left;
    case SweepStep::Left:
        return SweepStep::Up;
    case SweepStep::Up:
        return SweepStep::Down;
    case SweepStep::Down:
        return SweepStep::AskForHelp;
    case SweepStep::None:
    case SweepStep::AskForHelp:
    case SweepStep::Done:
        break;
    }
    return std::nullopt;
}

} // namespace

void CueStep::tellSweep(SweepStep step) {
    m_memory.sweep = SchedulerMemory::Sweep{step, m_fix.time};
    Cue cue = cueOf(CueKind::Unsure, CuePriority::OffRoute, kUnsureSeconds);
    cue.sweep = step;
    cue.detail = m_fix.note;
    add(std::move(cue));
}

/// Unsure is also who was seen where the route does not expect it, once only: looking around settles it.
void CueStep::tellUnsure() {
    bool underWay = m_progress.route && m_progress.travel == Travel::OnRoute;
    bool asExpected = !underWay || m_fix.region == m_progress.route->regions[m_progress.regionsPassed];
    if (m_usable && asExpected) {
        // Who was just told to turn has to be told to stop turning, at once.
        bool turning = m_memory.sweep && following(m_memory.sweep->step) &&
                       m_fix.time - m_memory.sweep->toldAt <= 2.0 * m_options.sweepStepSeconds;
        if (turning) tellSweep(SweepStep::Done);
        m_memory.unusableSince.reset();
        m_memory.sweep.reset();
        return;
    }
    if (!m_memory.unusableSince) m_memory.unusableSince = m_fix.time;
    if (m_fix.time - *m_memory.unusableSince < m_options.unsureAfterSeconds) return;
    if (!m_memory.sweep) {
        tellSweep(SweepStep::Right);
        return;
    }
    // Without a destination nobody waits for directions: asked once, not led through a look around.
    if (m_progress.destination.empty()) return;
    double since = m_fix.time - m_memory.sweep->toldAt;
    std::optional<SweepStep> next = following(m_memory.sweep->step);
    if (next && since >= m_options.sweepStepSeconds) tellSweep(*next);
    if (!next && since >= m_options.unsureRepeatSeconds) tellSweep(SweepStep::Right);
}

/// Where the user is, when that changed and no instruction says it already.
void CueStep::tellRegion() {
    if (!m_usable) return;
    const RegionId& region = *m_fix.region;
    SchedulerMemory::Candidate& candidate = m_memory.candidate;
    if (candidate.region != region)
        candidate = {region, m_fix.evidenceTime, 1};
    else if (candidate.evidenceTime != m_fix.evidenceTime) {
        candidate.evidenceTime = m_fix.evidenceTime;
        ++candidate.fixes;
    }
    if (m_memory.located == region) return;
    if (m_routeTold) {
        m_memory.located = region;
        m_memory.locatedAt[region] = m_fix.time;
        return;
    }
    if (!m_sure && candidate.fixes < 2) return;
    m_memory.located = region;
    auto recent = [&](const std::map<RegionId, double>& times, double seconds) {
        auto found = times.find(region);
        return found != times.end() && m_fix.time - found->second < seconds;
    };
    bool isKnown = recent(m_memory.announcedInto, kAnnouncedIntoSeconds) ||
                   recent(m_memory.locatedAt, m_options.repeatAfterSeconds);
    m_memory.locatedAt[region] = m_fix.time;
    if (isKnown) return;
    Cue cue = cueOf(CueKind::Located, CuePriority::Detection, kLocatedSeconds);
    nameRegion(cue, region);
    const building::Region* known = m_building.region(region);
    if (known != nullptr && m_building.levels().size() > 1) cue.levelName = levelName(known->level, false);
    cue.validIn = {region};
    add(std::move(cue));
}

void CueStep::tellObjects(const std::vector<localisation::Observation>& fresh) {
    if (m_options.verbosity == Verbosity::Directions) return;
    for (const localisation::Observation& observation : fresh) {
        const recognition::Detection& seen = observation.detection;
        bool isText = seen.kind == Kind::Text;
        if (seen.kind == Kind::Place || (isText && m_options.verbosity != Verbosity::ObjectsAndTexts))
            continue;
        if (isText && seen.text.empty()) continue;
        std::string key(kindName(seen.kind));
        key += " " + seen.templateId.value + " " + foldedForMatching(seen.text);
        if (toldRecently(m_memory.objectsToldAt, key, m_options.objectRepeatSeconds)) continue;
        m_memory.objectsToldAt[key] = m_fix.time;
        Cue cue = cueOf(isText ? CueKind::Text : CueKind::Detection, CuePriority::Detection,
                        isText ? kTextSeconds : kDetectionSeconds);
        cue.objectKind = seen.kind;
        cue.zone = seen.zone();
        cue.text = seen.text;
        cue.sure = seen.score >= kSureScore;
        add(std::move(cue));
    }
}

} // namespace farol::guidance
