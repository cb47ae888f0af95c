// Whole views as places (images/tower): the publishers' own split, one template for each clip of the gallery,
// each query asked alone.

#include "app/farol-cli/evaluate/data_set.h"
#include "app/farol-cli/evaluate/evaluation.h"
#include "core/base/file.h"
#include "core/capture/picture.h"
#include "core/recognition/landmark_recogniser.h"
#include "core/recognition/training.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

namespace farol::cli {

namespace {

namespace fs = std::filesystem;

struct FloorTally {
    int asked = 0, first = 0, said = 0, saidWrong = 0;
};

/// The template that fits best, told or not.
std::optional<std::string> firstOf(const recognition::DetectorResult& result) {
    if (!result.detections.empty()) return result.detections.front().templateId.value;
    for (const recognition::Rejection& rejection : result.rejections)
        if (!rejection.templateId.empty()) return rejection.templateId.value;
    return std::nullopt;
}

std::vector<EvaluationJson> row(const std::string& name, const FloorTally& tally) {
    return {name,        tally.asked,
            tally.first, std::round(1000.0 * tally.first / std::max(1, tally.asked)) / 1000.0,
            tally.said,  tally.saidWrong};
}

} // namespace

Result<EvaluationReport> evaluatePlaces(const fs::path& data) {
    auto set = dataSet(data, "images/tower");
    if (!set) return set.error();
    auto frames = CsvTable::read(*set / "frames.csv", {"image", "clip", "floor", "split"});
    if (!frames) return frames.error();
    auto library = std::make_shared<recognition::LandmarkLibrary>();
    std::map<std::string, std::string> floorOf;
    int refused = 0;
    Progress progress("frames", frames->size());
    std::vector<std::size_t> queries;
    for (std::size_t i = 0; i < frames->size(); ++i) {
        if (frames->cell(i, "split") != "gallery") {
            queries.push_back(i);
            continue;
        }
        progress.step();
        auto bytes = readFile((*set / frames->cell(i, "image")).string());
        if (!bytes) return bytes.error();
        recognition::TrainingRequest request;
        request.id = TemplateId(frames->cell(i, "clip"));
        request.kind = Kind::Place;
        floorOf[request.id.value] = frames->cell(i, "floor");
        if (!addView(*library, request, *bytes, {})) ++refused;
    }
    recognition::LandmarkRecogniser recogniser(library);
    std::map<std::string, FloorTally> floors;
    FloorTally all;
    std::vector<double> times;
    for (std::size_t i : queries) {
        progress.step();
        std::string file = (*set / frames->cell(i, "image")).string();
        auto bytes = readFile(file);
        if (!bytes) return bytes.error();
        auto image = capture::decodePicture(*bytes, file);
        if (!image) return image.error();
        double start = cpuMilliseconds();
        auto result = recogniser.recognise(*image);
        times.push_back(cpuMilliseconds() - start);
        auto best = firstOf(result);
        const std::string& floor = frames->cell(i, "floor");
        bool right = best && floorOf[*best] == floor;
        for (FloorTally* tally : {&floors[floor], &all}) {
            ++tally->asked;
            tally->first += right ? 1 : 0;
            tally->said += result.detections.empty() ? 0 : 1;
            tally->saidWrong += !result.detections.empty() && !right ? 1 : 0;
        }
    }
    EvaluationTable table{"Floors by places, images/tower",
                          {"floor", "queries", "right floor first", "share", "said", "said wrongly"},
                          {}};
    for (const auto& [floor, tally] : floors) table.rows.push_back(row(floor, tally));
    table.rows.push_back(row("all", all));
    EvaluationReport report;
    report.tables.push_back(std::move(table));
    std::sort(times.begin(), times.end());
    double median = times.empty() ? 0.0 : times[times.size() / 2];
    report.notes.push_back("One template for each clip of the gallery, " +
                           std::to_string(library->viewCount()) + " views, " + std::to_string(refused) +
                           " refused (too few features). Said: what the recogniser tells; first: the best "
                           "fit even where it is not told. Median CPU " +
                           std::to_string(static_cast<int>(std::lround(median))) + " ms a query.");
    return report;
}

} // namespace farol::cli
