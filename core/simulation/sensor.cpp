#include "core/simulation/sensor.h"

#include "core/simulation/hash.h"
#include "core/simulation/parallel.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace farol::simulation {

namespace {

constexpr float kTarget = 0.26F, kLeastGain = 0.15F, kMostGain = 9.0F;
constexpr std::size_t kToneSteps = 2048; ///< over the square root of light, 0 to 2
constexpr std::size_t kNoiseSteps = 1U << 16U;

/// Screen value (0 to 255, with a fraction) by the square root of light: straight where it is dark, and a
/// soft shoulder that keeps lamps from running out into white all around.
const std::array<float, kToneSteps>& toneTable() {
    static const std::array<float, kToneSteps> kTable = [] {
        std::array<float, kToneSteps> table{};
        for (std::size_t i = 0; i < kToneSteps; ++i) {
            double root = 2.0 * (static_cast<double>(i) + 0.5) / kToneSteps, light = root * root;
            double soft = light < 0.5 ? light : 0.5 + 0.5 * (1.0 - std::exp(-(light - 0.5) / 0.55));
            double screen = soft <= 0.0031308 ? soft * 12.92 : 1.055 * std::pow(soft, 1.0 / 2.4) - 0.055;
            table[i] = static_cast<float>(std::clamp(screen, 0.0, 1.0) * 255.0);
        }
        return table;
    }();
    return kTable;
}

/// Normal deviates, looked up at places that a hash chooses.
const std::vector<float>& deviates() {
    static const std::vector<float> kTable = [] {
        std::vector<float> table(kNoiseSteps);
        Draw draw(4711);
        for (float& value : table) {
            double radius = std::sqrt(-2.0 * std::log(1.0 - draw.unit()));
            value = static_cast<float>(radius * std::cos(2.0 * std::numbers::pi * draw.unit()));
        }
        return table;
    }();
    return kTable;
}

} // namespace

float Exposure::next(const std::vector<Light>& picture, double seconds) {
    // Centre-weighted would flicker with every lamp; a mean of roots takes lamps and windows for less than
    // they are.
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.size(); i += 17, ++count)
        sum += std::sqrt(static_cast<double>(std::min(picture[i].green, 4.0F)));
    double root = count > 0 ? sum / static_cast<double>(count) : 0.5;
    auto wanted = static_cast<float>(kTarget / std::max(root * root, 1.0e-4));
    wanted = std::clamp(wanted, kLeastGain, kMostGain);
    if (!m_adapts) wanted = 1.0F;
    if (m_gain <= 0.0F) {
        m_gain = wanted;
    } else {
        auto share = static_cast<float>(1.0 - std::exp(-std::clamp(seconds, 0.0, 10.0) / 0.45));
        m_gain *= std::pow(wanted / m_gain, share);
    }
    return m_gain;
}

cv::Mat developed(const std::vector<Light>& picture, ImageSize size, float gain, std::uint64_t number,
                  const SensorOptions& options) {
    cv::Mat image(size.height, size.width, CV_8UC3);
    const auto& tone = toneTable();
    const auto& deviate = deviates();
    // Noise of the light itself grows with its root, which the tone curve evens out; what is left grows with
    // the gain.
    float sigma = static_cast<float>(options.noise) * (0.9F + 0.55F * std::sqrt(gain));
    std::uint64_t seed = hashOf(options.seed, number);
    constexpr float kScale = static_cast<float>(kToneSteps) / 2.0F;
    inParallel(size.height, options.threads, [&](int y) {
        const Light* row = picture.data() + static_cast<std::ptrdiff_t>(y) * size.width;
        auto* out = image.ptr<std::uint8_t>(y);
        std::uint64_t place = 0;
        for (int x = 0; x < size.width; ++x) {
            if (x % 64 == 0) // a new stretch of the table before any pattern could be seen
                place =
                    hashOf(seed, static_cast<std::uint64_t>(y) * 1024 + static_cast<std::uint64_t>(x) / 64);
            const float light[3] = {row[x].blue, row[x].green, row[x].red};
            for (int c = 0; c < 3; ++c, ++place) {
                float root = std::sqrt(std::max(light[c] * gain, 0.0F)) * kScale;
                std::size_t step = root < static_cast<float>(kToneSteps - 1) ? static_cast<std::size_t>(root)
                                                                             : kToneSteps - 1;
                float value = tone[step] + sigma * deviate[place & (kNoiseSteps - 1)] + 0.5F;
                out[3 * x + c] = static_cast<std::uint8_t>(value < 0.0F     ? 0.0F
                                                           : value > 255.0F ? 255.0F
                                                                            : value);
            }
        }
    });
    if (options.jpegQuality <= 0) return image;
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, options.jpegQuality});
    return cv::imdecode(bytes, cv::IMREAD_COLOR);
}

} // namespace farol::simulation
