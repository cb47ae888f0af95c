// farol-bench-routing FOLDER [--sizes 100,1000] [--pairs N]: routes on synthetic campuses. routing_peers.sh
// runs it with other planners side by side.

#include "tests/bench/bench_routing.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

int usage() {
    std::fprintf(stderr, "usage: farol-bench-routing FOLDER [--sizes 100,1000] [--pairs N]\n"
                         "       farol-bench-routing --import MAP PROFILE\n");
    return 2;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 4 && std::strcmp(argv[1], "--import") == 0)
        return farol::bench::benchRoutingImport(argv[2], argv[3]);
    if (argc < 2 || argv[1][0] == '-') return usage();
    farol::bench::RoutingBenchOptions options;
    options.folder = argv[1];
    for (int i = 2; i < argc; i += 2) {
        if (i + 1 >= argc) return usage();
        bool sizes = std::strcmp(argv[i], "--sizes") == 0;
        if (!sizes && std::strcmp(argv[i], "--pairs") != 0) return usage();
        if (sizes) options.sizes.clear();
        for (const char* at = argv[i + 1]; *at != '\0';) {
            char* end = nullptr;
            auto value = static_cast<std::size_t>(std::strtoul(at, &end, 10));
            if (end == at || value == 0) return usage();
            if (sizes)
                options.sizes.push_back(value);
            else
                options.pairs = value;
            at = *end == ',' ? end + 1 : end;
        }
    }
    return farol::bench::benchRouting(options);
}
