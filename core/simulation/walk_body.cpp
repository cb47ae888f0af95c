#include "core/simulation/walk_body.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace farol::simulation {

using building::AccessKind;

namespace {

constexpr double kPassingSpeed = 0.6, kFindHandleS = 2.0, kStairsSPerLevel = 18.0, kLiftWaitS = 12.0,
                 kLiftSPerLevel = 5.0, kLeastClimbS = 2.0;
constexpr Radians kTurnRate = fromDegrees(90.0);
/// Where one stands to open a door.
constexpr double kBeforeM = 0.4;
/// A lift's car is felt whole; stairs are found by the foot or the cane where they are drawn. A point on the
/// map stands for a flight that is a metre or more wide and some metres long.
constexpr double kCarReachM = 3.0, kFlightM = 1.5;

Point2 unitOf(Radians direction) {
    return {std::cos(direction.value), std::sin(direction.value)};
}

} // namespace

Result<void> WalkerOptions::check() const {
    const std::array<double, 11> values{speed,          speedSpread,    overshootDeg, overshootSpreadDeg,
                                        veerDegPerM,    caneReachM,     swayDeg,      swaySeconds,
                                        stopsPerSecond, looksPerSecond, wilfulness};
    for (double value : values)
        if (!std::isfinite(value) || value < 0.0)
            return Error{ErrorCode::InvalidArgument, "what a walker does is told in numbers from 0 on",
                         "walker"};
    if (speed < 0.1 || speed > 2.5)
        return Error{ErrorCode::InvalidArgument, "people walk at 0.1 to 2.5 metres a second", "walker.speed"};
    if (swaySeconds <= 0.0 || wilfulness > 1.0)
        return Error{ErrorCode::InvalidArgument, "a sway takes time, and a chance is at most 1", "walker"};
    return {};
}

WalkBody::WalkBody(std::shared_ptr<const WalkWorld> world, std::size_t region, Point2 position,
                   Radians heading, const WalkerOptions& options)
    : m_world(std::move(world)),
      m_options(options),
      m_region(region),
      m_position(m_world->standing(region, position)),
      m_level(m_world->building().regions()[region].level),
      m_heading(wrapped(heading)) {}

void WalkBody::step(double seconds, double speed, Radians turnRate) {
    Radians before = m_heading;
    Point2 from = m_position;
    if (busy()) {
        followLeg(seconds);
    } else {
        m_heading = wrapped(m_heading + Radians{turnRate.value * seconds});
        if (speed > 0.0) walkFreely(seconds, speed);
    }
    double gone = distance(from, m_position);
    m_walkedM += gone;
    m_speed = gone / seconds;
    m_turnRate = Radians{wrapped(m_heading - before).value / seconds};
}

void WalkBody::walkFreely(double seconds, double speed) {
    Point2 to = m_position + unitOf(m_heading) * (speed * seconds);
    if (const Passage* gap = m_world->crossed(m_region, m_position, to)) {
        beginPassage(*gap, nearestOnSegment(to, gap->gap.a, gap->gap.b), 0.0);
        return;
    }
    m_position = m_world->moved(m_region, m_position, to);
}

void WalkBody::beginPassage(const Passage& passage, Point2 at, double waitS) {
    if (waitS > 0.0) {
        Point2 before = at - passage.outward * kBeforeM;
        if (m_world->inside(m_region, before)) m_legs.push_back({before});
    }
    Leg through{at, waitS};
    through.region = passage.into;
    through.through = passage.access;
    m_legs.push_back(through);
    m_legs.push_back({m_world->landing(passage, at)});
}

void WalkBody::ride(const Passage& first, const std::string& level) {
    const building::Building& building = m_world->building();
    auto isCalled = [&](std::size_t region) {
        const building::Level* known = building.level(building.regions()[region].level);
        return known != nullptr && (known->ref == level || known->name == level);
    };
    const Passage* passage = &first;
    std::vector<const Passage*> ride{passage};
    bool wanted = !level.empty() && first.kind == AccessKind::Elevator;
    while (wanted && !isCalled(passage->into) && ride.size() < building.levels().size()) {
        const Passage* next = nullptr;
        for (const Passage& each : m_world->passagesOf(passage->into))
            if (each.kind == passage->kind && each.climb * passage->climb > 0.0) next = &each;
        if (next == nullptr) break;
        ride.push_back(passage = next);
    }
    if (wanted && !isCalled(passage->into)) ride.resize(1); // no such button: the next level
    Point2 at = nearestOnSegment(m_position, first.gap.a, first.gap.b);
    m_legs.push_back({m_world->standing(m_region, at)});
    for (std::size_t i = 0; i < ride.size(); ++i) {
        const Passage& each = *ride[i];
        bool lift = each.kind == AccessKind::Elevator;
        Leg leg{m_legs.back().to, lift && i == 0 ? kLiftWaitS : 0.0};
        leg.climbFrom = building.regions()[each.from].level;
        leg.climbTo = building.regions()[each.into].level;
        double levels = std::abs(leg.climbTo - leg.climbFrom);
        leg.climbS = std::max(kLeastClimbS, levels * (lift ? kLiftSPerLevel : kStairsSPerLevel));
        leg.region = each.into;
        leg.through = each.access;
        m_legs.push_back(leg);
    }
    m_legs.push_back({m_world->landing(*ride.back(), m_legs.back().to)});
}

void WalkBody::take(const Felt& felt, const std::string& level) {
    if (busy()) return;
    for (const Passage& passage : m_world->passagesOf(m_region)) {
        if (passage.access != felt.handle) continue;
        if (passage.changesLevel())
            ride(passage, level);
        else
            beginPassage(passage, (passage.gap.a + passage.gap.b) * 0.5,
                         passage.kind == AccessKind::Door ? kFindHandleS : 0.001);
        return;
    }
}

void WalkBody::stop() {
    bool before =
        std::any_of(m_legs.begin(), m_legs.end(), [](const Leg& leg) { return leg.through.has_value(); });
    bool climbs = std::any_of(m_legs.begin(), m_legs.end(), [](const Leg& leg) { return leg.climbS > 0.0; });
    if (before && !climbs) m_legs.clear();
}

void WalkBody::followLeg(double seconds) {
    Leg& leg = m_legs.front();
    if (leg.waitS > 0.0) {
        leg.waitS -= seconds;
        return;
    }
    Point2 way = leg.to - m_position;
    double left = length(way);
    if (left > 1e-6) {
        double off = wrapped(directionOf(way) - m_heading).value, most = kTurnRate.value * seconds;
        m_heading = wrapped(m_heading + Radians{std::clamp(off, -most, most)});
        if (std::abs(off) > kPi / 4.0) return; // turns first
        double gone = std::min(left, kPassingSpeed * seconds);
        m_position = m_position + way * (gone / left);
        if (gone < left) return;
    }
    m_position = leg.to;
    if (leg.climbS > 0.0 && leg.climbedS < leg.climbS) {
        leg.climbedS += seconds;
        double share = std::min(1.0, leg.climbedS / leg.climbS);
        m_level = leg.climbFrom + (leg.climbTo - leg.climbFrom) * share;
        if (share > 0.5 && leg.region) m_region = *leg.region;
        if (share < 1.0) return;
    }
    if (leg.region) {
        m_region = *leg.region;
        m_level = m_world->building().regions()[m_region].level;
    }
    if (leg.through) {
        m_cameThrough = leg.through;
        m_passed = m_world->building().accesses()[*leg.through].kind;
    }
    m_legs.pop_front();
}

bool WalkBody::reaches(const Passage& passage, Felt& felt) const {
    Point2 at = nearestOnSegment(m_position, passage.gap.a, passage.gap.b);
    felt.distance = distance(m_position, at);
    double reach = m_options.caneReachM + 0.1;
    if (passage.kind == AccessKind::Elevator) reach = kCarReachM;
    if (passage.kind == AccessKind::Stairs && passage.gap.a == passage.gap.b) reach += kFlightM;
    if (felt.distance > reach) return false;
    felt.bearing = felt.distance > 1e-6 ? wrapped(directionOf(at - m_position) - m_heading) : Radians{};
    if (passage.changesLevel()) return true;
    // Not through a wall, and not what stands edgewise.
    Point2 front = at - passage.outward * (0.1 + passage.behindM);
    double before = dot(passage.gap.a - m_position, passage.outward);
    if (before < -0.05) return false;
    double to = distance(m_position, front);
    if (to > 0.05 && m_world->free(m_region, m_position, directionOf(front - m_position), to) < to - 1e-6)
        return false;
    Point2 middle = (passage.gap.a + passage.gap.b) * 0.5 - m_position;
    if (length(middle) > 1e-6) felt.bearing = wrapped(directionOf(middle) - m_heading);
    return true;
}

Touch WalkBody::touch() const {
    Touch touch;
    double reach = m_options.caneReachM;
    for (double aside : {-14.0, 0.0, 14.0}) {
        double free = m_world->free(m_region, m_position, m_heading + fromDegrees(aside), reach + 0.01);
        if (free <= reach && (!touch.ahead || free < *touch.ahead)) touch.ahead = free;
    }
    auto wall = [&](double degrees) -> std::optional<WallFelt> {
        Radians direction = m_heading + fromDegrees(degrees);
        auto hit = m_world->hit(m_region, m_position, direction, reach);
        if (!hit) return std::nullopt;
        // From "across the arm" to "along the way".
        double along = hit->wall.value + fromDegrees(degrees).value;
        while (along > kPi / 2.0) along -= kPi;
        while (along <= -kPi / 2.0) along += kPi;
        return WallFelt{hit->distance * std::abs(std::cos(along)), Radians{along}};
    };
    touch.left = wall(90.0);
    touch.right = wall(-90.0);
    auto isCar = [&](std::size_t region) {
        return m_world->building().regions()[region].kind == building::RegionKind::Elevator;
    };
    for (const Passage& passage : m_world->passagesOf(m_region)) {
        Felt felt;
        felt.handle = passage.access;
        felt.kind = passage.kind;
        felt.cameThrough = m_cameThrough == passage.access;
        felt.lift = !passage.changesLevel() && (isCar(passage.from) || isCar(passage.into));
        if (passage.climb != 0.0)
            felt.vertical = passage.climb > 0.0 ? routing::Vertical::Up : routing::Vertical::Down;
        if (reaches(passage, felt)) touch.felt.push_back(felt);
    }
    std::sort(touch.felt.begin(), touch.felt.end(),
              [](const Felt& a, const Felt& b) { return a.distance < b.distance; });
    return touch;
}

} // namespace farol::simulation
