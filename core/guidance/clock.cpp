#include "core/guidance/clock.h"

#include <cmath>

namespace farol::guidance {

int clockHour(Radians delta) {
    if (!std::isfinite(delta.value)) return 12;
    double clockwise = std::fmod(-toDegrees(delta), 360.0);
    if (clockwise < 0.0) clockwise += 360.0;
    int hour = static_cast<int>(std::lround(clockwise / 30.0)) % 12;
    return hour == 0 ? 12 : hour;
}

TurnWord turnWord(Radians delta) {
    double degrees = toDegrees(wrapped(delta));
    double size = std::abs(degrees);
    bool left = degrees > 0.0;
    if (!std::isfinite(size) || size < 22.5) return TurnWord::Straight;
    if (size < 60.0) return left ? TurnWord::SlightLeft : TurnWord::SlightRight;
    if (size < 120.0) return left ? TurnWord::Left : TurnWord::Right;
    if (size < 150.0) return left ? TurnWord::SharpLeft : TurnWord::SharpRight;
    return TurnWord::Back;
}

Radians turnOnTheSpot(Radians delta) {
    constexpr Radians kNearlyHalf = fromDegrees(142.5);
    return std::abs(wrapped(delta).value) >= kNearlyHalf.value ? Radians{kPi} : delta;
}

} // namespace farol::guidance
