#include "ui/live/revote.h"

#include "core/building/geopackage.h"

#include <algorithm>

namespace farol::ui {

namespace {

struct Pass {
    std::vector<localisation::Fix> fixes;
    int cues = 0;
};

Result<Pass> pass(const session::Recording& recording,
                  const std::shared_ptr<const building::Building>& building,
                  const std::optional<session::NavigatorOptions>& options) {
    Pass result;
    session::ReplayHandlers handlers;
    handlers.step = [&](const session::NavigationStep& step) {
        result.fixes.push_back(step.fix);
        result.fixes.back().votes.clear();
        result.cues += static_cast<int>(step.cues.size());
    };
    auto done = session::replay(recording, building, options, handlers);
    if (!done) return done.error();
    return result;
}

void compare(const Pass& before, const Pass& now, Revote& result) {
    result.pictures = static_cast<int>(std::min(before.fixes.size(), now.fixes.size()));
    bool going = false;
    for (std::size_t i = 0; i < before.fixes.size() && i < now.fixes.size(); ++i) {
        const localisation::Fix& a = before.fixes[i];
        const localisation::Fix& b = now.fixes[i];
        if (a.region == b.region) {
            ++result.same;
            going = false;
            continue;
        }
        const bool more =
            going && result.rows.back().before == a.region && result.rows.back().now == b.region;
        if (!more) result.rows.push_back({a.time, 0, a.region, b.region, 0.0, 0.0});
        RevoteRow& row = result.rows.back();
        ++row.pictures;
        row.confidenceBefore = std::max(row.confidenceBefore, a.confidence);
        row.confidenceNow = std::max(row.confidenceNow, b.confidence);
        going = true;
    }
}

} // namespace

Result<Revote> revote(const std::string& folder, const std::string& localiser) {
    auto recording = session::loadRecording(folder);
    if (!recording) return recording.error();
    auto loaded = building::loadBuilding((std::filesystem::path(folder) / "map.gpkg").string());
    if (!loaded) return loaded.error();
    Revote result;
    result.building = loaded->building;
    result.localiserBefore = recording->header.options.localiser;
    result.localiserNow = localiser;
    session::NavigatorOptions other = recording->header.options;
    const session::NavigatorOptions fresh = session::NavigatorOptions::with(localiser);
    other.localiser = fresh.localiser;
    other.tracker = fresh.tracker;
    // Each localiser has its own measure of sure.
    other.guidance.sureConfidence = fresh.guidance.sureConfidence;
    other.guidance.usableConfidence = fresh.guidance.usableConfidence;
    other.guidance.usableNearConfidence = fresh.guidance.usableNearConfidence;
    auto before = pass(*recording, result.building, std::nullopt);
    if (!before) return before.error();
    auto now = pass(*recording, result.building, other);
    if (!now) return now.error();
    result.cuesBefore = before->cues;
    result.cuesNow = now->cues;
    compare(*before, *now, result);
    return result;
}

} // namespace farol::ui
