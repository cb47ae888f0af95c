// What the user asks for, as cues made for the present place: never the sentence of a moment ago.

#include "core/building/sayable.h"
#include "core/guidance/cue_step.h"
#include "core/guidance/on_the_way.h"

#include <algorithm>
#include <cmath>

namespace farol::guidance {

using building::Access;
using routing::Manoeuvre;
using routing::ManoeuvreKind;

namespace {

/// The answer waits behind more urgent words for no longer than this.
constexpr double kAnswerSeconds = 15.0;
/// "In or next to" has to be true.
constexpr double kNearConfidence = 0.8;
constexpr double kAnswerFreshSeconds = 3.0;
constexpr Radians kGoodHeading = fromDegrees(30.0);
constexpr double kLandmarkM = 8.0;
constexpr double kHereM = 0.7; // nearer, a thing has no direction
constexpr std::size_t kMostAround = 6;

/// Is there no wall of the region between? What lies on its border counts as within it.
bool isInSight(const building::Region& region, Point2 here, Point2 there) {
    constexpr double kBorderM = 0.3;
    double size = distance(here, there);
    if (size <= kBorderM || !contains(region.polygon, here)) return true;
    Point2 shortOf = there + (here - there) * (kBorderM / size);
    auto isCut = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (segmentsCross(here, shortOf, ring[i], ring[(i + 1) % ring.size()])) return true;
        return false;
    };
    if (isCut(region.polygon.outer)) return false;
    return std::none_of(region.polygon.holes.begin(), region.polygon.holes.end(), isCut);
}

/// Of a wide opening the nearest part that one can pass through, not its middle.
Point2 nearestWithin(const Polyline& line, Point2 here) {
    constexpr double kShoulderM = 0.5;
    Point2 a = line.front(), b = line.back();
    double width = distance(a, b);
    if (line.size() != 2 || width <= 2.0 * kShoulderM) return (a + b) * 0.5;
    Point2 shoulder = (b - a) * (kShoulderM / width);
    return nearestOnSegment(here, a + shoulder, b - shoulder);
}

bool isWorthTelling(Kind kind) {
    return kind != Kind::Place && kind != Kind::Rectangle && kind != Kind::Other && kind != Kind::Door;
}

} // namespace

Cue CueStep::answer(Question question) const {
    Cue cue;
    switch (question) {
    case Question::WhereAmI:
        cue = answerWhere();
        break;
    case Question::AroundMe:
        cue = answerAround();
        break;
    case Question::Next:
        cue = answerNext();
        break;
    case Question::Repeat:
        cue = m_progress.destination.empty() ? answerWhere() : answerNext();
        break;
    case Question::Remaining:
    case Question::Preview:
        cue = answerList(question == Question::Preview);
        break;
    }
    cue.asked = true;
    cue.priority = CuePriority::Answer;
    cue.validUntil = m_fix.time + kAnswerSeconds;
    // Asked for now, so it is wanted now, even on a border between two regions.
    cue.validIn.clear();
    return cue;
}

/// The order of the look around that is due, or its first one.
Cue CueStep::lookAround() const {
    Cue cue = cueOf(CueKind::Unsure, CuePriority::Answer, kAnswerSeconds);
    bool under = m_memory.sweep && m_memory.sweep->step != SweepStep::Done && !m_usable;
    cue.sweep = under ? m_memory.sweep->step : SweepStep::Right;
    cue.detail = m_fix.note;
    return cue;
}

Cue CueStep::answerWhere() const {
    bool near = m_usable && (m_sure || m_fix.nearConfidence >= kNearConfidence);
    if (!near || m_building.region(*m_fix.region) == nullptr) return lookAround();
    Cue cue = cueOf(CueKind::Located, CuePriority::Answer, kAnswerSeconds);
    nameRegion(cue, *m_fix.region);
    if (m_building.levels().size() > 1)
        cue.levelName = levelName(m_building.region(*m_fix.region)->level, false);
    return cue;
}

/// What directions can count from now; `zero` is that direction on the map.
Bearing CueStep::bearing(Radians& zero) const {
    if (!m_sure || !m_fix.position || !m_fix.level) return Bearing::None;
    const building::Landmark* seen = m_building.landmark(m_fix.landmark);
    bool place = seen != nullptr && seen->kind == Kind::Place;
    bool measured = m_fix.headingSigma.value > 0.0 && m_fix.headingSigma.value <= kGoodHeading.value;
    if (m_fix.heading && (place || measured) && age() <= kAnswerFreshSeconds) {
        zero = *m_fix.heading;
        return Bearing::Facing;
    }
    if (m_progress.travel == Travel::OnRoute && m_progress.route) {
        if (auto way = wayDirection(*m_progress.route, *m_fix.position, *m_fix.level)) {
            zero = *way;
            return Bearing::AlongWay;
        }
    }
    zero = fromDegrees(90.0);
    return Bearing::Map;
}

void CueStep::place(Surrounding& what, Point2 position, Bearing bearing, Radians zero) const {
    if (bearing == Bearing::None) return;
    Point2 way = position - *m_fix.position;
    what.distanceM = length(way);
    if (length(way) > std::max(kHereM, m_fix.sigmaM)) what.direction = wrapped(directionOf(way) - zero);
}

std::vector<Surrounding> CueStep::accessesAround(std::size_t region, Bearing bearing, Radians zero) const {
    std::vector<Surrounding> found;
    for (std::size_t index : m_building.accessesOf(region)) {
        const Access& access = m_building.accesses()[index];
        auto other = m_building.otherSide(access, region);
        if (!other || !access.passable()) continue;
        const building::Region& here = m_building.regions()[region];
        const building::Region& behind = m_building.regions()[*other];
        // In the car one knows that there is a lift.
        if (here.kind == building::RegionKind::Elevator && behind.kind == here.kind) continue;
        Surrounding what;
        what.access = routing::manoeuvreKindOf(access.kind);
        what.name = building::sayableName(behind, m_options.language);
        what.behind = behind.kind;
        double rise = behind.level - here.level;
        if (rise != 0.0) what.vertical = rise > 0.0 ? routing::Vertical::Up : routing::Vertical::Down;
        if (!access.line.empty()) {
            bool wide = access.line.size() == 2 && m_fix.position;
            Point2 at = wide ? nearestWithin(access.line, *m_fix.position) : access.midpoint();
            // "On your left" would be the wall that it lies behind.
            if (bearing != Bearing::None && !isInSight(here, *m_fix.position, at)) continue;
            place(what, at, bearing, zero);
        }
        found.push_back(std::move(what));
    }
    return found;
}

std::vector<Surrounding> CueStep::landmarksAround(std::size_t region, Bearing bearing, Radians zero) const {
    std::vector<Surrounding> found;
    if (bearing == Bearing::None) return found;
    for (std::size_t index : m_building.landmarksOf(region)) {
        const building::Landmark& landmark = m_building.landmarks()[index];
        if (!isWorthTelling(landmark.kind)) continue;
        Surrounding what;
        what.kind = landmark.kind;
        what.name = building::isSayable(landmark.text) ? landmark.text : std::string();
        if (!isInSight(m_building.regions()[region], *m_fix.position, landmark.position)) continue;
        place(what, landmark.position, bearing, zero);
        if (what.distanceM && *what.distanceM <= kLandmarkM) found.push_back(std::move(what));
    }
    return found;
}

Cue CueStep::answerAround() const {
    Cue cue = answerWhere();
    if (cue.kind != CueKind::Located) return cue;
    cue.kind = CueKind::Around;
    auto region = m_building.regionIndex(*m_fix.region);
    Radians zero;
    cue.bearing = bearing(zero);
    cue.around = accessesAround(*region, cue.bearing, zero);
    for (Surrounding& each : landmarksAround(*region, cue.bearing, zero))
        cue.around.push_back(std::move(each));
    std::stable_sort(cue.around.begin(), cue.around.end(), [](const Surrounding& a, const Surrounding& b) {
        return a.distanceM.value_or(0.0) < b.distanceM.value_or(0.0);
    });
    if (cue.around.size() > kMostAround) cue.around.resize(kMostAround);
    return cue;
}

Cue CueStep::answerRefusal() const {
    Cue cue = cueOf(CueKind::NoRoute, CuePriority::Answer, kAnswerSeconds);
    if (m_progress.destination.empty()) {
        cue.reason = CueReason::NoDestination;
        return cue;
    }
    bool known = m_building.region(m_progress.destination) != nullptr;
    cue.reason = known ? CueReason::DestinationUnreachable : CueReason::DestinationUnknown;
    cue.detail = m_progress.reason;
    nameRegion(cue, m_progress.destination);
    return cue;
}

Cue CueStep::answerNext() const {
    bool refused = m_progress.travel == Travel::NoDestination || m_progress.travel == Travel::Unreachable;
    if (refused) return answerRefusal();
    if (!m_usable || m_progress.travel == Travel::NoFix) return lookAround();
    if (m_progress.travel == Travel::Arrived) return arrivalCue();
    if (!m_progress.next) return lookAround();
    bool isNear = m_progress.distanceM && *m_progress.distanceM <= m_options.actDistanceM &&
                  age() <= kAnswerFreshSeconds && m_fix.sigmaM <= m_options.maxSigmaForActM;
    Cue cue = routeCue(isNear ? CueKind::Act : CueKind::Prepare, CuePriority::Answer, kAnswerSeconds);
    if (!isNear && distanceIsGood()) cue.distanceM = m_progress.distanceM;
    cue.soon = isSoon();
    fillManoeuvre(cue, *m_progress.next, m_progress.afterNext);
    locate(cue, *m_progress.next);
    if (!isNear && cue.facingWay && !cue.turnFirst && !cue.manoeuvre->alongWall)
        cue.mark = mark(*m_progress.next);
    return cue;
}

std::vector<Cue> CueStep::stepsFrom(std::size_t first, bool fromHere) const {
    const std::vector<Manoeuvre>& all = m_progress.route->manoeuvres;
    std::vector<Cue> steps;
    for (std::size_t i = first; i < all.size(); ++i) {
        if (all[i].kind == ManoeuvreKind::Start || all[i].kind == ManoeuvreKind::Arrive) continue;
        if (staysInLift(all[i])) continue;
        Cue cue = routeCue(CueKind::Act, CuePriority::Answer, kAnswerSeconds);
        cue.sure = true; // the plan is; where on it the user is, the answer says as a whole
        std::optional<Manoeuvre> after;
        if (i + 1 < all.size() && all[i + 1].kind == ManoeuvreKind::Arrive) after = all[i + 1];
        fillManoeuvre(cue, all[i], after);
        bool isFirst = steps.empty();
        if (isFirst) cue.facingWay = facesWay();
        if (isFirst && fromHere) countDoors(*cue.manoeuvre);
        if (all[i].alongWall && !cue.manoeuvre->alongWall) cue.facingWay = false;
        steps.push_back(std::move(cue));
    }
    return steps;
}

/// `whole`: from where the route begins, else from here.
Cue CueStep::answerList(bool whole) const {
    bool refused = m_progress.travel == Travel::NoDestination || m_progress.travel == Travel::Unreachable;
    if (refused) return answerRefusal();
    if (m_progress.travel == Travel::Arrived) return arrivalCue();
    if (!m_progress.route) return lookAround();
    if (!whole && (!m_usable || !m_progress.next)) return lookAround();
    Cue cue = routeCue(CueKind::Itinerary, CuePriority::Answer, kAnswerSeconds);
    nameRegion(cue, m_progress.destination);
    const std::vector<Manoeuvre>& all = m_progress.route->manoeuvres;
    std::size_t first = 0;
    while (!whole && first < all.size() && all[first].atM + 1e-6 < m_progress.next->atM) ++first;
    cue.distanceM = whole ? std::optional(m_progress.route->lengthM) : m_progress.remainingM;
    if (!whole && !placeIsGood()) cue.distanceM.reset();
    cue.steps = stepsFrom(first, !whole || m_progress.regionsPassed == 0);
    return cue;
}

} // namespace farol::guidance
