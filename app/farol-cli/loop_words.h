#pragma once
// The words of a closed loop: who wants to read along, and who is to hear nothing but sentences.

#include "core/session/closed_loop.h"
#include "ui/speech/phrasebook.h"

#include <optional>

namespace farol::cli {

/// What the walker takes from each cue's sentence alone.
session::ClosedLoop::Ear sentenceEar();

/// Prints where the walker really is, and what is said to him.
class LoopTranscript {
public:
    explicit LoopTranscript(const building::Building& building);
    void moment(const session::ClosedLoopMoment& moment);

private:
    Point2 m_corner; ///< of the map, so that coordinates are short
    ui::Phrasebook m_phrasebook;
    RegionId m_region;
    std::optional<RegionId> m_taken;
    double m_told = -1e9;
};

} // namespace farol::cli
