#include "core/recognition/sign_detector.h"

#include "core/recognition/box_overlap.h"
#include "core/recognition/models.h"

#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace farol::recognition {

namespace {

constexpr int kStride = 8;                               // picture pixels for a cell of the network's maps
constexpr int kMultiple = 64;                            // the deepest level halves the picture six times
constexpr double kSideUnit = 16.0;                       // sides come as the logarithm of pixels in this unit
constexpr double kLeastTold = 0.1;                       // weaker candidates are not even rejections
constexpr std::size_t kMostTold = 20;                    // rejections: the best few tell enough
constexpr double kSameOverlap = 0.4, kInsideShare = 0.7; // of two boxes round one sign
constexpr double kLeastSide = 5.0; // in pixels of the searched picture: what is less cannot be made out

struct SignKind {
    Kind kind;
    const char* name; ///< empty: the kind says all
};
/// In the order of the network's maps.
constexpr std::array<SignKind, 5> kKinds{{{Kind::ExitSign, ""},
                                          {Kind::Sign, "extinguisher"},
                                          {Kind::Sign, "toilet"},
                                          {Kind::Sign, "stairs"},
                                          {Kind::Sign, "lift"}}};
constexpr int kKindCount = static_cast<int>(kKinds.size());

struct Candidate {
    double score = 0.0;
    std::size_t kind = 0;
    ImageBox box;      ///< in the picture given
    double side = 0.0; ///< the shorter one, in the searched picture
};

int upTo(int length) {
    return (length + kMultiple - 1) / kMultiple * kMultiple;
}

double sigmoid(double x) {
    return 1.0 / (1.0 + std::exp(-x));
}

/// The maps of one forward pass, each `rows` by `columns`.
class Maps {
public:
    explicit Maps(const cv::Mat& output)
        : m_data(output.ptr<float>()), m_rows(output.size[2]), m_columns(output.size[3]) {}
    int rows() const { return m_rows; }
    int columns() const { return m_columns; }
    float at(int map, int row, int column) const {
        return m_data[(static_cast<std::ptrdiff_t>(map) * m_rows + row) * m_columns + column];
    }
    /// As high as all of its neighbours.
    bool isTop(int map, int row, int column) const {
        float here = at(map, row, column);
        for (int r = std::max(0, row - 1); r <= std::min(m_rows - 1, row + 1); ++r)
            for (int c = std::max(0, column - 1); c <= std::min(m_columns - 1, column + 1); ++c)
                if (at(map, r, c) > here) return false;
        return true;
    }

private:
    const float* m_data;
    int m_rows, m_columns;
};

/// `searched`: the size of the picture in the network's input, without its margin.
Candidate candidateAt(const Maps& maps, int kind, int row, int column, cv::Size searched, double scale) {
    auto side = [&](int which) {
        return kSideUnit *
               std::exp(std::clamp(static_cast<double>(maps.at(kKindCount + which, row, column)), -4.0, 4.0));
    };
    double x = (column + 0.5) * kStride, y = (row + 0.5) * kStride;
    double x0 = std::clamp(x - side(0), 0.0, static_cast<double>(searched.width));
    double y0 = std::clamp(y - side(1), 0.0, static_cast<double>(searched.height));
    double x1 = std::clamp(x + side(2), 0.0, static_cast<double>(searched.width));
    double y1 = std::clamp(y + side(3), 0.0, static_cast<double>(searched.height));
    Candidate candidate;
    candidate.score = sigmoid(maps.at(kind, row, column));
    candidate.kind = static_cast<std::size_t>(kind);
    candidate.box = {x0 / scale, y0 / scale, (x1 - x0) / scale, (y1 - y0) / scale};
    candidate.side = std::min(x1 - x0, y1 - y0);
    return candidate;
}

/// All tops of the heat, best first, one for each sign.
std::vector<Candidate> candidatesOf(const Maps& maps, cv::Size searched, double scale) {
    float least = static_cast<float>(std::log(kLeastTold / (1.0 - kLeastTold)));
    std::vector<Candidate> all, kept;
    for (int kind = 0; kind < kKindCount; ++kind)
        for (int row = 0; row < maps.rows(); ++row)
            for (int column = 0; column < maps.columns(); ++column)
                if (maps.at(kind, row, column) >= least && maps.isTop(kind, row, column))
                    all.push_back(candidateAt(maps, kind, row, column, searched, scale));
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    for (const Candidate& one : all) {
        bool copy = std::any_of(kept.begin(), kept.end(), [&](const Candidate& k) {
            return overlap(k.box, one.box) > kSameOverlap || shareInside(k.box, one.box) > kInsideShare;
        });
        if (!copy) kept.push_back(one);
    }
    return kept;
}

Detection detectionOf(const Candidate& candidate, const cv::Mat& image, double focalPx) {
    Detection detection;
    detection.kind = kKinds[candidate.kind].kind;
    detection.text = kKinds[candidate.kind].name;
    detection.quad = quadOf(candidate.box);
    detection.image = {image.cols, image.rows};
    detection.score = candidate.score;
    if (focalPx > 0.0)
        detection.bearing = Radians{std::atan2(image.cols / 2.0 - candidate.box.centre().x, focalPx)};
    return detection;
}

} // namespace

struct SignDetector::Network {
    cv::dnn::Net net;
};

Result<void> SignDetectorOptions::check() const {
    auto wrong = [](const std::string& message, const char* option) {
        return Error{ErrorCode::InvalidArgument, message, option};
    };
    if (!(minScore >= 0.0 && minScore <= 1.0)) return wrong("a score lies between 0 and 1", "minScore");
    if (!(minSquareScore >= 0.0 && minSquareScore <= 1.0))
        return wrong("a score lies between 0 and 1", "minSquareScore");
    if (longestSide < 128 || longestSide > 2048)
        return wrong("the searched picture is 128 to 2048 pixels long", "longestSide");
    if (!(focalPx >= 0.0)) return wrong("a focal length is positive, or 0 where it is unknown", "focalPx");
    return {};
}

SignDetector::SignDetector(const SignDetectorOptions& options)
    : m_options(options), m_network(std::make_unique<Network>()) {
    std::string_view model = signNetwork();
    try { // compiled in and tested: a damaged one finds no signs
        m_network->net = cv::dnn::readNetFromONNX(model.data(), model.size());
        m_network->net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    } catch (const cv::Exception&) {
        m_network->net = cv::dnn::Net();
    }
}

SignDetector::~SignDetector() = default;
SignDetector::SignDetector(SignDetector&&) noexcept = default;
SignDetector& SignDetector::operator=(SignDetector&&) noexcept = default;

DetectorResult SignDetector::detect(const cv::Mat& bgr) {
    DetectorResult result;
    if (bgr.empty() || bgr.type() != CV_8UC3 || m_network->net.empty()) return result;
    double scale = std::min(1.0, static_cast<double>(m_options.longestSide) / std::max(bgr.cols, bgr.rows));
    cv::Size searched(std::max(1, cvRound(bgr.cols * scale)), std::max(1, cvRound(bgr.rows * scale)));
    cv::Mat input(upTo(searched.height), upTo(searched.width), CV_8UC3, cv::Scalar::all(114));
    cv::Mat place = input(cv::Rect(cv::Point(), searched));
    cv::resize(bgr, place, searched, 0.0, 0.0, cv::INTER_AREA);
    m_network->net.setInput(cv::dnn::blobFromImage(input, 1.0 / 255.0));
    cv::Mat output = m_network->net.forward();
    if (output.dims != 4 || output.size[1] != kKindCount + 4) return result;
    for (const Candidate& one : candidatesOf(Maps(output), searched, scale)) {
        const SignKind& kind = kKinds[one.kind];
        bool square = kind.kind != Kind::ExitSign;
        const char* reason = nullptr;
        double value = one.score;
        if (square && !m_options.squareSigns) {
            reason = "kind_not_asked_for";
        } else if (one.side < kLeastSide) {
            reason = "too_small";
            value = one.side;
        } else if (one.score < (square ? m_options.minSquareScore : m_options.minScore)) {
            reason = "low_score";
        }
        if (reason == nullptr)
            result.detections.push_back(detectionOf(one, bgr, m_options.focalPx));
        else if (result.rejections.size() < kMostTold)
            result.rejections.push_back({"signs", kind.kind, {}, quadOf(one.box), reason, value});
    }
    return result;
}

} // namespace farol::recognition
