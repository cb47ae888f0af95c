#include "core/recognition/scale_space.h"

#include "core/recognition/wide_code.h"

#include <algorithm>
#include <cmath>

namespace farol::recognition {

namespace {

constexpr int kSmallestOctave = 16; // pixels of the shorter side
constexpr std::size_t kMostOctaves = 6;

/// Half of a symmetric kernel, from its middle on.
std::vector<float> halfKernel(double sigma) {
    int radius = std::max(1, static_cast<int>(std::ceil(3.0 * sigma)));
    std::vector<float> kernel(static_cast<std::size_t>(radius) + 1);
    double sum = 0.0;
    for (int i = 0; i <= radius; ++i) {
        double weight = std::exp(-0.5 * i * i / (sigma * sigma));
        kernel[static_cast<std::size_t>(i)] = static_cast<float>(weight);
        sum += i == 0 ? weight : 2.0 * weight;
    }
    for (float& weight : kernel) weight = static_cast<float>(weight / sum);
    return kernel;
}

int reflected(int at, int size) {
    if (at < 0) at = -at;
    if (at >= size) at = 2 * size - 2 - at;
    return std::clamp(at, 0, size - 1);
}

FAROL_WIDE void scaled(const float* in, float weight, float* out, int count) {
    for (int x = 0; x < count; ++x) out[x] = weight * in[x];
}

FAROL_WIDE void addPair(const float* a, const float* b, float weight, float* out, int count) {
    for (int x = 0; x < count; ++x) out[x] += weight * (a[x] + b[x]);
}

/// Two pairs at once: half the traffic of the sums.
FAROL_WIDE void addPairs(const float* a, const float* b, float weight, const float* c, const float* d,
                         float weight2, float* out, int count) {
    for (int x = 0; x < count; ++x) out[x] += weight * (a[x] + b[x]) + weight2 * (c[x] + d[x]);
}

FAROL_WIDE void subtract(const float* a, const float* b, float* out, int count) {
    for (int x = 0; x < count; ++x) out[x] = a[x] - b[x];
}

void blur(const cv::Mat& in, cv::Mat& out, double sigma, std::vector<float>& row) {
    std::vector<float> kernel = halfKernel(sigma);
    int radius = static_cast<int>(kernel.size()) - 1;
    int width = in.cols;
    out.create(in.size(), CV_32F);
    row.resize(static_cast<std::size_t>(width + 2 * radius));
    float* middle = row.data() + radius;
    auto line = [&](int y) { return in.ptr<float>(reflected(y, in.rows)); };
    auto weight = [&](int k) { return kernel[static_cast<std::size_t>(k)]; };
    for (int y = 0; y < in.rows; ++y) {
        scaled(line(y), weight(0), middle, width);
        int k = 1;
        for (; k < radius; k += 2)
            addPairs(line(y - k), line(y + k), weight(k), line(y - k - 1), line(y + k + 1), weight(k + 1),
                     middle, width);
        if (k == radius) addPair(line(y - k), line(y + k), weight(k), middle, width);
        for (int x = 1; x <= radius; ++x) {
            middle[-x] = middle[reflected(-x, width)];
            middle[width - 1 + x] = middle[reflected(width - 1 + x, width)];
        }
        float* to = out.ptr<float>(y);
        scaled(middle, weight(0), to, width);
        for (k = 1; k < radius; k += 2)
            addPairs(middle - k, middle + k, weight(k), middle - k - 1, middle + k + 1, weight(k + 1), to,
                     width);
        if (k == radius) addPair(middle - k, middle + k, weight(k), to, width);
    }
}

void halved(const cv::Mat& in, cv::Mat& out) {
    out.create(in.rows / 2, in.cols / 2, CV_32F);
    for (int y = 0; y < out.rows; ++y) {
        const float* from = in.ptr<float>(2 * y);
        float* to = out.ptr<float>(y);
        for (int x = 0; x < out.cols; ++x) to[x] = from[2 * x];
    }
}

void fill(Octave& octave, std::vector<float>& row) {
    double previous = kBaseSigma;
    for (std::size_t i = 1; i < octave.blurred.size(); ++i) {
        double sigma = kBaseSigma * std::exp2(static_cast<double>(i) / kScaleLayers);
        blur(octave.blurred[i - 1], octave.blurred[i], std::sqrt(sigma * sigma - previous * previous), row);
        previous = sigma;
        cv::Mat& difference = octave.differences[i - 1];
        difference.create(octave.blurred[i].size(), CV_32F);
        for (int y = 0; y < difference.rows; ++y)
            subtract(octave.blurred[i].ptr<float>(y), octave.blurred[i - 1].ptr<float>(y),
                     difference.ptr<float>(y), difference.cols);
    }
}

} // namespace

void ScaleSpace::build(const cv::Mat& grey) {
    std::size_t count = 1;
    for (int side = std::min(grey.cols, grey.rows) / 2; side >= kSmallestOctave && count < kMostOctaves;
         side /= 2)
        ++count;
    octaves.resize(count);
    grey.convertTo(input, CV_32F);
    blur(input, octaves[0].blurred[0], std::sqrt(kBaseSigma * kBaseSigma - kPictureSigma * kPictureSigma),
         row);
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) halved(octaves[i - 1].blurred[kScaleLayers], octaves[i].blurred[0]);
        fill(octaves[i], row);
    }
}

} // namespace farol::recognition
