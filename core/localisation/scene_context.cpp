#include "core/localisation/scene_context.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace farol::localisation {

namespace {

cv::Mat asBgr(const cv::Mat& image) {
    cv::Mat bgr;
    if (image.channels() == 1)
        cv::cvtColor(image, bgr, cv::COLOR_GRAY2BGR);
    else if (image.channels() == 4)
        cv::cvtColor(image, bgr, cv::COLOR_BGRA2BGR);
    else
        bgr = image;
    return bgr;
}

Error outOfRange(const char* message, const char* option) {
    return {ErrorCode::InvalidArgument, message, option};
}

} // namespace

Result<void> SceneOptions::check() const {
    auto isCorrelation = [](double value) { return value >= -1.0 && value <= 1.0; };
    if (!isCorrelation(minCorrelationToPrevious)) {
        return outOfRange("a correlation lies between -1 and 1", "scene.minCorrelationToPrevious");
    }
    if (!isCorrelation(minCorrelationToFirst)) {
        return outOfRange("a correlation lies between -1 and 1", "scene.minCorrelationToFirst");
    }
    for (int bins : {hueBins, saturationBins, valueBins}) {
        if (bins < 1 || bins > 64) return outOfRange("a histogram axis has 1 to 64 bins", "scene bins");
    }
    return {};
}

cv::Mat sceneHistogram(const cv::Mat& image, const SceneOptions& options) {
    int sizes[] = {options.hueBins, options.saturationBins, options.valueBins};
    if (image.empty() || image.depth() != CV_8U) return cv::Mat::zeros(3, sizes, CV_32F);
    cv::Mat small, hsv;
    cv::Size quarter(std::max(1, image.cols / 4), std::max(1, image.rows / 4));
    cv::resize(asBgr(image), small, quarter, 0, 0, cv::INTER_AREA);
    cv::cvtColor(small, hsv, cv::COLOR_BGR2HSV);
    const float hueRange[] = {0.0F, 180.0F};
    const float byteRange[] = {0.0F, 256.0F};
    const float* ranges[] = {hueRange, byteRange, byteRange};
    const int channels[] = {0, 1, 2};
    cv::Mat histogram;
    cv::calcHist(&hsv, 1, channels, cv::Mat(), histogram, 3, sizes, ranges);
    histogram.convertTo(histogram, CV_32F, 1.0 / static_cast<double>(hsv.total()));
    return histogram;
}

double sceneCorrelation(const cv::Mat& a, const cv::Mat& b) {
    cv::Mat rootA, rootB;
    cv::sqrt(a, rootA);
    cv::sqrt(b, rootB);
    double value = cv::compareHist(rootA, rootB, cv::HISTCMP_CORREL);
    return std::isfinite(value) ? std::clamp(value, -1.0, 1.0) : 0.0;
}

SceneContext::SceneContext(SceneOptions options) : m_options(options) {}

int SceneContext::observe(const cv::Mat& image) {
    if (image.empty()) return std::max(m_scene, 0); // a frame without a picture says nothing of the scene
    cv::Mat histogram = sceneHistogram(image, m_options);
    if (m_scene < 0) {
        m_scene = 0;
        m_first = histogram;
    } else {
        m_toPrevious = sceneCorrelation(histogram, m_previous);
        m_toFirst = sceneCorrelation(histogram, m_first);
        if (m_toPrevious < m_options.minCorrelationToPrevious ||
            m_toFirst < m_options.minCorrelationToFirst) {
            ++m_scene;
            m_first = histogram;
        }
    }
    m_previous = histogram;
    return m_scene;
}

} // namespace farol::localisation
