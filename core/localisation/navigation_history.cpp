#include "core/localisation/navigation_history.h"

#include "core/localisation/identity.h"

#include <algorithm>

namespace farol::localisation {

namespace {

/// A place is one spot of the building: seen again it is the same thing, whatever the scene.
bool samePlace(const Observation& old, const Observation& seen) {
    return old.detection.kind == Kind::Place && seen.detection.kind == Kind::Place &&
           !old.detection.templateId.empty() && old.detection.templateId == seen.detection.templateId;
}

/// Paper 3b: the same frame identifier, the same object, and the area of the picture in which it is. A
/// trained template is the same object while the scene lasts even when the camera pans, but not twice in one
/// frame.
bool isRepeat(const Observation& old, const Observation& seen, double duplicateOverlap) {
    if (old.scene != seen.scene || !identical(old.detection, seen.detection)) return false;
    bool trained = !old.detection.templateId.empty() && !seen.detection.templateId.empty();
    if (trained && old.frame != seen.frame) return true;
    return overlap(boundingBox(old.detection.quad), boundingBox(seen.detection.quad)) > duplicateOverlap;
}

/// The same track is the same object, wherever the picture has moved it meanwhile.
bool sameTrack(const Observation& old, const Observation& seen) {
    return old.track && seen.track && *old.track == *seen.track;
}

/// Other than `seen`, this one is in view right now under a track of its own: two extinguishers side by side.
bool seenBeside(const Observation& old, const Observation& seen, const std::vector<Observation>& now) {
    if (!old.track || !seen.track || sameTrack(old, seen)) return false;
    return std::any_of(now.begin(), now.end(),
                       [&](const Observation& other) { return sameTrack(old, other); });
}

/// The old one stays where it is in the queue, with the newest box and the better score (field.md ambiguity
/// 11).
void refresh(Observation& old, const Observation& seen) {
    double score = std::max(old.detection.score, seen.detection.score);
    TemplateId trained =
        seen.detection.templateId.empty() ? old.detection.templateId : seen.detection.templateId;
    old = seen;
    old.detection.score = score;
    old.detection.templateId = trained;
}

} // namespace

bool identical(const recognition::Detection& a, const recognition::Detection& b) {
    return sameThing(identityOf(a), identityOf(b));
}

Result<void> HistoryOptions::check() const {
    if (capacity < 1 || capacity > 64) {
        return Error{ErrorCode::InvalidArgument, "the navigation history holds 1 to 64 objects",
                     "history.capacity"};
    }
    if (!(duplicateOverlap >= 0.0 && duplicateOverlap <= 1.0)) {
        return Error{ErrorCode::InvalidArgument, "the overlap that makes a repeat is a share from 0 to 1",
                     "history.duplicateOverlap"};
    }
    return {};
}

NavigationHistory::NavigationHistory(HistoryOptions options) : m_options(options) {
    m_options.capacity = std::max<std::size_t>(m_options.capacity, 1);
}

std::vector<Observation> NavigationHistory::add(const std::vector<Observation>& seen) {
    std::vector<Observation> fresh;
    for (const Observation& observation : seen) {
        auto repeated = std::find_if(m_items.begin(), m_items.end(),
                                     [&](const Observation& old) { return sameTrack(old, observation); });
        if (repeated == m_items.end())
            repeated = std::find_if(m_items.begin(), m_items.end(), [&](const Observation& old) {
                return !seenBeside(old, observation, seen) &&
                       isRepeat(old, observation, m_options.duplicateOverlap);
            });
        bool counted = !rememberTrack(observation);
        if (repeated != m_items.end()) {
            refresh(*repeated, observation);
            continue;
        }
        if (counted) continue;
        // A place come back to counts once, as the newest.
        m_items.erase(std::remove_if(m_items.begin(), m_items.end(),
                                     [&](const Observation& old) { return samePlace(old, observation); }),
                      m_items.end());
        m_items.push_back(observation);
        while (m_items.size() > m_options.capacity) m_items.pop_front();
        fresh.push_back(observation);
    }
    return fresh;
}

/// False: this track has been counted already, though newer objects may have pushed it out since.
bool NavigationHistory::rememberTrack(const Observation& seen) {
    constexpr std::size_t kTracksRemembered = 256;
    if (!seen.track) return true;
    if (std::find(m_tracks.begin(), m_tracks.end(), *seen.track) != m_tracks.end()) return false;
    m_tracks.push_back(*seen.track);
    if (m_tracks.size() > kTracksRemembered) m_tracks.pop_front();
    return true;
}

void NavigationHistory::clear() {
    m_items.clear();
    m_tracks.clear();
}

} // namespace farol::localisation
