#pragma once
// From pixels to rays and back: a pinhole with radial distortion.

#include "core/base/geometry.h"
#include "core/simulation/vec3.h"

#include <optional>
#include <vector>

namespace farol::simulation {

class Lens {
public:
    Lens(ImageSize size, double horizontalFovDegrees, double k1, double k2);

    ImageSize size() const { return m_size; }
    double focalPx() const { return m_focal; }
    /// Right and down per unit forward, for a point of the picture.
    ImagePoint rayOf(ImagePoint pixel) const;
    /// Where something at right, down, forward appears; empty at or behind the camera, and far beyond the
    /// lens.
    std::optional<ImagePoint> project(double right, double down, double forward) const;

    /// rayOf for pixel centres, row by row.
    const std::vector<ImagePoint>& centres() const { return m_centres; }

private:
    ImageSize m_size;
    double m_focal, m_k1, m_k2;
    double m_limit = 1.0e9; ///< squared radius up to which the distortion grows outwards
    std::vector<ImagePoint> m_centres;
};

/// The axes of a camera in the world.
struct Sight {
    Vec3 eye, forward, right, down;

    Vec3 direction(float x, float y) const { return forward + right * x + down * y; }
};

} // namespace farol::simulation
