// Stairs on photographs, and what is taken for stairs in kitchens and hallways.

#include "app/farol-cli/evaluate/data_set.h"
#include "app/farol-cli/evaluate/evaluation.h"
#include "core/capture/picture.h"
#include "core/recognition/stairs_detector.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace farol::cli {

namespace {

namespace fs = std::filesystem;

struct Tally {
    int pictures = 0, found = 0;
    std::vector<double> milliseconds;
    std::set<std::string> names; ///< where something was found
};

/// Hallway frames of the tower in which an open flight of stairs stands, seen by eye.
bool showsStairs(const std::string& frame) {
    static const std::set<std::string> kFrames{"f13_hallway_left_frame_000024.jpg",
                                               "f13_hallway_right_frame_000022.jpg",
                                               "f13_hallway_right_frame_000023.jpg"};
    return kFrames.count(frame) > 0;
}

Result<void> look(const fs::path& path, Tally& tally) {
    auto image = capture::readPicture(path);
    if (!image) return image.error();
    double start = cpuMilliseconds();
    bool found = !recognition::detectStairs(*image).detections.empty();
    tally.milliseconds.push_back(cpuMilliseconds() - start);
    ++tally.pictures;
    if (!found) return {};
    ++tally.found;
    tally.names.insert(path.filename().string());
    return {};
}

std::vector<EvaluationJson> rowOf(const std::string& set, const Tally& t, const std::string& goal) {
    EvaluationJson share = nullptr, middle = nullptr;
    if (t.pictures > 0) {
        share = std::round(1000.0 * t.found / t.pictures) / 1000.0;
        std::vector<double> times = t.milliseconds;
        std::sort(times.begin(), times.end());
        middle = std::round(10.0 * times[times.size() / 2]) / 10.0;
    }
    std::string names;
    for (const std::string& name : t.names) names += (names.empty() ? "" : " ") + name;
    return {set, t.pictures, t.found, share, middle, goal, t.names.size() <= 6 ? names : ""};
}

struct Asked {
    const char* table;  ///< under images/
    const char* column; ///< that says which rows are meant; empty: all
    const char* value;
    const char* folder; ///< of the pictures, under the table's
    const char* name;
    const char* goal;
};

Result<void> ask(const fs::path& data, const Asked& asked, EvaluationTable& table) {
    fs::path file = data / "images" / asked.table, folder = file.parent_path() / asked.folder;
    std::vector<std::string> wanted{"image"};
    if (*asked.column != '\0') wanted.emplace_back(asked.column);
    auto rows = CsvTable::read(file, wanted);
    if (!rows) return rows.error();
    Tally halves[2], open;
    Progress progress(asked.name, rows->size());
    for (std::size_t i = 0; i < rows->size(); ++i) {
        progress.step();
        if (*asked.column != '\0' && rows->cell(i, asked.column) != asked.value) continue;
        fs::path path = folder / rows->cell(i, "image");
        std::string name = path.filename().string();
        auto looked = look(path, showsStairs(name) ? open : halves[shareOf(name, 2)]);
        if (!looked) return looked;
    }
    table.rows.push_back(rowOf(std::string(asked.name) + ", development half", halves[0], asked.goal));
    table.rows.push_back(rowOf(std::string(asked.name) + ", other half", halves[1], asked.goal));
    if (open.pictures > 0)
        table.rows.push_back(rowOf(std::string(asked.name) + " with open stairs in view", open, "reported"));
    return {};
}

} // namespace

Result<EvaluationReport> evaluateStairs(const fs::path& data) {
    auto stairs = dataSet(data, "images/stairs");
    if (!stairs) return stairs.error();
    EvaluationReport report;
    report.tables.push_back({"Stairs, by picture",
                             {"set", "pictures", "found", "share", "cpu ms (median)", "goal", "where"},
                             {}});
    const Asked all[] = {
        {"stairs/stairs.csv", "", "", "img", "stairs", "at least .80"},
        {"doors/index.csv", "scene", "no_door", "images", "no_door", "at most .02"},
        {"doors/index.csv", "scene", "indoor_home", "images", "indoor_home", "reported"},
        {"tower/frames.csv", "kind", "hallway", ".", "tower hallways", "at most .02"},
        {"tower/stairs_visible.csv", "stairs_steps_visible", "yes", ".", "tower stairs in view", "reported"},
        {"tower/stairs_visible.csv", "stairs_steps_visible", "no", ".", "tower stairs not in view",
         "reported"},
        {"corridor_walk/helper_labels.csv", "", "", ".", "corridor walk", "reported"},
    };
    for (const Asked& asked : all) {
        auto done = ask(data, asked, report.tables.back());
        if (!done) report.notes.push_back(done.error().text());
    }
    return report;
}

} // namespace farol::cli
