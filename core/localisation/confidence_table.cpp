#include "core/localisation/confidence_table.h"

#include <algorithm>

namespace farol::localisation {

namespace {

#include "core/localisation/confidence_table.inc"

} // namespace

std::span<const ConfidencePoint> confidenceTable(Statement statement) {
    switch (statement) {
    case Statement::Region:
        return kRegion;
    case Statement::RegionByMotion:
        return kRegionByMotion;
    case Statement::Near:
        return kNear;
    case Statement::NearByMotion:
        break;
    }
    return kNearByMotion;
}

double calibrated(Statement statement, double share) {
    std::span<const ConfidencePoint> table = confidenceTable(statement);
    if (!(share > table.front().share)) return table.front().probability;
    for (std::size_t i = 1; i < table.size(); ++i) {
        if (share > table[i].share) continue;
        double t = (share - table[i - 1].share) / (table[i].share - table[i - 1].share);
        return table[i - 1].probability + t * (table[i].probability - table[i - 1].probability);
    }
    return table.back().probability;
}

} // namespace farol::localisation
