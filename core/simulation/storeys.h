#pragma once
// Heights: where each level's floor lies, also of a map that gives none or gives them in the wrong order.

#include "core/building/building.h"

#include <vector>

namespace farol::simulation {

struct Storey {
    double ordinal = 0.0;
    double floorZ = 0.0;
    double ceilingM = 2.7; ///< clear height
    double riseM = 3.1;    ///< to the next floor
};

class Storeys {
public:
    Storeys() = default;
    explicit Storeys(const building::Building& building);

    /// The storey of that ordinal, or the nearest one. There is always one.
    const Storey& at(double ordinal) const;
    /// Height of a foot; between two ordinals in proportion.
    double footZ(double ordinal) const;
    const std::vector<Storey>& all() const { return m_storeys; }

private:
    std::vector<Storey> m_storeys; ///< ascending
};

} // namespace farol::simulation
