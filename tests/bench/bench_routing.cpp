#include "tests/bench/bench_routing.h"

#include "core/building/geopackage.h"
#include "core/building/import/importer.h"
#include "core/routing/route.h"
#include "tests/bench/boost_planner.h"
#include "tests/bench/door_graph.h"
#include "tests/support/campus.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sys/resource.h>

namespace farol::bench {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double percentile95(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[(values.size() * 95 + 99) / 100 - 1];
}

/// Of this thread alone, whatever else the machine does.
double processorSeconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Answers {
    std::vector<double> ms, wallMs, seconds; ///< what each query took, and what each route takes
};

/// After `warmUp` queries, which make what is made when first needed.
template <class Plan>
Answers askAll(std::size_t pairs, std::size_t warmUp, Plan plan) {
    Answers answers;
    for (std::size_t i = 0; i < warmUp; ++i) (void)plan(i);
    for (std::size_t i = 0; i < pairs; ++i) {
        auto start = Clock::now();
        double processor = processorSeconds();
        double seconds = plan(i);
        answers.ms.push_back(1000.0 * (processorSeconds() - processor));
        answers.wallMs.push_back(1000.0 * secondsSince(start));
        answers.seconds.push_back(seconds);
    }
    return answers;
}

/// Metres walked in the time by which two planners differ at most.
double largestDifference(const Answers& a, const Answers& b, double speed) {
    double largest = 0.0;
    for (std::size_t i = 0; i < b.seconds.size(); ++i) {
        double apart = std::abs(a.seconds[i] - b.seconds[i]) * speed;
        largest = std::max(largest, std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart);
    }
    return largest;
}

bool writeGraph(const std::string& stem, const DoorGraph& graph, const Answers& own) {
    std::ofstream nodes(stem + ".nodes.csv"), edges(stem + ".edges.csv"), pairs(stem + ".pairs.csv");
    for (std::ofstream* file : {&nodes, &edges, &pairs}) file->precision(12);
    Point2 corner = graph.nodes().front();
    for (std::size_t i = 0; i < graph.nodes().size(); ++i)
        nodes << i << ',' << graph.nodes()[i].x - corner.x << ',' << graph.nodes()[i].y - corner.y << '\n';
    for (std::size_t i = 0; i < graph.edges().size(); ++i) {
        const DoorGraph::Edge& edge = graph.edges()[i];
        edges << i << ',' << edge.from << ',' << edge.to << ',' << edge.seconds << '\n';
    }
    for (std::size_t i = 0; i < own.seconds.size(); ++i)
        pairs << i << ',' << graph.start(i) << ',' << graph.goal(i) << ',' << own.seconds[i] << ','
              << own.ms[i] << '\n';
    for (std::ofstream* file : {&nodes, &edges, &pairs}) file->close();
    return nodes.good() && edges.good() && pairs.good();
}

std::string importedLine(const std::string& map, const std::string& profile) {
    std::string command = "'" + std::filesystem::read_symlink("/proc/self/exe").string() + "' --import '" +
                          map + "' '" + profile + "'";
    FILE* pipe = ::popen(command.c_str(), "r");
    if (pipe == nullptr) return "cannot be started";
    char line[200] = {};
    const char* said = std::fgets(line, sizeof line, pipe);
    std::string text = said == nullptr ? "failed" : said;
    ::pclose(pipe);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

struct Sizes {
    std::size_t regions, nodes, edges;
    Answers farol, boost;
    std::string imported;
};

int fail(const std::string& why) {
    std::fprintf(stderr, "farol-bench: %s\n", why.c_str());
    return 1;
}

Result<Sizes> measure(const RoutingBenchOptions& options, std::size_t size) {
    std::string stem = options.folder + "/campus-" + std::to_string(size);
    test::CampusOptions wanted{size};
    wanted.crs = "EPSG:32629";
    wanted.origin = {595000.0, 4099000.0};
    auto campus = test::makeCampus(wanted);
    std::filesystem::remove(stem + ".gpkg");
    if (auto saved = building::saveBuilding(*campus, stem + ".gpkg"); !saved) return saved.error();
    std::ofstream(options.folder + "/profile.json")
        << "{}\n"; // no building file as it stands: every step of an import
    Sizes sizes{};
    sizes.imported = importedLine(stem + ".gpkg", options.folder + "/profile.json");
    auto pairs = test::campusPairs(*campus, options.pairs);
    routing::RouteOptions profile;
    auto planner = routing::makeOptimalPlanner(campus, profile);
    sizes.farol = askAll(pairs.size(), pairs.size(), [&](std::size_t i) {
        auto route = planner->plan(pairs[i].first, pairs[i].second);
        return route ? route->seconds : std::numeric_limits<double>::infinity();
    });
    planner.reset();
    routing::RouteGraph rules(campus, profile);
    DoorGraph graph(rules, pairs);
    BoostPlanner boost(graph, profile.walkingSpeed);
    // Its queries take long on large graphs: fewer there.
    std::size_t asked = size > 50000 ? std::min<std::size_t>(pairs.size(), 50) : pairs.size();
    sizes.boost =
        askAll(asked, 3, [&](std::size_t i) { return boost.seconds(graph.start(i), graph.goal(i)); });
    sizes.regions = campus->regions().size();
    sizes.nodes = graph.nodes().size();
    sizes.edges = graph.edges().size();
    if (!writeGraph(stem, graph, sizes.farol)) return Error{ErrorCode::Io, "cannot write the graph", stem};
    std::ofstream results(stem + ".boost.csv");
    results.precision(12);
    for (std::size_t i = 0; i < sizes.boost.ms.size(); ++i)
        results << i << ',' << sizes.boost.seconds[i] << ',' << sizes.boost.ms[i] << '\n';
    return sizes;
}

} // namespace

int benchRouting(const RoutingBenchOptions& options) {
    std::error_code failure;
    std::filesystem::create_directories(options.folder, failure);
    if (failure) return fail(options.folder + ": " + failure.message());
    double speed = routing::RouteOptions().walkingSpeed;
    bool same = true;
    std::printf("| regions | nodes, edges | Farol: median, 95th percentile ms | on the clock: median ms | "
                "Boost A*: median, 95th percentile ms | largest difference mm | import and graph "
                "|\n|---:|---:|---:|---:|---:|---:|---|\n");
    for (std::size_t size : options.sizes) {
        auto measured = measure(options, size);
        if (!measured) return fail(measured.error().text());
        double apart = 1000.0 * largestDifference(measured->farol, measured->boost, speed);
        same = same && apart <= 1.0;
        std::printf("| %zu | %zu, %zu | %.4f, %.4f | %.4f | %.4f, %.4f | %.3f | %s |\n", measured->regions,
                    measured->nodes, measured->edges, median(measured->farol.ms),
                    percentile95(measured->farol.ms), median(measured->farol.wallMs),
                    median(measured->boost.ms), percentile95(measured->boost.ms), apart,
                    measured->imported.c_str());
        std::fflush(stdout);
    }
    return same ? 0 : fail("the planners differ by more than 1 mm");
}

int benchRoutingImport(const std::string& map, const std::string& profile) {
    building::ImportOptions options;
    options.profile = profile;
    auto start = Clock::now();
    std::clock_t processor = std::clock();
    auto imported = building::importBuilding(map, options);
    if (!imported) return fail(imported.error().text());
    double importSeconds = secondsSince(start);
    auto planner = routing::makeOptimalPlanner(imported->building);
    double both = secondsSince(start), busy = static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    std::printf("%.2f s (import %.2f, graph %.2f; processor %.2f), %.0f MB\n", both, importSeconds,
                both - importSeconds, busy, static_cast<double>(usage.ru_maxrss) / 1024.0);
    return 0;
}

} // namespace farol::bench
