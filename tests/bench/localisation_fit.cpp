#include "tests/bench/localisation_fit.h"

#include "core/localisation/bayes_localiser.h"
#include "tests/support/campus.h"
#include "tests/support/walk_random.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <unistd.h>

namespace farol::bench {

using cli::Stated;
using localisation::ConfidencePoint;

std::vector<ConfidencePoint> risingTable(std::vector<Stated> stated) {
    constexpr std::size_t kBins = 40;
    std::sort(stated.begin(), stated.end(),
              [](const Stated& a, const Stated& b) { return a.confidence < b.confidence; });
    struct Block {
        double share, right, count;
    };
    std::vector<Block> blocks;
    std::size_t each = std::max<std::size_t>(1, stated.size() / kBins);
    for (std::size_t i = 0; i < stated.size(); i += each) {
        Block block{0.0, 0.0, 0.0};
        for (std::size_t j = i; j < std::min(i + each, stated.size()); ++j) {
            block.share += stated[j].confidence;
            block.right += stated[j].right ? 1.0 : 0.0;
            block.count += 1.0;
        }
        blocks.push_back(block);
        while (blocks.size() > 1) {
            Block &a = blocks[blocks.size() - 2], &b = blocks.back();
            if (a.right / a.count < b.right / b.count) break;
            a = {a.share + b.share, a.right + b.right, a.count + b.count};
            blocks.pop_back();
        }
    }
    std::vector<ConfidencePoint> table;
    constexpr double kMost = 0.995; // nobody is surer than that
    for (const Block& block : blocks)
        table.push_back({block.share / block.count, std::min(kMost, block.right / block.count)});
    if (table.empty()) return {{0.0, 0.0}, {1.0, 1.0}};
    if (table.front().share > 0.02) table.insert(table.begin(), {0.0, 0.5 * table.front().probability});
    if (table.back().share < 0.9999) table.push_back({1.0, table.back().probability});
    return table;
}

void writeTable(std::ostream& out, const std::string& name, const std::vector<ConfidencePoint>& table) {
    out << "constexpr ConfidencePoint " << name << "[] = {";
    for (std::size_t i = 0; i < table.size(); ++i) {
        char text[64];
        std::snprintf(text, sizeof text, "%s{%.4f, %.4f}", i % 4 == 0 ? "\n    " : " ", table[i].share,
                      table[i].probability);
        out << text << (i + 1 < table.size() ? "," : "");
    }
    out << "};\n";
}

namespace {

double residentMb() {
    std::ifstream file("/proc/self/statm");
    double pages = 0.0, resident = 0.0;
    file >> pages >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

/// Processor time of this thread: other people's work on the machine does not count.
double cpuMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1000.0 + static_cast<double>(now.tv_nsec) / 1e6;
}

/// Detections of random landmarks every third second, motion every second: a restless, often lost user, so
/// that nothing cheap is measured only.
std::vector<double> updateTimes(const building::Building& building, localisation::Localiser& localiser,
                                bool known) {
    test::WalkRandom random(7);
    const auto& landmarks = building.landmarks();
    localiser.start(0.0, known ? std::optional(building.regions()[building.regions().size() / 2].id)
                               : std::nullopt);
    std::vector<double> times;
    constexpr int kSeconds = 400;
    for (int t = 1; t <= kSeconds; ++t) {
        std::vector<localisation::Observation> fresh;
        if (t % 3 == 0 && !landmarks.empty()) {
            const auto& landmark = landmarks[random.below(landmarks.size())];
            localisation::Observation seen;
            seen.detection.kind = landmark.kind;
            seen.detection.text = landmark.text;
            seen.detection.image = {640, 480};
            seen.detection.rangeM = random.between(0.8, 3.5);
            seen.detection.bearing = fromDegrees(random.between(-30.0, 30.0));
            seen.time = t;
            fresh.push_back(seen);
        }
        recognition::Motion motion;
        motion.turn = fromDegrees(random.between(-30.0, 30.0));
        motion.speed = random.between(0.0, 1.0);
        localiser.moved(t, motion);
        double begun = cpuMs();
        localiser.update(t, fresh, {});
        times.push_back(cpuMs() - begun);
    }
    std::sort(times.begin(), times.end());
    return times;
}

} // namespace

int timeLocaliser() {
    std::printf(
        "regions  landmarks  start    build s  memory MB  goal ms  update ms: median      p99      max\n");
    for (std::size_t wanted : {100U, 1000U, 10000U, 100000U}) {
        test::CampusOptions options;
        options.regions = wanted;
        auto building = test::makeCampus(options);
        for (bool known : {true, false}) {
            double before = residentMb();
            double begun = cpuMs();
            auto localiser = localisation::makeBayesLocaliser(building);
            double built = (cpuMs() - begun) / 1000.0;
            localisation::RouteContext route;
            route.destination = building::Location{building->regions().back().id, std::nullopt};
            begun = cpuMs();
            localiser->setRoute(route);
            double goal = cpuMs() - begun;
            auto times = updateTimes(*building, *localiser, known);
            std::printf("%7zu  %9zu  %-7s  %7.2f  %9.1f  %7.1f  %17.3f  %7.3f  %7.3f\n",
                        building->regions().size(), building->landmarks().size(), known ? "known" : "unknown",
                        built, residentMb() - before, goal, times[times.size() / 2],
                        times[times.size() * 99 / 100], times.back());
            std::fflush(stdout);
        }
    }
    return 0;
}

} // namespace farol::bench
