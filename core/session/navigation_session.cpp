#include "core/session/navigation_session.h"

#include "core/base/database_source.h"
#include "core/base/log.h"
#include "core/capture/sayings.h"
#include "core/session/inbox.h"
#include "core/session/map_words.h"
#include "core/session/sayings.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace farol::session {

namespace {

constexpr std::size_t kWarningsShown = 8;

/// The session whose thread this is; null elsewhere.
thread_local const void* t_inside = nullptr;

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

bool changesCourse(const InboxItem& item) {
    const auto* command = std::get_if<Command>(&item);
    return command != nullptr && (std::holds_alternative<StartCommand>(*command) ||
                                  std::holds_alternative<DestinationCommand>(*command));
}

} // namespace

Result<void> SessionOptions::check() const {
    if (auto checked = perception.check(); !checked) return checked;
    if (auto checked = navigator.check(); !checked) return checked;
    if (!std::isfinite(speed) || speed < Pacer::kSlowest || speed > Pacer::kFastest)
        return Error{ErrorCode::InvalidArgument, "the speed of playing is to be between 0.05 and 1000",
                     "speed"};
    return {};
}

struct NavigationSession::Impl {
    Impl(SessionOptions sessionOptions, SessionHandlers sessionHandlers)
        : options(std::move(sessionOptions)), handlers(std::move(sessionHandlers)), inbox(options.speed) {}

    void runCapture();
    bool capture(std::vector<std::string>& messages);
    void hear(const capture::SourceEvent& event, std::vector<std::string>& messages);
    void runSession();
    void walk();
    bool handle(Work work, Perception& perception);
    void handle(const InboxItem& item);
    void handle(Parcel parcel, Perception& perception);
    bool looksOnThreads() const;
    Percept look(const capture::Frame& frame, Perception& perception, HopTimes& times);
    void perform(Command command);
    void tell(const std::string& message) { perform(MessageCommand{message}); }
    void recordingStopped(const Error& error);
    void end(const std::string& failure);
    void tellState();
    void publish(std::shared_ptr<Snapshot> next);
    void publishWithoutFrame(bool newCourse);
    ReplayHandlers outward();

    SessionOptions options;
    SessionHandlers handlers;
    Inbox inbox;
    std::shared_ptr<const recognition::LandmarkLibrary> library;
    std::unique_ptr<capture::FrameSource> source;

    // Of the session thread alone.
    std::unique_ptr<Navigator> navigator;
    std::unique_ptr<Recorder> recorder;
    std::vector<std::string> warnings;
    std::optional<RunState> told;
    bool cameraLost = false;

    mutable std::mutex snapshotMutex;
    std::shared_ptr<const Snapshot> snapshot;

    std::mutex lifecycle; ///< start, and the joining in stop
    bool started = false;
    std::jthread captureThread, sessionThread;
};

void NavigationSession::Impl::hear(const capture::SourceEvent& event, std::vector<std::string>& messages) {
    // A file's skipped picture is told just before the next frame, whatever the session is doing meanwhile:
    // the same walk gives the same lines. A camera's news cannot wait for a frame that may never come.
    if (event.kind == capture::SourceEventKind::FrameSkipped && !source->live()) {
        messages.push_back(event.message);
    } else {
        inbox.post(event);
    }
}

bool NavigationSession::Impl::capture(std::vector<std::string>& messages) {
    auto frame = source->next();
    inbox.setSkipped(source->skippedFrames());
    if (!frame) return false;
    Parcel parcel{std::move(*frame), std::exchange(messages, {})};
    if (source->live()) return inbox.putNewest(std::move(parcel));
    bool paced = options.pace == Pace::RealTime && !source->keepsPace();
    return paced ? inbox.putWhenDue(std::move(parcel)) : inbox.putWhenFree(std::move(parcel));
}

void NavigationSession::Impl::runCapture() {
    t_inside = this;
    std::vector<std::string> messages;
    source->onEvent([&](const capture::SourceEvent& event) { hear(event, messages); });
    std::string failure;
    try {
        if (inbox.waitUntilReady())
            while (capture(messages)) {
            }
        if (source->live() && !inbox.stopped())
            failure = said(capture::Saying::StreamEnded, {source->description()});
    } catch (const std::exception& exception) {
        failure = said(capture::Saying::SourceBroke, {source->description(), exception.what()});
    }
    source->onEvent({});
    inbox.finish(std::move(messages), std::move(failure));
}

ReplayHandlers NavigationSession::Impl::outward() {
    ReplayHandlers out;
    out.warning = handlers.warning;
    out.message = [this](double time, std::uint64_t frame, const std::string& text) {
        warnings.push_back(text);
        if (warnings.size() > kWarningsShown) warnings.erase(warnings.begin());
        if (handlers.message) handlers.message(time, frame, text);
    };
    return out;
}

void NavigationSession::Impl::recordingStopped(const Error& error) {
    std::string text = said(Saying::RecordingStopped, {error.text()});
    apply(MessageCommand{text}, *navigator, outward());
    apply(WarningCommand{guidance::CueReason::RecordingStopped, text}, *navigator, outward());
}

void NavigationSession::Impl::perform(Command command) {
    if (auto* start = std::get_if<StartCommand>(&command)) start->time = navigator->lastTime();
    if (recorder)
        if (auto written = recorder->write(command); !written) recordingStopped(written.error());
    apply(command, *navigator, outward());
}

void NavigationSession::Impl::handle(const InboxItem& item) {
    if (const auto* command = std::get_if<Command>(&item)) {
        perform(*command);
        return;
    }
    const auto& event = std::get<capture::SourceEvent>(item);
    tell(event.message);
    if (event.kind == capture::SourceEventKind::ConnectionLost && !std::exchange(cameraLost, true))
        perform(WarningCommand{guidance::CueReason::CameraLost, event.message});
    if (event.kind == capture::SourceEventKind::Reconnected && std::exchange(cameraLost, false))
        perform(WarningCommand{guidance::CueReason::CameraBack, event.message});
}

bool NavigationSession::Impl::looksOnThreads() const {
    if (options.looks != Looks::ByPace) return options.looks == Looks::OnThreads;
    return source->live() || (options.pace == Pace::RealTime && !source->keepsPace());
}

Percept NavigationSession::Impl::look(const capture::Frame& frame, Perception& perception, HopTimes& times) {
    try {
        Percept percept = perception.look(frame, &times);
        for (const std::string& message : perception.takeMessages()) tell(message);
        return percept;
    } catch (const std::exception& exception) {
        tell(said(Saying::FrameNotLookedAt, {std::to_string(frame.index), exception.what()}));
    }
    Percept blind;
    blind.frame = frame.index;
    blind.time = frame.capturedAt;
    blind.name = frame.name;
    blind.size = frame.size();
    return blind;
}

void NavigationSession::Impl::handle(Parcel parcel, Perception& perception) {
    for (const std::string& message : parcel.messages) tell(message);
    auto taken = std::chrono::steady_clock::now();
    auto next = std::make_shared<Snapshot>();
    Percept percept = look(parcel.frame, perception, next->times);
    if (recorder)
        if (auto written = recorder->write(percept, parcel.frame.image); !written)
            recordingStopped(written.error());
    auto before = std::chrono::steady_clock::now();
    next->step = navigator->advance(std::move(percept));
    next->times.navigateMs = millisecondsSince(before);
    next->times.loopMs = millisecondsSince(taken);
    if (parcel.frame.arrivedAt != std::chrono::steady_clock::time_point{})
        next->times.ageMs = millisecondsSince(parcel.frame.arrivedAt);
    if (auto arrived = next->times.landmarksArrivedAt;
        arrived && *arrived != std::chrono::steady_clock::time_point{})
        next->times.landmarkAgeMs = millisecondsSince(*arrived);
    next->frame = std::move(parcel.frame);
    publish(next);
    if (handlers.step) handlers.step(next->step, next->times);
}

void NavigationSession::Impl::publish(std::shared_ptr<Snapshot> next) {
    next->state = inbox.state();
    next->framesDropped = inbox.dropped();
    next->framesSkipped = inbox.skipped();
    next->warnings = warnings;
    next->source = options.sourceName;
    std::scoped_lock lock(snapshotMutex);
    snapshot = std::move(next);
}

void NavigationSession::Impl::publishWithoutFrame(bool newCourse) {
    // Only this thread writes `snapshot`, so it may be read here without the lock.
    auto next = snapshot ? std::make_shared<Snapshot>(*snapshot) : std::make_shared<Snapshot>();
    if (newCourse) {
        next->step.fix = navigator->lastFix();
        next->step.progress = navigator->preview();
    }
    next->step.cues.clear(); // told already with their frame
    publish(std::move(next));
}

void NavigationSession::Impl::tellState() {
    RunState now = inbox.state();
    if (told == now) return;
    told = now;
    publishWithoutFrame(false);
    if (handlers.state) handlers.state(now);
}

void NavigationSession::Impl::end(const std::string& failure) {
    if (!failure.empty()) {
        tell(failure);
        if (source->live() && !std::exchange(cameraLost, true))
            perform(WarningCommand{guidance::CueReason::CameraLost, failure});
    }
    inbox.setOver(failure.empty() ? RunState::Ended : RunState::Failed);
    tellState();
}

bool NavigationSession::Impl::handle(Work work, Perception& perception) {
    switch (work.kind) {
    case Work::Kind::Stopped:
        return false;
    case Work::Kind::Items:
        for (const InboxItem& item : work.items) handle(item);
        publishWithoutFrame(std::any_of(work.items.begin(), work.items.end(), changesCourse));
        break;
    case Work::Kind::StateChanged:
        tellState();
        break;
    case Work::Kind::Frame:
        handle(std::move(work.parcel), perception);
        break;
    case Work::Kind::Ended:
        for (const std::string& message : work.parcel.messages) tell(message);
        end(work.failure);
        break;
    }
    return true;
}

void NavigationSession::Impl::walk() {
    std::vector<std::string> missing;
    PerceptionOptions seeing = options.perception;
    if (seeing.textReader.words.empty()) seeing.textReader.words = wordsOf(navigator->building());
    Perception perception(library, std::move(seeing), missing,
                          looksOnThreads() ? lookOnAThread : lookOnTheSpot);
    for (const std::string& warning : missing) tell(warning);
    tellState();
    inbox.setReady();
    while (handle(inbox.next(), perception)) {
    }
}

void NavigationSession::Impl::runSession() {
    t_inside = this;
    try {
        walk();
        tellState();
    } catch (const std::exception& exception) {
        // Nothing of ours throws; a library or a handler did. The walk ends with a word instead of the
        // program.
        std::string text = said(Saying::WalkBrokeOff, {exception.what()});
        logError(text);
        inbox.setOver(RunState::Failed);
        source->requestStop();
        if (handlers.message) handlers.message(navigator->lastTime(), navigator->lastFrame(), text);
        if (handlers.state) handlers.state(RunState::Failed);
    }
    inbox.stop(); // the capture thread must not wait for a taker that is gone
}

Result<std::unique_ptr<NavigationSession>>
NavigationSession::create(std::shared_ptr<const building::Building> building,
                          std::shared_ptr<const recognition::LandmarkLibrary> library,
                          std::unique_ptr<capture::FrameSource> source, const SessionOptions& options,
                          SessionHandlers handlers) {
    if (!source) return Error{ErrorCode::InvalidArgument, said(Saying::NoSource), "source"};
    if (auto checked = options.check(); !checked) return checked.error();
    auto navigator = Navigator::create(building, options.navigator);
    if (!navigator) return navigator.error();
    auto impl = std::make_unique<Impl>(options, std::move(handlers));
    if (impl->options.sourceName.empty()) impl->options.sourceName = source->description();
    if (options.recordFolder) {
        RecordingHeader header{1, impl->options.sourceName, shownSource(options.mapName), options.libraryName,
                               options.navigator};
        auto recorder = Recorder::create(*options.recordFolder, header, *building);
        if (!recorder) return recorder.error();
        impl->recorder = std::move(recorder).value();
    }
    impl->library = std::move(library);
    impl->source = std::move(source);
    if (options.pace == Pace::RealTime) impl->source->setSpeed(options.speed);
    impl->navigator = std::move(navigator).value();
    return std::unique_ptr<NavigationSession>(new NavigationSession(std::move(impl)));
}

NavigationSession::NavigationSession(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

NavigationSession::~NavigationSession() {
    stop();
}

void NavigationSession::start() {
    std::scoped_lock lock(m_impl->lifecycle);
    if (m_impl->started || m_impl->inbox.stopped()) return;
    m_impl->started = true;
    m_impl->inbox.begin();
    m_impl->sessionThread = std::jthread([impl = m_impl.get()] { impl->runSession(); });
    m_impl->captureThread = std::jthread([impl = m_impl.get()] { impl->runCapture(); });
}

void NavigationSession::stop() {
    m_impl->inbox.stop();
    m_impl->source->requestStop();
    if (t_inside == m_impl.get()) return;
    std::scoped_lock lock(m_impl->lifecycle);
    if (m_impl->captureThread.joinable()) m_impl->captureThread.join();
    if (m_impl->sessionThread.joinable()) m_impl->sessionThread.join();
}

void NavigationSession::wait() {
    m_impl->inbox.waitUntilOver();
}

void NavigationSession::setStart(const std::optional<RegionId>& region) {
    m_impl->inbox.post(Command(StartCommand{0.0, region})); // its time is that of the frame before
}

void NavigationSession::setDestination(const std::optional<building::Location>& destination) {
    m_impl->inbox.post(Command(DestinationCommand{destination}));
}

void NavigationSession::setVerbosity(guidance::Verbosity verbosity) {
    m_impl->inbox.post(Command(VerbosityCommand{verbosity}));
}

void NavigationSession::setLanguage(const std::string& language) {
    m_impl->inbox.post(Command(LanguageCommand{language}));
}

void NavigationSession::ask(guidance::Question question) {
    m_impl->inbox.post(Command(AskCommand{question}));
}

void NavigationSession::heard(std::uint64_t cue) {
    m_impl->inbox.post(Command(HeardCommand{cue}));
}

void NavigationSession::pause() {
    m_impl->inbox.pause();
}
void NavigationSession::resume() {
    m_impl->inbox.resume();
}
void NavigationSession::stepOnce() {
    m_impl->inbox.stepOnce();
}
void NavigationSession::setSpeed(double factor) {
    m_impl->inbox.setSpeed(factor);
    if (m_impl->options.pace == Pace::RealTime) m_impl->source->setSpeed(factor);
}
RunState NavigationSession::state() const {
    return m_impl->inbox.state();
}

std::shared_ptr<const Snapshot> NavigationSession::snapshot() const {
    std::scoped_lock lock(m_impl->snapshotMutex);
    return m_impl->snapshot;
}

} // namespace farol::session
