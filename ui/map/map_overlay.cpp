#include "ui/map/map_overlay.h"

#include <algorithm>

namespace farol::ui {

double MapOverlay::heatOf(const RegionId& region) const {
    if (!fix || fix->votes.empty()) return 0.0;
    const double best = fix->votes.front().vote;
    if (best <= 0.0) return 0.0;
    for (const localisation::RegionVote& vote : fix->votes)
        if (vote.region == region) return std::clamp(vote.vote / best, 0.0, 1.0);
    return 0.0;
}

} // namespace farol::ui
