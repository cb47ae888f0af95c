#pragma once
// A walk: a source, perception and a navigator on two threads (capture, session) with a one-slot mailbox
// between them and the newest snapshot for the GUI. Live sources drop old frames and count them; files wait,
// so that nothing is lost. Where frames come at a pace of their own, slow looks at them have threads too.

#include "core/session/navigator.h"
#include "core/session/perception.h"
#include "core/session/recorder.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace farol::session {

enum class Pace { AsFastAsPossible, RealTime };

/// Where slow looks (landmarks, doors, text) are taken.
enum class Looks {
    ByPace,    ///< on threads for live sources and real time, else on the spot
    OnTheSpot, ///< the session's thread waits for each: the same material gives the same walk
    OnThreads
};

struct SessionOptions {
    PerceptionOptions perception;
    NavigatorOptions navigator;
    Pace pace = Pace::AsFastAsPossible; ///< of sources that are not live; RealTime also drops frames that
                                        ///< come too late
    double speed = 1.0;                 ///< of RealTime
    Looks looks = Looks::ByPace;
    std::optional<std::filesystem::path> recordFolder;
    std::string mapName, libraryName, sourceName; ///< for the recording's header

    Result<void> check() const;
};

/// Called on the session thread, in order; they must not block for long. After stop() none is called any
/// more. A handler that calls stop() itself only asks for it: the thread cannot wait for its own end.
struct SessionHandlers {
    std::function<void(const NavigationStep&, const HopTimes&)> step;
    std::function<void(const guidance::Cue&)> warning; ///< cues from outside the chain: warnings, answers
    std::function<void(double, std::uint64_t, const std::string&)>
        message; ///< time, frame, text: for the log
    std::function<void(RunState)> state;
};

/// Commands may come from any thread; they take effect before the next frame, also while paused, before
/// start() (then with it) and after the end of the material.
class NavigationSession {
public:
    static Result<std::unique_ptr<NavigationSession>>
    create(std::shared_ptr<const building::Building> building,
           std::shared_ptr<const recognition::LandmarkLibrary> library,
           std::unique_ptr<capture::FrameSource> source, const SessionOptions& options,
           SessionHandlers handlers);
    ~NavigationSession(); ///< stops and joins

    void start();
    /// Asks both threads to end and waits for them. Safe at any moment, from any thread, and twice.
    void stop();
    /// Waits until the material is at its end (or stop() was called); returns at once before start().
    void wait();

    void setStart(const std::optional<RegionId>& region);
    void setDestination(const std::optional<building::Location>& destination);
    void setVerbosity(guidance::Verbosity verbosity);
    void setLanguage(const std::string& language); ///< of the map's names: "pt"
    /// The answer comes as a cue to the `warning` handler, also while paused.
    void ask(guidance::Question question);
    /// With NavigatorOptions::heardIsReported: the voice has begun to say that cue.
    void heard(std::uint64_t cue);
    void pause();
    void resume();
    void stepOnce(); ///< one frame, then paused
    void setSpeed(double factor);

    RunState state() const;
    /// The newest picture of the walk; null until there is anything to tell. Its frame is empty before the
    /// first one.
    std::shared_ptr<const Snapshot> snapshot() const;

private:
    struct Impl;
    explicit NavigationSession(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace farol::session
