#include "core/simulation/camera_shake.h"

#include "core/simulation/hash.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace farol::simulation {

namespace {

/// Two sines whose periods never come together.
double wave(double time, double hertz, std::uint64_t seed) {
    Draw draw(seed);
    double first = draw.unit(), second = draw.unit();
    auto sine = [time](double rate, double phase) {
        return std::sin(2.0 * std::numbers::pi * (rate * time + phase));
    };
    return 0.7 * sine(hertz, first) + 0.3 * sine(hertz * 1.618, second);
}

} // namespace

ShakeOffset shakeAt(Shake shake, double time, double speed, std::uint64_t seed) {
    ShakeOffset offset;
    if (shake == Shake::None) return offset;
    constexpr double kDegree = std::numbers::pi / 180.0;
    constexpr double kStepsPerSecond = 1.85;
    double walking = std::clamp(speed / 1.1, 0.0, 1.3);
    auto at = [&](double hertz, std::uint64_t which) { return wave(time, hertz, hashOf(seed, which)); };
    // Steps: down and up with each, to the side with every second one. Breathing and swaying go on while one
    // stands.
    offset.upM = 0.018 * walking * at(kStepsPerSecond, 1) + 0.004 * at(0.27, 2);
    offset.rightM = 0.015 * walking * at(kStepsPerSecond / 2, 3);
    if (shake == Shake::Chest) {
        offset.roll = kDegree * (1.6 * walking * at(kStepsPerSecond / 2, 4) + 0.3 * at(0.3, 5));
        offset.pitch = kDegree * (1.0 * walking * at(kStepsPerSecond, 6) + 0.4 * at(0.23, 7));
        offset.yaw = kDegree * (1.8 * walking * at(kStepsPerSecond / 2, 8) + 0.4 * at(0.19, 9));
    } else {
        offset.roll =
            kDegree * (1.2 * walking * at(kStepsPerSecond / 2, 4) + 2.0 * at(0.21, 5) + 0.15 * at(7.3, 10));
        offset.pitch =
            kDegree * (1.2 * walking * at(kStepsPerSecond, 6) + 2.2 * at(0.31, 7) + 0.2 * at(6.1, 11));
        offset.yaw =
            kDegree * (1.5 * walking * at(kStepsPerSecond / 2, 8) + 3.0 * at(0.26, 9) + 0.2 * at(5.7, 12));
    }
    return offset;
}

CameraPose shaken(const CameraPose& pose, const ShakeOffset& offset) {
    CameraPose moved = pose;
    Point2 right{std::sin(pose.heading.value), -std::cos(pose.heading.value)};
    moved.position = pose.position + right * offset.rightM;
    moved.eyeHeightM = std::clamp(pose.eyeHeightM + offset.upM, 0.2, 2.6);
    moved.heading = Radians{pose.heading.value + offset.yaw};
    moved.pitch = Radians{pose.pitch.value + offset.pitch};
    moved.roll = Radians{pose.roll.value + offset.roll};
    return moved;
}

} // namespace farol::simulation
