// Doors on photographs: boxes of the door set, and the labelled frames of the corridor walk.

#include "app/farol-cli/evaluate/box_scores.h"
#include "app/farol-cli/evaluate/data_set.h"
#include "app/farol-cli/evaluate/evaluation.h"
#include "core/capture/picture.h"
#include "core/recognition/door_detector.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

namespace farol::cli {

namespace {

namespace fs = std::filesystem;
using recognition::Detection;

struct Tally {
    int pictures = 0, picturesWithAny = 0;
    BoxScores doors;
    std::vector<double> milliseconds;
};

std::vector<Detection> look(const cv::Mat& image, Tally& tally) {
    double start = cpuMilliseconds();
    auto found = recognition::detectDoors(image).detections;
    tally.milliseconds.push_back(cpuMilliseconds() - start);
    ++tally.pictures;
    tally.picturesWithAny += found.empty() ? 0 : 1;
    return found;
}

std::vector<EvaluationJson> rowOf(const std::string& name, const Tally& t, const std::string& goal) {
    return {name,
            t.pictures,
            t.doors.boxes,
            t.doors.found,
            t.doors.wrong,
            shareCell(t.doors.found, t.doors.boxes),
            shareCell(t.doors.found, t.doors.found + t.doors.wrong),
            medianCell(t.milliseconds),
            goal};
}

std::string goalOf(const std::string& scene) {
    if (scene == "office_like") return "recall .75 at precision .90 with no_door";
    return scene == "no_door" ? "at most 3 wrong in 100" : "reported";
}

Result<void> photographs(const fs::path& doors, EvaluationTable& table) {
    auto rows = CsvTable::read(doors / "index.csv", {"image", "scene"});
    if (!rows) return rows.error();
    std::map<std::string, Tally> tallies;
    Progress progress("doors", rows->size());
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const std::string& name = rows->cell(i, "image");
        auto image = capture::readPicture(doors / "images" / name);
        if (!image) return image.error();
        std::string half = shareOf(name, 2) == 0 ? "development half" : "other half";
        Tally& tally = tallies[rows->cell(i, "scene") + ", " + half];
        auto found = look(*image, tally);
        tally.doors.book(
            found, yoloBoxes(doors / "labels" / fs::path(name).replace_extension(".txt"), image->size()));
        progress.step();
    }
    for (const auto& [name, tally] : tallies)
        table.rows.push_back(rowOf(name, tally, goalOf(name.substr(0, name.find(',')))));
    for (const char* half : {"development half", "other half"}) {
        Tally both;
        for (const char* scene : {"office_like, ", "no_door, "}) {
            const Tally& t = tallies[std::string(scene) + half];
            both.pictures += t.pictures;
            both.doors.boxes += t.doors.boxes;
            both.doors.found += t.doors.found;
            both.doors.wrong += t.doors.wrong;
            both.milliseconds.insert(both.milliseconds.end(), t.milliseconds.begin(), t.milliseconds.end());
        }
        table.rows.push_back(
            rowOf("office_like and no_door, " + std::string(half), both, "precision .90, recall .75"));
    }
    return {};
}

/// Whether a frame shows a door at all, against the labels "frontal door of at least half the frame's
/// height".
Result<void> corridor(const fs::path& walk, EvaluationTable& table) {
    auto rows =
        CsvTable::read(walk / "helper_labels.csv", {"image", "frontal_door_at_least_half_frame_height"});
    if (!rows) return rows.error();
    std::map<std::string, Tally> tallies;
    Progress progress("corridor", rows->size());
    for (std::size_t i = 0; i < rows->size(); ++i) {
        auto image = capture::readPicture(walk / rows->cell(i, "image"));
        if (!image) return image.error();
        const std::string& label = rows->cell(i, "frontal_door_at_least_half_frame_height");
        std::string lap = i < 40 ? "first lap (trained on)" : "second lap";
        Tally& tally = tallies[label + ", " + lap];
        bool any = !look(*image, tally).empty();
        tally.doors.boxes += label == "yes" ? 1 : 0;
        tally.doors.found += label == "yes" && any ? 1 : 0;
        tally.doors.wrong += label == "no" && any ? 1 : 0;
        progress.step();
    }
    for (const auto& [name, tally] : tallies)
        table.rows.push_back(rowOf("frontal door: " + name, tally,
                                   name.rfind("unclear", 0) == 0 ? "reported" : "all found, none wrong"));
    return {};
}

} // namespace

Result<EvaluationReport> evaluateDoors(const fs::path& data) {
    auto doors = dataSet(data, "images/doors");
    if (!doors) return doors.error();
    EvaluationReport report;
    std::vector<std::string> columns{"set",    "pictures",  "doors",           "found", "wrong",
                                     "recall", "precision", "cpu ms (median)", "goal"};
    report.tables.push_back({"Doors, box overlap at least one half", columns, {}});
    auto booked = photographs(*doors, report.tables.back());
    if (!booked) return booked.error();
    auto walk = dataSet(data, "images/corridor_walk");
    if (!walk) {
        report.notes.push_back(walk.error().text());
        return report;
    }
    report.tables.push_back({"Doors of the corridor walk, by frame", columns, {}});
    booked = corridor(*walk, report.tables.back());
    if (!booked) return booked.error();
    report.notes.push_back("The classifier was trained on the development halves and the first lap.");
    return report;
}

} // namespace farol::cli
