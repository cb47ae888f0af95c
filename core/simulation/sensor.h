#pragma once
// From light to the bytes of a picture: exposure, the tone curve, the sensor's noise, compression.

#include "core/base/geometry.h"
#include "core/simulation/shader.h"

#include <opencv2/core.hpp>

#include <cstdint>
#include <vector>

namespace farol::simulation {

/// Brightness that follows the light, as a camera's automatic does: quickly at first, never all at once.
class Exposure {
public:
    explicit Exposure(bool adapts) : m_adapts(adapts) {}
    /// The factor for this picture; `seconds` since the one before.
    float next(const std::vector<Light>& picture, double seconds);
    void restart() { m_gain = 0.0F; }

private:
    bool m_adapts;
    float m_gain = 0.0F; ///< 0: not yet known
};

struct SensorOptions {
    double noise = 1.0;
    int jpegQuality = 92;
    std::uint64_t seed = 1;
    int threads = 0;
};

/// `number` counts the pictures: each has noise of its own.
cv::Mat developed(const std::vector<Light>& picture, ImageSize size, float gain, std::uint64_t number,
                  const SensorOptions& options);

} // namespace farol::simulation
