#pragma once
// Hops 3 to 6 as one plain call chain: history, localiser, route tracker, cues. `run`, `replay` and `locate`
// all go through here, so that they cannot differ.

#include "core/guidance/cue_scheduler.h"
#include "core/guidance/route_tracker.h"
#include "core/localisation/localisers.h"
#include "core/localisation/navigation_history.h"
#include "core/session/percept.h"

#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace farol::session {

struct NavigatorOptions {
    std::string localiser = "voting";
    std::string planner = "optimal";
    routing::RouteOptions routing;
    localisation::HistoryOptions history;
    guidance::TrackerOptions tracker;
    guidance::GuidanceOptions guidance;
    /// A voice tells by heard() what it began to say, and only that counts as told: not what was muted, or
    /// expired while it waited. Whoever hears nothing of what is told (a muted voice, one that has failed)
    /// does not obey it: after a while the last order that was heard counts no more. False: all that is told
    /// counts.
    bool heardIsReported = false;

    Result<void> check() const;
    /// Options for a user who knows the way only from what is said: the filter for them, whose confidence is
    /// a probability, so that words are sure from .8 on. Any other name: the defaults with that localiser.
    static NavigatorOptions with(const std::string& localiser);
};

class Navigator {
public:
    static Result<std::unique_ptr<Navigator>> create(std::shared_ptr<const building::Building> building,
                                                     const NavigatorOptions& options = {});
    /// With a localiser of the caller's, whatever the options name.
    static Result<std::unique_ptr<Navigator>> create(std::shared_ptr<const building::Building> building,
                                                     const NavigatorOptions& options,
                                                     std::unique_ptr<localisation::Localiser> localiser);

    /// Forgets history and fix. Empty: an unknown start.
    void start(double time, const std::optional<RegionId>& region);
    /// Empty: no destination. The cue that follows (RouteStart, NoRoute, AlreadyThere) comes with the next
    /// step.
    void setDestination(const std::optional<building::Location>& destination);
    void setVerbosity(guidance::Verbosity verbosity);
    /// Of the names from the map, where it has several: "pt".
    void setLanguage(std::string language);
    /// A percept whose time runs backwards counts as of the time before.
    NavigationStep advance(Percept percept);
    /// With heardIsReported: the voice has begun to say that cue.
    void heard(std::uint64_t cue);
    guidance::Cue warning(guidance::CueReason reason, std::string detail);
    /// For the present place; the walk goes on as if nothing had been asked.
    guidance::Cue answer(guidance::Question question);

    /// What the tracker would say now, without a frame and without changing anything: a destination chosen
    /// while the walk is paused shows its route at once.
    guidance::Progress preview() const;
    const localisation::Fix& lastFix() const { return m_lastFix; }
    double lastTime() const { return m_lastTime; }
    std::uint64_t lastFrame() const { return m_lastFrame; }
    const building::Building& building() const { return *m_building; }

private:
    Navigator(const std::shared_ptr<const building::Building>& building,
              std::unique_ptr<localisation::Localiser> localiser,
              std::shared_ptr<const routing::Planner> planner, const NavigatorOptions& options);

    void issued(const guidance::Cue& cue);
    void forgetUnheard(double time);

    /// A cue that tells a way, and that the voice has not begun to say.
    struct Unheard {
        std::uint64_t cue = 0;
        double time = 0.0;
        localisation::ToldWay way;
    };

    std::shared_ptr<const building::Building> m_building;
    std::unique_ptr<localisation::Localiser> m_localiser;
    localisation::NavigationHistory m_history;
    guidance::RouteTracker m_tracker;
    guidance::CueScheduler m_scheduler;
    bool m_heardIsReported = false;
    std::deque<Unheard> m_unheard; ///< in the order of their ids
    std::optional<localisation::ToldWay>
        m_heardWay; ///< what the localiser was told last; empty: it does not know
    double m_heardAt = 0.0;
    std::uint64_t m_lastHeard = 0; ///< the newest cue of all that were heard or given up
    localisation::Fix m_lastFix;
    std::uint64_t m_lastFrame = 0;
    double m_lastTime = 0.0;
};

} // namespace farol::session
