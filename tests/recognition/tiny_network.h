#pragma once
// Writes the smallest networks a detector can be: one convolution over the whole input whose answers are the
// rows of a detector's table. Enough protocol buffer for that and no more.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace farol::recognition::test {

struct TinyNetwork {
    int width = 32, height = 32;
    std::vector<std::int64_t> answer; ///< its shape; as many numbers as there are biases
    std::vector<float> biases;        ///< the numbers answered for a black picture
    /// Added to the numbers of the same place for each unit of the input's first channel, on average.
    std::vector<float> perFirstChannel;
};

std::string onnxBytes(const TinyNetwork& network);
void writeFile(const std::filesystem::path& path, const std::string& bytes);

} // namespace farol::recognition::test
