#include "tests/guidance/golden_walk.h"

#include "core/guidance/cue_scheduler.h"
#include "ui/speech/speech_queue.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace farol::test {

namespace {

using guidance::Cue;
using routing::PathPoint;
using ui::DirectionStyle;
using ui::Phrasebook;
using ui::Utterance;
using ui::UtteranceState;

constexpr double kStepS = 0.5;
constexpr double kSpeed = 0.8;
constexpr double kWordsPerS = 2.7;
constexpr double kGapS = 0.5;
constexpr double kStairsS = 15.0;
constexpr double kHeadingAfterM = 1.0;
constexpr double kSeenM = 4.0;

/// Says nothing and takes as long as saying it would.
class TimedVoice final : public ui::SpeechOutput {
public:
    void say(const QString& text) override {
        m_left = static_cast<double>(text.split(QLatin1Char(' ')).size()) / kWordsPerS + kGapS;
        m_speaking = true;
    }
    void stop() override { m_speaking = false; }
    bool speaking() const override { return m_speaking; }
    QString description() const override { return QStringLiteral("timed"); }
    void pass(double seconds) {
        if (!m_speaking) return;
        m_left -= seconds;
        if (m_left > 0.0) return;
        m_speaking = false;
        Q_EMIT finished();
    }

private:
    double m_left = 0.0;
    bool m_speaking = false;
};

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

class Teller {
public:
    explicit Teller(const GoldenBuilding& golden);
    QString tell();
    void setListener(std::function<void(const Cue&, const QString&)> listener) {
        m_listener = std::move(listener);
    }

private:
    void head();
    void step();
    void add(const QString& what, const Cue& cue);
    void ask(guidance::Question question);
    localisation::Fix fix();
    std::vector<localisation::Observation> seen(const localisation::Fix& fix) const;

    const GoldenBuilding& m_golden;
    std::shared_ptr<const routing::Planner> m_planner;
    routing::Route m_route;
    guidance::RouteTracker m_tracker;
    guidance::CueScheduler m_scheduler;
    PathWalker m_walker;
    Phrasebook m_phrasebook;
    TimedVoice m_voice;
    ui::SpeechQueue m_queue;
    localisation::Fix m_fix;
    guidance::Progress m_progress;
    bool m_asked = false;
    double m_time = 0.0;
    std::uint64_t m_frame = 0;
    QStringList m_lines;
    std::function<void(const Cue&, const QString&)> m_listener;
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

Teller::Teller(const GoldenBuilding& golden)
    : m_golden(golden),
      m_planner(routing::makeOptimalPlanner(golden.building)),
      m_route(planned(*m_planner, golden)),
      m_tracker(golden.building, m_planner),
      m_scheduler(golden.building, optionsOf(golden)),
      m_walker(*golden.building, m_route),
      m_queue(m_voice, m_phrasebook) {
    m_queue.setGapMs(0);
    QObject::connect(&m_queue, &ui::SpeechQueue::changed, [this](const Utterance& utterance) {
        if (utterance.state == UtteranceState::Speaking)
            add(QString::fromStdString(cueKindName(utterance.cue.kind)), utterance.cue);
        if (utterance.state == UtteranceState::Expired || utterance.state == UtteranceState::Interrupted) {
            bool cut = utterance.state == UtteranceState::Interrupted;
            m_lines << QStringLiteral("%1 (%2: %3)")
                           .arg(QString(), 20)
                           .arg(cut ? QStringLiteral("cut short") : QStringLiteral("not spoken"),
                                utterance.text);
        }
    });
}

/// What would be answered now; asking does not disturb the walk.
void Teller::ask(guidance::Question question) {
    const Cue cue = m_scheduler.answer(question, m_frame, m_fix, m_progress);
    add(QStringLiteral("? ") + QString::fromStdString(questionName(question)), cue);
}

void Teller::add(const QString& what, const Cue& cue) {
    auto said = [&](DirectionStyle style) { return Phrasebook(style).sentence(cue); };
    const QString plain = said(DirectionStyle::LeftRight);
    if (m_listener) m_listener(cue, plain);
    m_lines << QStringLiteral("%1 s %2 m  %3 %4")
                   .arg(m_time, 5, 'f', 1)
                   .arg(m_walker.gone(), 5, 'f', 1)
                   .arg(what, -12)
                   .arg(plain);
    const QString margin(30, QLatin1Char(' '));
    for (auto [style, name] :
         {std::pair(DirectionStyle::Clock, "clock"), {DirectionStyle::Degrees, "degrees"}}) {
        const QString text = said(style);
        if (text != plain) m_lines << margin + QStringLiteral("[%1] %2").arg(QLatin1String(name), text);
    }
}

localisation::Fix Teller::fix() {
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
std::vector<localisation::Observation> Teller::seen(const localisation::Fix& fix) const {
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

void Teller::head() {
    m_lines << QString::fromStdString(m_golden.title) << QString();
    for (const std::string& drawing : m_golden.drawings) m_lines << QString::fromStdString(drawing).trimmed();
    m_lines << QString();
}

void Teller::step() {
    m_voice.pass(kStepS);
    m_fix = fix();
    m_progress = m_tracker.update(m_fix);
    m_queue.setNow(m_time, m_fix.region, m_progress.routeVersion);
    for (const Cue& cue : m_scheduler.update(++m_frame, m_fix, m_progress, seen(m_fix))) {
        if (cue.chime != guidance::Chime::None)
            m_lines << QStringLiteral("%1 s %2 m  (chime: %3)")
                           .arg(m_time, 5, 'f', 1)
                           .arg(m_walker.gone(), 5, 'f', 1)
                           .arg(QString::fromStdString(chimeName(cue.chime)));
        m_queue.add(cue);
    }
    if (m_frame == 1) ask(guidance::Question::Preview);
    if (!m_asked && m_walker.gone() >= 0.5 * m_route.lengthM) {
        m_asked = true;
        for (auto question : {guidance::Question::WhereAmI, guidance::Question::AroundMe,
                              guidance::Question::Next, guidance::Question::Remaining})
            ask(question);
    }
    // Nobody sets out before the way was told to its end.
    bool listening = m_walker.gone() == 0.0 && m_voice.speaking();
    if (!listening) m_walker.walk(kStepS);
    m_time += kStepS;
}

QString Teller::tell() {
    head();
    m_tracker.setDestination(m_golden.to);
    constexpr double kLongestS = 300.0, kRestS = 8.0;
    double arrivedAt = kLongestS;
    while (m_time < std::min(kLongestS, arrivedAt + kRestS)) {
        step();
        if (m_walker.arrived()) arrivedAt = std::min(arrivedAt, m_time);
    }
    return m_lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

} // namespace

QString tellWalk(const GoldenBuilding& golden) {
    return Teller(golden).tell();
}

void listenToWalk(const GoldenBuilding& golden,
                  const std::function<void(const Cue& cue, const QString& words)>& listener) {
    Teller teller(golden);
    teller.setListener(listener);
    teller.tell();
}

} // namespace farol::test
