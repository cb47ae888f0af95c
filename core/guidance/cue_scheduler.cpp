#include "core/guidance/cue_scheduler.h"

#include "core/guidance/cue_step.h"

#include <algorithm>
#include <cmath>

namespace farol::guidance {

Result<void> GuidanceOptions::check() const {
    auto wrong = [](const char* message, const char* option) -> Result<void> {
        return Error{ErrorCode::InvalidArgument, message, std::string("guidance.") + option};
    };
    auto isPositive = [](double value) { return std::isfinite(value) && value > 0.0; };
    if (!isPositive(actDistanceM)) return wrong("must be above 0 metres", "actDistanceM");
    if (!std::isfinite(prepareDistanceM) || prepareDistanceM <= actDistanceM) {
        return wrong("something is to be prepared before it is to be done", "prepareDistanceM");
    }
    if (!isPositive(reassureEveryM)) return wrong("must be above 0 metres", "reassureEveryM");
    if (!isPositive(maxSigmaForActM)) return wrong("must be above 0 metres", "maxSigmaForActM");
    if (!isPositive(maxSigmaForDistanceM)) return wrong("must be above 0 metres", "maxSigmaForDistanceM");
    if (!(sureConfidence >= 0.0 && sureConfidence <= 1.0))
        return wrong("must be from 0 to 1", "sureConfidence");
    if (!(usableConfidence >= 0.0 && usableConfidence <= 1.0))
        return wrong("must be from 0 to 1", "usableConfidence");
    if (!(usableNearConfidence >= 0.0 && usableNearConfidence <= 1.0))
        return wrong("must be from 0 to 1", "usableNearConfidence");
    for (double seconds : {reassureEverySeconds, repeatAfterSeconds, objectRepeatSeconds, unsureAfterSeconds,
                           unsureRepeatSeconds, sweepStepSeconds, offRouteRepeatSeconds}) {
        if (!isPositive(seconds)) return wrong("every time is above 0 seconds", "times");
    }
    return {};
}

CueScheduler::CueScheduler(std::shared_ptr<const building::Building> building, GuidanceOptions options)
    : m_building(std::move(building)),
      m_options(std::move(options)),
      m_memory(std::make_unique<SchedulerMemory>()) {}

CueScheduler::~CueScheduler() = default;
CueScheduler::CueScheduler(CueScheduler&&) noexcept = default;
CueScheduler& CueScheduler::operator=(CueScheduler&&) noexcept = default;

std::vector<Cue> CueScheduler::update(std::uint64_t frame, const localisation::Fix& fix,
                                      const Progress& progress,
                                      const std::vector<localisation::Observation>& fresh) {
    CueStep step{*m_building, m_options, *m_memory, frame, fix, progress};
    step.tellRoute();
    step.tellUnsure();
    step.tellRegion();
    step.tellObjects(fresh);
    step.addChimes();
    std::vector<Cue> cues = step.takeCues();
    std::stable_sort(cues.begin(), cues.end(),
                     [](const Cue& a, const Cue& b) { return a.priority < b.priority; });
    for (Cue& cue : cues) cue.id = ++m_memory->lastId;
    return cues;
}

Cue CueScheduler::answer(Question question, std::uint64_t frame, const localisation::Fix& fix,
                         const Progress& progress) {
    Cue cue = CueStep{*m_building, m_options, *m_memory, frame, fix, progress}.answer(question);
    cue.id = ++m_memory->lastId;
    return cue;
}

Cue CueScheduler::warning(std::uint64_t frame, double time, CueReason reason, std::string detail) {
    constexpr double kWarningSeconds = 10.0;
    Cue cue;
    cue.kind = CueKind::Warning;
    cue.priority = CuePriority::Warning;
    cue.id = ++m_memory->lastId;
    cue.frame = frame;
    cue.time = time;
    cue.validUntil = time + kWarningSeconds;
    cue.reason = reason;
    cue.detail = std::move(detail);
    cue.chime = Chime::Warning;
    return cue;
}

std::string questionName(Question question) {
    switch (question) {
    case Question::WhereAmI:
        return "where_am_i";
    case Question::AroundMe:
        return "around_me";
    case Question::Next:
        return "next";
    case Question::Remaining:
        return "remaining";
    case Question::Repeat:
        return "repeat";
    case Question::Preview:
        return "preview";
    }
    return "unknown";
}

} // namespace farol::guidance
