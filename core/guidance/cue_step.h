#pragma once
// What one frame causes to be told, and what the scheduler remembers between frames. Private to guidance.

#include "core/guidance/cue_scheduler.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace farol::guidance {

struct SchedulerMemory {
    std::uint64_t lastId = 0;

    // Of the present route; forgotten with it.
    std::uint64_t version = 0;
    std::optional<std::size_t> regionIndex;
    double enteredAt = 0.0;
    std::map<std::string, double> told;      ///< manoeuvre -> when, as main or second part of a cue
    std::map<std::string, double> acted;     ///< manoeuvre -> when it was told to be done now
    std::map<std::string, double> followed;  ///< manoeuvre -> when it was told as the second part of a cue
    std::set<std::string> prepared;          ///< announced when they came near, or as the next thing
    std::optional<double> startedAt;         ///< when the beginning of the route was told
    bool startToldSide = false;              ///< with the side of its door, or there was none to tell
    std::optional<double> routeToldAt;       ///< any cue of the route
    std::optional<double> remainingWhenTold; ///< metres to the destination then
    std::optional<double> arrivedToldAt;
    /// When something was told to be done at once by a guess; not forgotten with the route.
    std::optional<double> doubtfulOrderAt;
    struct Advance {
        double spotTime = 0.0, remainingM = 0.0;
        std::optional<Point2> at;
        bool along = false;
    };
    std::optional<Advance> advance;
    struct Steady {
        Radians heading;
        double since = 0.0;
    };
    std::optional<Steady> steady;    ///< about that way the user has faced since then
    std::optional<double> awaySince; ///< faces away from the way since then
    std::optional<double> turnToldAt;

    std::map<RegionId, double> announcedInto; ///< regions named as what comes next -> when
    std::optional<double> offRouteToldAt;
    std::optional<double> unusableSince;
    struct Sweep {
        SweepStep step = SweepStep::Right;
        double toldAt = 0.0;
    };
    std::optional<Sweep> sweep;
    std::optional<RegionId> located; ///< the last region told, or told to come next
    std::map<RegionId, double> locatedAt;
    struct Candidate {
        RegionId region;
        double evidenceTime = 0.0;
        int fixes = 0;
    };
    Candidate candidate;
    std::map<std::string, double> objectsToldAt;
    int repeats = 0;       ///< of the same order to somebody who does not get on
    bool facesWay = false; ///< seen to walk along the present route, or come through one of its accesses
    bool known = false;    ///< the place was known with confidence
    std::optional<double> chimedAt;
};

class CueStep {
public:
    CueStep(const building::Building& building, const GuidanceOptions& options, SchedulerMemory& memory,
            std::uint64_t frame, const localisation::Fix& fix, const Progress& progress);

    void tellRoute();
    void tellUnsure();
    bool tellsAWay() const; ///< in this step
    void tellSweep(SweepStep step);
    void tellRegion();
    void tellObjects(const std::vector<localisation::Observation>& fresh);
    void addChimes();
    std::vector<Cue> takeCues() { return std::move(m_cues); }
    /// Changes nothing of what is remembered.
    Cue answer(Question question) const;

private:
    /// What is told of the very spot rests on a position and a heading no older than this: 1.6 m of walking.
    static constexpr double kFreshSeconds = 2.0;
    /// How fast a position gets stale: the pace of a blind walker (routing::RouteOptions).
    static constexpr double kWalkingSpeed = 0.8;
    /// Below, the user faces the way well enough to just walk.
    static constexpr Radians kTurnFirst = fromDegrees(60.0);
    /// A way that is no more than this longer than the straight line is straight.
    static constexpr double kStraightM = 0.5;

    Cue answerWhere() const;
    Cue answerAround() const;
    Cue answerNext() const;
    Cue answerList(bool whole) const;
    Cue answerRefusal() const;
    Cue lookAround() const;
    Bearing bearing(Radians& zero) const;
    std::vector<Surrounding> accessesAround(std::size_t region, Bearing bearing, Radians zero) const;
    std::vector<Surrounding> landmarksAround(std::size_t region, Bearing bearing, Radians zero) const;
    void place(Surrounding& what, Point2 position, Bearing bearing, Radians zero) const;
    std::vector<Cue> stepsFrom(std::size_t first, bool fromHere) const;
    Cue arrivalCue() const;

    void tellRefusal();
    void tellArrival();
    bool ordersSomething(const Cue& cue) const;
    void tellStart();
    void tellOffRoute();
    void tellManoeuvre();
    void tellMeasured(const routing::Manoeuvre& next);
    bool tellWhatFollows(const routing::Manoeuvre& next, double measuredM);
    void forgetRide(const routing::Manoeuvre& ride);
    bool tellRide(const routing::Manoeuvre& door);
    void tellUnmeasured(const routing::Manoeuvre& next);
    void tellAgain(const routing::Manoeuvre& next);
    void tellReassurance(double aheadM);
    void followAdvance();
    bool walksAgainstTheWay(const std::optional<Point2>& from) const;
    Cue cueOf(CueKind kind, CuePriority priority, double seconds) const;
    Cue routeCue(CueKind kind, CuePriority priority, double seconds) const;
    void addManoeuvre(Cue cue, const routing::Manoeuvre& manoeuvre,
                      const std::optional<routing::Manoeuvre>& after);
    void fillManoeuvre(Cue& cue, const routing::Manoeuvre& manoeuvre,
                       const std::optional<routing::Manoeuvre>& after) const;
    void setShortSide(routing::Manoeuvre& manoeuvre) const;
    void locate(Cue& cue, const routing::Manoeuvre& manoeuvre) const;
    void countDoors(routing::Manoeuvre& manoeuvre) const;
    void countAlongWall(routing::Manoeuvre& manoeuvre) const;
    bool standsInEntrance(const routing::Manoeuvre& manoeuvre) const;
    bool waitsForCount(const routing::Manoeuvre& manoeuvre, double measuredM) const;
    std::optional<Mark> mark(const routing::Manoeuvre& manoeuvre) const;
    bool staysInLift(const routing::Manoeuvre& manoeuvre) const;
    bool placeIsGood() const;
    bool facesWay() const;
    std::optional<Radians> facing() const;
    void add(Cue cue);
    void nameRegion(Cue& cue, const RegionId& region) const;
    std::string nameOf(const RegionId& region) const;
    std::string levelName(double ordinal, bool asOnButtons) const;
    std::optional<double> legLength(const routing::Manoeuvre& manoeuvre) const;
    std::optional<Radians> turnFirst() const;
    std::optional<double> firstM() const;
    bool isSoon() const;
    std::optional<int> hourTo(const routing::Manoeuvre& manoeuvre) const;
    std::string keyOf(const routing::Manoeuvre& manoeuvre) const;
    bool toldRecently(const std::map<std::string, double>& times, const std::string& key,
                      double seconds) const;
    /// Of what the fix says of the spot and the way the user faces.
    double age() const { return m_fix.time - spotTime(); }
    double spotTime() const { return m_fix.followed ? m_fix.time : m_fix.evidenceTime; }
    /// Since anything was seen.
    double unseen() const { return m_fix.time - m_fix.evidenceTime; }
    bool headingIsGood() const;
    void followHeading();
    bool facesAway() const;
    bool turnsNow() const;
    std::optional<Radians> throughOf(const routing::Manoeuvre& gap) const;
    std::optional<Radians> onward(const routing::Manoeuvre& next, bool& along) const;
    void orient(Cue& cue) const;
    bool distanceIsGood() const;

    const building::Building& m_building;
    const GuidanceOptions& m_options;
    SchedulerMemory& m_memory;
    std::uint64_t m_frame;
    const localisation::Fix& m_fix;
    const Progress& m_progress;
    bool m_usable = false;
    bool m_sure = false;
    bool m_routeTold = false; ///< a cue of the route is among m_cues
    std::vector<Cue> m_cues;
};

} // namespace farol::guidance
