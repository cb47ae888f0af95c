#include "core/recognition/sharpness.h"

#include "core/recognition/grey.h"

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

/// 8-bit with the same channels; empty for depths and channel counts that no camera gives.
cv::Mat eightBit(const cv::Mat& image) {
    if (image.empty() || image.dims != 2) return {};
    if (image.channels() != 1 && image.channels() != 3 && image.channels() != 4) return {};
    if (image.depth() == CV_8U) return image;
    if (image.depth() != CV_16U) return {};
    cv::Mat out;
    image.convertTo(out, CV_8U, 1.0 / 257.0);
    return out;
}

} // namespace

cv::Mat greyOf(const cv::Mat& image) {
    cv::Mat in = eightBit(image);
    if (in.empty() || in.channels() == 1) return in;
    cv::Mat grey;
    cv::cvtColor(in, grey, in.channels() == 3 ? cv::COLOR_BGR2GRAY : cv::COLOR_BGRA2GRAY);
    return grey;
}

cv::Mat colourOf(const cv::Mat& image) {
    cv::Mat in = eightBit(image);
    if (in.empty() || in.channels() == 3) return in;
    cv::Mat colour;
    cv::cvtColor(in, colour, in.channels() == 1 ? cv::COLOR_GRAY2BGR : cv::COLOR_BGRA2BGR);
    return colour;
}

cv::Mat reduced(const cv::Mat& image, int longSide, double& scale) {
    int side = std::max(image.cols, image.rows);
    scale = 1.0;
    if (side <= longSide) return image;
    scale = static_cast<double>(longSide) / side;
    cv::Mat small;
    cv::Size size(std::max(1, static_cast<int>(std::lround(image.cols * scale))),
                  std::max(1, static_cast<int>(std::lround(image.rows * scale))));
    cv::resize(image, small, size, 0.0, 0.0, cv::INTER_AREA);
    return small;
}

double sharpness(const cv::Mat& image) {
    cv::Mat grey = greyOf(image);
    if (grey.empty()) return 0.0;
    if (grey.cols > 320) {
        int height = std::max(1, static_cast<int>(std::lround(grey.rows * 320.0 / grey.cols)));
        cv::Mat small;
        cv::resize(grey, small, cv::Size(320, height), 0.0, 0.0, cv::INTER_AREA);
        grey = small;
    }
    cv::Mat edges;
    cv::Laplacian(grey, edges, CV_16S, 1);
    return cv::norm(edges, cv::NORM_L2) / std::sqrt(static_cast<double>(edges.total()));
}

} // namespace farol::recognition
