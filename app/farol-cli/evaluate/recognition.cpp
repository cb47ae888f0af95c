// Trained planes in composed frames (images/planar_landmarks): recall by difficulty, precision, time of the
// processor.

#include "app/farol-cli/evaluate/data_set.h"
#include "app/farol-cli/evaluate/evaluation.h"
#include "app/farol-cli/evaluate/posters.h"
#include "core/base/file.h"
#include "core/capture/picture.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/training.h"

#include <opencv2/features2d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <set>

namespace farol::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kDrawnTemplates = 900; // with the hundred of the set a thousand
constexpr double kHit = 0.5;         // overlap of the outlines
const std::array<std::string, 3> kDifficulties{"easy", "medium", "hard"};

Result<std::vector<json>> jsonLines(const fs::path& file) {
    std::ifstream in(file);
    if (!in) return Error{ErrorCode::NotFound, "cannot be opened", file.string()};
    std::vector<json> lines;
    for (std::string line; std::getline(in, line);) {
        lines.push_back(json::parse(line, nullptr, false));
        if (lines.back().is_discarded())
            return Error{ErrorCode::Corrupt, "line " + std::to_string(lines.size()) + " is no JSON",
                         file.string()};
    }
    return lines;
}

Quad quadFrom(const json& corners) {
    Quad quad;
    for (std::size_t i = 0; i < 4; ++i)
        quad[i] = {corners.at(i).at(0).get<double>(), corners.at(i).at(1).get<double>()};
    return quad;
}

double overlap(const Quad& a, const Quad& b) {
    auto outline = [](const Quad& quad) {
        std::vector<cv::Point2f> points;
        for (const ImagePoint& p : quad)
            points.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
        return points;
    };
    std::vector<cv::Point2f> pa = outline(a), pb = outline(b), common;
    double both = cv::intersectConvexConvex(pa, pb, common);
    return both / (cv::contourArea(pa) + cv::contourArea(pb) - both);
}

Result<void> trainSet(const fs::path& set, recognition::LandmarkLibrary& library, int& refused) {
    auto lines = jsonLines(set / "train.jsonl");
    if (!lines) return lines.error();
    Progress progress("training", lines->size());
    for (const json& line : *lines) {
        progress.step();
        recognition::TrainingRequest request;
        request.id = TemplateId(line.at("template").get<std::string>());
        request.kind = Kind::Poster;
        request.widthM = line.at("width_m").get<double>();
        request.heightM = line.at("tall_m").get<double>();
        auto bytes = readFile((set / line.at("file").get<std::string>()).string());
        if (!bytes) return bytes.error();
        if (!addView(library, request, *bytes, quadFrom(line.at("outline")))) ++refused;
    }
    return {};
}

void trainDrawn(recognition::LandmarkLibrary& library) {
    Progress progress("training drawn posters", kDrawnTemplates);
    for (int number = 0; number < kDrawnTemplates; ++number) {
        progress.step();
        std::vector<unsigned char> bytes;
        cv::imencode(".jpg", drawnPoster(number), bytes);
        recognition::TrainingRequest request;
        request.id = TemplateId("drawn-" + std::to_string(number));
        request.kind = Kind::Poster;
        (void)addView(library, request, {bytes.begin(), bytes.end()}, {});
    }
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct Tally {
    std::array<int, 3> shown{}, found{};
    int wrong = 0, wrongInNegatives = 0, negatives = 0;
    std::vector<double> milliseconds, reference;
};

std::size_t difficultyOf(const json& line) {
    auto name = line.at("difficulty").get<std::string>();
    auto at = std::find(kDifficulties.begin(), kDifficulties.end(), name) - kDifficulties.begin();
    return std::min<std::size_t>(static_cast<std::size_t>(at), 2);
}

void count(const json& line, const recognition::DetectorResult& result, Tally& tally) {
    std::size_t difficulty = difficultyOf(line);
    const json& shown = line.at("landmarks");
    tally.shown[difficulty] += static_cast<int>(shown.size());
    bool negative = shown.empty();
    tally.negatives += negative ? 1 : 0;
    std::set<std::string> found;
    for (const recognition::Detection& detection : result.detections) {
        bool right = std::any_of(shown.begin(), shown.end(), [&](const json& one) {
            return one.at("template").get<std::string>() == detection.templateId.value &&
                   overlap(quadFrom(one.at("quad")), detection.quad) > kHit;
        });
        if (right && found.insert(detection.templateId.value).second) {
            ++tally.found[difficulty];
        } else {
            ++tally.wrong;
            tally.wrongInNegatives += negative ? 1 : 0;
        }
    }
}

Result<Tally> recognised(const fs::path& set, const recognition::LandmarkRecogniser& recogniser) {
    auto lines = jsonLines(set / "frames.jsonl");
    if (!lines) return lines.error();
    Tally tally;
    auto reference = cv::SIFT::create();
    Progress progress("frames", lines->size());
    for (std::size_t i = 0; i < lines->size(); ++i) {
        progress.step();
        const json& line = (*lines)[i];
        std::string file = (set / line.at("file").get<std::string>()).string();
        auto bytes = readFile(file);
        if (!bytes) return bytes.error();
        auto image = capture::decodePicture(*bytes, file);
        if (!image) return image.error();
        double start = cpuMilliseconds();
        auto result = recogniser.recognise(*image);
        tally.milliseconds.push_back(cpuMilliseconds() - start);
        count(line, result, tally);
        if (i % 4 != 0) continue;
        cv::Mat grey, descriptors;
        std::vector<cv::KeyPoint> keypoints;
        cv::cvtColor(*image, grey, cv::COLOR_BGR2GRAY);
        start = cpuMilliseconds();
        reference->detectAndCompute(grey, cv::noArray(), keypoints, descriptors);
        tally.reference.push_back(cpuMilliseconds() - start);
    }
    return tally;
}

EvaluationJson share(int part, int whole) {
    if (whole == 0) return nullptr;
    return std::round(10000.0 * part / whole) / 10000.0;
}

std::vector<EvaluationJson> row(const std::string& name, const Tally& tally) {
    int right = tally.found[0] + tally.found[1] + tally.found[2];
    double time = median(tally.milliseconds), reference = median(tally.reference);
    std::vector<EvaluationJson> cells{name};
    for (std::size_t i = 0; i < 3; ++i) cells.push_back(share(tally.found[i], tally.shown[i]));
    cells.push_back(share(right, right + tally.wrong));
    cells.push_back(tally.wrongInNegatives);
    cells.push_back(tally.negatives);
    cells.push_back(std::round(10.0 * time) / 10.0);
    cells.push_back(reference > 0.0 ? EvaluationJson(std::round(100.0 * time / reference) / 100.0)
                                    : EvaluationJson());
    return cells;
}

} // namespace

Result<EvaluationReport> evaluateRecognition(const fs::path& data) {
    auto set = dataSet(data, "images/planar_landmarks");
    if (!set) return set.error();
    int threads = cv::getNumThreads();
    cv::setNumThreads(1);
    EvaluationReport report;
    EvaluationTable table{"Trained planes, images/planar_landmarks",
                          {"templates", "recall easy", "recall medium", "recall hard", "precision",
                           "false in empty frames", "empty frames", "median CPU ms", "of OpenCV's SIFT"},
                          {}};
    auto library = std::make_shared<recognition::LandmarkLibrary>();
    int refused = 0;
    try {
        for (bool drawn : {false, true}) {
            if (drawn)
                trainDrawn(*library);
            else if (auto trained = trainSet(*set, *library, refused); !trained)
                return trained.error();
            recognition::LandmarkRecogniser recogniser(library);
            auto tally = recognised(*set, recogniser);
            if (!tally) return tally.error();
            table.rows.push_back(row(std::to_string(library->templates.size()), *tally));
        }
    } catch (const json::exception& problem) {
        return Error{ErrorCode::Corrupt, std::string("a line lacks what it needs: ") + problem.what(),
                     set->string()};
    }
    cv::setNumThreads(threads);
    report.tables.push_back(std::move(table));
    report.notes.push_back(std::to_string(refused) +
                           " of the set's photographs were refused at training: too few features.");
    report.notes.push_back(
        "A hit: the right template, and outlines that overlap by more than half. Templates "
        "beyond the set's hundred are drawn. One thread; the last column is the ratio to "
        "the time of cv::SIFT alone on the same frames in the same run.");
    return report;
}

} // namespace farol::cli
