#pragma once
// What a share of the filter's weight is worth, measured: a rising table from share to probability.

#include <span>

namespace farol::localisation {

/// Which statement, and from what: the shares mean something else once the picture's motion is known.
enum class Statement { Region, RegionByMotion, Near, NearByMotion };

struct ConfidencePoint {
    double share = 0.0;
    double probability = 0.0;
};

/// Linear between the points, both rising.
double calibrated(Statement statement, double share);
std::span<const ConfidencePoint> confidenceTable(Statement statement);

} // namespace farol::localisation
