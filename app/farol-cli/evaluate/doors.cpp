// Doors on photographs: boxes of the door set, and the labelled frames of the corridor walk.

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
    int pictures = 0, doors = 0, found = 0, wrong = 0, picturesWithAny = 0;
    std::vector<double> milliseconds;
};

/// YOLO form: class, centre and size as shares of the picture; class 0 is a door.
std::vector<ImageBox> doorBoxes(const fs::path& labels, cv::Size size) {
    std::vector<ImageBox> boxes;
    std::ifstream in(labels);
    int kind = 0;
    double x = 0.0, y = 0.0, w = 0.0, h = 0.0;
    while (in >> kind >> x >> y >> w >> h)
        if (kind == 0)
            boxes.push_back(
                {(x - w / 2.0) * size.width, (y - h / 2.0) * size.height, w * size.width, h * size.height});
    return boxes;
}

std::vector<Detection> look(const cv::Mat& image, Tally& tally) {
    double start = cpuMilliseconds();
    auto found = recognition::detectDoors(image).detections;
    tally.milliseconds.push_back(cpuMilliseconds() - start);
    ++tally.pictures;
    tally.picturesWithAny += found.empty() ? 0 : 1;
    return found;
}

void book(const std::vector<Detection>& found, const std::vector<ImageBox>& boxes, Tally& tally) {
    std::vector<bool> met(boxes.size(), false);
    for (const Detection& d : found) {
        bool hit = false;
        for (std::size_t i = 0; i < boxes.size() && !hit; ++i) {
            if (met[i] || overlap(boundingBox(d.quad), boxes[i]) < 0.5) continue;
            met[i] = hit = true;
        }
        (hit ? tally.found : tally.wrong) += 1;
    }
    tally.doors += static_cast<int>(boxes.size());
}

EvaluationJson share(int part, int whole) {
    if (whole == 0) return nullptr;
    return std::round(1000.0 * part / whole) / 1000.0;
}

EvaluationJson middle(std::vector<double> values) {
    if (values.empty()) return nullptr;
    std::sort(values.begin(), values.end());
    return std::round(10.0 * values[values.size() / 2]) / 10.0;
}

std::vector<EvaluationJson> rowOf(const std::string& name, const Tally& t, const std::string& goal) {
    return {name,
            t.pictures,
            t.doors,
            t.found,
            t.wrong,
            share(t.found, t.doors),
            share(t.found, t.found + t.wrong),
            middle(t.milliseconds),
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
        book(found, doorBoxes(doors / "labels" / fs::path(name).replace_extension(".txt"), image->size()),
             tally);
        progress.step();
    }
    for (const auto& [name, tally] : tallies)
        table.rows.push_back(rowOf(name, tally, goalOf(name.substr(0, name.find(',')))));
    for (const char* half : {"development half", "other half"}) {
        Tally both;
        for (const char* scene : {"office_like, ", "no_door, "}) {
            const Tally& t = tallies[std::string(scene) + half];
            both.pictures += t.pictures;
            both.doors += t.doors;
            both.found += t.found;
            both.wrong += t.wrong;
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
        tally.doors += label == "yes" ? 1 : 0;
        tally.found += label == "yes" && any ? 1 : 0;
        tally.wrong += label == "no" && any ? 1 : 0;
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
