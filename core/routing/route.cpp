#include "core/routing/route.h"

#include "core/building/sentence.h"

#include <algorithm>
#include <cmath>

namespace farol::routing {

bool Route::passes(const RegionId& region) const {
    return std::find(regions.begin(), regions.end(), region) != regions.end();
}

Result<void> RouteOptions::check() const {
    struct Entry {
        const char* name;
        double value;
        double low;
    };
    const Entry entries[] = {{"walkingSpeed", walkingSpeed, 0.01},
                             {"doorSeconds", doorSeconds, 0.0},
                             {"narrowDoorSeconds", narrowDoorSeconds, 0.0},
                             {"stairsSecondsPerLevel", stairsSecondsPerLevel, 0.0},
                             {"escalatorSecondsPerLevel", escalatorSecondsPerLevel, 0.0},
                             {"walkwaySeconds", walkwaySeconds, 0.0},
                             {"rampSeconds", rampSeconds, 0.0},
                             {"elevatorSeconds", elevatorSeconds, 0.0},
                             {"elevatorSecondsPerLevel", elevatorSecondsPerLevel, 0.0},
                             {"storeyHeightM", storeyHeightM, 0.0},
                             {"narrowDoorM", narrowDoorM, 0.0}};
    for (const Entry& entry : entries)
        if (!(entry.value >= entry.low) || entry.value > 1e6)
            return Error{ErrorCode::InvalidArgument, building::english(building::Sentence::WayOptionRange),
                         std::string("route option ") + entry.name};
    return {};
}

std::string manoeuvreKindName(ManoeuvreKind kind) {
    switch (kind) {
    case ManoeuvreKind::Start:
        return "start";
    case ManoeuvreKind::Door:
        return "door";
    case ManoeuvreKind::Opening:
        return "opening";
    case ManoeuvreKind::Stairs:
        return "stairs";
    case ManoeuvreKind::Elevator:
        return "elevator";
    case ManoeuvreKind::Escalator:
        return "escalator";
    case ManoeuvreKind::Ramp:
        return "ramp";
    case ManoeuvreKind::Turn:
        return "turn";
    case ManoeuvreKind::Arrive:
        return "arrive";
    }
    return "start";
}

} // namespace farol::routing
