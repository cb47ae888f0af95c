#include "core/session/navigator.h"

#include "core/session/sayings.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace farol::session {

namespace {

constexpr const char* kGuidedLocalisers = "bayes-guided";
constexpr double kGuidedSure = 0.8;
/// A place that is as likely as not to be another one is no ground for sending anybody through a door.
constexpr double kUsable = 0.5, kUsableNear = 0.8;
constexpr double kHopeless = 0.15;
constexpr std::size_t kMostUnheard = 32; // what waits longer to be said is not said any more
/// Longer than the guidance takes to tell an order again, which a voice that speaks would then have said.
constexpr double kForgottenSeconds = 20.0;
/// A voice does not say the same again so soon: then it was heard all the same.
constexpr double kStillInEarSeconds = 15.0;

Result<std::shared_ptr<const routing::Planner>>
makePlanner(const std::shared_ptr<const building::Building>& building, const NavigatorOptions& options) {
    if (options.planner == "optimal")
        return std::shared_ptr<const routing::Planner>(
            routing::makeOptimalPlanner(building, options.routing));
    if (options.planner == "greedy")
        return std::shared_ptr<const routing::Planner>(routing::makeGreedyPlanner(building, options.routing));
    return Error{ErrorCode::InvalidArgument,
                 "there is no planner \"" + options.planner + "\"; choose optimal or greedy", "planner"};
}

/// The filter's confidence is a probability, and "you have arrived" is to be true.
guidance::TrackerOptions trackerOptions(const NavigatorOptions& options) {
    constexpr double kArrivalConfidence = 0.97, kPatientSeconds = 20.0;
    constexpr double kGuessedSeconds = 3.0; // that the way was left
    guidance::TrackerOptions tracker = options.tracker;
    bool filter = options.localiser.rfind("bayes", 0) == 0;
    if (filter && tracker.arrivalConfidence == 0.0) tracker.arrivalConfidence = kArrivalConfidence;
    if (filter && tracker.patientSeconds == 0.0) tracker.patientSeconds = kPatientSeconds;
    if (filter && tracker.offRouteSeconds == 0.0) tracker.offRouteSeconds = kGuessedSeconds;
    if (filter && tracker.guessConfidence == 0.0) tracker.guessConfidence = kUsable;
    if (filter && tracker.hopelessConfidence == 0.0) tracker.hopelessConfidence = kHopeless;
    return tracker;
}

std::vector<localisation::Observation> observationsOf(const Percept& percept) {
    std::vector<localisation::Observation> seen;
    seen.reserve(percept.detections.size());
    for (const recognition::Detection& detection : percept.detections) {
        localisation::Observation one{detection, percept.time, percept.frame, percept.scene};
        if (detection.track != 0) one.track = detection.track;
        one.confirmations = detection.confirmations;
        seen.push_back(std::move(one));
    }
    return seen;
}

/// What a cue tells to pass; empty: it tells no way.
std::optional<localisation::ToldWay> toldBy(const building::Building& building, const guidance::Cue& cue) {
    using guidance::CueKind;
    bool tells = cue.kind == CueKind::RouteStart || cue.kind == CueKind::Prepare ||
                 cue.kind == CueKind::Act || cue.kind == CueKind::OffRoute || cue.kind == CueKind::Arrived ||
                 cue.kind == CueKind::AlreadyThere || cue.kind == CueKind::NoRoute;
    if (!tells) return std::nullopt;
    localisation::ToldWay way;
    for (const std::optional<routing::Manoeuvre>& each : {cue.manoeuvre, cue.next}) {
        const building::Access* access = each ? building.access(each->access) : nullptr;
        if (access == nullptr) continue;
        const building::Region* into = building.region(each->into);
        bool lift = access->kind != building::AccessKind::Elevator && into != nullptr &&
                    into->kind == building::RegionKind::Elevator;
        way.passages.push_back({access->kind, each->level, each->targetLevel, lift});
    }
    return way;
}

bool sameWay(const localisation::ToldWay& a, const localisation::ToldWay& b) {
    using Passage = localisation::ToldWay::Passage;
    return std::equal(a.passages.begin(), a.passages.end(), b.passages.begin(), b.passages.end(),
                      [](const Passage& one, const Passage& other) {
                          return one.kind == other.kind && one.level == other.level &&
                                 one.targetLevel == other.targetLevel && one.intoLift == other.intoLift;
                      });
}

} // namespace

Result<void> NavigatorOptions::check() const {
    for (const Result<void>& checked : {routing.check(), history.check(), tracker.check(), guidance.check()})
        if (!checked) return checked;
    return {};
}

NavigatorOptions NavigatorOptions::with(const std::string& localiser) {
    NavigatorOptions options;
    options.localiser = localiser;
    if (localiser.rfind(kGuidedLocalisers, 0) == 0) {
        options.guidance.sureConfidence = kGuidedSure;
        options.guidance.usableConfidence = kUsable;
        options.guidance.usableNearConfidence = kUsableNear;
    }
    return options;
}

Result<std::unique_ptr<Navigator>> Navigator::create(std::shared_ptr<const building::Building> building,
                                                     const NavigatorOptions& options) {
    if (!building) return Error{ErrorCode::InvalidArgument, said(Saying::NoMap), "map"};
    auto localiser = localisation::makeLocaliser(options.localiser, building);
    if (!localiser) return localiser.error();
    return create(std::move(building), options, std::move(localiser).value());
}

Result<std::unique_ptr<Navigator>> Navigator::create(std::shared_ptr<const building::Building> building,
                                                     const NavigatorOptions& options,
                                                     std::unique_ptr<localisation::Localiser> localiser) {
    if (!building) return Error{ErrorCode::InvalidArgument, said(Saying::NoMap), "map"};
    if (auto checked = options.check(); !checked) return checked.error();
    auto planner = makePlanner(building, options);
    if (!planner) return planner.error();
    return std::unique_ptr<Navigator>(
        new Navigator(std::move(building), std::move(localiser), std::move(planner).value(), options));
}

Navigator::Navigator(const std::shared_ptr<const building::Building>& building,
                     std::unique_ptr<localisation::Localiser> localiser,
                     std::shared_ptr<const routing::Planner> planner, const NavigatorOptions& options)
    : m_building(building),
      m_localiser(std::move(localiser)),
      m_history(options.history),
      m_tracker(building, std::move(planner), trackerOptions(options)),
      m_scheduler(building, options.guidance),
      m_heardIsReported(options.heardIsReported) {
    m_localiser->start(0.0, std::nullopt);
}

void Navigator::start(double time, const std::optional<RegionId>& region) {
    m_history.clear();
    m_unheard.clear();
    m_heardWay.reset();
    m_localiser->start(time, region);
    m_lastFix = {};
    m_lastFix.time = time;
    // Only for preview(): the next frame brings the localiser's own word.
    m_lastFix.region = region;
    m_lastFix.confidence = region ? 1.0 : 0.0;
}

void Navigator::setDestination(const std::optional<building::Location>& destination) {
    m_tracker.setDestination(destination);
}

void Navigator::setVerbosity(guidance::Verbosity verbosity) {
    m_scheduler.setVerbosity(verbosity);
}

void Navigator::setLanguage(std::string language) {
    m_scheduler.setLanguage(std::move(language));
}

NavigationStep Navigator::advance(Percept percept) {
    percept.time = std::max(percept.time, m_lastTime);
    m_lastTime = percept.time;
    m_lastFrame = percept.frame;
    NavigationStep step;
    step.fresh = m_history.add(observationsOf(percept));
    step.history = m_history.items();
    if (percept.motion.turn || percept.motion.speed) m_localiser->moved(percept.time, percept.motion);
    localisation::RouteContext context = m_tracker.context();
    context.destination = m_tracker.destination();
    m_localiser->setRoute(context);
    step.fix = m_localiser->update(percept.time, step.fresh, step.history);
    step.progress = m_tracker.update(step.fix);
    step.cues = m_scheduler.update(percept.frame, step.fix, step.progress, step.fresh);
    for (const guidance::Cue& cue : step.cues) issued(cue);
    forgetUnheard(percept.time);
    step.percept = std::move(percept);
    m_lastFix = step.fix;
    return step;
}

void Navigator::issued(const guidance::Cue& cue) {
    auto way = toldBy(*m_building, cue);
    if (!way) return;
    if (!m_heardIsReported) return m_localiser->told(*way);
    m_unheard.push_back({cue.id, m_lastTime, std::move(*way)});
    if (m_unheard.size() > kMostUnheard) m_unheard.pop_front();
}

void Navigator::heard(std::uint64_t cue) {
    auto found = std::find_if(m_unheard.begin(), m_unheard.end(),
                              [&](const Unheard& unheard) { return unheard.cue == cue; });
    if (found == m_unheard.end()) return;
    m_localiser->told(found->way);
    m_heardWay = std::move(found->way);
    m_heardAt = m_lastTime;
    m_lastHeard = std::max(m_lastHeard, cue);
    m_unheard.erase(found);
}

/// An order that is not heard for long means that nobody hears anything: it is not known any more what the
/// user does.
void Navigator::forgetUnheard(double time) {
    if (!m_heardWay) return;
    auto missed = std::find_if(m_unheard.begin(), m_unheard.end(), [&](const Unheard& unheard) {
        bool inEar = unheard.time - m_heardAt < kStillInEarSeconds && sameWay(unheard.way, *m_heardWay);
        return unheard.cue > m_lastHeard && !inEar;
    });
    if (missed == m_unheard.end() || time - missed->time < kForgottenSeconds) return;
    m_heardWay.reset();
    m_localiser->told(std::nullopt);
    m_lastHeard = m_unheard.back().cue;
}

guidance::Cue Navigator::warning(guidance::CueReason reason, std::string detail) {
    return m_scheduler.warning(m_lastFrame, m_lastTime, reason, std::move(detail));
}

guidance::Cue Navigator::answer(guidance::Question question) {
    guidance::Cue cue = m_scheduler.answer(question, m_lastFrame, m_lastFix, preview());
    // Whoever asks, and hears what to do, does it; before a voice says it, nobody has heard anything.
    if (m_heardIsReported) issued(cue);
    return cue;
}

guidance::Progress Navigator::preview() const {
    static_assert(std::is_copy_constructible_v<guidance::RouteTracker>);
    guidance::RouteTracker copy = m_tracker;
    return copy.update(m_lastFix);
}

} // namespace farol::session
