#pragma once
// The FIFO of the last detected objects (paper 3b and 4.2: four), without repeats.

#include "core/base/error.h"
#include "core/localisation/observation.h"

#include <cstdint>
#include <deque>
#include <vector>

namespace farol::localisation {

/// What counts as identical objects (paper 4.2; field.md ambiguity 8).
bool identical(const recognition::Detection& a, const recognition::Detection& b);

struct HistoryOptions {
    std::size_t capacity = 4;      ///< paper: four, found by experiment
    double duplicateOverlap = 0.5; ///< box intersection over union in one scene that makes a repeat

    Result<void> check() const;
};

class NavigationHistory {
public:
    explicit NavigationHistory(HistoryOptions options = {});

    /// Accepts what is new and answers it in order. A repeat (the same track; or same scene, identical,
    /// overlapping box, or the same trained template while the scene lasts) refreshes time, box and score of
    /// the old one instead. A track is new once only, also after newer objects have pushed it out.
    std::vector<Observation> add(const std::vector<Observation>& seen);
    const std::deque<Observation>& items() const { return m_items; } ///< oldest first
    void clear();

private:
    bool rememberTrack(const Observation& seen);

    HistoryOptions m_options;
    std::deque<Observation> m_items;
    std::deque<std::uint64_t> m_tracks; ///< counted, oldest first
};

} // namespace farol::localisation
