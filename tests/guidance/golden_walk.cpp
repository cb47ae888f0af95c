#include "tests/guidance/golden_walk.h"

#include "tests/guidance/golden_teller.h"

#include <algorithm>
#include <cmath>

namespace farol::test {

namespace {

using guidance::Cue;
using routing::PathPoint;

constexpr double kStepS = 0.5;
constexpr double kSpeed = 0.8;
constexpr double kStairsS = 15.0;
constexpr double kHeadingAfterM = 1.0;
constexpr double kSeenM = 4.0;

/// Not on its border, along which a path may lead.
bool isWithin(const Polygon& polygon, Point2 p) {
    constexpr double kWallM = 0.05;
    const Ring& ring = polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (distanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]) < kWallM) return false;
    return contains(polygon, p);
}

/// Somebody on the path: `gone` metres of it are done.
class PathWalker {
public:
    PathWalker(const building::Building& building, const routing::Route& route)
        : m_building(building), m_route(route) {}

    void walk(double seconds) {
        if (m_resting > 0.0) {
            m_resting -= seconds;
            return;
        }
        double left = kSpeed * seconds;
        if (climbs(m_leg)) {
            ++m_leg;
            m_sinceTurnedUp = m_gone;
        }
        while (left > 0.0 && m_leg + 1 < m_route.path.size()) {
            const PathPoint &a = m_route.path[m_leg], &b = m_route.path[m_leg + 1];
            double size = a.level == b.level ? distance(a.position, b.position) : 0.0;
            if (m_along + left < size) {
                m_along += left;
                m_gone += left;
                return;
            }
            m_gone += size - m_along;
            left -= size - m_along;
            m_along = 0.0;
            ++m_leg;
            if (climbs(m_leg)) {
                m_resting = kStairsS * std::abs(m_route.path[m_leg].level - m_route.path[m_leg + 1].level);
                return;
            }
        }
    }
    bool arrived() const { return m_leg + 1 >= m_route.path.size(); }
    double gone() const { return m_gone; }
    PathPoint here() const {
        const PathPoint& a = m_route.path[m_leg];
        if (arrived()) return a;
        Point2 way = m_route.path[m_leg + 1].position - a.position;
        double size = length(way);
        return {size > 0.0 ? a.position + way * (m_along / size) : a.position, a.level};
    }
    std::optional<Radians> heading() const {
        if (arrived() || m_gone - m_sinceTurnedUp < kHeadingAfterM) return std::nullopt;
        Point2 way = m_route.path[m_leg + 1].position - m_route.path[m_leg].position;
        return length(way) > 0.0 ? std::optional(directionOf(way)) : std::nullopt;
    }
    /// Of the regions of the route the one that one stands in, never an earlier one than before. A lift
    /// passes some without a stop.
    RegionId region() {
        PathPoint at = here();
        for (std::size_t i = m_region; i < m_route.regions.size(); ++i) {
            const building::Region* region = m_building.region(m_route.regions[i]);
            bool rides = m_building.region(m_route.regions[m_region])->level != at.level;
            if (i > m_region + 1 && !rides) break;
            if (region->level == at.level && isWithin(region->polygon, at.position)) m_region = i;
        }
        return m_route.regions[m_region];
    }

private:
    bool climbs(std::size_t leg) const {
        return leg + 1 < m_route.path.size() && m_route.path[leg].level != m_route.path[leg + 1].level;
    }

    const building::Building& m_building;
    const routing::Route& m_route;
    std::size_t m_leg = 0, m_region = 0;
    double m_along = 0.0, m_gone = 0.0, m_resting = 0.0, m_sinceTurnedUp = 0.0;
};

class Walk {
public:
    explicit Walk(const GoldenBuilding& golden);
    QString tell();
    void setListener(std::function<void(const Cue&, const QString&)> listener) {
        m_teller.setListener(std::move(listener));
    }

private:
    void head();
    void step();
    localisation::Fix fix();
    std::vector<localisation::Observation> seen(const localisation::Fix& fix) const;

    const GoldenBuilding& m_golden;
    std::shared_ptr<const routing::Planner> m_planner;
    routing::Route m_route;
    PathWalker m_walker;
    Teller m_teller;
    bool m_started = false, m_asked = false;
    double m_time = 0.0;
};

routing::Route planned(const routing::Planner& planner, const GoldenBuilding& golden) {
    auto route = planner.plan(golden.from, golden.to);
    return route ? std::move(route).value() : routing::Route{};
}

guidance::GuidanceOptions optionsOf(const GoldenBuilding& golden) {
    guidance::GuidanceOptions options;
    options.language = ui::installedLanguage().toStdString();
    options.verbosity =
        golden.seesObjects ? guidance::Verbosity::ObjectsAndTexts : guidance::Verbosity::Directions;
    return options;
}

Walk::Walk(const GoldenBuilding& golden)
    : m_golden(golden),
      m_planner(routing::makeOptimalPlanner(golden.building)),
      m_route(planned(*m_planner, golden)),
      m_walker(*golden.building, m_route),
      m_teller(golden.building, m_planner, optionsOf(golden)) {}

localisation::Fix Walk::fix() {
    PathPoint at = m_walker.here();
    localisation::Fix fix;
    fix.time = fix.evidenceTime = m_time;
    fix.region = m_walker.region();
    fix.confidence = 0.95;
    fix.near = {*fix.region};
    fix.nearConfidence = 1.0;
    fix.level = at.level;
    fix.position = at.position;
    fix.sigmaM = 0.7;
    fix.heading = m_walker.heading();
    if (fix.heading) fix.headingSigma = fromDegrees(10.0);
    return fix;
}

/// What the camera sees of the landmarks ahead of the walker.
std::vector<localisation::Observation> Walk::seen(const localisation::Fix& fix) const {
    std::vector<localisation::Observation> all;
    if (!fix.heading) return all;
    for (const building::Landmark& landmark : m_golden.building->landmarks()) {
        Point2 way = landmark.position - *fix.position;
        double bearing = toDegrees(wrapped(directionOf(way) - *fix.heading));
        if (landmark.region != *fix.region || length(way) > kSeenM || std::abs(bearing) > 30.0) continue;
        localisation::Observation sight;
        sight.detection.kind = landmark.kind;
        sight.detection.text = landmark.text;
        sight.detection.image = {640, 480};
        sight.detection.quad = quadOf({310.0 - 10.0 * bearing, 350.0, 20.0, 40.0});
        sight.detection.score = 0.9;
        all.push_back(sight);
    }
    return all;
}

void Walk::head() {
    m_teller.write(QString::fromStdString(m_golden.title) + QLatin1Char('\n'));
    // Only the margin that all lines have: the walls stand where they were drawn.
    for (const std::string& drawing : m_golden.drawings)
        m_teller.write(QString::fromStdString(drawing).remove(0, 1));
}

void Walk::step() {
    const localisation::Fix now = fix();
    m_teller.step(now, kStepS, m_walker.gone(), seen(now));
    if (!m_started) m_teller.ask(guidance::Question::Preview);
    m_started = true;
    if (!m_asked && m_walker.gone() >= 0.5 * m_route.lengthM) {
        m_asked = true;
        for (auto question : {guidance::Question::WhereAmI, guidance::Question::AroundMe,
                              guidance::Question::Next, guidance::Question::Remaining})
            m_teller.ask(question);
    }
    // Nobody sets out before the way was told to its end.
    bool listening = m_walker.gone() == 0.0 && m_teller.voice().speaking();
    if (!listening) m_walker.walk(kStepS);
    m_time += kStepS;
}

QString Walk::tell() {
    head();
    m_teller.tracker().setDestination(m_golden.to);
    constexpr double kLongestS = 300.0, kAfterS = 8.0;
    double arrivedAt = kLongestS;
    while (m_time < std::min(kLongestS, arrivedAt + kAfterS)) {
        step();
        if (m_walker.arrived()) arrivedAt = std::min(arrivedAt, m_time);
    }
    return m_teller.text();
}

} // namespace

QString tellWalk(const GoldenBuilding& golden) {
    return Walk(golden).tell();
}

void listenToWalk(const GoldenBuilding& golden,
                  const std::function<void(const Cue& cue, const QString& words)>& listener) {
    Walk walk(golden);
    walk.setListener(listener);
    walk.tell();
}

} // namespace farol::test
