#include "tests/guidance/golden_situations.h"

#include "tests/guidance/golden_teller.h"
#include "tests/support/ascii_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace farol::test {

namespace {

using building::AccessKind;
using building::RegionKind;
using guidance::Question;

constexpr double kStepS = 0.5;
constexpr double kSpeed = 0.8;

/// How the user's place is known.
struct Known {
    double confidence = 0.95;
    double sigmaM = 0.7; ///< 0: the region only
    enum class Facing { Unknown, Walking, Followed, Place } facing = Facing::Walking;
};

class Play {
public:
    explicit Play(const char* title) : m_title(title) {}

    Play& level(double ordinal, const char* drawing) {
        m_map.floor(drawing, ordinal);
        m_drawings.emplace_back(drawing);
        return *this;
    }
    Play& called(char letter, const char* name, RegionKind kind = RegionKind::Room) {
        m_map.region(letter, {name, kind});
        return *this;
    }
    Play& landmark(char spot, Kind kind, const char* text = "") {
        m_map.landmark(spot, {kind, text});
        return *this;
    }
    Play& join(AccessKind kind, char a, char b, const char* shaft, std::optional<int> steps = {}) {
        m_map.join(kind, a, b, shaft, steps);
        return *this;
    }
    /// The map is drawn: the user stands at that spot.
    Play& begin(char spot, const guidance::TrackerOptions& tracking = {}) {
        m_building = m_map.build();
        guidance::GuidanceOptions options;
        options.language = ui::installedLanguage().toStdString();
        options.verbosity = guidance::Verbosity::ObjectsAndTexts;
        m_teller =
            std::make_unique<Teller>(m_building, routing::makeOptimalPlanner(m_building), options, tracking);
        m_teller->setListener([this](const guidance::Cue& cue, const QString&) {
            m_called = m_called || cue.kind == guidance::CueKind::OffRoute;
        });
        m_teller->write(QString::fromLatin1(m_title) + QLatin1Char('\n'));
        for (const std::string& drawing : m_drawings)
            m_teller->write(QString::fromStdString(drawing).remove(0, 1));
        put(spot);
        return *this;
    }
    Play& to(const char* region) {
        note(QStringLiteral("to %1").arg(QLatin1String(region)));
        m_teller->tracker().setDestination(building::Location{RegionId(region), std::nullopt});
        return *this;
    }
    Play& known(const Known& how) {
        m_known = how;
        return *this;
    }
    /// Counter-clockwise from east.
    Play& face(double degrees) {
        note(QStringLiteral("faces %1").arg(degrees < 0 ? degrees + 360 : degrees));
        m_heading = fromDegrees(degrees);
        return *this;
    }
    Play& walk(const char* spots) {
        note(QStringLiteral("walks to %1").arg(QLatin1String(spots)));
        for (char spot : std::string_view(spots)) walkTo(*m_map.spot(spot).position);
        return *this;
    }
    /// The same, but who is told to have gone wrong stops and listens.
    Play& stray(const char* spots) {
        note(QStringLiteral("walks to %1").arg(QLatin1String(spots)));
        m_heeds = true;
        m_called = false;
        for (char spot : std::string_view(spots)) walkTo(*m_map.spot(spot).position);
        m_heeds = false;
        return m_called ? stand(11.0) : *this;
    }
    Play& stand(double seconds) {
        note(QStringLiteral("stands"));
        for (double t = 0.0; t < seconds; t += kStepS) step();
        return *this;
    }
    /// Nothing tells where the user is.
    Play& lose(double seconds) {
        note(QStringLiteral("is lost"));
        m_lost = true;
        for (double t = 0.0; t < seconds; t += kStepS) step();
        m_lost = false;
        return *this;
    }
    /// By stairs, lift, escalator, or while nobody looks.
    Play& carry(char spot, double seconds) {
        note(QStringLiteral("is carried to %1").arg(QLatin1Char(spot)));
        for (double t = 0.0; t < seconds; t += kStepS) step();
        put(spot);
        return *this;
    }
    Play& see(Kind kind, Zone zone, const char* text = "", double score = 0.9) {
        localisation::Observation sight;
        sight.detection.kind = kind;
        sight.detection.text = text;
        sight.detection.image = {640, 480};
        const double x = 320.0 + 250.0 * (static_cast<int>(zone.column) - 1);
        const double y = 240.0 + 190.0 * (static_cast<int>(zone.row) - 1);
        sight.detection.quad = quadOf({x - 20.0, y - 20.0, 40.0, 40.0});
        sight.detection.score = score;
        m_seen.push_back(sight);
        return *this;
    }
    Play& warn(guidance::CueReason reason) {
        m_teller->warn(reason);
        return *this;
    }
    Play& ask(Question question) {
        m_teller->ask(question);
        return *this;
    }
    QString text() const { return m_teller->text(); }

private:
    void note(const QString& what) { m_teller->write(QStringLiteral("        -- ") + what); }
    void put(char spot) {
        const building::Location at = m_map.spot(spot);
        m_at = *at.position;
        m_level = m_building->region(at.region)->level;
        m_region = at.region;
    }
    void walkTo(Point2 there) {
        m_heading = directionOf(there - m_at);
        m_walks = true;
        while (distance(m_at, there) > 1e-6 && !(m_heeds && m_called)) {
            const double size = std::min(kSpeed * kStepS, distance(m_at, there));
            m_at = m_at + (there - m_at) * (size / distance(m_at, there));
            m_gone += size;
            // On a border one is still where one was.
            const building::Region* last = m_building->region(m_region);
            if (!contains(last->polygon, m_at))
                for (const building::Region& region : m_building->regions())
                    if (region.level == m_level && contains(region.polygon, m_at)) m_region = region.id;
            step();
        }
        m_walks = false;
    }
    localisation::Fix fix() {
        localisation::Fix fix;
        fix.time = m_time;
        if (!m_lost) m_evidence = m_time;
        fix.evidenceTime = m_evidence;
        if (m_lost) return fix;
        fix.region = m_region;
        fix.confidence = m_known.confidence;
        fix.near = {m_region};
        fix.nearConfidence = std::max(0.9, m_known.confidence);
        fix.level = m_level;
        if (m_known.sigmaM <= 0.0) return fix;
        fix.position = m_at;
        fix.sigmaM = m_known.sigmaM;
        const bool knows = m_known.facing == Known::Facing::Followed ||
                           m_known.facing == Known::Facing::Place ||
                           (m_known.facing == Known::Facing::Walking && m_walks);
        if (!knows) return fix;
        fix.heading = m_heading;
        fix.headingSigma = fromDegrees(12.0);
        fix.followed = m_known.facing == Known::Facing::Followed;
        if (m_known.facing == Known::Facing::Place)
            for (const building::Landmark& landmark : m_building->landmarks())
                if (landmark.kind == Kind::Place) fix.landmark = landmark.id;
        return fix;
    }
    void step() {
        m_teller->step(fix(), kStepS, m_gone, m_seen);
        m_seen.clear();
        m_time += kStepS;
    }

    const char* m_title;
    AsciiMap m_map;
    std::vector<std::string> m_drawings;
    std::shared_ptr<const building::Building> m_building;
    std::unique_ptr<Teller> m_teller;
    Known m_known;
    Point2 m_at;
    double m_level = 0.0, m_time = 0.0, m_evidence = 0.0, m_gone = 0.0;
    RegionId m_region;
    Radians m_heading;
    bool m_walks = false, m_lost = false;
    bool m_heeds = false, m_called = false; ///< stops when told to have gone wrong; was told
    std::vector<localisation::Observation> m_seen;
};

constexpr Known kAtPlace{0.95, 0.5, Known::Facing::Place};
constexpr Known kFollowed{0.95, 0.5, Known::Facing::Followed};
constexpr Known kGuess{0.3, 1.5, Known::Facing::Unknown};
constexpr Known kRegionOnly{0.9, 0.0, Known::Facing::Unknown};
constexpr Known kRegionGuess{0.3, 0.0, Known::Facing::Unknown};

Play hallway(const char* title) {
    Play play(title);
    play.level(0, R"(
+------+------+------+------+
|A     |B     |C     |D     |
|  a   |  b   |  c   |  d   |
|  5   |  6   |  7   |  8   |
+--/---+--/---+--/---+--/---+
|K                          |
|h 1 i   2   k 3    l 4  m p|
|                           |
+------------/--------------+
         |E  e     |
         |         |
         +---------+
)")
        .called('A', "Library")
        .called('B', "Bar")
        .called('C', "Chapel")
        .called('D', "Dean")
        .called('E', "Exit hall", RegionKind::Hall)
        .called('K', "Corridor", RegionKind::Corridor)
        .landmark('p', Kind::Place);
    return play;
}

QString turned() {
    return hallway("who faces away is turned first: by a trained place, and by a heading that is followed")
        .begin('3')
        .known(kAtPlace)
        .face(180.0)
        .to("D")
        .stand(10.0)
        .known(kFollowed)
        .walk("4")
        .face(-90.0)
        .to("A")
        .stand(14.0)
        .walk("3k")
        .face(20.0)
        .stand(12.0)
        .ask(Question::Next)
        .walk("21")
        .face(180.0)
        .stand(6.0)
        .ask(Question::Next)
        .walk("5a")
        .stand(6.0)
        .text();
}

QString wrongWay() {
    return hallway(
               "the wrong way, too far, through a wrong door, and back in the corridor the wrong way again")
        .begin('2')
        .known({0.95, 0.6, Known::Facing::Walking})
        .to("C")
        .stand(9.0)
        .stray("1h")
        .walk("2k3")
        .stray("l4m")
        .walk("l3")
        .stray("k26b")
        .stray("6b")
        .walk("6")
        .stray("21h")
        .walk("23")
        .walk("7c")
        .stand(6.0)
        .text();
}

QString guess() {
    guidance::TrackerOptions patient;
    patient.arrivalConfidence = 0.9;
    patient.patientConfidence = 0.2;
    patient.patientSeconds = 4.0;
    return hallway("where one is is a guess: words are hedged, and no metres are told")
        .begin('1')
        .known(kGuess)
        .to("C")
        .stand(16.0)
        .walk("i2k")
        .ask(Question::WhereAmI)
        .ask(Question::Next)
        .walk("3")
        .known({0.3, 1.2, Known::Facing::Walking})
        .stray("21h")
        .walk("23")
        .stray("l4m")
        .walk("l3")
        .known(kGuess)
        .walk("7c")
        .stand(16.0)
        .text();
}

QString guessed() {
    guidance::TrackerOptions patient;
    patient.arrivalConfidence = 0.9;
    patient.patientConfidence = 0.2;
    patient.patientSeconds = 4.0;
    return hallway("the region is a guess, and then another one; a place that is perhaps the destination")
        .begin('1')
        .known(kRegionGuess)
        .to("C")
        .stand(20.0)
        .carry('e', 1.0)
        .stand(14.0)
        .carry('2', 1.0)
        .stand(20.0)
        .to("K")
        .stand(8.0)
        .text();
}

QString lost() {
    return hallway("lost: the look around, and found again")
        .begin('1')
        .to("C")
        .stand(9.0)
        .walk("2")
        .lose(24.0)
        .ask(Question::WhereAmI)
        .lose(14.0)
        .lose(20.0)
        .stand(3.0)
        .lose(10.0)
        .stand(12.0)
        .walk("3")
        .text();
}

QString regionsOnly() {
    return hallway("only the region is known: no metres, and the door is told on entering")
        .begin('e')
        .known(kRegionOnly)
        .to("D")
        .stand(20.0)
        .carry('2', 1.0)
        .stand(36.0)
        .carry('d', 1.0)
        .stand(6.0)
        .ask(Question::AroundMe)
        .text();
}

QString floors() {
    return Play("down an escalator, by a lift that one stays in, up a ramp")
        .level(2, R"(
+-----+----+
|A    |B   |
|  1  :  2 |
|     |    |
+-----+----+
)")
        .level(1, R"(
       +----+-------+---+
       |C   |D      |L  |
       |  3 :  4    / 5 |
       |    |       |   |
       +----+-------+---+
)")
        .level(0, R"(
                    +---+
                    |M  |
                    | 6 |
                    |   |
+                   +---+
)")
        .level(-1, R"(
         +----------+---+
         |P         |N  |
         |  9  8    / 7 |
         |          |   |
         +----------+---+
)")
        .level(-0.5, R"(
  +------+
  |R     |
  |  0   |
  |      |
+ +------+
)")
        .called('A', "Shops", RegionKind::Hall)
        .called('B', "Top", RegionKind::Hall)
        .called('C', "Arcade", RegionKind::Hall)
        .called('D', "Passage", RegionKind::Corridor)
        .called('L', "Lift", RegionKind::Elevator)
        .called('M', "Lift", RegionKind::Elevator)
        .called('N', "Lift", RegionKind::Elevator)
        .called('P', "Car park", RegionKind::Hall)
        .called('R', "Street", RegionKind::Outside)
        .join(AccessKind::Escalator, 'B', 'C', "moving")
        .join(AccessKind::Elevator, 'L', 'M', "one")
        .join(AccessKind::Elevator, 'M', 'N', "one")
        .join(AccessKind::Ramp, 'P', 'R', "ramp")
        .begin('1')
        .to("R")
        .stand(9.0)
        .ask(Question::Preview)
        .walk("2")
        .carry('3', 12.0)
        .stand(3.0)
        .walk("45")
        .ask(Question::Next)
        .carry('6', 8.0)
        .stand(8.0)
        .ask(Question::Next)
        .ask(Question::AroundMe)
        .carry('7', 4.0)
        .stand(2.0)
        .walk("89")
        .carry('0', 4.0)
        .stand(6.0)
        .text();
}

QString refused() {
    return Play("no way: nothing chosen, unknown, unreachable; already there; what the program tells of "
                "itself")
        .level(0, R"(
+------+------+
|A     |B     |
|  1   /  2   |
|      |      |
+------+------+
              +------+
              |C     |
              |  3   |
              +------+
)")
        .called('A', "Library")
        .called('B', "Bar")
        .called('C', "Chapel")
        .begin('1')
        .stand(2.0)
        .ask(Question::Next)
        .to("C")
        .stand(9.0)
        .ask(Question::Next)
        .to("Z")
        .stand(9.0)
        .to("A")
        .stand(9.0)
        .to("B")
        .stand(8.0)
        .carry('3', 1.0)
        .stand(14.0)
        .warn(guidance::CueReason::CameraLost)
        .stand(6.0)
        .warn(guidance::CueReason::CameraBack)
        .stand(4.0)
        .warn(guidance::CueReason::PictureCovered)
        .stand(6.0)
        .warn(guidance::CueReason::RecordingStopped)
        .stand(5.0)
        .warn(guidance::CueReason::FrameSkipped)
        .stand(5.0)
        .warn(guidance::CueReason::None)
        .stand(6.0)
        .text();
}

QString objects() {
    return hallway("objects and texts on the way, sure and unsure")
        .begin('1')
        .to("D")
        .stand(12.0)
        .see(Kind::Extinguisher, {Column::Left, Row::Down})
        .stand(5.0)
        .see(Kind::Door, {Column::Right, Row::Centre}, "", 0.3)
        .stand(5.0)
        .see(Kind::ExitSign, {Column::Centre, Row::Up})
        .stand(5.0)
        .see(Kind::Sign, {Column::Left, Row::Up}, "2.14")
        .stand(5.0)
        .see(Kind::Text, {Column::Centre, Row::Centre}, "Chapel")
        .stand(6.0)
        .text();
}

} // namespace

std::vector<GoldenSituation> goldenSituations() {
    return {{"turned", turned},   {"wrong_way", wrongWay}, {"guess", guess},
            {"guessed", guessed}, {"lost", lost},          {"regions_only", regionsOnly},
            {"floors", floors},   {"refused", refused},    {"objects", objects}};
}

} // namespace farol::test
