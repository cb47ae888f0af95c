#include "app/farol-cli/evaluate/posters.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace farol::cli {

namespace {

constexpr int kLongSide = 400;

cv::Scalar colour(cv::RNG& draw) {
    return {static_cast<double>(draw.uniform(0, 256)), static_cast<double>(draw.uniform(0, 256)),
            static_cast<double>(draw.uniform(0, 256))};
}

cv::Point spot(cv::RNG& draw, cv::Size size) {
    return {draw.uniform(0, size.width), draw.uniform(0, size.height)};
}

/// Soft clouds of colour, as photographs have them behind what is sharp.
cv::Mat clouds(cv::RNG& draw, cv::Size size) {
    cv::Mat picture(size, CV_8UC3, cv::Scalar::all(0));
    double share = 1.0;
    for (int cells : {3, 8, 24, 80}) {
        cv::Mat coarse(cells, cells, CV_8UC3), fine;
        draw.fill(coarse, cv::RNG::UNIFORM, 0, 256);
        cv::resize(coarse, fine, size, 0, 0, cv::INTER_CUBIC);
        cv::addWeighted(picture, 1.0 - share, fine, share, 0.0, picture);
        share *= draw.uniform(0.25, 0.6);
    }
    return picture;
}

void drawShape(cv::RNG& draw, cv::Mat& picture) {
    cv::Size size = picture.size();
    int largest = std::max(size.width, size.height) / draw.uniform(3, 12);
    cv::Point at = spot(draw, size);
    int thickness = draw.uniform(0, 3) == 0 ? draw.uniform(1, 5) : cv::FILLED;
    switch (draw.uniform(0, 4)) {
    case 0:
        cv::ellipse(picture, at, {draw.uniform(3, largest), draw.uniform(3, largest)},
                    draw.uniform(0.0, 180.0), 0, 360, colour(draw), thickness, cv::LINE_AA);
        break;
    case 1: {
        std::vector<cv::Point> corners;
        for (int i = draw.uniform(3, 7); i > 0; --i)
            corners.push_back(at +
                              cv::Point(draw.uniform(-largest, largest), draw.uniform(-largest, largest)));
        cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{corners}, colour(draw), cv::LINE_AA);
        break;
    }
    case 2:
        cv::line(picture, at, spot(draw, size), colour(draw), draw.uniform(1, 6), cv::LINE_AA);
        break;
    default: {
        std::string words;
        for (int i = draw.uniform(2, 9); i > 0; --i) words += static_cast<char>('A' + draw.uniform(0, 26));
        cv::putText(picture, words, at, draw.uniform(0, 8), draw.uniform(0.4, 2.0), colour(draw),
                    draw.uniform(1, 4), cv::LINE_AA);
    }
    }
}

} // namespace

cv::Mat drawnPoster(int number) {
    cv::RNG draw(0x9E3779B97F4A7C15ULL * (static_cast<std::uint64_t>(number) + 1U));
    int shorter = draw.uniform(kLongSide * 5 / 8, kLongSide + 1);
    cv::Size size = draw.uniform(0, 2) == 0 ? cv::Size(kLongSide, shorter) : cv::Size(shorter, kLongSide);
    cv::Mat picture = clouds(draw, size);
    for (int i = draw.uniform(12, 60); i > 0; --i) drawShape(draw, picture);
    cv::GaussianBlur(picture, picture, {}, draw.uniform(0.4, 1.2));
    return picture;
}

} // namespace farol::cli
