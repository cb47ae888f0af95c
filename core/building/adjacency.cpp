#include "core/building/adjacency.h"

#include <algorithm>

namespace farol::building {

Adjacency::Adjacency(std::size_t size, const std::vector<std::pair<std::size_t, std::size_t>>& pairs)
    : m_size(size) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> both;
    both.reserve(2 * pairs.size());
    for (auto [a, b] : pairs) {
        if (a == b || a >= size || b >= size) continue;
        both.emplace_back(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
        both.emplace_back(static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(a));
    }
    std::sort(both.begin(), both.end());
    both.erase(std::unique(both.begin(), both.end()), both.end());
    std::size_t rows = (size + 1 + both.size()) * sizeof(std::uint32_t);
    if (size * wordsPerRow() * sizeof(std::uint64_t) <= rows) {
        m_bits.assign(size * wordsPerRow(), 0);
        for (auto [a, b] : both) m_bits[a * wordsPerRow() + b / 64] |= std::uint64_t{1} << (b % 64);
        return;
    }
    m_starts.assign(size + 1, 0);
    for (auto [a, b] : both) ++m_starts[a + 1];
    for (std::size_t i = 0; i < size; ++i) m_starts[i + 1] += m_starts[i];
    m_items.reserve(both.size());
    for (auto [a, b] : both) m_items.push_back(b);
}

bool Adjacency::joined(std::size_t a, std::size_t b) const {
    if (a >= m_size || b >= m_size) return false;
    if (isMatrix()) return (m_bits[a * wordsPerRow() + b / 64] >> (b % 64) & 1U) != 0;
    return std::binary_search(m_items.begin() + m_starts[a], m_items.begin() + m_starts[a + 1],
                              static_cast<std::uint32_t>(b));
}

std::vector<std::size_t> Adjacency::row(std::size_t a) const {
    std::vector<std::size_t> found;
    if (a >= m_size) return found;
    if (!isMatrix()) return {m_items.begin() + m_starts[a], m_items.begin() + m_starts[a + 1]};
    for (std::size_t b = 0; b < m_size; ++b)
        if (joined(a, b)) found.push_back(b);
    return found;
}

std::size_t Adjacency::bytes() const {
    return (m_starts.size() + m_items.size()) * sizeof(std::uint32_t) + m_bits.size() * sizeof(std::uint64_t);
}

Adjacency adjacencyOf(const Building& building) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t a = 0; a < building.regions().size(); ++a)
        for (std::size_t b : building.neighboursOf(a))
            if (a < b) pairs.emplace_back(a, b);
    return {building.regions().size(), pairs};
}

} // namespace farol::building
