#include "core/recognition/network_detector.h"

#include "core/base/file.h"
#include "core/recognition/box_overlap.h"

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

namespace farol::recognition {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostCandidates = 1000; // the best; more only cost time
constexpr double kLeastTold = 0.5;            // of the least score: weaker ones are not even rejections
constexpr std::size_t kMostTold = 20;
constexpr int kSsdRow = 7;

/// The network's answer as a table: `rows` candidates of `columns` numbers.
struct Answer {
    cv::Mat table;                 ///< CV_32F
    bool chanceOfAnything = false; ///< yolo: a fifth number before the classes
};

struct Candidate {
    double score = 0.0;
    std::size_t which = 0; ///< of the classes
    ImageBox box;          ///< in the picture given
};

/// How the picture lies in the network's input.
struct Fit {
    double scaleX = 1.0, scaleY = 1.0;
};

std::string shapeText(const cv::Mat& output) {
    std::string text;
    for (int i = 0; i < output.dims; ++i) text += (i > 0 ? " x " : "") + std::to_string(output.size[i]);
    return text;
}

/// Empty where the output is not of the described layout.
std::optional<Answer> answerOf(const cv::Mat& output, const DetectorDescription& description) {
    if (output.empty() || output.type() != CV_32F || output.dims < 2) return std::nullopt;
    for (int i = 0; i + 2 < output.dims; ++i)
        if (output.size[i] != 1) return std::nullopt;
    int rows = output.size[output.dims - 2], columns = output.size[output.dims - 1];
    cv::Mat table(rows, columns, CV_32F, const_cast<float*>(output.ptr<float>()));
    if (description.layout == DetectorDescription::Layout::Ssd)
        return columns == kSsdRow ? std::optional<Answer>({table.clone(), false}) : std::nullopt;
    int classes = static_cast<int>(description.classes.size());
    if (columns == classes + 5 || columns == classes + 4)
        return Answer{table.clone(), columns == classes + 5};
    if (rows == classes + 5 || rows == classes + 4) return Answer{table.t(), rows == classes + 5};
    return std::nullopt;
}

void addYolo(const Answer& answer, const Fit& fit, double least, std::vector<Candidate>& out) {
    int first = answer.chanceOfAnything ? 5 : 4;
    for (int r = 0; r < answer.table.rows; ++r) {
        const float* row = answer.table.ptr<float>(r);
        const float* best = std::max_element(row + first, row + answer.table.cols);
        double score =
            static_cast<double>(*best) * (answer.chanceOfAnything ? static_cast<double>(row[4]) : 1.0);
        if (!(score >= least)) continue;
        double width = row[2] / fit.scaleX, height = row[3] / fit.scaleY;
        out.push_back(
            {score,
             static_cast<std::size_t>(best - row - first),
             {row[0] / fit.scaleX - width / 2.0, row[1] / fit.scaleY - height / 2.0, width, height}});
    }
}

void addSsd(const Answer& answer, const Fit& fit, const DetectorDescription& description, double least,
            std::vector<Candidate>& out) {
    double x = description.width / fit.scaleX, y = description.height / fit.scaleY;
    for (int r = 0; r < answer.table.rows; ++r) {
        const float* row = answer.table.ptr<float>(r);
        double which = row[1], score = row[2];
        if (!(row[0] >= 0.0F) || !(score >= least)) continue; // a negative picture ends the list
        if (!(which >= 0.0 && which < static_cast<double>(description.classes.size()))) continue;
        out.push_back({score,
                       static_cast<std::size_t>(which),
                       {row[3] * x, row[4] * y, (row[5] - row[3]) * x, (row[6] - row[4]) * y}});
    }
}

/// What cv::dnn prints about a network it cannot use is for its programmers; ours is told as an Error.
class QuietOpenCv {
public:
    QuietOpenCv() : m_before(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}
    ~QuietOpenCv() { cv::utils::logging::setLogLevel(m_before); }
    QuietOpenCv(const QuietOpenCv&) = delete;
    QuietOpenCv& operator=(const QuietOpenCv&) = delete;

private:
    cv::utils::logging::LogLevel m_before;
};

/// Finite, and cut at the picture's border; false where nothing is left.
bool keepInside(ImageBox& box, const cv::Mat& image) {
    double x0 = std::max(0.0, box.x), x1 = std::min<double>(image.cols, box.x + box.width);
    double y0 = std::max(0.0, box.y), y1 = std::min<double>(image.rows, box.y + box.height);
    if (!std::isfinite(box.x + box.y + box.width + box.height) || !(x1 - x0 >= 1.0 && y1 - y0 >= 1.0))
        return false;
    box = {x0, y0, x1 - x0, y1 - y0};
    return true;
}

/// The best of each object, as detections and rejections.
void tell(std::vector<Candidate> all, const DetectorDescription& description, const cv::Mat& image,
          DetectorResult& result) {
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    if (all.size() > kMostCandidates) all.resize(kMostCandidates);
    std::vector<Candidate> kept;
    for (Candidate& one : all) {
        const auto& kind = description.classes[one.which].kind;
        if (!kind || !keepInside(one.box, image)) continue;
        bool copy = std::any_of(kept.begin(), kept.end(), [&](const Candidate& k) {
            return k.which == one.which && overlap(k.box, one.box) > description.maxOverlap;
        });
        if (copy) continue;
        kept.push_back(one);
    }
    for (const Candidate& one : kept) {
        const auto& told = description.classes[one.which];
        if (one.score >= description.minScore) {
            Detection detection;
            detection.kind = *told.kind;
            if (*told.kind == Kind::Sign || *told.kind == Kind::Other) detection.text = told.name;
            detection.quad = quadOf(one.box);
            detection.image = {image.cols, image.rows};
            detection.score = std::min(one.score, 1.0);
            result.detections.push_back(std::move(detection));
        } else if (result.rejections.size() < kMostTold) {
            result.rejections.push_back({"network", *told.kind, {}, quadOf(one.box), "low_score", one.score});
        }
    }
}

} // namespace

struct NetworkDetector::Network {
    cv::dnn::Net net;
    std::vector<std::string> outputs;

    /// Throws what cv::dnn throws.
    std::optional<Answer> run(const cv::Mat& input, const DetectorDescription& description,
                              std::string* shapes) {
        net.setInput(
            cv::dnn::blobFromImage(input, description.scale, {}, description.mean, description.redFirst));
        std::vector<cv::Mat> answers;
        net.forward(answers, outputs);
        for (const cv::Mat& one : answers) {
            if (auto answer = answerOf(one, description)) return answer;
            if (shapes != nullptr) *shapes += (shapes->empty() ? "" : ", ") + shapeText(one);
        }
        return std::nullopt;
    }
};

NetworkDetector::NetworkDetector(DetectorDescription description, std::unique_ptr<Network> network)
    : m_description(std::move(description)), m_network(std::move(network)) {}
NetworkDetector::~NetworkDetector() = default;
NetworkDetector::NetworkDetector(NetworkDetector&&) noexcept = default;
NetworkDetector& NetworkDetector::operator=(NetworkDetector&&) noexcept = default;

Result<NetworkDetector> NetworkDetector::load(const fs::path& file) {
    auto text = readFile(file);
    if (!text) return text.error();
    auto description = DetectorDescription::parse(*text, file);
    if (!description) return description.error();
    std::string model = description->model.string();
    std::error_code ignored;
    if (!fs::is_regular_file(description->model, ignored))
        return Error{ErrorCode::NotFound,
                     "the network's file is not there; \"model\" in " + file.string() + " names it", model};
    auto network = std::make_unique<Network>();
    QuietOpenCv quiet;
    try {
        network->net = cv::dnn::readNetFromONNX(model);
        network->net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
        network->outputs = network->net.getUnconnectedOutLayersNames();
    } catch (const std::exception&) {
        return Error{
            ErrorCode::UnsupportedFormat,
            "cannot be read as a network: it is no ONNX file, is damaged, or has layers that are not "
            "supported; export it again with a lower operator version (11 or 12)",
            model};
    }
    std::string shapes;
    try {
        cv::Mat grey(description->height, description->width, CV_8UC3, cv::Scalar::all(114));
        if (network->run(grey, *description, &shapes))
            return NetworkDetector(std::move(*description), std::move(network));
    } catch (const std::exception&) {
        return Error{ErrorCode::Conflict,
                     "the network does not take a colour picture of " + std::to_string(description->width) +
                         " x " + std::to_string(description->height) +
                         "; give the size it was exported with as \"input\" in " + file.string(),
                     model};
    }
    bool ssd = description->layout == DetectorDescription::Layout::Ssd;
    std::string count = std::to_string(description->classes.size());
    return Error{ErrorCode::Conflict,
                 "the network answers with " + (shapes.empty() ? "nothing" : shapes) + ", and " +
                     (ssd ? std::string("an ssd has rows of 7 numbers")
                          : "a yolo of " + count + " classes has rows of " + count + " + 4 or + 5 numbers") +
                     "; correct \"layout\" or \"classes\" in " + file.string(),
                 model};
}

DetectorResult NetworkDetector::detect(const cv::Mat& bgr) {
    DetectorResult result;
    if (bgr.empty() || bgr.type() != CV_8UC3) return result;
    const DetectorDescription& d = m_description;
    Fit fit{static_cast<double>(d.width) / bgr.cols, static_cast<double>(d.height) / bgr.rows};
    if (d.letterbox) fit.scaleX = fit.scaleY = std::min(fit.scaleX, fit.scaleY);
    cv::Size size(std::clamp(cvRound(bgr.cols * fit.scaleX), 1, d.width),
                  std::clamp(cvRound(bgr.rows * fit.scaleY), 1, d.height));
    cv::Mat input(d.height, d.width, CV_8UC3, cv::Scalar::all(114));
    cv::Mat place = input(cv::Rect(cv::Point(), size));
    cv::resize(bgr, place, size, 0.0, 0.0, fit.scaleX < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
    std::optional<Answer> answer;
    try {
        answer = m_network->run(input, d, nullptr);
    } catch (const std::exception&) {
        return result; // the same input was taken when it was loaded
    }
    if (!answer) return result;
    std::vector<Candidate> all;
    double least = kLeastTold * d.minScore;
    if (d.layout == DetectorDescription::Layout::Ssd)
        addSsd(*answer, fit, d, least, all);
    else
        addYolo(*answer, fit, least, all);
    tell(std::move(all), d, bgr, result);
    return result;
}

} // namespace farol::recognition
