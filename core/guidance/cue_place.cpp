// Where the user is, what is seen, and the look around of somebody lost.

#include "core/base/text.h"
#include "core/guidance/cue_step.h"

#include <algorithm>

namespace farol::guidance {

namespace {

constexpr double kAnnouncedIntoSeconds = 60.0;
constexpr double kChimeSeconds = 15.0;
constexpr double kUnsureSeconds = 6.0, kLocatedSeconds = 6.0, kDetectionSeconds = 3.0,
                 kChimeValidSeconds = 1.0, kTextSeconds = 4.0;
constexpr double kSureScore = 0.5;

/// Empty: the look around is over and found nothing.
std::optional<SweepStep> following(SweepStep step) {
    switch (step) {
    case SweepStep::Right:
        return SweepStep::Left;
    case SweepStep::Left:
        return SweepStep::Up;
    case SweepStep::Up:
        return SweepStep::Down;
    case SweepStep::Down:
        return SweepStep::AskForHelp;
    case SweepStep::None:
    case SweepStep::AskForHelp:
    case SweepStep::Done:
        break;
    }
    return std::nullopt;
}

} // namespace

void CueStep::tellSweep(SweepStep step) {
    m_memory.sweep = SchedulerMemory::Sweep{step, m_fix.time};
    m_memory.facesWay = false; // who has looked around faces anywhere
    m_memory.advance.reset();
    Cue cue = cueOf(CueKind::Unsure, CuePriority::OffRoute, kUnsureSeconds);
    cue.sweep = step;
    cue.detail = m_fix.note;
    add(std::move(cue));
}

bool CueStep::tellsAWay() const {
    return std::any_of(m_cues.begin(), m_cues.end(), [](const Cue& cue) {
        return cue.kind == CueKind::RouteStart || (cue.kind == CueKind::OffRoute && cue.manoeuvre);
    });
}

/// Unsure is also who was seen where the route does not expect it, once only: looking around settles it. So
/// is who is perhaps in the destination already, so that no way begins: silence would be no answer to the
/// choice.
void CueStep::tellUnsure() {
    bool isGuess = m_progress.travel == Travel::NoFix && !m_progress.route && !m_progress.destination.empty();
    bool underWay = m_progress.route && m_progress.travel == Travel::OnRoute;
    bool asExpected = !underWay || m_fix.region == m_progress.route->regions[m_progress.regionsPassed];
    if (m_usable && asExpected && !isGuess) {
        // Who was just told to turn has to be told to stop turning, at once.
        bool turning = m_memory.sweep && following(m_memory.sweep->step) &&
                       m_fix.time - m_memory.sweep->toldAt <= 2.0 * m_options.sweepStepSeconds;
        if (turning) tellSweep(SweepStep::Done);
        m_memory.unusableSince.reset();
        m_memory.sweep.reset();
        return;
    }
    if (tellsAWay()) {
        // Whoever is told a way, be it on a guess that has lasted, walks: not "I do not know" in the same
        // breath.
        m_memory.unusableSince = m_fix.time;
        m_memory.sweep.reset();
        return;
    }
    if (!m_memory.unusableSince) m_memory.unusableSince = m_fix.time;
    if (m_fix.time - *m_memory.unusableSince < m_options.unsureAfterSeconds) return;
    if (!m_memory.sweep) {
        tellSweep(SweepStep::Right);
        return;
    }
    // Without a destination nobody waits for directions: asked once, not led through a look around.
    if (m_progress.destination.empty()) return;
    double since = m_fix.time - m_memory.sweep->toldAt;
    std::optional<SweepStep> next = following(m_memory.sweep->step);
    if (next && since >= m_options.sweepStepSeconds) tellSweep(*next);
    if (!next && since >= m_options.unsureRepeatSeconds) tellSweep(SweepStep::Right);
}

/// Where the user is, when that changed and no instruction says it already.
void CueStep::tellRegion() {
    if (!m_usable) return;
    const RegionId& region = *m_fix.region;
    SchedulerMemory::Candidate& candidate = m_memory.candidate;
    if (candidate.region != region)
        candidate = {region, m_fix.evidenceTime, 1};
    else if (candidate.evidenceTime != m_fix.evidenceTime) {
        candidate.evidenceTime = m_fix.evidenceTime;
        ++candidate.fixes;
    }
    if (m_memory.located == region) return;
    if (m_routeTold) {
        m_memory.located = region;
        m_memory.locatedAt[region] = m_fix.time;
        return;
    }
    if (!m_sure && candidate.fixes < 2) return;
    m_memory.located = region;
    auto recent = [&](const std::map<RegionId, double>& times, double seconds) {
        auto found = times.find(region);
        return found != times.end() && m_fix.time - found->second < seconds;
    };
    bool isKnown = recent(m_memory.announcedInto, kAnnouncedIntoSeconds) ||
                   recent(m_memory.locatedAt, m_options.repeatAfterSeconds);
    m_memory.locatedAt[region] = m_fix.time;
    if (isKnown) return;
    Cue cue = cueOf(CueKind::Located, CuePriority::Detection, kLocatedSeconds);
    nameRegion(cue, region);
    const building::Region* known = m_building.region(region);
    if (known != nullptr && m_building.levels().size() > 1) cue.levelName = levelName(known->level, false);
    cue.validIn = {region};
    add(std::move(cue));
}

/// A fix after the place was not known is heard; so is what asks for attention.
void CueStep::addChimes() {
    for (Cue& cue : m_cues) {
        bool asksForAttention = cue.kind == CueKind::OffRoute || cue.kind == CueKind::NoRoute ||
                                (cue.kind == CueKind::Unsure && cue.sweep == SweepStep::Right);
        if (asksForAttention) cue.chime = Chime::Warning;
    }
    if (!m_usable) m_memory.known = false;
    if (!m_sure || m_memory.known) return;
    m_memory.known = true;
    bool lately = m_memory.chimedAt && m_fix.time - *m_memory.chimedAt < kChimeSeconds;
    bool warned =
        std::any_of(m_cues.begin(), m_cues.end(), [](const Cue& cue) { return cue.chime == Chime::Warning; });
    if (lately || warned) return;
    m_memory.chimedAt = m_fix.time;
    if (m_cues.empty()) m_cues.push_back(cueOf(CueKind::Chime, CuePriority::Reassurance, kChimeValidSeconds));
    m_cues.front().chime = Chime::Fix;
}

void CueStep::tellObjects(const std::vector<localisation::Observation>& fresh) {
    if (m_options.verbosity == Verbosity::Directions) return;
    for (const localisation::Observation& observation : fresh) {
        const recognition::Detection& seen = observation.detection;
        bool isText = seen.kind == Kind::Text;
        if (seen.kind == Kind::Place || (isText && m_options.verbosity != Verbosity::ObjectsAndTexts))
            continue;
        if (isText && seen.text.empty()) continue;
        std::string key(kindName(seen.kind));
        key += " " + seen.templateId.value + " " + foldedForMatching(seen.text);
        if (toldRecently(m_memory.objectsToldAt, key, m_options.objectRepeatSeconds)) continue;
        m_memory.objectsToldAt[key] = m_fix.time;
        Cue cue = cueOf(isText ? CueKind::Text : CueKind::Detection, CuePriority::Detection,
                        isText ? kTextSeconds : kDetectionSeconds);
        cue.objectKind = seen.kind;
        cue.zone = seen.zone();
        cue.text = seen.text;
        cue.sure = seen.score >= kSureScore;
        add(std::move(cue));
    }
}

} // namespace farol::guidance
