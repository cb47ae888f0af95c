#pragma once
// When to say what (paper 4.3; Wayfindr timing in field.md section 4).

#include "core/guidance/cue.h"
#include "core/guidance/route_tracker.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace farol::guidance {

/// Which notifications the user wants (paper 4.3: directions; directions plus objects; and texts).
enum class Verbosity { Directions, Objects, ObjectsAndTexts };

struct GuidanceOptions {
    Verbosity verbosity = Verbosity::Objects;
    std::string language; ///< "pt": names in it where the map has them (field name_pt); empty: its own
    double prepareDistanceM = 6.0;
    double actDistanceM = 2.0;
    double reassureEveryM = 10.0;
    double reassureEverySeconds = 15.0; ///< where no distance is known
    double repeatAfterSeconds = 15.0;   ///< the same action is not told again sooner
    double objectRepeatSeconds = 20.0;
    double unsureAfterSeconds = 8.0;   ///< without a usable fix
    double sweepStepSeconds = 6.0;     ///< from one order of the look around to the next
    double unsureRepeatSeconds = 15.0; ///< after a look around that found nothing
    double offRouteRepeatSeconds = 10.0;
    double sureConfidence = 0.5; ///< below: hedged words
    /// Below, a fix is no ground for any instruction, unless it is at least so sure that the user is there or
    /// next to it; who is left without for long is asked to look around.
    double usableConfidence = 0.05, usableNearConfidence = 1.0;
    double maxSigmaForActM =
        1.6; ///< an order to act needs a position this good (a place, not an object seen from afar)
    double maxSigmaForDistanceM = 2.0; ///< a distance is told only when the position is that good

    Result<void> check() const;
};

/// What the user may ask at any moment.
enum class Question {
    WhereAmI,
    AroundMe,
    Next,      ///< what to do next, from here
    Remaining, ///< all that is left to do
    Repeat,    ///< the last thing of importance, as it is now
    Preview,   ///< the whole route, before setting out
};

std::string questionName(Question question);

struct SchedulerMemory;

/// Deterministic; time comes from the frames. One thread. How a turn goes comes from the route's geometry,
/// never from the estimated heading. Without a position a manoeuvre is announced once, on entering the region
/// that it leaves.
class CueScheduler {
public:
    CueScheduler(std::shared_ptr<const building::Building> building, GuidanceOptions options = {});
    ~CueScheduler();
    CueScheduler(CueScheduler&&) noexcept;
    CueScheduler& operator=(CueScheduler&&) noexcept;

    void setVerbosity(Verbosity verbosity) { m_options.verbosity = verbosity; }
    void setLanguage(std::string language) { m_options.language = std::move(language); }
    /// The cues this frame causes, most urgent first; often none.
    std::vector<Cue> update(std::uint64_t frame, const localisation::Fix& fix, const Progress& progress,
                            const std::vector<localisation::Observation>& fresh);
    /// The answer as one cue, spoken by the Phrasebook as any other. What was or will be told by itself is
    /// not changed by it. `fix` and `progress` are those of the newest frame.
    Cue answer(Question question, std::uint64_t frame, const localisation::Fix& fix,
               const Progress& progress);
    /// A Warning cue from outside the chain (camera lost, disk full).
    Cue warning(std::uint64_t frame, double time, CueReason reason, std::string detail);

private:
    std::shared_ptr<const building::Building> m_building;
    GuidanceOptions m_options;
    std::unique_ptr<SchedulerMemory> m_memory;
};

} // namespace farol::guidance
