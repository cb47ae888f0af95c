#pragma once
// Work shared out in pieces whose results do not depend on who does them.

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace farol::simulation {

/// Calls work(i) for each i below `count`, each once. `threads`: 0 for one each core.
template <class Work>
void inParallel(int count, int threads, const Work& work) {
    if (threads <= 0) threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    threads = std::min(threads, count);
    std::atomic<int> next{0};
    auto run = [&] {
        for (int i = next.fetch_add(1); i < count; i = next.fetch_add(1)) work(i);
    };
    std::vector<std::jthread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(run);
    run();
}

} // namespace farol::simulation
