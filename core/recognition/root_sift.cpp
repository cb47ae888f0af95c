#include "core/recognition/root_sift.h"

#include "core/recognition/wide_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace farol::recognition {

namespace {

constexpr int kBorder = 5;
constexpr int kRefinements = 5;
constexpr int kAngleBins = 36;
constexpr int kAngleGrid = 15; // samples of a side, 0.6 sigma apart
constexpr int kGrid = 20;      // samples of a side of the descriptor, five cells wide
constexpr int kCells = 4, kBins = 8;
constexpr double kSecondPeak = 0.8;
constexpr int kCellPx = 80;        // of the cells that share out half of the spots
constexpr double kEvenShare = 0.5; // of the spots, as many for each cell
constexpr float kTurn = 6.2831853F;

/// An extremum of the differences, refined.
struct Spot {
    std::size_t octave = 0;
    int layer = 0;
    float x = 0.0F, y = 0.0F; ///< in pixels of its octave
    float sigma = 0.0F;       ///< likewise
    float response = 0.0F;
};

FAROL_WIDE int candidatesOfRow(const float* row, float threshold, int from, int to, int* out) {
    int count = 0;
    for (int x = from; x < to; ++x) {
        float v = row[x];
        bool peak = v > threshold && v >= row[x - 1] && v >= row[x + 1];
        bool pit = v < -threshold && v <= row[x - 1] && v <= row[x + 1];
        if (peak || pit) out[count++] = x;
    }
    return count;
}

bool isExtremum(const Octave& octave, int layer, int y, int x) {
    float v = octave.differences[static_cast<std::size_t>(layer)].at<float>(y, x);
    float sign = v > 0.0F ? 1.0F : -1.0F;
    v *= sign;
    for (int l = layer - 1; l <= layer + 1; ++l)
        for (int dy = -1; dy <= 1; ++dy) {
            const float* row = octave.differences[static_cast<std::size_t>(l)].ptr<float>(y + dy) + x;
            if (sign * row[-1] > v || sign * row[0] > v || sign * row[1] > v) return false;
        }
    return true;
}

struct Derivatives {
    cv::Vec3f first; ///< x, y, scale
    cv::Matx33f second;
    float value = 0.0F;
};

Derivatives derivativesAt(const Octave& octave, int layer, int y, int x) {
    auto at = [&](int l, int dy, int dx) {
        return octave.differences[static_cast<std::size_t>(layer + l)].at<float>(y + dy, x + dx);
    };
    Derivatives d;
    d.value = at(0, 0, 0);
    d.first = {(at(0, 0, 1) - at(0, 0, -1)) / 2, (at(0, 1, 0) - at(0, -1, 0)) / 2,
               (at(1, 0, 0) - at(-1, 0, 0)) / 2};
    float twice = 2 * d.value;
    float xx = at(0, 0, 1) + at(0, 0, -1) - twice;
    float yy = at(0, 1, 0) + at(0, -1, 0) - twice;
    float ss = at(1, 0, 0) + at(-1, 0, 0) - twice;
    float xy = (at(0, 1, 1) - at(0, 1, -1) - at(0, -1, 1) + at(0, -1, -1)) / 4;
    float xs = (at(1, 0, 1) - at(1, 0, -1) - at(-1, 0, 1) + at(-1, 0, -1)) / 4;
    float ys = (at(1, 1, 0) - at(1, -1, 0) - at(-1, 1, 0) + at(-1, -1, 0)) / 4;
    d.second = {xx, xy, xs, xy, yy, ys, xs, ys, ss};
    return d;
}

/// False where the peak wanders off, is too weak or lies along an edge.
bool refine(const Octave& octave, int layer, int y, int x, const RootSiftOptions& options, Spot& spot) {
    const cv::Size size = octave.differences[0].size();
    for (int round = 0; round < kRefinements; ++round) {
        Derivatives d = derivativesAt(octave, layer, y, x);
        cv::Vec3f step = d.second.solve(-d.first, cv::DECOMP_LU);
        if (std::abs(step[0]) < 0.5F && std::abs(step[1]) < 0.5F && std::abs(step[2]) < 0.5F) {
            float value = (d.value + 0.5F * d.first.dot(step)) / 255.0F;
            if (std::abs(value) * kScaleLayers < options.contrastThreshold) return false;
            float trace = d.second(0, 0) + d.second(1, 1);
            float determinant = d.second(0, 0) * d.second(1, 1) - d.second(0, 1) * d.second(0, 1);
            auto edge = static_cast<float>(options.edgeThreshold);
            if (determinant <= 0.0F || trace * trace * edge >= (edge + 1) * (edge + 1) * determinant)
                return false;
            spot.layer = layer;
            spot.x = static_cast<float>(x) + step[0];
            spot.y = static_cast<float>(y) + step[1];
            spot.sigma = static_cast<float>(kBaseSigma) *
                         std::exp2((static_cast<float>(layer) + step[2]) / kScaleLayers);
            spot.response = std::abs(value);
            return true;
        }
        for (int i = 0; i < 3; ++i)
            if (!(std::abs(step[i]) < 1000.0F)) return false; // also no number
        x += cvRound(step[0]);
        y += cvRound(step[1]);
        layer += cvRound(step[2]);
        if (layer < 1 || layer > kScaleLayers || x < kBorder || y < kBorder || x >= size.width - kBorder ||
            y >= size.height - kBorder)
            return false;
    }
    return false;
}

bool stronger(const Spot& a, const Spot& b) {
    return a.response > b.response;
}

/// Of spots in order of strength: one half is shared out evenly over the picture, so that a busy part does
/// not leave a plain poster without any, the other half are the strongest of the rest.
void keepStrongest(std::vector<Spot>& spots, std::size_t most, cv::Size picture) {
    if (spots.size() <= most) return;
    const int columns = (picture.width + kCellPx - 1) / kCellPx,
              rows = (picture.height + kCellPx - 1) / kCellPx;
    auto cellOf = [&](const Spot& spot) {
        auto scale = static_cast<float>(1 << spot.octave);
        int column = std::clamp(static_cast<int>(spot.x * scale) / kCellPx, 0, columns - 1);
        int row = std::clamp(static_cast<int>(spot.y * scale) / kCellPx, 0, rows - 1);
        return static_cast<std::size_t>(row * columns + column);
    };
    auto quota = static_cast<int>(kEvenShare * static_cast<double>(most) / (columns * rows));
    std::vector<int> taken(static_cast<std::size_t>(columns * rows), 0);
    std::vector<Spot> even, others;
    for (const Spot& spot : spots) (taken[cellOf(spot)]++ < quota ? even : others).push_back(spot);
    others.resize(most - even.size());
    spots.clear();
    std::merge(even.begin(), even.end(), others.begin(), others.end(), std::back_inserter(spots), stronger);
}

std::vector<Spot> findSpots(const ScaleSpace& space, const RootSiftOptions& options) {
    std::vector<Spot> spots;
    std::vector<int> columns;
    auto threshold = static_cast<float>(0.5 * options.contrastThreshold / kScaleLayers * 255.0);
    for (std::size_t o = 0; o < space.octaves.size(); ++o) {
        const Octave& octave = space.octaves[o];
        const cv::Size size = octave.differences[0].size();
        columns.resize(static_cast<std::size_t>(size.width));
        for (int layer = 1; layer <= kScaleLayers; ++layer)
            for (int y = kBorder; y < size.height - kBorder; ++y) {
                const float* row = octave.differences[static_cast<std::size_t>(layer)].ptr<float>(y);
                int found = candidatesOfRow(row, threshold, kBorder, size.width - kBorder, columns.data());
                for (int i = 0; i < found; ++i) {
                    int x = columns[static_cast<std::size_t>(i)];
                    Spot spot;
                    spot.octave = o;
                    if (isExtremum(octave, layer, y, x) && refine(octave, layer, y, x, options, spot))
                        spots.push_back(spot);
                }
            }
    }
    // Several starting points can end in one peak.
    auto same = [](const Spot& a, const Spot& b) {
        return a.octave == b.octave && a.layer == b.layer && a.x == b.x && a.y == b.y;
    };
    std::stable_sort(spots.begin(), spots.end(), stronger);
    spots.erase(std::unique(spots.begin(), spots.end(), same), spots.end());
    keepStrongest(spots, static_cast<std::size_t>(options.maxKeypoints),
                  space.octaves[0].differences[0].size());
    return spots;
}

/// `side` x `side` samples around a point, `step` apart, turned; beyond the picture its border goes on.
void sample(const cv::Mat& image, float x, float y, float cosine, float sine, float step, int side,
            float* out) {
    float half = 0.5F * static_cast<float>(side - 1);
    auto right = static_cast<float>(image.cols) - 1.001F;
    auto bottom = static_cast<float>(image.rows) - 1.001F;
    std::size_t stride = image.step1();
    const float* pixels = image.ptr<float>();
    for (int row = 0; row < side; ++row) {
        float v = step * (static_cast<float>(row) - half);
        for (int column = 0; column < side; ++column) {
            float u = step * (static_cast<float>(column) - half);
            float sx = std::min(std::max(x + u * cosine - v * sine, 0.0F), right);
            float sy = std::min(std::max(y + u * sine + v * cosine, 0.0F), bottom);
            int ix = static_cast<int>(sx);
            int iy = static_cast<int>(sy);
            float fx = sx - static_cast<float>(ix);
            float fy = sy - static_cast<float>(iy);
            const float* at = pixels + static_cast<std::size_t>(iy) * stride + static_cast<std::size_t>(ix);
            float top = at[0] + fx * (at[1] - at[0]);
            float low = at[stride] + fx * (at[stride + 1] - at[stride]);
            *out++ = top + fy * (low - top);
        }
    }
}

/// Gradient of a sampled square without its rim: weighted size, and direction in parts of a turn times
/// `bins`.
FAROL_WIDE void gradients(const float* patch, int side, const float* weights, float bins, float* size,
                          float* direction) {
    int inner = side - 2;
    for (int row = 0; row < inner; ++row) {
        const float* at = patch + (row + 1) * side + 1;
        for (int column = 0; column < inner; ++column) {
            float gx = at[column + 1] - at[column - 1];
            float gy = at[column + side] - at[column - side];
            float ax = std::abs(gx);
            float ay = std::abs(gy);
            float low = ax < ay ? ax : ay;
            float high = ax < ay ? ay : ax;
            float t = low / (high + 1e-6F);
            float s = t * t;
            // Arctangent on 0 to 1, to a ten-thousandth of a turn.
            float a =
                t * (0.9998660F + s * (-0.3302995F + s * (0.1801410F + s * (-0.0851330F + s * 0.0208351F))));
            a = ay > ax ? 1.5707963F - a : a;
            a = gx < 0.0F ? 3.1415927F - a : a;
            a = gy < 0.0F ? kTurn - a : a;
            int i = row * inner + column;
            size[i] = weights[i] * std::sqrt(gx * gx + gy * gy);
            direction[i] = a * (bins / kTurn);
        }
    }
}

std::array<float, kAngleGrid * kAngleGrid> angleWeights() {
    std::array<float, kAngleGrid * kAngleGrid> weights{};
    for (int y = 0; y < kAngleGrid; ++y)
        for (int x = 0; x < kAngleGrid; ++x) {
            double u = 0.6 * (x - kAngleGrid / 2), v = 0.6 * (y - kAngleGrid / 2);
            weights[static_cast<std::size_t>(y * kAngleGrid + x)] =
                static_cast<float>(std::exp(-(u * u + v * v) / (2.0 * 1.5 * 1.5)));
        }
    return weights;
}

/// Directions of the surroundings' strongest gradients, clockwise in radians.
std::vector<float> orientations(const cv::Mat& image, const Spot& spot) {
    static const auto kWeights = angleWeights();
    constexpr int kSide = kAngleGrid + 2;
    std::array<float, kSide * kSide> patch;
    std::array<float, kAngleGrid * kAngleGrid> size, direction;
    sample(image, spot.x, spot.y, 1.0F, 0.0F, 0.6F * spot.sigma, kSide, patch.data());
    gradients(patch.data(), kSide, kWeights.data(), kAngleBins, size.data(), direction.data());
    std::array<float, kAngleBins> raw{}, smooth{};
    for (std::size_t i = 0; i < size.size(); ++i) {
        int bin = static_cast<int>(direction[i] + 0.5F) % kAngleBins;
        raw[static_cast<std::size_t>(bin)] += size[i];
    }
    auto of = [](const auto& bins, int i) {
        return bins[static_cast<std::size_t>((i + kAngleBins) % kAngleBins)];
    };
    for (int i = 0; i < kAngleBins; ++i)
        smooth[static_cast<std::size_t>(i)] = (of(raw, i - 2) + of(raw, i + 2)) / 16 +
                                              (of(raw, i - 1) + of(raw, i + 1)) / 4 + of(raw, i) * 6 / 16;
    float most = *std::max_element(smooth.begin(), smooth.end());
    std::vector<float> found;
    for (int i = 0; i < kAngleBins; ++i) {
        float left = of(smooth, i - 1), here = of(smooth, i), right = of(smooth, i + 1);
        if (here <= left || here <= right || here < kSecondPeak * most) continue;
        float bin = static_cast<float>(i) + 0.5F * (left - right) / (left - 2 * here + right);
        found.push_back(bin * kTurn / kAngleBins);
    }
    return found;
}

/// What every descriptor shares: the window's weight of a sample, and its cells with their shares.
struct GridTables {
    std::array<float, kGrid * kGrid> window;
    std::array<int, kGrid> cell;    ///< the left one of the two, -1 to 3
    std::array<float, kGrid> share; ///< of the right one

    GridTables() {
        for (int i = 0; i < kGrid; ++i) {
            double at = (i + 0.5) * 5.0 / kGrid - 1.0; // in cells; the middle of cell 0 is 0
            auto n = static_cast<std::size_t>(i);
            cell[n] = static_cast<int>(std::floor(at));
            share[n] = static_cast<float>(at - std::floor(at));
        }
        for (int y = 0; y < kGrid; ++y)
            for (int x = 0; x < kGrid; ++x) {
                double u = (x + 0.5) * 5.0 / kGrid - 2.5, v = (y + 0.5) * 5.0 / kGrid - 2.5;
                window[static_cast<std::size_t>(y * kGrid + x)] =
                    static_cast<float>(std::exp(-(u * u + v * v) / 8.0));
            }
    }
};

/// Adds a row of the grid, already spread over columns and directions, to the two rows of cells it lies in.
FAROL_WIDE void addRow(const float* row, float weight, float* histogram) {
    for (int i = 0; i < kCells * kBins; ++i) histogram[i] += weight * row[i];
}

void describe(const cv::Mat& image, const Spot& spot, float angle, unsigned char* out) {
    static const GridTables kTables;
    constexpr int kSide = kGrid + 2;
    std::array<float, kSide * kSide> patch;
    std::array<float, kGrid * kGrid> size, direction;
    sample(image, spot.x, spot.y, std::cos(angle), std::sin(angle), 3.0F * spot.sigma * 5.0F / kGrid, kSide,
           patch.data());
    gradients(patch.data(), kSide, kTables.window.data(), kBins, size.data(), direction.data());
    std::array<float, kDescriptorBytes> histogram{};
    for (int y = 0; y < kGrid; ++y) {
        // One cell of margin on both sides takes what falls outside.
        std::array<float, (kCells + 2) * kBins> row{};
        for (int x = 0; x < kGrid; ++x) {
            auto i = static_cast<std::size_t>(y * kGrid + x);
            int whole = static_cast<int>(direction[i]);
            float part = direction[i] - static_cast<float>(whole);
            auto first = static_cast<std::size_t>(whole & (kBins - 1));
            auto second = static_cast<std::size_t>((whole + 1) & (kBins - 1));
            float right = size[i] * kTables.share[static_cast<std::size_t>(x)];
            float left = size[i] - right;
            float* at = row.data() + (kTables.cell[static_cast<std::size_t>(x)] + 1) * kBins;
            at[first] += left * (1 - part);
            at[second] += left * part;
            at[kBins + first] += right * (1 - part);
            at[kBins + second] += right * part;
        }
        int cell = kTables.cell[static_cast<std::size_t>(y)];
        float share = kTables.share[static_cast<std::size_t>(y)];
        if (cell >= 0) addRow(row.data() + kBins, 1 - share, histogram.data() + cell * kCells * kBins);
        if (cell + 1 < kCells)
            addRow(row.data() + kBins, share, histogram.data() + (cell + 1) * kCells * kBins);
    }
    rootBytes(histogram.data(), out);
}

} // namespace

void rootBytes(const float* histogram, unsigned char* out) {
    float squares = 1e-12F;
    for (int i = 0; i < kDescriptorBytes; ++i) squares += histogram[i] * histogram[i];
    float clip = 0.2F * std::sqrt(squares); // one strong edge must not outvote the rest
    float sum = 1e-6F;
    for (int i = 0; i < kDescriptorBytes; ++i) sum += std::min(histogram[i], clip);
    for (int i = 0; i < kDescriptorBytes; ++i)
        out[i] = cv::saturate_cast<unsigned char>(512.0F * std::sqrt(std::min(histogram[i], clip) / sum));
}

void rootSift(const cv::Mat& grey, const RootSiftOptions& options, ScaleSpace& space,
              std::vector<cv::KeyPoint>& keypoints, cv::Mat& descriptors) {
    space.build(grey);
    std::vector<Spot> spots = findSpots(space, options);
    keypoints.clear();
    descriptors.create(0, kDescriptorBytes, CV_8U);
    descriptors.reserve(2 * spots.size());
    std::array<unsigned char, kDescriptorBytes> bytes{};
    const cv::Mat row(1, kDescriptorBytes, CV_8U, bytes.data());
    for (const Spot& spot : spots) {
        const Octave& octave = space.octaves[spot.octave];
        const cv::Mat& image = octave.blurred[static_cast<std::size_t>(spot.layer)];
        auto scale = static_cast<float>(1 << spot.octave);
        for (float angle : orientations(image, spot)) {
            float degrees = std::fmod(angle * 360.0F / kTurn + 360.0F, 360.0F);
            keypoints.emplace_back(spot.x * scale, spot.y * scale, 2.0F * spot.sigma * scale, degrees,
                                   spot.response, static_cast<int>(spot.octave));
            describe(image, spot, angle, bytes.data());
            descriptors.push_back(row);
        }
    }
}

} // namespace farol::recognition
