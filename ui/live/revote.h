#pragma once
// A recorded walk, worked out once as it was and once with another localiser, and where the two differ.

#include "core/base/error.h"
#include "core/session/recorder.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace farol::ui {

struct RevoteRow {
    double time = 0.0; ///< of the first picture on which the two differ so
    int pictures = 0;  ///< on which they do
    std::optional<RegionId> before, now;
    double confidenceBefore = 0.0, confidenceNow = 0.0; ///< the highest meanwhile
};

struct Revote {
    std::shared_ptr<const building::Building> building;
    std::string localiserBefore, localiserNow;
    int pictures = 0, same = 0;
    int cuesBefore = 0, cuesNow = 0;
    std::vector<RevoteRow> rows; ///< stretches on which the two differ
};

/// `folder` is a recording. Slow: for another thread.
Result<Revote> revote(const std::string& folder, const std::string& localiser);

} // namespace farol::ui
