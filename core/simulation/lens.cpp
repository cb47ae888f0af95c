#include "core/simulation/lens.h"

#include <cmath>

namespace farol::simulation {

Lens::Lens(ImageSize size, double horizontalFovDegrees, double k1, double k2)
    : m_size(size),
      m_focal(size.width / 2.0 / std::tan(horizontalFovDegrees * 3.14159265358979323846 / 360.0)),
      m_k1(k1),
      m_k2(k2) {
    // r (1 + k1 r2 + k2 r4) turns back where its slope is zero; beyond, one pixel would show two directions.
    for (double squared = 0.05; squared < 16.0; squared += 0.01) {
        if (1.0 + 3.0 * m_k1 * squared + 5.0 * m_k2 * squared * squared <= 0.05) {
            m_limit = squared;
            break;
        }
    }
    m_centres.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) m_centres.push_back(rayOf({x + 0.5, y + 0.5}));
}

ImagePoint Lens::rayOf(ImagePoint pixel) const {
    double x = (pixel.x - m_size.width / 2.0) / m_focal, y = (pixel.y - m_size.height / 2.0) / m_focal;
    double px = x, py = y;
    for (int i = 0; i < 12; ++i) {
        double squared = std::fmin(px * px + py * py, m_limit);
        double scale = 1.0 + m_k1 * squared + m_k2 * squared * squared;
        px = x / scale;
        py = y / scale;
    }
    return {px, py};
}

std::optional<ImagePoint> Lens::project(double right, double down, double forward) const {
    if (!(forward > 1.0e-6)) return std::nullopt;
    double x = right / forward, y = down / forward, squared = x * x + y * y;
    if (squared > m_limit || squared > 1.0e6) return std::nullopt;
    double scale = 1.0 + m_k1 * squared + m_k2 * squared * squared;
    return ImagePoint{m_size.width / 2.0 + m_focal * x * scale, m_size.height / 2.0 + m_focal * y * scale};
}

} // namespace farol::simulation
