#include "tests/bench/planner_table.h"

#include "core/routing/route.h"
#include "tests/support/campus.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace farol::bench {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kPairs = 1000;
constexpr std::size_t kGreedyPairs = 300; // its planner takes its time

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double at(std::vector<double>& values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1,
                           static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

void printRow(std::size_t wanted) {
    test::CampusOptions options;
    options.regions = wanted;
    auto building = test::makeCampus(options);
    auto pairs = test::campusPairs(*building, kPairs);
    auto start = Clock::now();
    auto optimal = routing::makeOptimalPlanner(building);
    double graphSeconds = since(start);
    std::vector<double> milliseconds;
    for (int round = 0; round < 2; ++round) { // the first one warms what is made when first needed
        milliseconds.clear();
        for (const auto& [from, to] : pairs) {
            start = Clock::now();
            auto route = optimal->plan(from, to);
            milliseconds.push_back(1000.0 * since(start));
        }
    }
    auto greedy = routing::makeGreedyPlanner(building);
    std::vector<double> longer, slower;
    for (std::size_t i = 0; i < kGreedyPairs; ++i) {
        auto best = optimal->plan(pairs[i].first, pairs[i].second);
        auto printed = greedy->plan(pairs[i].first, pairs[i].second);
        if (!best || !printed || best->lengthM < 1.0) continue;
        longer.push_back(100.0 * (printed->lengthM / best->lengthM - 1.0));
        slower.push_back(100.0 * (printed->seconds / best->seconds - 1.0));
    }
    std::size_t found = longer.size();
    std::printf("| %zu | %.2f | %.3f | %.3f | %zu of %zu | %.1f / %.1f / %.0f | %.1f / %.1f / %.0f |\n",
                building->regions().size(), graphSeconds, at(milliseconds, 0.5), at(milliseconds, 0.95),
                found, kGreedyPairs, at(longer, 0.5), at(longer, 0.95), at(longer, 1.0), at(slower, 0.5),
                at(slower, 0.95), at(slower, 1.0));
    std::fflush(stdout);
}

} // namespace

int benchPlanners(const std::vector<std::size_t>& regions) {
    std::printf("| regions | graph s | query ms, median | 95 %% | greedy finds a way | longer by %%, median "
                "/ 95 %% / "
                "most | slower by %% |\n|---:|---:|---:|---:|---:|---:|---:|\n");
    for (std::size_t each : regions) printRow(each);
    return 0;
}

} // namespace farol::bench
