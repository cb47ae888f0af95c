// Text on real pictures: the tower's floor plates and room numbers, and blurred street signs.

#include "core/base/text.h"

#include "app/farol-cli/evaluate/data_set.h"
#include "app/farol-cli/evaluate/evaluation.h"
#include "core/base/file.h"
#include "core/capture/picture.h"
#include "core/recognition/text_reader.h"

#include <cmath>
#include <set>
#include <sstream>

namespace farol::cli {

namespace {

namespace fs = std::filesystem;
using recognition::Detection;
using recognition::TextReader;

struct Tally {
    int asked = 0, read = 0, withWrong = 0;
    double milliseconds = 0.0;
    std::set<std::string> wrong;
};

std::vector<EvaluationJson> rowOf(const std::string& name, const Tally& tally, const std::string& goal) {
    std::string wrong;
    for (const std::string& text : tally.wrong) wrong += (wrong.empty() ? "" : " | ") + text;
    EvaluationJson share = nullptr, each = nullptr;
    if (tally.asked > 0) {
        share = std::round(1000.0 * tally.read / tally.asked) / 1000.0;
        each = std::round(10.0 * tally.milliseconds / tally.asked) / 10.0;
    }
    return {name, tally.asked, tally.read, share, tally.withWrong, wrong, each, goal};
}

EvaluationTable tableOf(const std::string& title) {
    return {title,
            {"set", "pictures", "read", "share", "pictures with a wrong word", "wrong", "cpu ms a picture",
             "goal"},
            {}};
}

/// Every word of the reading is one of the truths, or all of it is.
bool isAllowed(const std::set<std::string>& truths, const std::string& text) {
    std::string folded = foldedForMatching(text);
    if (truths.count(folded) > 0) return true;
    std::istringstream words(folded);
    for (std::string word; words >> word;)
        if (truths.count(word) == 0) return false;
    return !folded.empty();
}

/// Reads one picture and books what was found against what may be read there.
Result<void> book(const TextReader& reader, const fs::path& path, const std::string& wanted,
                  const std::set<std::string>& allowed, Tally& tally) {
    auto image = capture::readPicture(path);
    if (!image) return image.error();
    double start = cpuMilliseconds();
    auto found = reader.read(*image);
    tally.milliseconds += cpuMilliseconds() - start;
    ++tally.asked;
    bool read = false, wrong = false;
    for (const Detection& d : found.detections) {
        read = read || (!wanted.empty() && foldedForMatching(d.text) == foldedForMatching(wanted));
        if (isAllowed(allowed, d.text)) continue;
        wrong = true;
        tally.wrong.insert(d.text);
    }
    tally.read += read ? 1 : 0;
    tally.withWrong += wrong ? 1 : 0;
    return {};
}

/// The labelled pictures of a table of the tower, whole frames, in two halves by file name.
Result<void> towerRows(const TextReader& reader, const fs::path& tower, const char* file, const char* goal,
                       EvaluationTable& table) {
    auto rows = CsvTable::read(tower / file, {"image", "text"});
    if (!rows) return rows.error();
    Tally halves[2];
    Progress progress(file, rows->size());
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const std::string& image = rows->cell(i, "image");
        const std::string& text = rows->cell(i, "text");
        auto booked = book(reader, tower / image, text, {foldedForMatching(text)}, halves[shareOf(image, 2)]);
        if (!booked) return booked;
        progress.step();
    }
    table.rows.push_back(rowOf(std::string(file) + ", development half", halves[0], goal));
    table.rows.push_back(rowOf(std::string(file) + ", other half", halves[1], goal));
    return {};
}

/// Words that the publishers of the pictures could read in one, folded; "###" stands for what they could not.
std::set<std::string> icdarWords(const fs::path& picture) {
    std::set<std::string> words;
    auto truth = readFile(picture.parent_path() / ("gt_" + picture.stem().string() + ".txt"));
    if (!truth) return words;
    std::istringstream lines(*truth);
    for (std::string line; std::getline(lines, line);) {
        std::size_t at = 0;
        for (int comma = 0; comma < 8 && at != std::string::npos; ++comma)
            at = line.find(',', at + (comma > 0 ? 1 : 0));
        if (at != std::string::npos) words.insert(foldedForMatching(line.substr(at + 1)));
    }
    words.erase("###");
    return words;
}

Result<void> blurredRows(const TextReader& reader, const fs::path& data, EvaluationTable& table) {
    auto folder = dataSet(data, "images/scene_text/icdar2015_motion_blurred");
    if (!folder) return folder.error();
    Tally tally;
    auto pictures = picturesOf(*folder);
    Progress progress("blurred", pictures.size());
    for (const fs::path& picture : pictures) {
        auto booked = book(reader, picture, "", icdarWords(picture), tally);
        if (!booked) return booked;
        progress.step();
    }
    table.rows.push_back(rowOf("blurred signs", tally, "at most 2 with a wrong word"));
    return {};
}

} // namespace

Result<EvaluationReport> evaluateText(const fs::path& data) {
    auto tower = dataSet(data, "images/tower");
    if (!tower) return tower.error();
    auto reader = TextReader::create();
    if (!reader) return reader.error();
    EvaluationReport report;
    report.tables.push_back(tableOf("Text read in whole pictures"));
    EvaluationTable& table = report.tables.back();
    auto plates = towerRows(*reader, *tower, "floor_number_plates.csv", ".85 read, none wrong", table);
    if (!plates) return plates.error();
    auto rooms = towerRows(*reader, *tower, "room_numbers.csv", "reported", table);
    if (!rooms) return rooms.error();
    auto blurred = blurredRows(*reader, data, table);
    if (!blurred) return blurred.error();
    return report;
}

} // namespace farol::cli
