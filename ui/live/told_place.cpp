#include "ui/live/told_place.h"

namespace farol::ui {

namespace {

/// As many pictures may be on their way between the session and the window; a later one that does not agree
/// has not been believed.
constexpr int kOnTheirWay = 3;
constexpr double kWalkedOnS = 10.0; // after that another place is where the user has gone

} // namespace

void ToldPlace::tell(const std::optional<RegionId>& region) {
    m_state = State::Waiting;
    m_region = region;
    m_before = 0;
    m_since.reset();
}

void ToldPlace::heard(const localisation::Fix& fix) {
    if (m_state == State::None) return;
    if (!m_since) m_since = fix.time;
    const bool walkedOn = fix.time > *m_since + kWalkedOnS;
    if (fix.region == m_region) {
        // What was recognised since bears it out, and says how surely.
        const bool borneOut = m_state == State::Overruled || fix.evidenceTime > *m_since;
        m_state = borneOut ? State::None : State::Agreed;
        return;
    }
    if (m_state == State::Waiting && ++m_before <= kOnTheirWay) return;
    // Nothing is overruled where the assistant only said that it is not known.
    m_state = m_region && !walkedOn ? State::Overruled : State::None;
}

localisation::Fix ToldPlace::shown(const localisation::Fix& fix, const building::Building& building) const {
    if (fix.region == m_region && (fix.level || !m_region)) return fix;
    localisation::Fix told;
    told.time = told.evidenceTime = fix.time;
    told.region = m_region;
    if (!m_region) return told;
    told.confidence = told.nearConfidence = 1.0;
    told.near = {*m_region};
    if (const building::Region* region = building.region(*m_region)) told.level = region->level;
    return told;
}

} // namespace farol::ui
