#include "core/recognition/flat_plate.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace farol::recognition {

cv::Mat rectified(const cv::Mat& grey, const Quad& quad, int height, int widest) {
    auto side = [&](std::size_t a, std::size_t b) {
        return std::hypot(quad[a].x - quad[b].x, quad[a].y - quad[b].y);
    };
    double high = std::max((side(0, 3) + side(1, 2)) / 2.0, 1.0);
    double wide = std::max((side(0, 1) + side(3, 2)) / 2.0, 1.0);
    cv::Size size(std::clamp(static_cast<int>(std::lround(wide * height / high)), 8, widest), height);
    std::array<cv::Point2f, 4> from;
    for (std::size_t i = 0; i < 4; ++i)
        from[i] = cv::Point2f(static_cast<float>(quad[i].x - 0.5), static_cast<float>(quad[i].y - 0.5));
    auto w = static_cast<float>(size.width) - 0.5F;
    auto h = static_cast<float>(size.height) - 0.5F;
    std::array<cv::Point2f, 4> to{cv::Point2f(-0.5F, -0.5F), cv::Point2f(w, -0.5F), cv::Point2f(w, h),
                                  cv::Point2f(-0.5F, h)};
    cv::Mat out;
    cv::warpPerspective(grey, out, cv::getPerspectiveTransform(from.data(), to.data()), size,
                        height > high ? cv::INTER_CUBIC : cv::INTER_AREA, cv::BORDER_REPLICATE);
    return out;
}

cv::Mat darkOnLight(const cv::Mat& grey) {
    // The border may be a frame or the wall beside the plate; further in, letters cover less than half.
    int bandX = std::min(grey.rows / 8, grey.cols / 8);
    int bandY = grey.rows / 8;
    cv::Mat middle =
        grey(cv::Rect(bandX, bandY, std::max(1, grey.cols - 2 * bandX), std::max(1, grey.rows - 2 * bandY)));
    cv::Mat light;
    cv::threshold(middle, light, 0.0, 255.0, cv::THRESH_BINARY | cv::THRESH_OTSU);
    if (2 * cv::countNonZero(light) >= static_cast<int>(light.total())) return grey;
    cv::Mat inverse;
    cv::bitwise_not(grey, inverse);
    return inverse;
}

} // namespace farol::recognition
