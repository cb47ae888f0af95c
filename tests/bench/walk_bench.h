#pragma once
// `farol-bench --walk`: what a real walk costs, hop by hop, and whether the words would come in time.

#include <string>

namespace farol::bench {

struct WalkBenchOptions {
    std::string map, library, frames;
    double framesPerSecond = 15.0;
    std::string localiser; ///< empty: the default
    std::string record;    ///< folder for a recording of the paced walk; empty: none
    int laps = 0;          ///< over the pictures; 0: until there are about 300 frames
};

/// Prints Markdown tables on stdout; answers the exit code.
int benchWalk(const WalkBenchOptions& options);

} // namespace farol::bench
