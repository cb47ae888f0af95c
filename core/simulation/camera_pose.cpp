#include "core/simulation/camera_pose.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace farol::simulation {

Result<void> CameraPose::check() const {
    const std::array<std::pair<const char*, double>, 10> fields{{{"time", time},
                                                                 {"x", position.x},
                                                                 {"y", position.y},
                                                                 {"level", level},
                                                                 {"heading", heading.value},
                                                                 {"pitch", pitch.value},
                                                                 {"roll", roll.value},
                                                                 {"eye height", eyeHeightM},
                                                                 {"speed", speed},
                                                                 {"turn rate", turnRate.value}}};
    for (const auto& [name, value] : fields) {
        if (!std::isfinite(value))
            return Error{ErrorCode::InvalidArgument,
                         std::string("the camera pose has no number for its ") + name, ""};
    }
    if (eyeHeightM < 0.2 || eyeHeightM > 2.6) {
        return Error{ErrorCode::InvalidArgument,
                     "the camera stands " + std::to_string(eyeHeightM) +
                         " m above the floor; 0.2 to 2.6 m is possible",
                     ""};
    }
    return {};
}

} // namespace farol::simulation
