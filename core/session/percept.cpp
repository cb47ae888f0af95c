#include "core/session/percept.h"

#include <algorithm>

namespace farol::session {

std::vector<recognition::Detection> inView(const Percept& percept) {
    std::vector<recognition::Detection> shown;
    for (const recognition::Track& track : percept.tracks) shown.push_back(track.now);
    for (const recognition::Detection& detection : percept.detections) {
        bool followed =
            std::any_of(percept.tracks.begin(), percept.tracks.end(),
                        [&](const recognition::Track& track) { return track.now.track == detection.track; });
        if (!followed) shown.push_back(detection);
    }
    return shown;
}

} // namespace farol::session
