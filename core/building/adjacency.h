#pragma once
// The paper's matrix map: which regions are neighbours, for every pair. Kept as compressed rows, or as the
// matrix itself, one bit a pair, where that is smaller: in small buildings, and where nearly everything
// adjoins.

#include "core/building/building.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace farol::building {

class Adjacency {
public:
    Adjacency() = default;
    /// Pairs of numbers below `size`, in any order; each joins both ways. A pair of one number, or with one
    /// that is too high, joins nothing.
    Adjacency(std::size_t size, const std::vector<std::pair<std::size_t, std::size_t>>& pairs);

    std::size_t size() const { return m_size; }
    bool joined(std::size_t a, std::size_t b) const;   ///< false for numbers that are too high
    std::vector<std::size_t> row(std::size_t a) const; ///< ascending
    bool isMatrix() const { return m_starts.empty(); }
    std::size_t bytes() const;

private:
    std::size_t wordsPerRow() const { return (m_size + 63) / 64; }

    std::size_t m_size = 0;
    std::vector<std::uint32_t> m_starts; ///< row i is m_items[m_starts[i] .. m_starts[i + 1])
    std::vector<std::uint32_t> m_items;
    std::vector<std::uint64_t> m_bits;
};

/// Regions that a passable access joins, by their indices.
Adjacency adjacencyOf(const Building& building);

} // namespace farol::building
