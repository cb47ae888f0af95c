#include "core/base/angle.h"

#include <cmath>

namespace farol {

Radians wrapped(Radians angle) {
    if (!std::isfinite(angle.value)) return angle;
    constexpr double kTurn = 2.0 * kPi;
    double value = std::fmod(angle.value, kTurn);
    if (value > kPi) value -= kTurn;
    if (value <= -kPi) value += kTurn;
    return {value};
}

} // namespace farol
