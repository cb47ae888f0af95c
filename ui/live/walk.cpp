#include "ui/live/walk.h"

#include "core/base/database_source.h"
#include "core/recognition/landmark_library.h"
#include "ui/convert/convert.h"
#include "ui/models/core_words.h"
#include "ui/speech/phrasebook.h"

#include <QDir>
#include <QFileInfo>

namespace farol::ui {

namespace {

constexpr int kPullMs = 33; // 30 times a second

} // namespace

Walk::Walk(OpenSource open, QObject* parent)
    : QObject(parent), m_openSource(std::move(open)), m_background(this) {
    if (!m_openSource)
        m_openSource = [](const std::string& name, const capture::SourceOptions& options) {
            return capture::openSource(name, options);
        };
    m_pull.setInterval(kPullMs);
    connect(&m_pull, &QTimer::timeout, this, &Walk::pull);
}

Walk::~Walk() {
    m_background.doorway()->detach();
    if (m_session) m_session->stop();
}

void Walk::loadMap(const QString& path) {
    const std::uint64_t job = ++m_mapJob;
    ++m_loading;
    tellBusy();
    m_background.run([name = toUtf8(path)] { return building::loadBuilding(name); },
                     [this, job, path](Result<building::LoadedBuilding> result) {
                         --m_loading;
                         tellBusy();
                         if (job == m_mapJob) mapLoaded(path, std::move(result));
                     });
}

void Walk::mapLoaded(const QString& path, Result<building::LoadedBuilding> result) {
    if (!result) {
        m_playWanted = false;
        Q_EMIT problem(Problem::Map, CoreWords::problem(result.error()));
        return;
    }
    endSession();
    m_building = result->building;
    m_mapName = toQString(shownSource(toUtf8(path))); // it is shown and remembered: without a password
    m_start.reset();
    m_destination.reset();
    m_shown.reset();
    Q_EMIT problemSolved(Problem::Map);
    Q_EMIT mapChanged();
    const std::vector<std::string>& warnings = result->warnings;
    if (!warnings.empty()) {
        QString text = tr("%n remark(s) about the map: %1", nullptr, static_cast<int>(warnings.size()))
                           .arg(CoreWords::remark(warnings.front()));
        Q_EMIT remark(text);
    }
    startIfWanted();
}

void Walk::loadLibrary(const QString& path) {
    const std::uint64_t job = ++m_libraryJob;
    ++m_loading;
    tellBusy();
    m_background.run([name = toUtf8(path)] { return recognition::loadLibrary(name); },
                     [this, job, path](Result<recognition::LandmarkLibrary> result) {
                         --m_loading;
                         tellBusy();
                         if (job != m_libraryJob) return;
                         if (!result) {
                             m_playWanted = false;
                             Q_EMIT problem(Problem::Library, CoreWords::problem(result.error()));
                             return;
                         }
                         endSession();
                         m_library = std::make_shared<const recognition::LandmarkLibrary>(std::move(*result));
                         m_libraryName = path;
                         Q_EMIT problemSolved(Problem::Library);
                         Q_EMIT libraryChanged();
                         startIfWanted();
                     });
}

void Walk::dropLibrary() {
    ++m_libraryJob;
    endSession();
    m_library.reset();
    m_libraryName.clear();
    Q_EMIT libraryChanged();
}

void Walk::setSource(const WalkSource& source) {
    endSession();
    m_source = source;
    Q_EMIT problemSolved(Problem::Source);
    Q_EMIT sourceChanged();
}

void Walk::tellBusy() {
    QString text;
    if (m_opening)
        text = tr("Opening %1…").arg(m_source.name);
    else if (m_loading > 0)
        text = tr("Loading…");
    if (text == m_busyText) return;
    m_busyText = text;
    Q_EMIT busyChanged(text);
}

void Walk::startIfWanted() {
    if (m_playWanted && m_loading == 0) play();
}

void Walk::play() {
    if (m_loading > 0) {
        m_playWanted = true; // as soon as everything is there
        return;
    }
    m_playWanted = false;
    if (m_session && m_state == session::RunState::Paused) {
        m_session->resume();
        return;
    }
    if (m_session && m_state == session::RunState::Running) return;
    open(false);
}

void Walk::step() {
    if (m_loading > 0) return;
    if (m_session && (m_state == session::RunState::Paused || m_state == session::RunState::Running)) {
        m_session->stepOnce();
        return;
    }
    open(true);
}

void Walk::pause() {
    m_playWanted = false;
    if (m_session)
        m_session->pause();
    else if (m_opening)
        m_pauseWhenOpen = true;
}

void Walk::stop() {
    m_playWanted = false;
    endSession();
}

void Walk::endSession() {
    ++m_serial; // what the old session still says does not count
    m_opening = false;
    dispose();
    m_pull.stop();
    m_recording.clear();
    tellBusy();
    setState(session::RunState::Idle);
}

void Walk::dispose() {
    if (!m_session) return;
    // A camera can take seconds to give up: not on this thread.
    std::shared_ptr<session::NavigationSession> old(std::move(m_session));
    m_background.run([old] { old->stop(); });
}

void Walk::open(bool stepOnly) {
    if (m_opening) return;
    if (!m_building) return Q_EMIT problem(Problem::Session, tr("Open a map first (Ctrl+O)."));
    if (m_source.name.isEmpty())
        return Q_EMIT problem(Problem::Session,
                              tr("Open a camera, a video or a folder of pictures first (Ctrl+P)."));
    dispose();
    m_pull.stop();
    const std::uint64_t serial = ++m_serial;
    m_opening = true;
    m_pauseWhenOpen = false;
    tellBusy();

    session::SessionOptions options;
    options.pace = session::Pace::RealTime;
    options.speed = m_speed;
    options.mapName = toUtf8(m_mapName);
    options.libraryName = toUtf8(m_libraryName);
    options.sourceName = toUtf8(m_source.name);
    options.navigator = session::NavigatorOptions::with(toUtf8(m_localiser));
    options.navigator.guidance.verbosity = m_verbosity;
    options.navigator.heardIsReported =
        m_voiced && !m_source.name.startsWith(QLatin1String("sim:"), Qt::CaseInsensitive);
    if (m_adjust) m_adjust(options);
    options.navigator.guidance.language = toUtf8(installedLanguage());
    m_recording = m_nextFolder ? m_nextFolder().value_or(QString()) : QString();
    if (!m_recording.isEmpty()) options.recordFolder = toUtf8(m_recording);
    capture::SourceOptions sourceOptions;
    sourceOptions.framesPerSecond = m_source.framesPerSecond;

    using Made = Result<std::unique_ptr<session::NavigationSession>>;
    const auto work = [open = m_openSource, options, sourceOptions, building = m_building,
                       library = m_library, handlers = handlersFor(serial), folder = m_recording]() -> Made {
        if (!folder.isEmpty() && !QDir().mkpath(QFileInfo(folder).absolutePath()))
            return Error{
                ErrorCode::Io,
                toUtf8(tr("the folder for recordings cannot be made; choose another one in the settings")),
                toUtf8(QFileInfo(folder).absolutePath())};
        auto source = open(options.sourceName, sourceOptions);
        if (!source) return source.error();
        return session::NavigationSession::create(building, library, std::move(*source), options, handlers);
    };
    m_background.run(work,
                     [this, serial, stepOnly](Made result) { opened(serial, std::move(result), stepOnly); });
}

session::SessionHandlers Walk::handlersFor(std::uint64_t serial) {
    // Called on the session's thread: everything goes through the door, in order.
    const auto post = [this, door = m_background.doorway(), serial](std::function<void()> call) {
        door->post([this, serial, call = std::move(call)] {
            if (serial == m_serial) call();
        });
    };
    session::SessionHandlers handlers;
    handlers.step = [this, post](const session::NavigationStep& step, const session::HopTimes&) {
        post([this, step] {
            Q_EMIT stepped(step);
            for (const guidance::Cue& cue : step.cues) Q_EMIT cueCame(cue);
        });
    };
    handlers.warning = [this, post](const guidance::Cue& cue) { post([this, cue] { Q_EMIT cueCame(cue); }); };
    handlers.message = [this, post](double, std::uint64_t, const std::string& text) {
        const QString words = text == session::kNoTrainedLandmarks
                                  ? tr("No trained landmarks: only doors and texts are recognised. Open a "
                                       "library of landmarks to recognise more.")
                                  : CoreWords::message(text);
        post([this, words] { Q_EMIT remark(words); });
    };
    handlers.state = [this, post](session::RunState state) {
        post([this, state] {
            pull(); // the last picture before the news
            if (state == session::RunState::Ended || state == session::RunState::Failed) m_pull.stop();
            setState(state);
        });
    };
    return handlers;
}

void Walk::opened(std::uint64_t serial, Result<std::unique_ptr<session::NavigationSession>> result,
                  bool stepOnly) {
    if (serial != m_serial) {
        if (!result) return;
        std::shared_ptr<session::NavigationSession> unwanted(std::move(*result));
        m_background.run([unwanted] { unwanted->stop(); });
        return;
    }
    m_opening = false;
    tellBusy();
    if (!result) {
        m_recording.clear();
        Q_EMIT problem(Problem::Source, CoreWords::problem(result.error()));
        setState(session::RunState::Failed);
        return;
    }
    Q_EMIT problemSolved(Problem::Source);
    Q_EMIT problemSolved(Problem::Session);
    m_session = std::move(*result);
    m_shown.reset();
    Q_EMIT walkBegan();
    if (m_start) m_session->setStart(m_start);
    if (m_destination) m_session->setDestination(building::Location{*m_destination, std::nullopt});
    m_session->setVerbosity(m_verbosity);
    m_session->setSpeed(m_speed);
    const bool paused = stepOnly || m_pauseWhenOpen;
    if (paused) m_session->pause();
    setState(paused ? session::RunState::Paused : session::RunState::Running);
    m_session->start();
    if (stepOnly) m_session->stepOnce();
    m_pull.start();
}

void Walk::pull() {
    if (!m_session) return;
    std::shared_ptr<const session::Snapshot> newest = m_session->snapshot();
    if (!newest || newest == m_shown) return;
    m_shown = std::move(newest);
    Q_EMIT snapshotChanged();
}

void Walk::setState(session::RunState state) {
    if (state == m_state) return;
    m_state = state;
    Q_EMIT stateChanged(state);
}

void Walk::setSpeed(double factor) {
    m_speed = factor;
    if (m_session) m_session->setSpeed(factor);
}

void Walk::setStart(const std::optional<RegionId>& region) {
    m_start = region;
    if (m_session) m_session->setStart(region);
    Q_EMIT placesChanged();
}

void Walk::correct(const std::optional<RegionId>& region) {
    if (!m_session) return;
    m_session->setStart(region);
    Q_EMIT corrected(region);
}

void Walk::setDestination(const std::optional<RegionId>& region) {
    m_destination = region;
    if (m_session)
        m_session->setDestination(region ? std::optional(building::Location{*region, std::nullopt})
                                         : std::nullopt);
    Q_EMIT placesChanged();
}

void Walk::setVerbosity(guidance::Verbosity verbosity) {
    m_verbosity = verbosity;
    if (m_session) m_session->setVerbosity(verbosity);
}

void Walk::followLanguage() {
    if (m_session) m_session->setLanguage(toUtf8(installedLanguage()));
}

void Walk::ask(guidance::Question question) {
    if (m_session) m_session->ask(question);
}

void Walk::heard(const guidance::Cue& cue) {
    if (m_session && m_voiced) m_session->heard(cue.id);
}

} // namespace farol::ui
