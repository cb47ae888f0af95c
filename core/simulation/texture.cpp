#include "core/simulation/texture.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace farol::simulation {

namespace {

float linearOfByte(int value) {
    float share = static_cast<float>(value) / 255.0F;
    return share <= 0.04045F ? share / 12.92F : std::pow((share + 0.055F) / 1.055F, 2.4F);
}

const std::array<float, 256>& linearTable() {
    static const std::array<float, 256> kTable = [] {
        std::array<float, 256> table{};
        for (int i = 0; i < 256; ++i) table[static_cast<std::size_t>(i)] = linearOfByte(i);
        return table;
    }();
    return kTable;
}

cv::Mat linearPicture(const cv::Mat& picture) {
    cv::Mat linear(picture.size(), CV_32FC3);
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            const auto& from = picture.at<cv::Vec3b>(y, x);
            linear.at<cv::Vec3f>(y, x) =
                cv::Vec3f(linearTable()[from[2]], linearTable()[from[1]], linearTable()[from[0]]);
        }
    }
    return linear;
}

std::uint32_t encoded(const cv::Vec3f& linear) {
    std::uint32_t texel = 0;
    for (int channel = 0; channel < 3; ++channel) {
        float root = std::sqrt(std::clamp(linear[channel], 0.0F, 1.0F)) * 255.0F + 0.5F;
        texel |= static_cast<std::uint32_t>(root) << static_cast<unsigned>(8 * channel);
    }
    return texel;
}

} // namespace

Texture::Texture(const cv::Mat& picture, bool wraps) : m_wraps(wraps) {
    cv::Mat level = picture.empty() ? cv::Mat(1, 1, CV_32FC3, cv::Scalar::all(0.5)) : linearPicture(picture);
    cv::Scalar mean = cv::mean(level);
    m_mean = {static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2])};
    while (true) {
        Level& entry = m_levels[static_cast<std::size_t>(m_levelCount++)];
        entry = {level.cols, level.rows, m_texels.size()};
        for (int y = 0; y < level.rows; ++y)
            for (int x = 0; x < level.cols; ++x) m_texels.push_back(encoded(level.at<cv::Vec3f>(y, x)));
        if ((level.cols == 1 && level.rows == 1) || m_levelCount == static_cast<int>(m_levels.size())) break;
        cv::Mat half;
        cv::resize(level, half, cv::Size(std::max(1, level.cols / 2), std::max(1, level.rows / 2)), 0.0, 0.0,
                   cv::INTER_AREA);
        level = half;
    }
}

Vec3 linearOf(int red, int green, int blue) {
    auto one = [](int value) { return linearTable()[static_cast<std::size_t>(std::clamp(value, 0, 255))]; };
    return {one(red), one(green), one(blue)};
}

} // namespace farol::simulation
