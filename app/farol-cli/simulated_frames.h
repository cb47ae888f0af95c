#pragma once
// What `simulate --out` writes: frames/NNNNNN.jpg and truth.jsonl, one object a frame.

#include "core/base/error.h"
#include "core/simulation/simulated_camera.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>

namespace farol::cli {

class SimulatedFrames {
public:
    /// The folder must be new or empty.
    static Result<std::shared_ptr<SimulatedFrames>> create(const std::filesystem::path& folder);
    Result<void> write(std::uint64_t index, const simulation::RenderedFrame& picture);

private:
    explicit SimulatedFrames(std::filesystem::path folder);

    std::filesystem::path m_folder;
    std::ofstream m_truth;
};

} // namespace farol::cli
