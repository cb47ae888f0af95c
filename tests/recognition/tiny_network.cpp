#include "tiny_network.h"

#include <cstring>
#include <fstream>

namespace farol::recognition::test {

namespace {

std::string varint(std::uint64_t value) {
    std::string bytes;
    for (; value >= 0x80U; value >>= 7U) bytes += static_cast<char>((value & 0x7FU) | 0x80U);
    return bytes + static_cast<char>(value);
}

std::string number(int field, std::int64_t value) {
    return varint(static_cast<std::uint64_t>(field) << 3U) + varint(static_cast<std::uint64_t>(value));
}

std::string bytes(int field, const std::string& content) {
    return varint((static_cast<std::uint64_t>(field) << 3U) | 2U) + varint(content.size()) + content;
}

template <class T>
std::string tensor(const std::string& name, int type, const std::vector<std::int64_t>& shape,
                   const std::vector<T>& values) {
    std::string raw(values.size() * sizeof(T), '\0'), made;
    std::memcpy(raw.data(), values.data(), raw.size());
    for (std::int64_t side : shape) made += number(1, side);
    return made + number(2, type) + bytes(8, name) + bytes(9, raw);
}

std::string valueInfo(const std::string& name, const std::vector<std::int64_t>& shape) {
    std::string sides;
    for (std::int64_t side : shape) sides += bytes(1, number(1, side));
    return bytes(1, name) + bytes(2, bytes(1, number(1, 1) + bytes(2, sides)));
}

std::string node(const std::vector<std::string>& inputs, const std::string& output, const std::string& type,
                 const std::string& attributes = "") {
    std::string made;
    for (const std::string& input : inputs) made += bytes(1, input);
    return made + bytes(2, output) + bytes(3, output) + bytes(4, type) + attributes;
}

std::string integers(const std::string& name, const std::vector<std::int64_t>& values) {
    std::string made = bytes(1, name);
    for (std::int64_t value : values) made += number(8, value);
    return bytes(5, made + number(20, 7));
}

} // namespace

std::string onnxBytes(const TinyNetwork& network) {
    auto count = static_cast<std::int64_t>(network.biases.size());
    std::size_t area = static_cast<std::size_t>(network.width) * static_cast<std::size_t>(network.height);
    std::vector<float> weights(network.biases.size() * 3 * area, 0.0F);
    for (std::size_t i = 0; i < network.perFirstChannel.size(); ++i)
        for (std::size_t p = 0; p < area; ++p)
            weights[i * 3 * area + p] = network.perFirstChannel[i] / static_cast<float>(area);
    std::string graph =
        bytes(1, node({"picture", "weights", "biases"}, "column", "Conv",
                      integers("kernel_shape", {network.height, network.width}))) +
        bytes(1, node({"column", "shape"}, "answer", "Reshape")) + bytes(2, "tiny") +
        bytes(5, tensor("weights", 1, {count, 3, network.height, network.width}, weights)) +
        bytes(5, tensor("biases", 1, {count}, network.biases)) +
        bytes(5, tensor("shape", 7, {static_cast<std::int64_t>(network.answer.size())}, network.answer)) +
        bytes(11, valueInfo("picture", {1, 3, network.height, network.width})) +
        bytes(12, valueInfo("answer", network.answer));
    return number(1, 7) + bytes(7, graph) + bytes(8, bytes(1, "") + number(2, 11));
}

void writeFile(const std::filesystem::path& path, const std::string& content) {
    std::ofstream out(path, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
}

} // namespace farol::recognition::test
