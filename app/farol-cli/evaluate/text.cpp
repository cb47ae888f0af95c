// Text on real pictures: the tower's floor plates and room numbers, and blurred street signs.

#include "core/base/text.h"

#include "app/farol-cli/evaluate/data_set.h"
#include "app/farol-cli/evaluate/evaluation.h"
#include "app/farol-cli/evaluate/rendered_signs.h"
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

/// What else stands in the labelled pictures of the tower: a display beside the lifts, posters.
const std::set<std::string> kElsewhere{"WELCOME", "TO",       "THE",   "IE",   "TOWER",
                                       "THEIE",   "ELEVATOR", "FLOOR", "DAMM", "CLASSROOM"};

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

/// A drawn sign: only what is read on the plate itself counts.
void bookSign(const TextReader& reader, const RenderedSign& sign, Tally& tally) {
    double start = cpuMilliseconds();
    auto found = reader.read(sign.picture);
    tally.milliseconds += cpuMilliseconds() - start;
    ++tally.asked;
    bool read = false, wrong = false;
    ImageBox plate = boundingBox(sign.plate);
    for (const Detection& d : found.detections) {
        ImagePoint middle = boundingBox(d.quad).centre();
        if (middle.x < plate.x || middle.x > plate.x + plate.width || middle.y < plate.y ||
            middle.y > plate.y + plate.height)
            continue;
        bool right = foldedForMatching(d.text) == foldedForMatching(sign.text);
        read = read || right;
        wrong = wrong || !right;
        if (!right) tally.wrong.insert(d.text + " for " + sign.text);
    }
    tally.read += read ? 1 : 0;
    tally.withWrong += wrong ? 1 : 0;
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
        std::set<std::string> allowed = kElsewhere;
        allowed.insert(foldedForMatching(text));
        auto booked = book(reader, tower / image, text, allowed, halves[shareOf(image, 2)]);
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

/// What a map of the whole tower would hold: its floors from -2 to 25, and rooms 01 to 20 on each.
std::vector<std::string> towerWords() {
    std::vector<std::string> words;
    for (int floor = -2; floor <= 25; ++floor) {
        std::string name = std::to_string(floor);
        words.push_back(name);
        for (int room = 1; room <= 20; ++room)
            words.push_back(name + (room < 10 ? ".0" : ".") + std::to_string(room));
    }
    return words;
}

/// Frames of the tower as backgrounds, as far as they are there; drawn walls otherwise.
std::vector<cv::Mat> backgrounds(const fs::path& tower) {
    std::vector<cv::Mat> out;
    auto frames = CsvTable::read(tower / "frames.csv", {"image", "kind"});
    for (std::size_t i = 0; frames && i < frames->size() && out.size() < 40; i += 17) {
        auto image = capture::readPicture(tower / frames->cell(i, "image"));
        if (!image) continue;
        int width = image->rows * 4 / 3;
        out.push_back((*image)(cv::Rect((image->cols - width) / 2, 0, width, image->rows)).clone());
    }
    for (std::uint64_t seed = 0; seed < 20; ++seed) out.push_back(drawnWall(seed));
    return out;
}

void renderedRows(const TextReader& reader, const fs::path& tower, EvaluationTable& table) {
    constexpr std::uint64_t kEach = 100;
    const std::pair<double, const char*> kDistances[] = {
        {1.0, ".98"}, {1.5, ".98"}, {2.0, ".95"}, {3.0, ".85"}};
    std::vector<cv::Mat> walls = backgrounds(tower);
    Progress progress("drawn signs", std::size(kDistances) * kEach);
    for (const auto& [distance, goal] : kDistances) {
        Tally tally;
        for (std::uint64_t i = 0; i < kEach; ++i) {
            auto seed = static_cast<std::uint64_t>(distance * 10.0) * 100000 + i;
            RenderedSign sign = randomSign(distance, walls[i % walls.size()], seed);
            bookSign(reader, sign, tally);
            progress.step();
        }
        table.rows.push_back(rowOf("drawn signs at " + formatNumber(distance) + " m", tally, goal));
    }
}

} // namespace

Result<EvaluationReport> evaluateText(const fs::path& data) {
    auto tower = dataSet(data, "images/tower");
    if (!tower) return tower.error();
    recognition::TextReaderOptions options;
    options.words = towerWords();
    auto reader = TextReader::create(options);
    if (!reader) return reader.error();
    auto bare = TextReader::create();
    if (!bare) return bare.error();
    EvaluationReport report;
    report.tables.push_back(tableOf("Text read in whole pictures"));
    EvaluationTable& table = report.tables.back();
    auto plates = towerRows(*reader, *tower, "floor_number_plates.csv", ".85 read, none wrong", table);
    if (!plates) return plates.error();
    auto rooms = towerRows(*reader, *tower, "room_numbers.csv", "reported", table);
    if (!rooms) return rooms.error();
    auto blurred = blurredRows(*bare, data, table);
    if (!blurred) return blurred.error();
    renderedRows(*bare, *tower, table);
    return report;
}

} // namespace farol::cli
