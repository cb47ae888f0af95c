#pragma once
// Where the simulated camera is and how it moves: what the walker hands to the camera for each frame.
//
// Frame: the map's axes (x east, y north, metres), z up from the level's floor. Angles in radians,
// counter-clockwise from east; pitch upwards positive, roll clockwise as the camera looks.

#include "core/base/angle.h"
#include "core/base/error.h"
#include "core/base/geometry.h"

namespace farol::simulation {

struct CameraPose {
    double time = 0.0;  ///< seconds since the walk's start
    Point2 position;    ///< of the body on the plan
    double level = 0.0; ///< ordinal of the level; between two ordinals while on stairs or in a lift
    Radians heading{0.0};
    Radians pitch{0.0};
    Radians roll{0.0};
    double eyeHeightM = 1.4; ///< of the lens above the floor under the feet
    double speed = 0.0;      ///< metres a second along the heading, for motion blur
    Radians turnRate{0.0};   ///< a second, left positive, for motion blur

    /// An error names the field that is not a number or out of its range.
    Result<void> check() const;
};

} // namespace farol::simulation
