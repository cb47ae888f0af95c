// farol-bench: Google Benchmark over core, or `--walk MAP LIBRARY FRAMES` over a real walk.

#include "tests/bench/film.h"
#include "tests/bench/library_bench.h"
#include "tests/bench/planner_table.h"
#include "tests/bench/walk_bench.h"

#include <benchmark/benchmark.h>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace {

int usage() {
    std::fprintf(stderr,
                 "usage: farol-bench --walk MAP LIBRARY FRAMES [--fps F] [--laps N] [--localiser NAME] "
                 "[--record DIR]\n"
                 "       farol-bench --film FRAMES OUT.avi [--seconds S] [--count N]\n"
                 "       farol-bench --planners REGIONS...\n"
                 "       farol-bench --libraries TEMPLATES...\n"
                 "       farol-bench [options of Google Benchmark, such as --benchmark_filter=Navigator]\n");
    return 2;
}

int walk(int argc, char** argv) {
    if (argc < 5) return usage();
    farol::bench::WalkBenchOptions options;
    options.map = argv[2];
    options.library = argv[3];
    options.frames = argv[4];
    for (int i = 5; i < argc; i += 2) {
        if (i + 1 >= argc) return usage();
        if (std::strcmp(argv[i], "--localiser") == 0) {
            options.localiser = argv[i + 1];
            continue;
        }
        if (std::strcmp(argv[i], "--record") == 0) {
            options.record = argv[i + 1];
            continue;
        }
        double value = std::atof(argv[i + 1]);
        if (!(value > 0.0 && value <= 1e6)) return usage();
        if (std::strcmp(argv[i], "--fps") == 0)
            options.framesPerSecond = value;
        else if (std::strcmp(argv[i], "--laps") == 0)
            options.laps = static_cast<int>(value);
        else
            return usage();
    }
    return farol::bench::benchWalk(options);
}

int film(int argc, char** argv) {
    if (argc < 4) return usage();
    farol::bench::FilmOptions options;
    options.frames = argv[2];
    options.file = argv[3];
    for (int i = 4; i < argc; i += 2) {
        if (i + 1 >= argc) return usage();
        double value = std::atof(argv[i + 1]);
        if (!(value > 0.0 && value <= 1e5)) return usage();
        if (std::strcmp(argv[i], "--seconds") == 0)
            options.secondsEach = value;
        else if (std::strcmp(argv[i], "--count") == 0)
            options.count = static_cast<int>(value);
        else
            return usage();
    }
    return farol::bench::makeFilm(options);
}

int planners(int argc, char** argv) {
    std::vector<std::size_t> regions;
    for (int i = 2; i < argc; ++i) {
        long long value = std::atoll(argv[i]);
        if (value < 100 || value > 1000000) return usage();
        regions.push_back(static_cast<std::size_t>(value));
    }
    return regions.empty() ? usage() : farol::bench::benchPlanners(regions);
}

int libraries(int argc, char** argv) {
    std::vector<int> templates;
    for (int i = 2; i < argc; ++i) {
        int value = std::atoi(argv[i]);
        if (value < 1 || value > 100000) return usage();
        templates.push_back(value);
    }
    return templates.empty() ? usage() : farol::bench::benchLibraries(templates);
}

} // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::strcmp(argv[1], "--walk") == 0) return walk(argc, argv);
    if (argc > 1 && std::strcmp(argv[1], "--film") == 0) return film(argc, argv);
    if (argc > 1 && std::strcmp(argv[1], "--planners") == 0) return planners(argc, argv);
    if (argc > 1 && std::strcmp(argv[1], "--libraries") == 0) return libraries(argc, argv);
    if (argc > 1 && std::strcmp(argv[1], "--help") == 0) usage();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
