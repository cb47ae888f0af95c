#pragma once
// Parts of bench_localisation: the rising tables of confidence, and the timing on campuses.

#include "app/farol-cli/evaluate/walk_scores.h"
#include "core/localisation/confidence_table.h"

#include <ostream>
#include <string>
#include <vector>

namespace farol::bench {

/// Least squares among rising tables (pool adjacent violators) over bins of equal numbers.
std::vector<localisation::ConfidencePoint> risingTable(std::vector<cli::Stated> stated);
void writeTable(std::ostream& out, const std::string& name,
                const std::vector<localisation::ConfidencePoint>& table);

/// Median, 99th percentile and greatest time of an update, memory and time to build, at 100 to 100,000
/// regions.
int timeLocaliser();

} // namespace farol::bench
