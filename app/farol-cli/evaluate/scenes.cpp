// How alike pictures of one scene and of different scenes are, by the measure that splits walks into scenes.

#include "app/farol-cli/evaluate/data_set.h"
#include "app/farol-cli/evaluate/evaluation.h"
#include "core/capture/picture.h"
#include "core/localisation/scene_context.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace farol::cli {

namespace {

namespace fs = std::filesystem;
using localisation::SceneOptions;

constexpr int kBins = 24; ///< of the plot, from -0.2 to 1

/// The histograms of one clip's frames, in order.
using Clip = std::vector<cv::Mat>;
using Clips = std::map<std::string, Clip>;

struct Scores {
    std::vector<double> samePrevious, otherPrevious, sameFirst, otherFirst;
};

Result<void> add(const fs::path& file, Clip& clip) {
    auto image = capture::readPicture(file);
    if (!image) return image.error();
    clip.push_back(localisation::sceneHistogram(*image, SceneOptions{}));
    return {};
}

/// The clips of the tower, in halves by the clip's name.
Result<void> towerClips(const fs::path& tower, Clips halves[2]) {
    auto rows = CsvTable::read(tower / "frames.csv", {"image", "clip"});
    if (!rows) return rows.error();
    Progress progress("tower", rows->size());
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const std::string& clip = rows->cell(i, "clip");
        auto added = add(tower / rows->cell(i, "image"), halves[shareOf(clip, 2)][clip]);
        if (!added) return added;
        progress.step();
    }
    return {};
}

/// The legs of the rectangular corridor: the first lap, then the second.
Result<void> corridorLegs(const fs::path& walk, Clips laps[2]) {
    static const std::pair<int, const char*> kEnds[] = {{6, "A1"},  {19, "B1"}, {25, "C1"},
                                                        {39, "D1"}, {46, "A2"}, {59, "B2"},
                                                        {65, "C2"}, {80, "D2"}, {84, "A3"}};
    int frame = 1;
    for (auto [last, name] : kEnds)
        for (; frame <= last; ++frame) {
            auto added = add(walk / (std::to_string(frame) + ".jpg"), laps[last <= 39 ? 0 : 1][name]);
            if (!added) return added;
        }
    return {};
}

void score(const Clips& clips, Scores& scores) {
    for (const auto& [name, clip] : clips) {
        for (std::size_t k = 1; k < clip.size(); ++k) {
            scores.samePrevious.push_back(localisation::sceneCorrelation(clip[k], clip[k - 1]));
            scores.sameFirst.push_back(localisation::sceneCorrelation(clip[k], clip[0]));
        }
        for (const auto& [otherName, other] : clips) {
            if (otherName == name) continue;
            scores.otherPrevious.push_back(localisation::sceneCorrelation(other[0], clip.back()));
            for (std::size_t k = 0; k < clip.size(); k += 5)
                scores.otherFirst.push_back(localisation::sceneCorrelation(clip[k], other[0]));
        }
    }
}

EvaluationJson shareAbove(const std::vector<double>& values, double least) {
    if (values.empty()) return nullptr;
    auto above = std::count_if(values.begin(), values.end(), [&](double v) { return v >= least; });
    return std::round(1000.0 * static_cast<double>(above) / static_cast<double>(values.size())) / 1000.0;
}

/// How often a pair of one scene is more alike than a pair of two.
EvaluationJson order(const std::vector<double>& same, std::vector<double> other) {
    if (same.empty() || other.empty()) return nullptr;
    std::sort(other.begin(), other.end());
    double below = 0.0;
    for (double v : same)
        below += static_cast<double>(std::lower_bound(other.begin(), other.end(), v) - other.begin());
    return std::round(1000.0 * below / static_cast<double>(same.size()) / static_cast<double>(other.size())) /
           1000.0;
}

void addRows(const std::string& set, const Scores& s, EvaluationTable& table) {
    const SceneOptions options;
    auto row = [&](const char* against, const std::vector<double>& same, const std::vector<double>& other,
                   double least) {
        table.rows.push_back({set, against, same.size(), shareAbove(same, least), other.size(),
                              shareAbove(other, least), order(same, other), least});
    };
    row("previous frame", s.samePrevious, s.otherPrevious, options.minCorrelationToPrevious);
    row("first frame", s.sameFirst, s.otherFirst, options.minCorrelationToFirst);
}

EvaluationTable plotTable(const Scores& s) {
    EvaluationTable table{
        "Shares of the pairs by correlation, all sets",
        {"from", "one scene, previous", "two scenes, previous", "one scene, first", "two scenes, first"},
        {}};
    for (int bin = 0; bin < kBins; ++bin) {
        double from = std::round((-0.2 + 1.2 * bin / kBins) * 1000.0) / 1000.0, to = from + 1.2 / kBins;
        auto share = [&](const std::vector<double>& values) -> EvaluationJson {
            auto in = std::count_if(values.begin(), values.end(), [&](double v) {
                return (v >= from || bin == 0) && (v < to || bin == kBins - 1);
            });
            return std::round(10000.0 * static_cast<double>(in) /
                              std::max(1.0, static_cast<double>(values.size()))) /
                   10000.0;
        };
        table.rows.push_back(
            {from, share(s.samePrevious), share(s.otherPrevious), share(s.sameFirst), share(s.otherFirst)});
    }
    return table;
}

} // namespace

Result<EvaluationReport> evaluateScenes(const fs::path& data) {
    auto tower = dataSet(data, "images/tower");
    if (!tower) return tower.error();
    auto walk = dataSet(data, "images/corridor_walk");
    if (!walk) return walk.error();
    Clips clips[2], legs[2];
    auto read = towerClips(*tower, clips);
    if (read) read = corridorLegs(*walk, legs);
    if (!read) return read.error();
    EvaluationReport report;
    report.tables.push_back({"Scenes by histogram correlation",
                             {"set", "against", "pairs of one scene", "kept together", "pairs of two scenes",
                              "taken for one", "rightly ordered", "least correlation"},
                             {}});
    const std::pair<const char*, const Clips*> sets[] = {{"tower, development half", &clips[0]},
                                                         {"tower, other half", &clips[1]},
                                                         {"corridor walk, first lap", &legs[0]},
                                                         {"corridor walk, second lap", &legs[1]}};
    Scores all;
    for (auto [name, set] : sets) {
        Scores scores;
        score(*set, scores);
        score(*set, all);
        addRows(name, scores, report.tables[0]);
    }
    report.tables.push_back(plotTable(all));
    report.notes.push_back(
        "Frames of one clip a second apart count as one scene, clips and legs as different ones; many "
        "of them look alike.");
    return report;
}

} // namespace farol::cli
