#include "tests/support/simulated_walk.h"

#include "core/building/info.h"
#include "tests/support/walk_random.h"

#include <queue>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <limits>
#include <map>
#include <utility>

namespace farol::test {

using building::Access;
using building::Building;
using building::Landmark;
using building::RegionKind;

namespace {

constexpr double kTickS = 0.2, kTurnRateDeg = 90.0;

/// Shortest ways, access by access; regions are convex here.
class Ways {
public:
    explicit Ways(const Building& building) : m_building(building) {}

    /// Metres to walk to the middle of the region, from each access.
    void plan(std::size_t goal) {
        m_goal = goal;
        m_cost.assign(m_building.accesses().size(), std::numeric_limits<double>::infinity());
        using Entry = std::pair<double, std::size_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        auto offer = [&](std::size_t access, double cost) {
            if (cost >= m_cost[access]) return;
            m_cost[access] = cost;
            open.emplace(cost, access);
        };
        Point2 middle = centroid(m_building.regions()[goal].polygon);
        for (std::size_t a : m_building.accessesOf(goal)) offer(a, distance(at(a), middle) + climb(a));
        while (!open.empty()) {
            auto [cost, a] = open.top();
            open.pop();
            if (cost > m_cost[a]) continue;
            for (const RegionId& id : {m_building.accesses()[a].regionA, m_building.accesses()[a].regionB}) {
                std::size_t region = *m_building.regionIndex(id);
                if (region == goal) continue;
                for (std::size_t b : m_building.accessesOf(region))
                    if (b != a) offer(b, cost + distance(at(a), at(b)) + climb(b));
            }
        }
    }
    /// `passed`: the access one came through; nobody turns on the spot.
    std::optional<std::size_t> next(std::size_t region, Point2 from,
                                    std::optional<std::size_t> passed) const {
        std::optional<std::size_t> best;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t a : m_building.accessesOf(region)) {
            double cost = m_cost[a] + distance(from, at(a)) + (a == passed ? 0.5 : 0.0);
            if (cost < least) {
                least = cost;
                best = a;
            }
        }
        return region == m_goal ? std::nullopt : best;
    }
    std::size_t goal() const { return m_goal; }
    Point2 at(std::size_t access) const { return m_building.accesses()[access].midpoint(); }
    double climb(std::size_t access) const {
        const Access& a = m_building.accesses()[access];
        return !a.changesLevel() ? 0.0 : a.kind == building::AccessKind::Elevator ? 14.0 : 12.0;
    }

private:
    const Building& m_building;
    std::size_t m_goal = 0;
    std::vector<double> m_cost;
};

struct Thing {
    Kind kind;
    std::string text;
    std::size_t region;
    Point2 at;
    std::optional<Radians> facing;
    double luck = 1.0; ///< of being found on this visit: misses of one object go together
    double lastSeen = -100.0;
    bool found = true;
};

class Simulation {
public:
    Simulation(std::shared_ptr<const Building> building, const WalkOptions& options)
        : m_building(std::move(building)),
          m_options(options),
          m_random(options.seed * 104729ULL + 7ULL),
          m_ways(*m_building) {
        placeThings();
        WalkRandom eyes(options.seed * 7919ULL + 3ULL);
        for (double& share : m_eyes) share = 1.0 - options.unevenEyes * eyes.uniform();
    }

    SimulatedWalk run();

private:
    void placeThings();
    void leg(bool known, double mostS);
    void tick();
    void act();
    bool finished() const { return m_restS <= 0.0 && m_mode == "arrived"; }
    void choose();
    void turnBack();
    void arriveAtTarget();
    void look();
    void see(Thing& thing, double hazard);
    void invent();
    void write(const Thing& thing, double rangeM, double bearingDeg, bool invented);
    void writeTruth();
    void writeMotion();
    Kind confused(Kind kind);
    std::string misread(std::string text);
    Point2 spotIn(std::size_t region);
    double yawDeg() const;

    std::shared_ptr<const Building> m_building;
    WalkOptions m_options;
    WalkRandom m_random;
    Ways m_ways;
    std::vector<Thing> m_things;
    std::map<std::size_t, std::vector<std::size_t>> m_thingsOf;
    SimulatedWalk m_walk;

    double m_time = 0.0, m_baseSpeed = 0.7, m_speed = 0.7, m_scale = 1.0;
    std::size_t m_region = 0;
    Point2 m_at, m_target;
    std::optional<std::size_t> m_access, m_passed; ///< walked to; come through
    double m_headingDeg = 0.0, m_wantedDeg = 0.0, m_lookPhase = 0.0, m_swayPhase = 0.0;
    double m_restS = 0.0, m_climbS = 0.0, m_climbHalfS = 0.0;
    std::array<double, static_cast<std::size_t>(Kind::Other) + 1> m_eyes{};
    int m_strays = 0;
    bool m_onRoute = true;
    std::vector<std::size_t> m_planned;
    std::string m_mode = "walk";
    double m_lastYaw = 0.0, m_walkedM = 0.0;
    std::map<std::size_t, double> m_roomScale;
    bool m_flowLost = false;
    int m_frame = 0, m_scene = 0;
};

double wrapDegrees(double a) {
    return toDegrees(wrapped(fromDegrees(a)));
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", value);
    return text;
}

Point2 Simulation::spotIn(std::size_t region) {
    const Ring& ring = m_building->regions()[region].polygon.outer; // a turned rectangle
    double u = m_random.between(0.2, 0.8), v = m_random.between(0.2, 0.8);
    return ring[0] + (ring[1] - ring[0]) * u + (ring[3] - ring[0]) * v;
}

void Simulation::placeThings() {
    for (const Landmark& landmark : m_building->landmarks()) {
        if (m_random.chance(m_options.stale)) continue;
        m_things.push_back({landmark.kind, landmark.text, *m_building->regionIndex(landmark.region),
                            landmark.position, landmark.heading});
        m_things.back().found = !m_random.chance(m_options.neverFound);
    }
    constexpr Kind kClutter[] = {Kind::Rectangle, Kind::Poster, Kind::Locker, Kind::Door};
    for (std::size_t r = 0; r < m_building->regions().size(); ++r) {
        double wanted = m_options.clutterPerM2 * area(m_building->regions()[r].polygon);
        if (!m_random.chance(std::min(1.0, wanted))) continue;
        m_things.push_back(
            {kClutter[m_random.below(4)], "", r, spotIn(r), Radians{m_random.between(-kPi, kPi)}});
    }
    for (std::size_t i = 0; i < m_things.size(); ++i) m_thingsOf[m_things[i].region].push_back(i);
}

double Simulation::yawDeg() const {
    double sway = m_mode == "look" ? m_options.lookDeg * std::sin(m_lookPhase)
                                   : m_options.swayDeg * std::sin(m_swayPhase);
    return wrapDegrees(m_headingDeg + sway + m_options.cameraOffDeg);
}

void Simulation::choose() {
    auto accesses = m_building->accessesOf(m_region);
    m_access = m_ways.next(m_region, m_at, m_passed);
    bool strays = m_strays > 0 || (m_access && m_time > 2.0 && m_random.chance(m_options.strayAtDoor));
    if (strays && accesses.size() > 1) {
        if (m_strays == 0)
            m_strays = 1 + static_cast<int>(m_random.below(static_cast<std::size_t>(m_options.strayMost)));
        --m_strays;
        auto right = m_access;
        for (int i = 0; i < 4 && (m_access == right || i == 0); ++i)
            m_access = accesses[m_random.below(accesses.size())];
    }
    m_target = m_access ? m_ways.at(*m_access) : centroid(m_building->regions()[m_region].polygon);
    if (distance(m_at, m_target) > 0.05) m_wantedDeg = toDegrees(directionOf(m_target - m_at));
}

void Simulation::arriveAtTarget() {
    if (!m_access) {
        m_mode = "arrived";
        m_restS = 3.0 + 1.5 * m_random.uniform();
        return;
    }
    const Access& access = m_building->accesses()[*m_access];
    std::size_t beyond = *m_building->otherSide(access, m_region);
    if (access.changesLevel()) {
        m_mode = "floor";
        m_climbS = m_ways.climb(*m_access) / m_speed;
        m_climbHalfS = m_climbS / 2.0;
        return;
    }
    m_passed = m_access;
    m_region = beyond;
    bool planned = std::find(m_planned.begin(), m_planned.end(), m_region) != m_planned.end();
    m_onRoute = planned;
    choose();
}

/// A change of mind on the way: off through another door of the same region, often the last one.
void Simulation::turnBack() {
    auto accesses = m_building->accessesOf(m_region);
    std::size_t another =
        m_passed && m_random.chance(0.5) ? *m_passed : accesses[m_random.below(accesses.size())];
    if (another == m_access) return;
    m_strays = std::max(m_strays, 1);
    m_access = another;
    m_target = m_ways.at(another);
    if (distance(m_at, m_target) > 0.05) m_wantedDeg = toDegrees(directionOf(m_target - m_at));
}

void Simulation::act() {
    if (m_mode == "floor") {
        m_climbS -= kTickS;
        bool lift = m_building->accesses()[*m_access].kind == building::AccessKind::Elevator;
        m_walkedM += lift ? 0.0 : m_options.stairsShow * m_speed * kTickS;
        const Access& access = m_building->accesses()[*m_access];
        if (m_climbS < m_climbHalfS && m_climbHalfS > 0.0) {
            m_region = *m_building->otherSide(access, m_region);
            m_climbHalfS = -1.0;
            m_onRoute = std::find(m_planned.begin(), m_planned.end(), m_region) != m_planned.end();
        }
        if (m_climbS > 0.0) return;
        m_mode = "walk";
        m_passed = m_access;
        return choose();
    }
    if (m_restS > 0.0) {
        m_restS -= kTickS;
        m_lookPhase += 2.0 * kPi * kTickS / 6.0;
        if (m_restS <= 0.0 && m_mode != "arrived") m_mode = "walk";
        return;
    }
    if (m_mode != "walk") return;
    if (m_random.chance(kTickS * m_options.pausePerS)) {
        m_mode = "pause";
        m_restS = m_random.between(1.0, m_options.pauseMostS);
        return;
    }
    if (m_random.chance(kTickS * m_options.lookPerS)) {
        m_mode = "look";
        m_restS = 6.0;
        m_lookPhase = 0.0;
        return;
    }
    if (m_access && m_random.chance(kTickS * m_options.turnBackPerS)) turnBack();
    double off = wrapDegrees(m_wantedDeg - m_headingDeg);
    double most = kTurnRateDeg * kTickS;
    m_headingDeg = wrapDegrees(m_headingDeg + std::clamp(off, -most, most));
    if (std::abs(off) > 2.0 * most) return;
    m_speed += (m_baseSpeed - m_speed) * 0.1 + 0.03 * m_random.normal();
    double step = std::max(0.1, m_speed) * kTickS, gap = distance(m_at, m_target);
    m_walkedM += std::min(step, gap);
    if (gap <= step) {
        m_at = m_target;
        return arriveAtTarget();
    }
    m_at = m_at + (m_target - m_at) * (step / gap);
}

Kind Simulation::confused(Kind kind) {
    if (!m_random.chance(m_options.wrongKind)) return kind;
    double u = m_random.uniform();
    switch (kind) {
    case Kind::Door:
        return u < 0.6 ? Kind::Rectangle : Kind::Locker;
    case Kind::Locker:
        return u < 0.5 ? Kind::Door : Kind::Rectangle;
    case Kind::Rectangle:
        return u < 0.6 ? Kind::Poster : Kind::Door;
    case Kind::ExitSign:
        return u < 0.7 ? Kind::Rectangle : Kind::Poster;
    case Kind::Text:
        return Kind::Poster;
    default:
        return Kind::Rectangle;
    }
}

std::string Simulation::misread(std::string text) {
    static const std::string kLetters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    int wrong = m_random.chance(m_options.misread) ? (m_random.chance(0.8) ? 1 : 2) : 0;
    for (int i = 0; i < wrong && !text.empty(); ++i) {
        std::size_t at = m_random.below(text.size());
        if (m_random.chance(0.15) && text.size() > 1)
            text.erase(at, 1);
        else
            text[at] = kLetters[m_random.below(kLetters.size())];
    }
    return text;
}

void Simulation::write(const Thing& thing, double rangeM, double bearingDeg, bool invented) {
    static const std::map<Kind, double> kSigma{
        {Kind::Door, 0.15}, {Kind::Extinguisher, 0.18}, {Kind::ExitSign, 0.18}, {Kind::Locker, 0.2},
        {Kind::Text, 0.25}, {Kind::Stairs, 0.3},        {Kind::Poster, 0.35},   {Kind::Rectangle, 0.4}};
    Kind kind = invented ? thing.kind : confused(thing.kind);
    double range = rangeM * std::exp((invented ? 0.0 : kSigma.at(thing.kind)) * m_random.normal());
    double bearing = std::clamp(bearingDeg + (invented ? 0.0 : 3.0 * m_random.normal()), -30.0, 30.0);
    double x = 320.0 - bearing / 60.0 * 640.0;
    std::string line = "{\"t\":" + number(m_time) + ",\"frame\":" + std::to_string(m_frame) +
                       ",\"scene\":" + std::to_string(m_scene) + ",\"kind\":\"" +
                       std::string(kindName(kind)) + "\",\"template\":null,\"text\":";
    line += kind == Kind::Text ? "\"" + (invented ? thing.text : misread(thing.text)) + "\"" : "null";
    line += ",\"box\":[" + number(x - 40.0) + ",150,80,120],\"image\":[640,480],\"score\":0.7,\"range_m\":";
    line += m_random.chance(0.07) ? "null" : number(std::clamp(range, 0.45, 6.0));
    m_walk.log += line + ",\"bearing_deg\":" + number(bearing) + "}\n";
}

void Simulation::see(Thing& thing, double hazard) {
    if (!thing.found) return;
    Point2 to = thing.at - m_at;
    double range = length(to);
    if (range > 4.2 || range < m_options.tooNearM) return;
    double bearing = wrapDegrees(toDegrees(directionOf(to)) - yawDeg());
    if (std::abs(bearing) > 30.0) return;
    double facing = 1.0;
    if (thing.facing) {
        double c = -(to.x * std::cos(thing.facing->value) + to.y * std::sin(thing.facing->value)) / range;
        facing = c < 0.02 ? 0.0 : std::min(1.0, (c - 0.02) / 0.5);
    }
    double far = range < 1.0 ? 0.3 + 0.7 * range : range < 2.6 ? 1.0 : (4.2 - range) / 1.6;
    if (m_time - thing.lastSeen > 20.0) thing.luck = m_random.between(0.2, 1.8);
    thing.lastSeen = m_time;
    double prominent = thing.kind == Kind::ExitSign ? 1.6 : thing.kind == Kind::Stairs ? 1.3 : 1.0;
    prominent *= m_eyes.at(static_cast<std::size_t>(thing.kind));
    if (m_random.chance(hazard * prominent * thing.luck * facing * far * kTickS))
        write(thing, range, bearing, false);
}

void Simulation::invent() {
    if (!m_random.chance(m_options.falsePerS * kTickS)) return;
    constexpr std::pair<Kind, double> kShares[] = {
        {Kind::Door, 0.18},   {Kind::Rectangle, 0.48},    {Kind::Poster, 0.72}, {Kind::Text, 0.86},
        {Kind::Locker, 0.94}, {Kind::Extinguisher, 0.97}, {Kind::ExitSign, 1.0}};
    double u = m_random.uniform();
    Thing thing{Kind::Rectangle, "", m_region, m_at, std::nullopt};
    for (auto it = std::rbegin(kShares); it != std::rend(kShares); ++it)
        if (u < it->second) thing.kind = it->first;
    const auto& landmarks = m_building->landmarks();
    thing.text = m_random.chance(0.5) ? "EXIT" : std::to_string(100 + m_random.below(900));
    if (m_random.chance(0.15) && !landmarks.empty()) {
        const Landmark& other = landmarks[m_random.below(landmarks.size())];
        if (!other.text.empty()) thing.text = other.text;
    }
    write(thing, std::exp(std::log(2.0) + 0.5 * m_random.normal()), m_random.between(-30.0, 30.0), true);
}

void Simulation::look() {
    double eyes = m_options.detectionPerS * (m_mode == "floor" ? m_options.climbSees : 1.0);
    for (std::size_t i : m_thingsOf[m_region]) see(m_things[i], eyes);
    for (std::size_t a : m_building->accessesOf(m_region)) {
        const Access& access = m_building->accesses()[a];
        if (access.kind != building::AccessKind::Opening) continue;
        std::size_t beyond = *m_building->otherSide(access, m_region);
        if (distance(access.midpoint(), m_at) > 4.0) continue;
        for (std::size_t i : m_thingsOf[beyond])
            if (segmentsCross(m_at, m_things[i].at, access.line.front(), access.line.back()))
                see(m_things[i], eyes);
    }
    if (m_mode != "floor") invent();
}

void Simulation::writeTruth() {
    const auto& region = m_building->regions()[m_region];
    m_walk.truth += "{\"t\":" + number(m_time) + ",\"region\":\"" + region.id.value +
                    "\",\"level\":" + number(region.level) + ",\"x\":" + number(m_at.x) +
                    ",\"y\":" + number(m_at.y) + ",\"heading_deg\":" + number(m_headingDeg) +
                    ",\"yaw_deg\":" + number(yawDeg()) + ",\"mode\":\"" + m_mode +
                    "\",\"onroute\":" + (m_onRoute ? "true" : "false") + ",\"to\":\"" +
                    m_building->regions()[m_ways.goal()].id.value + "\"}\n";
}

void Simulation::writeMotion() {
    double yaw = yawDeg();
    double turn = m_options.turnGain * wrapDegrees(yaw - m_lastYaw) + m_options.turnBiasDeg +
                  m_options.turnNoiseDeg * m_random.normal();
    auto [here, isNew] = m_roomScale.try_emplace(m_region, 1.0);
    if (isNew) here->second = std::exp(m_options.roomScaleSigma * m_random.normal());
    double scale = m_scale * here->second * (1.0 + m_options.speedNoise * m_random.normal());
    double speed = std::max(0.0, m_walkedM * scale) + 0.03 * std::abs(m_random.normal());
    m_lastYaw = yaw;
    m_walkedM = 0.0;
    double stays = 1.0 - 1.0 / std::max(1.0, m_options.lostFlowS);
    m_flowLost = m_random.chance(m_flowLost ? stays : m_options.lostFlow * (1.0 - stays));
    m_walk.log += "{\"t\":" + number(m_time) +
                  ",\"motion\":{\"turn_deg\":" + (m_flowLost ? "null" : number(turn)) +
                  ",\"speed\":" + (m_flowLost ? "null" : number(speed)) + "}}\n";
}

void Simulation::tick() {
    m_time += kTickS;
    ++m_frame;
    if (m_frame % 4 == 0) ++m_scene;
    m_swayPhase += 2.0 * kPi * kTickS / m_options.swayS * (1.0 + 0.3 * m_random.normal());
    act();
    if (m_frame % 5 == 0) writeMotion();
    look();
    if (m_frame % 5 == 0) writeTruth();
}

void Simulation::leg(bool known, double mostS) {
    std::size_t goal = m_region;
    for (int i = 0; i < 40; ++i) {
        goal = m_random.below(m_building->regions().size());
        auto kind = m_building->regions()[goal].kind;
        bool fits = kind != RegionKind::Stairwell && kind != RegionKind::Elevator;
        if (goal != m_region && fits && distance(centroid(m_building->regions()[goal].polygon), m_at) > 12.0)
            break;
    }
    m_ways.plan(goal);
    m_walk.log += "{\"t\":" + number(m_time) + ",\"to\":\"" + m_building->regions()[goal].id.value +
                  "\",\"known\":" + (known ? "true" : "false") + "}\n";
    m_planned = {m_region};
    Point2 at = m_at;
    std::optional<std::size_t> passed;
    for (std::size_t region = m_region; auto a = m_ways.next(region, at, passed);) {
        passed = a;
        at = m_ways.at(*a);
        region = *m_building->otherSide(m_building->accesses()[*a], region);
        m_planned.push_back(region);
        if (m_planned.size() > 400) break;
    }
    m_onRoute = true;
    m_strays = 0;
    m_passed.reset();
    m_mode = "walk";
    if (!known && m_options.looksFirstS > 0.0) {
        m_mode = "look";
        m_restS = m_options.looksFirstS;
        m_lookPhase = 0.0;
    }
    choose();
    double until = m_time + mostS;
    while (m_time < until && !finished()) tick();
}

SimulatedWalk Simulation::run() {
    m_baseSpeed = m_speed = m_random.between(m_options.slowest, m_options.fastest);
    m_scale = m_random.between(m_options.leastScale, m_options.mostScale);
    m_region = m_random.below(m_building->regions().size());
    m_at = spotIn(m_region);
    m_headingDeg = m_random.between(-180.0, 180.0);
    m_swayPhase = m_random.between(0.0, 6.0);
    m_lastYaw = yawDeg();
    bool unknown = m_random.chance(m_options.unknownStart);
    m_walk.log = "{\"t\":0.0,\"start\":" +
                 (unknown ? "null" : "\"" + m_building->regions()[m_region].id.value + "\"") + "}\n";
    leg(!unknown, 400.0);
    bool carried = m_random.chance(m_options.kidnap);
    if (carried) {
        m_time += std::round(m_random.between(60.0, 90.0) * 5.0) / 5.0;
        m_region = m_random.below(m_building->regions().size());
        m_at = spotIn(m_region);
        m_mode = "walk";
    }
    leg(!carried, 400.0);
    return m_walk;
}

} // namespace

WalkOptions variedWalk(std::uint64_t seed) {
    WalkRandom random(seed * 15485863ULL + 11ULL);
    WalkOptions o;
    o.seed = seed;
    o.unknownStart = 0.3;
    o.kidnap = 0.2;
    o.strayAtDoor = random.between(0.04, 0.16);
    o.turnBackPerS = random.chance(0.5) ? 0.0 : random.between(0.0, 0.01);
    o.strayMost = 1 + static_cast<int>(random.below(6));
    o.wrongKind = random.between(0.04, 0.12);
    o.misread = random.between(0.08, 0.25);
    o.stale = random.between(0.02, 0.1);
    o.falsePerS = random.between(0.01, 0.035);
    o.clutterPerM2 = random.between(0.02, 0.06);
    o.detectionPerS = random.between(0.15, 0.45);
    o.neverFound = random.between(0.0, 0.25);
    o.swayDeg = random.between(6.0, 32.0);
    o.swayS = random.between(4.0, 14.0);
    o.cameraOffDeg = random.chance(0.5) ? 0.0 : random.between(-15.0, 15.0);
    o.lookPerS = random.between(0.008, 0.04);
    o.lookDeg = random.between(50.0, 160.0);
    o.pausePerS = random.between(0.02, 0.08);
    o.pauseMostS = random.between(4.0, 12.0);
    o.lostFlow = random.between(0.0, 0.15);
    o.lostFlowS = random.between(1.0, 6.0);
    o.turnNoiseDeg = random.between(0.5, 6.0);
    o.turnBiasDeg = random.chance(0.5) ? 0.0 : random.between(-1.2, 1.2);
    o.turnGain = random.between(0.88, 1.12);
    o.speedNoise = random.between(0.05, 0.35);
    o.leastScale = 0.3;
    o.mostScale = 3.0;
    o.roomScaleSigma = random.between(0.0, 0.25);
    o.tooNearM = random.between(0.3, 1.4);
    o.unevenEyes = random.between(0.0, 0.8);
    o.climbSees = random.chance(0.7) ? 0.0 : random.between(0.0, 0.5);
    o.looksFirstS = random.chance(0.3) ? 0.0 : random.between(3.0, 12.0);
    o.stairsShow = random.chance(0.5) ? 0.0 : random.between(0.2, 1.1);
    return o;
}

SimulatedWalk simulateWalk(const std::shared_ptr<const building::Building>& building,
                           const WalkOptions& options) {
    return Simulation(building, options).run();
}

} // namespace farol::test
