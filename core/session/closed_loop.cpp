#include "core/session/closed_loop.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace farol::session {

using guidance::Cue;
using guidance::CueKind;
using simulation::WalkWorld;

namespace {

/// Of the last minute, what counts as having been lost.
constexpr double kLastSeconds = 60.0, kLostShare = 0.5;

} // namespace

Result<void> ClosedLoopOptions::check() const {
    if (auto checked = navigator.check(); !checked) return checked;
    if (auto checked = walker.check(); !checked) return checked;
    if (!(framesPerSecond >= 0.2 && framesPerSecond <= 100.0))
        return Error{ErrorCode::InvalidArgument, "a walk has 0.2 to 100 frames a second", "framesPerSecond"};
    if (!(hearingSeconds >= 0.0 && hearingSeconds <= 60.0) || !(patience >= 1.0 && patience <= 1000.0) ||
        !(patienceSeconds >= 0.0 && patienceSeconds <= 1e6))
        return Error{ErrorCode::InvalidArgument, "hearing and patience are told in sensible seconds",
                     "closed loop"};
    return {};
}

std::string walkEndName(WalkEnd end) {
    switch (end) {
    case WalkEnd::Arrived:
        return "arrived";
    case WalkEnd::ArrivedElsewhere:
        return "arrived elsewhere";
    case WalkEnd::NoRoute:
        return "no route";
    case WalkEnd::Lost:
        return "lost";
    case WalkEnd::NotFound:
        return "not found";
    }
    return "unknown";
}

namespace {

/// Knows what it is told.
class TruthTeller : public localisation::Localiser {
public:
    void tell(const localisation::Fix& fix) { m_fix = fix; }

    void start(double, const std::optional<RegionId>&) override {}
    void setRoute(const localisation::RouteContext&) override {}
    localisation::Fix update(double time, std::span<const localisation::Observation>,
                             const std::deque<localisation::Observation>&) override {
        m_fix.time = m_fix.evidenceTime = time;
        return m_fix;
    }
    std::string name() const override { return "truth"; }

private:
    localisation::Fix m_fix;
};

localisation::Fix trueFix(const simulation::Walker& walker, const building::Building& building, bool spot) {
    localisation::Fix fix;
    fix.region = walker.region();
    fix.confidence = fix.nearConfidence = 1.0;
    fix.near = {walker.region()};
    fix.level = building.region(walker.region())->level;
    if (!spot) return fix;
    fix.position = walker.position();
    fix.followed = true;
    fix.sigmaM = 0.3;
    fix.heading = walker.pose().heading;
    fix.headingSigma = fromDegrees(20.0);
    return fix;
}

} // namespace

struct ClosedLoop::Impl {
    std::shared_ptr<const WalkWorld> world;
    ClosedLoopOptions options;
    Eye eye;
    Ear ear;
    std::function<void(const ClosedLoopMoment&)> handler;
    std::unique_ptr<simulation::Walker> walker;
    std::unique_ptr<Navigator> navigator;
    TruthTeller* truth = nullptr; ///< the navigator's localiser, if it is told the truth
    RegionId destination;
    ClosedLoopResult result;
    double mostSeconds = 0.0;
    std::deque<std::pair<double, simulation::WalkInstruction>> said;
    std::deque<bool> right; ///< of each frame of the last minute: was the place right?
    bool refused = false;

    void hear(const Cue& cue);
    void judge(const Cue& cue);
    void remember(const NavigationStep& step);
    bool near(const RegionId& region) const;
    Result<void> frame(std::uint64_t index);
    void finish();
};

bool ClosedLoop::Impl::near(const RegionId& region) const {
    const building::Building& building = world->building();
    auto a = building.regionIndex(region), b = building.regionIndex(walker->region());
    return a && b && (*a == *b || building.areNeighbours(*a, *b));
}

/// Was a place told that is wrong? Hedged words also name what is next to it.
void ClosedLoop::Impl::judge(const Cue& cue) {
    bool arrival = cue.kind == CueKind::Arrived || cue.kind == CueKind::AlreadyThere;
    if (arrival) result.announcedArrival = true;
    if (!arrival && cue.kind != CueKind::Located) return;
    bool true_ = cue.region == walker->region() || (!arrival && !cue.sure && near(cue.region));
    if (!true_) ++result.wrongRegionSaid;
}

void ClosedLoop::Impl::hear(const Cue& cue) {
    ++result.cues;
    judge(cue);
    if (cue.kind == CueKind::NoRoute) refused = true;
    auto heard = ear ? ear(cue) : std::optional(simulation::instructionOf(cue));
    if (heard) said.emplace_back(cue.time + options.hearingSeconds, std::move(*heard));
}

void ClosedLoop::Impl::remember(const NavigationStep& step) {
    right.push_back(step.fix.region == walker->region());
    if (static_cast<double>(right.size()) > kLastSeconds * options.framesPerSecond) right.pop_front();
}

Result<void> ClosedLoop::Impl::frame(std::uint64_t index) {
    double time = static_cast<double>(index) / options.framesPerSecond;
    while (!said.empty() && said.front().first <= time) {
        walker->walkUntil(std::max(walker->time(), said.front().first));
        walker->hear(said.front().second);
        said.pop_front();
    }
    walker->walkUntil(time);
    simulation::CameraPose pose = walker->pose();
    auto percept = eye(pose, *world->building().regionIndex(walker->region()), index);
    if (!percept) return percept.error();
    if (truth != nullptr)
        truth->tell(trueFix(*walker, world->building(), options.truePlace == TruePlace::Spot));
    NavigationStep step = navigator->advance(std::move(percept).value());
    for (const Cue& cue : step.cues) hear(cue);
    remember(step);
    if (handler) handler({pose, walker->region(), step});
    return {};
}

void ClosedLoop::Impl::finish() {
    result.seconds = walker->time();
    result.metres = walker->walkedM();
    result.arrived = walker->region() == destination;
    const building::Region* region = world->building().region(walker->region());
    std::string place = building::spokenName(*region);
    auto rightFrames = static_cast<double>(std::count(right.begin(), right.end(), true));
    if (walker->arrived() && result.announcedArrival) {
        result.end = result.arrived ? WalkEnd::Arrived : WalkEnd::ArrivedElsewhere;
        result.reason = result.arrived ? "arrived" : "told of the arrival in " + place;
        return;
    }
    if (refused) {
        result.end = WalkEnd::NoRoute;
        result.reason = "no way was known; stood in " + place;
    } else if (rightFrames < kLostShare * static_cast<double>(right.size())) {
        result.end = WalkEnd::Lost;
        result.reason = "time was up in " + place + ", taken for another place";
    } else {
        result.end = WalkEnd::NotFound;
        result.reason = "time was up in " + place + ", and what was told was not found";
    }
}

Result<std::unique_ptr<ClosedLoop>> ClosedLoop::create(std::shared_ptr<const WalkWorld> world,
                                                       const building::Location& from,
                                                       const building::Location& to,
                                                       const ClosedLoopOptions& options, Eye eye) {
    if (auto checked = options.check(); !checked) return checked.error();
    // The same building without its ownership: the world outlives the loop.
    std::shared_ptr<const building::Building> building(world, &world->building());
    auto walker = simulation::Walker::create(world, from, options.walker);
    if (!walker) return walker.error();
    auto teller = options.truePlace != TruePlace::No ? std::make_unique<TruthTeller>() : nullptr;
    TruthTeller* truth = teller.get();
    auto navigator = truth != nullptr ? Navigator::create(building, options.navigator, std::move(teller))
                                      : Navigator::create(building, options.navigator);
    if (!navigator) return navigator.error();
    auto planner = routing::makeOptimalPlanner(building, options.navigator.routing);
    auto route = planner->plan({(*walker)->region(), (*walker)->position()}, to);
    if (!route) return route.error();
    auto impl = std::make_unique<Impl>();
    impl->world = std::move(world);
    impl->options = options;
    impl->eye = std::move(eye);
    impl->destination = to.region;
    impl->result.shortestM = route->lengthM;
    impl->result.shortestS = route->seconds;
    impl->mostSeconds = options.patience * route->seconds + options.patienceSeconds;
    impl->walker = std::move(walker).value();
    impl->navigator = std::move(navigator).value();
    impl->truth = truth;
    impl->navigator->start(0.0, options.knownStart ? std::optional(from.region) : std::nullopt);
    impl->navigator->setDestination(to);
    return std::unique_ptr<ClosedLoop>(new ClosedLoop(std::move(impl)));
}

ClosedLoop::ClosedLoop(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
ClosedLoop::~ClosedLoop() = default;

void ClosedLoop::setEar(Ear ear) {
    m_impl->ear = std::move(ear);
}

void ClosedLoop::onMoment(std::function<void(const ClosedLoopMoment&)> handler) {
    m_impl->handler = std::move(handler);
}

Result<ClosedLoopResult> ClosedLoop::run() {
    for (std::uint64_t index = 0; m_impl->walker->time() < m_impl->mostSeconds; ++index) {
        if (auto seen = m_impl->frame(index); !seen) return seen.error();
        if (m_impl->walker->arrived() || m_impl->refused) break;
    }
    m_impl->finish();
    return m_impl->result;
}

ClosedLoop::Eye truthEye(std::shared_ptr<const WalkWorld> world,
                         const simulation::TruthDetectionOptions& options) {
    auto detections = std::make_shared<simulation::TruthDetections>(std::move(world), options);
    return [detections](const simulation::CameraPose& pose, std::size_t region,
                        std::uint64_t frame) -> Result<Percept> {
        simulation::TruthSight sight = detections->look(pose, region);
        Percept percept;
        percept.frame = frame;
        percept.time = pose.time;
        percept.size = {640, 480};
        percept.scene = sight.scene;
        percept.sharpness = 1.0;
        percept.detections = std::move(sight.detections);
        percept.motion = sight.motion;
        return percept;
    };
}

} // namespace farol::session
