#pragma once
// Angles inside core: radians, counter-clockwise from east (map) or from the optical axis to the left
// (bearing). Degrees and clock hours exist only at the edge (files, JSON, words).

namespace farol {

/// Not <numbers>: Qt 6.4's moc cannot parse that header, and this one is seen by Qt classes.
inline constexpr double kPi = 3.14159265358979323846;

/// An angle in radians; the unit is in the type so that degrees cannot slip in.
struct Radians {
    double value = 0.0;

    friend constexpr Radians operator+(Radians a, Radians b) { return {a.value + b.value}; }
    friend constexpr Radians operator-(Radians a, Radians b) { return {a.value - b.value}; }
    friend constexpr Radians operator-(Radians a) { return {-a.value}; }
    friend constexpr bool operator==(Radians, Radians) = default;
};

constexpr Radians fromDegrees(double degrees) {
    return {degrees * kPi / 180.0};
}
constexpr double toDegrees(Radians angle) {
    return angle.value * 180.0 / kPi;
}

/// The same direction in (-pi, pi]. A value that is not finite comes back as it is.
Radians wrapped(Radians angle);

} // namespace farol
