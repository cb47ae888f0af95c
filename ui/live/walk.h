#pragma once
// The walk as the window sees it: material is loaded and opened in the background, a session is made from it,
// its snapshots are pulled 30 times a second and its cues arrive in order. GUI thread; nothing here blocks
// it.

#include "core/building/geopackage.h"
#include "core/session/navigation_session.h"
#include "ui/convert/background.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

namespace farol::ui {

struct WalkSource {
    QString name;                 ///< as for --source
    double framesPerSecond = 0.0; ///< of pictures in a folder; 0: as the source has it
};

enum class Problem { Map, Library, Source, Session, Recording };

class Walk : public QObject {
    Q_OBJECT

public:
    using OpenSource = std::function<Result<std::unique_ptr<capture::FrameSource>>(
        const std::string&, const capture::SourceOptions&)>;

    /// `open` is replaced by tests; empty: camera, file, folder, address.
    explicit Walk(OpenSource open = {}, QObject* parent = nullptr);
    ~Walk() override; ///< stops and waits; what is still loading is waited for and dropped

    const OpenSource& opener() const { return m_openSource; }
    void loadMap(const QString& path);
    void loadLibrary(const QString& path);
    void dropLibrary();
    void setSource(const WalkSource& source);

    void play(); ///< starts, or goes on after a pause; waits for what is still loading
    void pause();
    void step(); ///< one picture; starts the walk when there is none
    void stop();
    void setSpeed(double factor);
    void setStart(const std::optional<RegionId>& region);
    /// The user is there now, or (empty) it is not known where; the start of the next walk stays. Nothing
    /// without a walk.
    void correct(const std::optional<RegionId>& region);
    void setDestination(const std::optional<RegionId>& region);
    void setVerbosity(guidance::Verbosity verbosity);
    /// How the next walk works out the place: one of localisation::localiserNames().
    void setLocaliser(const QString& name) { m_localiser = name; }
    const QString& localiser() const { return m_localiser; }
    /// The program speaks another language now: the names of places follow.
    void followLanguage();
    /// The answer comes as a cue; without a walk none comes.
    void ask(guidance::Question question);
    /// A voice says the cues, and tells by heard() what it has begun to say; from the next walk on. A
    /// simulated walker hears all cues, whatever the voice does.
    void setVoiced(bool voiced) { m_voiced = voiced; }
    void heard(const guidance::Cue& cue);
    /// Changes the options of the next walk; called as it begins.
    void setAdjust(std::function<void(session::SessionOptions&)> adjust) { m_adjust = std::move(adjust); }
    /// Where the next walk is recorded; empty: it is not. A running walk keeps what it has.
    void setRecordFolder(std::function<std::optional<QString>()> nextFolder) {
        m_nextFolder = std::move(nextFolder);
    }

    session::RunState state() const { return m_state; }
    bool active() const { return m_session != nullptr || m_opening; }
    bool loading() const { return m_loading > 0 || m_opening; }
    const std::shared_ptr<const building::Building>& building() const { return m_building; }
    const std::shared_ptr<const session::Snapshot>& snapshot() const { return m_shown; }
    const WalkSource& source() const { return m_source; }
    const std::optional<RegionId>& start() const { return m_start; }
    const std::optional<RegionId>& destination() const { return m_destination; }
    const QString& mapName() const { return m_mapName; }
    const QString& libraryName() const { return m_libraryName; }
    const QString& recording() const { return m_recording; } ///< folder of the running recording; empty: none

Q_SIGNALS:
    void mapChanged();
    void libraryChanged();
    void sourceChanged();
    void corrected(const std::optional<farol::RegionId>& region); ///< by the assistant, just now
    void placesChanged();                                         ///< start or destination
    void busyChanged(const QString& what);                        ///< empty: nothing is being loaded
    void problem(farol::ui::Problem kind, const QString& message);
    void problemSolved(farol::ui::Problem kind);
    void remark(const QString& message); ///< what is odd in a map, a lost camera, skipped pictures
    void stateChanged(farol::session::RunState state);
    void walkBegan(); ///< a new session: forget what the old one said
    void snapshotChanged();
    void stepped(const farol::session::NavigationStep& step); ///< before its cues
    void cueCame(const farol::guidance::Cue& cue);

private:
    void open(bool pausedAfterOne);
    void opened(std::uint64_t serial, Result<std::unique_ptr<session::NavigationSession>> result,
                bool stepOnly);
    session::SessionHandlers handlersFor(std::uint64_t serial);
    void endSession(); ///< a wish to play once everything is loaded stays
    void dispose();
    void pull();
    void setState(session::RunState state);
    void mapLoaded(const QString& path, Result<building::LoadedBuilding> result);
    void startIfWanted();
    void tellBusy();

    OpenSource m_openSource;
    std::shared_ptr<const building::Building> m_building;
    std::shared_ptr<const recognition::LandmarkLibrary> m_library;
    QString m_mapName, m_libraryName, m_recording;
    WalkSource m_source;
    std::optional<RegionId> m_start, m_destination;
    guidance::Verbosity m_verbosity = guidance::Verbosity::Objects;
    double m_speed = 1.0;
    QString m_localiser = QStringLiteral("bayes-guided"); ///< users know the way from what is said
    std::function<std::optional<QString>()> m_nextFolder;
    std::function<void(session::SessionOptions&)> m_adjust;

    std::unique_ptr<session::NavigationSession> m_session;
    std::shared_ptr<const session::Snapshot> m_shown;
    session::RunState m_state = session::RunState::Idle;
    std::uint64_t m_serial = 0; ///< of the session whose messages count
    bool m_opening = false, m_pauseWhenOpen = false;
    bool m_voiced = false;
    int m_loading = 0;
    bool m_playWanted = false;
    std::uint64_t m_mapJob = 0, m_libraryJob = 0;
    QString m_busyText;
    QTimer m_pull;
    Background m_background; ///< last: its jobs use the rest
};

} // namespace farol::ui
