#include "app/farol-cli/evaluate/guidance.h"

#include "app/farol-cli/evaluate/data_set.h"
#include "core/building/checks.h"
#include "core/building/geopackage.h"
#include "core/localisation/random.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace farol::cli {

namespace {

using session::WalkEnd;

constexpr int kWalks = 1000;
constexpr std::uint64_t kSeed = 2026;

double rounded(double value) {
    return std::round(value * 1000.0) / 1000.0;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

/// Where one may be and want to go: of the largest part that holds together.
std::vector<RegionId> places(const building::Building& building) {
    std::vector<RegionId> result;
    auto parts = building::components(building);
    if (parts.empty()) return result;
    for (std::size_t region : parts.front()) {
        const building::Region& each = building.regions()[region];
        bool passed =
            each.kind == building::RegionKind::Stairwell || each.kind == building::RegionKind::Elevator;
        if (!passed && each.polygon.outer.size() > 2) result.push_back(each.id);
    }
    return result;
}

} // namespace

std::vector<std::pair<std::string, double>> PairsFigures::figures() const {
    double arrived = 0, elsewhere = 0, wrong = 0, cues = 0, simulated = 0;
    std::vector<double> overM, overS, lost;
    for (const WalkedPair& walk : walks) {
        const session::ClosedLoopResult& result = walk.result;
        wrong += result.wrongRegionSaid;
        cues += result.cues;
        simulated += result.seconds;
        elsewhere += result.end == WalkEnd::ArrivedElsewhere ? 1.0 : 0.0;
        if (result.end != WalkEnd::Arrived) continue;
        arrived += 1.0;
        overM.push_back(result.metres / std::max(1.0, result.shortestM));
        overS.push_back(result.seconds / std::max(1.0, result.shortestS));
        lost.push_back(result.seconds - result.shortestS);
    }
    double n = std::max<double>(1.0, static_cast<double>(walks.size()));
    return {{"walks", static_cast<double>(walks.size())},
            {"arrived, share", rounded(arrived / n)},
            {"told of arrival elsewhere", elsewhere},
            {"wrong places told, a walk", rounded(wrong / n)},
            {"cues a walk", rounded(cues / n)},
            {"metres against the shortest, median", rounded(median(overM))},
            {"seconds against the route's, median", rounded(median(overS))},
            {"seconds lost, median of those that arrived", rounded(median(lost))},
            {"times real time", rounded(simulated / std::max(1e-3, computedSeconds))}};
}

std::vector<std::pair<std::string, int>> PairsFigures::failures() const {
    std::map<std::string, int> counts;
    for (const WalkedPair& walk : walks)
        if (walk.result.end != WalkEnd::Arrived) ++counts[session::walkEndName(walk.result.end)];
    std::vector<std::pair<std::string, int>> sorted(counts.begin(), counts.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    return sorted;
}

Result<PairsFigures> walkPairs(const std::shared_ptr<const simulation::WalkWorld>& world,
                               const PairsOptions& options) {
    std::vector<RegionId> all = places(world->building());
    if (all.size() < 2)
        return Error{ErrorCode::InvalidArgument,
                     "the map has no two places that are joined: nobody can walk in it", ""};
    localisation::Random random(options.seed);
    auto draw = [&] {
        return all[static_cast<std::size_t>(random.uniformDouble() * static_cast<double>(all.size()))];
    };
    PairsFigures figures;
    Progress progress("walks", static_cast<std::size_t>(std::max(0, options.walks)));
    auto begin = std::chrono::steady_clock::now();
    int refused = 0;
    while (static_cast<int>(figures.walks.size()) < options.walks) {
        RegionId from = draw(), to = draw();
        if (from == to) continue;
        WalkedPair walk{from.value, to.value, options.seed * 100000ULL + figures.walks.size(), {}};
        session::ClosedLoopOptions loop = options.loop;
        simulation::TruthDetectionOptions detections = options.detections;
        loop.walker.seed = detections.seed = walk.seed;
        session::ClosedLoop::Eye eye;
        if (options.eye) {
            auto made = options.eye(walk.seed);
            if (!made) return made.error();
            eye = std::move(made).value();
        } else {
            eye = session::truthEye(world, detections);
        }
        auto made = session::ClosedLoop::create(world, {from, {}}, {to, {}}, loop, std::move(eye));
        // One way doors: a pair without a way is no pair.
        if (!made && made.error().code == ErrorCode::NotFound && ++refused < 10 * options.walks) continue;
        if (!made) return made.error();
        if (options.ear) (*made)->setEar(options.ear);
        auto result = (*made)->run();
        if (!result) return result.error();
        walk.result = std::move(result).value();
        figures.walks.push_back(std::move(walk));
        progress.step();
    }
    figures.computedSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return figures;
}

EvaluationTable pairsTable(const std::string& title,
                           const std::vector<std::pair<std::string, PairsFigures>>& runs) {
    EvaluationTable table{title, {"figure"}, {}};
    for (const auto& [name, figures] : runs) {
        table.columns.push_back(name);
        std::size_t row = 0;
        for (const auto& [label, value] : figures.figures()) {
            if (table.rows.size() <= row) table.rows.push_back({label});
            table.rows[row++].emplace_back(value);
        }
    }
    return table;
}

Result<EvaluationReport> evaluateGuidance(const std::filesystem::path& data) {
    // The demo building is ours and always there; a map given as data is walked in instead.
    bool given = data.extension() == ".gpkg";
    auto loaded = building::loadBuilding(given ? data.string() : FAROL_DEMO_FOLDER "/demo.gpkg");
    if (!loaded) return loaded.error();
    auto world = std::make_shared<const simulation::WalkWorld>(loaded->building);
    EvaluationReport report;
    std::vector<std::pair<std::string, PairsFigures>> runs;
    EvaluationTable failures{"how the others ended", {"walks", "end", "how many"}, {}};
    struct Way {
        const char* name;
        bool known;
        double wilfulness;
    };
    for (const Way& way :
         {Way{"known start", true, 0.0}, Way{"unknown start", false, 0.0}, Way{"wilful", true, 0.05}}) {
        PairsOptions options;
        options.walks = kWalks;
        options.seed = kSeed;
        options.loop.knownStart = way.known;
        options.loop.walker.wilfulness = way.wilfulness;
        auto figures = walkPairs(world, options);
        if (!figures) return figures.error();
        for (const auto& [end, count] : figures->failures()) failures.rows.push_back({way.name, end, count});
        runs.emplace_back(way.name, std::move(figures).value());
    }
    report.tables.push_back(
        pairsTable("closed loop without pictures, " + std::to_string(kWalks) + " pairs", runs));
    report.tables.push_back(std::move(failures));
    report.notes = {
        "The walker hears cues only; detections are drawn from the truth with misses, false ones, confused "
        "kinds and misread numbers."};
    return report;
}

} // namespace farol::cli
