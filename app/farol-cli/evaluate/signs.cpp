// Exit signs on photographs, and what is taken for signs in rooms without any.

#include "app/farol-cli/evaluate/box_scores.h"
#include "app/farol-cli/evaluate/data_set.h"
#include "app/farol-cli/evaluate/evaluation.h"
#include "core/capture/picture.h"
#include "core/recognition/sign_detector.h"

#include <array>
#include <cmath>
#include <map>

namespace farol::cli {

namespace {

namespace fs = std::filesystem;
using recognition::Detection;
using recognition::SignDetector;

struct Tally {
    int pictures = 0;
    BoxScores signs;
    std::vector<double> milliseconds;
    std::string where; ///< the first few pictures with something missed or wrong
    int named = 0;

    void name(const std::string& picture) {
        if (++named <= 8) where += (where.empty() ? "" : " ") + picture;
    }
};

Result<std::vector<Detection>> look(const fs::path& path, SignDetector& detector, Tally& tally,
                                    cv::Mat& image) {
    auto read = capture::readPicture(path);
    if (!read) return read.error();
    image = *read;
    double start = cpuMilliseconds();
    auto found = detector.detect(image).detections;
    tally.milliseconds.push_back(cpuMilliseconds() - start);
    ++tally.pictures;
    return found;
}

std::vector<EvaluationJson> foundRow(const std::string& set, const Tally& t, const std::string& goal) {
    const BoxScores& s = t.signs;
    return {set,
            t.pictures,
            s.boxes,
            s.found,
            s.wrong,
            shareCell(s.found, s.boxes),
            shareCell(s.found, s.found + s.wrong),
            medianCell(t.milliseconds),
            goal,
            t.where};
}

/// Every third picture from the first on, in the order of their numbers, is what the network learnt from.
Result<EvaluationTable> exitSigns(const fs::path& data) {
    EvaluationTable table{"Exit signs of images/exit_signs_campus_tw, box IoU 0.5",
                          {"set", "pictures", "signs", "found", "wrong", "recall", "precision",
                           "cpu ms (median)", "goal", "missed or wrong"},
                          {}};
    auto folder = dataSet(data, "images/exit_signs_campus_tw");
    if (!folder) return folder.error();
    SignDetector detector;
    Tally learnt, asked;
    std::vector<fs::path> pictures = picturesOf(*folder / "images");
    Progress progress("exit signs", pictures.size());
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        progress.step();
        Tally& tally = i % 3 == 0 ? learnt : asked;
        cv::Mat image;
        auto found = look(pictures[i], detector, tally, image);
        if (!found) return found.error();
        auto boxes = yoloBoxes(*folder / "labels" / pictures[i].stem().concat(".txt"), image.size());
        if (!tally.signs.book(*found, boxes)) tally.name(pictures[i].stem().string());
    }
    table.rows.push_back(foundRow("two thirds not learnt from", asked, "recall .85 at precision .95"));
    table.rows.push_back(foundRow("the third that was learnt from", learnt, "reported"));
    return table;
}

struct Rooms {
    const char* table;  ///< under images/
    const char* column; ///< that says which rows are meant; empty: all
    const char* value;
    const char* folder; ///< of the pictures, under the table's
    const char* name;
    bool (*learnt)(const CsvTable&, std::size_t);
};

bool ofLearntHalf(const CsvTable& rows, std::size_t i) {
    return shareOf(rows.cell(i, "image"), 2) == 0;
}

bool ofLearntFloor(const CsvTable& rows, std::size_t i) {
    const std::string& floor = rows.cell(i, "floor");
    return floor != "floor10" && floor != "floor11" && floor != "floor12" && floor != "floor13";
}

bool ofFirstLap(const CsvTable& rows, std::size_t i) {
    return rows.number(i, "image") <= 40.0; // "12.jpg"
}

std::string kindOf(const Detection& detection) {
    return detection.text.empty() ? "exit" : detection.text;
}

const std::array<const char*, 5> kNames{"exit", "extinguisher", "toilet", "stairs", "lift"};

Result<void> ask(const fs::path& data, const Rooms& rooms, SignDetector& detector, EvaluationTable& table) {
    fs::path file = data / "images" / rooms.table, folder = file.parent_path() / rooms.folder;
    std::vector<std::string> wanted{"image"};
    if (*rooms.column != '\0') wanted.emplace_back(rooms.column);
    auto rows = CsvTable::read(file, wanted);
    if (!rows) return rows.error();
    Tally tallies[2];
    std::map<std::string, int> seen[2];
    Progress progress(rooms.name, rows->size());
    for (std::size_t i = 0; i < rows->size(); ++i) {
        progress.step();
        if (*rooms.column != '\0' && rows->cell(i, rooms.column) != rooms.value) continue;
        int side = rooms.learnt(*rows, i) ? 0 : 1;
        fs::path path = folder / rows->cell(i, "image");
        cv::Mat image;
        auto found = look(path, detector, tallies[side], image);
        if (!found) return found.error();
        for (const Detection& one : *found) {
            ++seen[side][kindOf(one)];
            tallies[side].name(path.stem().string() + ":" + kindOf(one));
        }
    }
    for (int side : {1, 0}) {
        const Tally& t = tallies[side];
        std::vector<EvaluationJson> row{
            std::string(rooms.name) + (side == 0 ? ", learnt from" : ", kept for asking"), t.pictures};
        for (const char* name : kNames) row.emplace_back(seen[side][name]);
        row.emplace_back(t.pictures == 0
                             ? EvaluationJson(nullptr)
                             : EvaluationJson(std::round(1000.0 * seen[side]["exit"] / t.pictures) / 10.0));
        row.push_back(medianCell(t.milliseconds));
        row.emplace_back(t.where);
        table.rows.push_back(std::move(row));
    }
    return {};
}

/// Found in rooms: all kinds, at their usual scores; the square ones are off in use.
EvaluationTable inRooms(const fs::path& data, std::vector<std::string>& notes) {
    EvaluationTable table{"Signs found in photographs of rooms (square signs are off unless asked for)",
                          {"set", "pictures", "exit", "extinguisher", "toilet", "stairs", "lift",
                           "exits in 100", "cpu ms (median)", "where"},
                          {}};
    recognition::SignDetectorOptions options;
    options.squareSigns = true;
    SignDetector detector(options);
    const Rooms all[] = {
        {"doors/index.csv", "scene", "no_door", "images", "no_door", ofLearntHalf},
        {"doors/index.csv", "scene", "indoor_home", "images", "indoor_home", ofLearntHalf},
        {"doors/index.csv", "scene", "office_like", "images", "office_like", ofLearntHalf},
        {"tower/frames.csv", "kind", "hallway", ".", "tower hallways", ofLearntFloor},
        {"corridor_walk/helper_labels.csv", "", "", ".", "corridor walk", ofFirstLap},
    };
    for (const Rooms& rooms : all) {
        auto done = ask(data, rooms, detector, table);
        if (!done) notes.push_back(done.error().text());
    }
    return table;
}

} // namespace

Result<EvaluationReport> evaluateSigns(const fs::path& data) {
    EvaluationReport report;
    auto exits = exitSigns(data);
    if (!exits) return exits.error();
    report.tables.push_back(std::move(*exits));
    report.tables.push_back(inRooms(data, report.notes));
    return report;
}

} // namespace farol::cli
