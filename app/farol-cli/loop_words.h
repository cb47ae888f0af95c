#pragma once
// The words of a closed loop: who wants to read along, and who is to hear nothing but sentences.

#include "core/session/closed_loop.h"
#include "ui/speech/phrasebook.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace farol::cli {

/// What the walker takes from each cue's sentence alone.
session::ClosedLoop::Ear sentenceEar();

/// Prints where the walker really is, what is recognised and what is said to him.
class LoopTranscript {
public:
    explicit LoopTranscript(const building::Building& building);
    void moment(const session::ClosedLoopMoment& moment);

private:
    void sights(double time, const std::vector<localisation::Observation>& fresh);

    Point2 m_corner; ///< of the map, so that coordinates are short
    ui::Phrasebook m_phrasebook;
    RegionId m_region;
    std::optional<RegionId> m_taken;
    double m_told = -1e9;
    std::map<std::string, double> m_seen; ///< when it was printed last, by kind, name and text
};

} // namespace farol::cli
