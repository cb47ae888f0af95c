#pragma once
// Floors told apart by their heights, where a source says nothing better.

#include <optional>
#include <vector>

namespace farol::building {

/// Heights less than 1.5 m apart are one floor. The floor nearest to height 0 is the ground, which is the
/// lowest when all lie higher, as heights above the sea do.
class HeightLevels {
public:
    explicit HeightLevels(std::vector<double> heights);
    bool empty() const { return m_floors.empty(); }
    const std::vector<double>& floors() const { return m_floors; } ///< the lowest height of each, ascending
    double ordinalAt(std::size_t floor) const;
    double ordinalOf(double height) const;
    double ground() const { return m_floors[m_ground]; }

private:
    std::vector<double> m_floors;
    std::size_t m_ground = 0;
};

} // namespace farol::building
