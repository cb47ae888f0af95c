#include "core/guidance/route_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace farol::guidance {

using localisation::Fix;
using routing::Manoeuvre;
using routing::ManoeuvreKind;
using routing::Route;

namespace {

/// "You are there already" is told at once where it is as sure as of a start that was told, or was so and
/// nothing has spoken against it since.
constexpr double kAlreadyThere = 0.9, kAsLikelyAsNot = 0.5;

/// The vertex of the path at which a manoeuvre takes place: the nearest of its level, not before `from`.
std::size_t vertexOf(const Route& route, const Manoeuvre& manoeuvre, std::size_t from) {
    std::size_t best = std::min(from, route.path.size() - 1);
    double bestGap = std::numeric_limits<double>::infinity();
    for (std::size_t i = from; i < route.path.size(); ++i) {
        if (route.path[i].level != manoeuvre.level) continue;
        double gap = distance(route.path[i].position, manoeuvre.position);
        if (gap < bestGap - 1e-6) {
            best = i;
            bestGap = gap;
        }
    }
    return best;
}

/// Who is this far from where the way would have him, and farther with every observation, does not follow it.
constexpr double kAstrayM = 3.0;
constexpr double kSigmasAstray = 2.5;
constexpr double kGoodSigmaM = 1.6;
constexpr double kSureConfidence = 0.5;
constexpr double kStepM = 0.3;      // of a walker, between two observations that count
constexpr double kDirectionM = 1.0; // from so far on a displacement has a direction
constexpr int kObservationsAstray = 2;
/// Of an opening that leads to the destination: so near to it one has not arrived before so long.
constexpr double kThresholdM = 0.6, kThresholdSeconds = 8.0;

/// Does the way begin with the only access between where one is and where one was?
bool leadsBack(const building::Building& building, const Route& route, const RegionId& before) {
    if (route.accesses.empty() || route.regions.size() < 2 || route.regions[1] != before) return false;
    auto here = building.regionIndex(route.regions[0]), there = building.regionIndex(before);
    if (!here || !there) return false;
    int ways = 0;
    for (std::size_t access : building.accessesOf(*here)) {
        const building::Access& each = building.accesses()[access];
        ways += each.passable() && building.otherSide(each, *here) == there ? 1 : 0;
    }
    const building::Access* first = building.access(route.accesses.front());
    bool level = first != nullptr &&
                 (first->kind == building::AccessKind::Door || first->kind == building::AccessKind::Opening);
    return ways == 1 && level;
}

} // namespace

std::string travelName(Travel travel) {
    switch (travel) {
    case Travel::NoDestination:
        return "no_destination";
    case Travel::NoFix:
        return "no_fix";
    case Travel::OnRoute:
        return "on_route";
    case Travel::OffRoute:
        return "off_route";
    case Travel::Arrived:
        return "arrived";
    case Travel::Unreachable:
        return "unreachable";
    }
    return "unknown";
}

Result<void> TrackerOptions::check() const {
    if (offRouteFixes < 1) {
        return Error{ErrorCode::InvalidArgument, "a fix off the route has to come at least once",
                     "tracker.offRouteFixes"};
    }
    if (!(offRouteSeconds >= 0.0)) {
        return Error{ErrorCode::InvalidArgument, "a time is not negative", "tracker.offRouteSeconds"};
    }
    if (!(offRouteConfidence >= 0.0 && offRouteConfidence <= 1.0)) {
        return Error{ErrorCode::InvalidArgument, "a confidence is from 0 to 1", "tracker.offRouteConfidence"};
    }
    if (!(guessConfidence >= 0.0 && guessConfidence <= 1.0 && guessSeconds >= 0.0 &&
          hopelessConfidence >= 0.0 && hopelessConfidence <= 1.0)) {
        return Error{ErrorCode::InvalidArgument, "a confidence is from 0 to 1, a time not negative",
                     "tracker.guessConfidence"};
    }
    if (!(arrivalConfidence >= 0.0 && arrivalConfidence <= 1.0)) {
        return Error{ErrorCode::InvalidArgument, "a confidence is from 0 to 1", "tracker.arrivalConfidence"};
    }
    if (!(patientConfidence >= 0.0 && patientConfidence <= 1.0 && patientSeconds >= 0.0)) {
        return Error{ErrorCode::InvalidArgument, "a confidence is from 0 to 1, a time not negative",
                     "tracker.patientConfidence"};
    }
    if (!(minConfidence >= 0.0 && minConfidence <= 1.0)) {
        return Error{ErrorCode::InvalidArgument, "a confidence is from 0 to 1", "tracker.minConfidence"};
    }
    return {};
}

RouteTracker::RouteTracker(std::shared_ptr<const building::Building> building,
                           std::shared_ptr<const routing::Planner> planner, TrackerOptions options)
    : m_building(std::move(building)), m_planner(std::move(planner)), m_options(options) {}

void RouteTracker::setDestination(const std::optional<building::Location>& destination) {
    std::uint64_t version = m_progress.routeVersion;
    if (m_destination) ++version; // what was told of the way there is void at once, not with the next route
    m_destination = destination;
    m_progress = {};
    m_progress.routeVersion = version;
    if (destination) {
        m_progress.destination = destination->region;
        m_progress.travel = Travel::NoFix;
    }
    m_doubtfulFixes = 0;
    m_doubtCounted.reset();
    m_thereSince.reset();
    m_refusedFrom.reset();
    m_trail = {};
}

Progress RouteTracker::update(const Fix& fix) {
    m_progress.replanned = false;
    m_progress.deviation = Deviation::LeftRoute;
    m_progress.walking.reset();
    m_progress.backAgain = false;
    m_progress.distanceM.reset();
    m_progress.remainingM.reset();
    remember(fix);
    if (!m_destination) return m_progress;
    if (m_building->region(m_destination->region) == nullptr) {
        if (m_progress.travel != Travel::Unreachable) ++m_progress.routeVersion;
        refuse("the destination " + m_destination->region.value + " is not in the map");
        return m_progress;
    }
    bool usable =
        fix.region && m_building->regionIndex(*fix.region) && fix.confidence >= m_options.minConfidence;
    if (!usable) {
        m_thereSince.reset();
        // What is planned stays planned; where on it the user is, is not known now.
        if (m_progress.travel != Travel::Unreachable && m_progress.travel != Travel::Arrived) {
            m_progress.travel = Travel::NoFix;
        }
        return m_progress;
    }
    bool there = fix.region == m_destination->region && fix.confidence >= m_options.patientConfidence;
    if (!there)
        m_thereSince.reset();
    else if (!m_thereSince)
        m_thereSince = fix.time;
    if (m_progress.route) {
        follow(fix);
        if (m_progress.route) watch(fix);
    } else if ((isGuess(fix) || isBarelyThere(fix)) && !believed(fix)) {
        m_progress.travel = Travel::NoFix;
    } else if (m_refusedFrom != fix.region) {
        plan(fix);
    }
    describeNext(fix);
    return m_progress;
}

bool RouteTracker::isGuess(const Fix& fix) const {
    return fix.confidence < m_options.guessConfidence;
}

void RouteTracker::remember(const Fix& fix) {
    bool likely = fix.region && fix.confidence >= kAsLikelyAsNot;
    if (!likely || m_lately != fix.region) {
        m_lately = likely ? fix.region : std::nullopt;
        m_latelySure = false;
    }
    m_latelySure = m_latelySure || (likely && fix.confidence >= kAlreadyThere);
}

/// "You are there already" has to be true as well.
bool RouteTracker::isBarelyThere(const Fix& fix) const {
    return m_options.arrivalConfidence > 0.0 && fix.region == m_destination->region && !m_latelySure;
}

/// True once a surprising fix is to be acted on.
bool RouteTracker::believed(const Fix& fix) {
    if (m_doubtCounted != fix.evidenceTime) {
        if (++m_doubtfulFixes == 1) m_doubtSince = fix.time;
        m_doubtCounted = fix.evidenceTime;
    }
    bool arrival = m_options.arrivalConfidence > 0.0 && fix.region == m_destination->region;
    if (arrival) {
        bool sure = fix.confidence >= m_options.arrivalConfidence && m_doubtfulFixes > 1 && !onThreshold(fix);
        m_progress.doubtful = !sure && waitedLong(fix);
        return sure || m_progress.doubtful;
    }
    if (fix.confidence >= m_options.offRouteConfidence) return true;
    if (fix.confidence < m_options.hopelessConfidence) return false;
    double lasts = isGuess(fix) ? m_options.guessSeconds : m_options.offRouteSeconds;
    return m_doubtfulFixes >= m_options.offRouteFixes && fix.time - m_doubtSince >= lasts;
}

/// An opening has no leaf to pass: who is between its sides is as soon out again as in.
bool RouteTracker::onThreshold(const Fix& fix) const {
    if (!m_progress.route || m_progress.route->accesses.empty() || !fix.position || !m_thereSince)
        return false;
    const building::Access* last = m_building->access(m_progress.route->accesses.back());
    if (last == nullptr || last->kind != building::AccessKind::Opening || last->line.empty()) return false;
    double gap = distanceToSegment(*fix.position, last->line.front(), last->line.back());
    return gap < kThresholdM && fix.time - *m_thereSince < kThresholdSeconds;
}

bool RouteTracker::waitedLong(const Fix& fix) {
    if (m_options.patientSeconds <= 0.0 || !m_thereSince) return false;
    return fix.time - *m_thereSince >= m_options.patientSeconds;
}

void RouteTracker::settle() {
    m_doubtfulFixes = 0;
    m_doubtCounted.reset();
}

void RouteTracker::follow(const Fix& fix) {
    std::optional<std::size_t> index = onRoute(*fix.region);
    bool jumps = index && (*index > m_progress.regionsPassed + 1 || *index + 1 < m_progress.regionsPassed);
    // "Arrived" has to be true: one doubtful sight behind the last door is not enough.
    bool arrives =
        index && *index + 1 == m_progress.route->regions.size() && *index != m_progress.regionsPassed;
    if ((!index || jumps || arrives) && !believed(fix)) {
        if (m_progress.travel != Travel::Arrived) m_progress.travel = Travel::OnRoute;
    } else if (!index) {
        RegionId before = m_progress.route->regions[m_progress.regionsPassed];
        plan(fix);
        m_progress.replanned = true;
        m_progress.backAgain = m_progress.route && leadsBack(*m_building, *m_progress.route, before);
        if (m_progress.travel == Travel::OnRoute) m_progress.travel = Travel::OffRoute;
    } else {
        settle();
        m_progress.regionsPassed = *index;
        m_progress.travel =
            *index + 1 == m_progress.route->regions.size() ? Travel::Arrived : Travel::OnRoute;
    }
}

/// Where on the route a region is: the next time it is passed, else the last time it was.
std::optional<std::size_t> RouteTracker::onRoute(const RegionId& region) const {
    const std::vector<RegionId>& regions = m_progress.route->regions;
    auto current = regions.begin() + static_cast<std::ptrdiff_t>(m_progress.regionsPassed);
    auto ahead = std::find(current, regions.end(), region);
    if (ahead != regions.end()) return static_cast<std::size_t>(ahead - regions.begin());
    for (std::size_t i = m_progress.regionsPassed; i-- > 0;) {
        if (regions[i] == region) return i;
    }
    return std::nullopt;
}

void RouteTracker::refuse(const std::string& reason) {
    m_progress.travel = Travel::Unreachable;
    m_progress.reason = reason;
    m_progress.route.reset();
    m_progress.regionsPassed = 0;
    m_progress.next.reset();
    m_progress.afterNext.reset();
}

void RouteTracker::plan(const Fix& fix) {
    settle();
    // Only a position inside the region is one to plan from: a landmark may hang on the far side of its wall.
    building::Location from{*fix.region, std::nullopt};
    const building::Region* region = m_building->region(*fix.region);
    if (fix.position && contains(region->polygon, *fix.position)) from.position = fix.position;
    Result<Route> planned = m_planner->plan(from, *m_destination);
    // Trying again from another region, in vain, is nothing new to tell.
    bool refusedAgain = !planned && m_progress.travel == Travel::Unreachable;
    if (!refusedAgain) ++m_progress.routeVersion;
    if (!planned || planned->regions.empty() || planned->accesses.size() + 1 != planned->regions.size()) {
        refuse(planned ? "the planner gave no route" : planned.error().message);
        m_refusedFrom = fix.region;
        return;
    }
    m_refusedFrom.reset();
    m_trail = {};
    m_progress.reason.clear();
    m_progress.route = std::make_shared<const Route>(std::move(planned).value());
    m_progress.regionsPassed = 0;
    assignManoeuvres();
    m_progress.travel = m_progress.route->regions.size() == 1 ? Travel::Arrived : Travel::OnRoute;
}

/// In which region of the route each manoeuvre is done. Accesses that the route does not name belong to none.
void RouteTracker::assignManoeuvres() {
    const Route& route = *m_progress.route;
    m_regionOf.assign(route.manoeuvres.size(), std::nullopt);
    std::size_t region = 0;
    for (std::size_t i = 0; i < route.manoeuvres.size(); ++i) {
        const AccessId& access = route.manoeuvres[i].access;
        if (!access.empty()) {
            auto from =
                route.accesses.begin() + static_cast<std::ptrdiff_t>(std::min(region, route.accesses.size()));
            auto found = std::find(from, route.accesses.end(), access);
            if (found == route.accesses.end()) continue;
            region = static_cast<std::size_t>(found - route.accesses.begin());
        }
        m_regionOf[i] = region;
        if (!access.empty()) ++region;
    }
}

/// The spot of the way through the present region that is nearest to the user.
struct RouteTracker::Foot {
    double toEndM = 0.0; ///< walking distance from there to the region's exit
    double gapM = 0.0;
    bool atEntry = false;  ///< the very first point
    bool atCorner = false; ///< a later point at which the way bends or the region ends
};

std::optional<RouteTracker::Foot> RouteTracker::footOf(const Fix& fix, std::size_t exit) const {
    const Route& route = *m_progress.route;
    if (!fix.position || !isFinite(*fix.position) || route.path.empty()) return std::nullopt;
    const Manoeuvre& leaves = route.manoeuvres[exit];
    if (fix.level && *fix.level != leaves.level) return std::nullopt;
    std::size_t entry = 0;
    for (std::size_t i = 0; i < exit; ++i) {
        if (route.manoeuvres[i].access.empty()) continue;
        entry = vertexOf(route, route.manoeuvres[i], entry);
    }
    std::size_t end =
        leaves.kind == ManoeuvreKind::Arrive ? route.path.size() - 1 : vertexOf(route, leaves, entry);
    // Behind stairs and lifts the path goes on at the next vertex, on the level of the exit.
    while (entry < end && route.path[entry].level != leaves.level) ++entry;
    Foot foot;
    foot.gapM = std::numeric_limits<double>::infinity();
    double toEnd = 0.0;
    for (std::size_t i = end; i > entry; --i) {
        Point2 a = route.path[i - 1].position, b = route.path[i].position;
        Point2 nearest = nearestOnSegment(*fix.position, a, b);
        double gap = distance(*fix.position, nearest);
        if (gap < foot.gapM)
            foot = {toEnd + distance(nearest, b), gap, i - 1 == entry && nearest == a,
                    nearest == b || (nearest == a && i - 1 > entry)};
        toEnd += distance(a, b);
    }
    if (end == entry) foot = {0.0, distance(*fix.position, route.path[end].position), false, true};
    return foot;
}

std::optional<double> RouteTracker::walkedM(const Fix& fix, std::size_t exit) const {
    auto foot = footOf(fix, exit);
    if (!foot) return std::nullopt;
    return m_progress.route->manoeuvres[exit].atM - foot->toEndM;
}

/// The manoeuvre that leads out of a region of the route.
std::optional<std::size_t> RouteTracker::exitOf(std::size_t region) const {
    const std::vector<Manoeuvre>& manoeuvres = m_progress.route->manoeuvres;
    for (std::size_t i = 0; i < manoeuvres.size(); ++i) {
        bool leaves = manoeuvres[i].kind != ManoeuvreKind::Start && manoeuvres[i].kind != ManoeuvreKind::Turn;
        if (leaves && m_regionOf[i] && *m_regionOf[i] >= region) return i;
    }
    return std::nullopt;
}

/// Walks the user away from the way without leaving its regions? Backwards, or past the door or the bend.
/// Across a hall one may walk as one likes.
std::optional<Deviation> RouteTracker::straying(const Fix& fix) {
    bool counts = fix.position && fix.sigmaM <= kGoodSigmaM && fix.confidence >= kSureConfidence &&
                  *fix.region == m_progress.route->regions[m_progress.regionsPassed];
    double spotTime = fix.followed ? fix.time : fix.evidenceTime;
    if (!counts || m_trail.spotTime == spotTime) return std::nullopt;
    auto exit = exitOf(m_progress.regionsPassed);
    auto foot = exit ? footOf(fix, *exit) : std::nullopt;
    if (!foot) return std::nullopt;
    double walked = m_progress.route->manoeuvres[*exit].atM - foot->toEndM;
    double limit = std::max(kAstrayM, kSigmasAstray * fix.sigmaM);
    // Positions that come many times a second are a step apart only after some of them.
    bool moved = !m_trail.last || distance(*m_trail.last, *fix.position) >= kStepM;
    m_trail.spotTime = spotTime;
    if (!moved) return std::nullopt;
    bool back = walked < m_trail.farthestM - limit;
    bool away = foot->gapM >= limit && foot->gapM > m_trail.gapM && (foot->atEntry || foot->atCorner);
    m_trail.farthestM = std::max(m_trail.farthestM, walked);
    if (!back && !(foot->gapM >= kDirectionM && foot->gapM > m_trail.gapM) &&
        m_trail.farthestM <= walked + kStepM)
        m_trail.walkedFrom = fix.position;
    if (!m_trail.walkedFrom) m_trail.walkedFrom = fix.position;
    m_trail.gapM = foot->gapM;
    m_trail.last = fix.position;
    m_trail.astray = back || away ? m_trail.astray + 1 : 0;
    if (m_trail.astray < kObservationsAstray) return std::nullopt;
    return back || foot->atEntry ? Deviation::WrongWay : Deviation::Missed;
}

/// A way that the user does not follow is given up for one from where he is.
void RouteTracker::watch(const Fix& fix) {
    if (m_progress.travel != Travel::OnRoute) {
        m_trail = {};
        return;
    }
    auto deviation = straying(fix);
    if (!deviation) return;
    std::optional<Radians> walking;
    if (m_trail.walkedFrom && distance(*m_trail.walkedFrom, *fix.position) >= kDirectionM)
        walking = directionOf(*fix.position - *m_trail.walkedFrom);
    plan(fix);
    m_progress.replanned = true;
    m_progress.deviation = *deviation;
    m_progress.walking = walking;
    if (m_progress.travel == Travel::OnRoute) m_progress.travel = Travel::OffRoute;
}

void RouteTracker::describeNext(const Fix& fix) {
    m_progress.next.reset();
    m_progress.afterNext.reset();
    const Route* route = m_progress.route.get();
    bool underWay = m_progress.travel == Travel::OnRoute || m_progress.travel == Travel::OffRoute;
    if (route == nullptr || !underWay) return;
    const std::vector<Manoeuvre>& manoeuvres = route->manoeuvres;
    std::optional<std::size_t> first, exit;
    for (std::size_t i = 0; i < manoeuvres.size(); ++i) {
        std::optional<std::size_t> region = m_regionOf[i];
        if (manoeuvres[i].kind == ManoeuvreKind::Start || !region || *region < m_progress.regionsPassed)
            continue;
        if (!first) first = i;
        if (manoeuvres[i].kind == ManoeuvreKind::Turn) continue;
        exit = i;
        break;
    }
    if (!first || !exit) return;
    bool here = *fix.region == route->regions[m_progress.regionsPassed];
    std::optional<double> walked = here ? walkedM(fix, *exit) : std::nullopt;
    // A bend that lies behind the user is done.
    while (walked && *first < *exit && manoeuvres[*first].atM <= *walked) ++*first;
    m_progress.next = manoeuvres[*first];
    if (*first + 1 < manoeuvres.size()) m_progress.afterNext = manoeuvres[*first + 1];
    if (!walked) return;
    m_progress.distanceM = std::max(0.0, manoeuvres[*first].atM - *walked);
    m_progress.remainingM = std::max(0.0, route->lengthM - *walked);
}

localisation::RouteContext RouteTracker::context() const {
    localisation::RouteContext context;
    const Route* route = m_progress.route.get();
    if (route == nullptr) return context;
    auto current = route->regions.begin() + static_cast<std::ptrdiff_t>(m_progress.regionsPassed);
    context.regions.assign(current, route->regions.end());
    if (const building::Region* region = m_building->region(context.regions.front()))
        context.level = region->level;
    if (m_progress.regionsPassed < route->accesses.size()) {
        const AccessId& id = route->accesses[m_progress.regionsPassed];
        for (const Manoeuvre& manoeuvre : route->manoeuvres) {
            if (manoeuvre.access == id) context.nextAccess = manoeuvre.position;
        }
        const building::Access* access = m_building->access(id);
        if (!context.nextAccess && access != nullptr) context.nextAccess = access->midpoint();
    } else if (m_destination->position) {
        context.nextAccess = m_destination->position;
    }
    return context;
}

} // namespace farol::guidance
