#pragma once
// Writing the layers of a building into an open dataset, the same for files and databases.

#include "core/base/error.h"
#include "core/building/building.h"

#include <string>

class GDALDataset;

namespace farol::building {

/// What a dataset cannot hold, before anything is written.
Result<void> checkWritable(const BuildingData& data, const std::string& context);
/// A map of a later Farol may hold what this one would lose.
Result<void> checkNotLater(GDALDataset& dataset, const std::string& context);
/// Within the caller's transaction.
Result<void> writeLayers(GDALDataset& dataset, const BuildingData& data, const std::string& context);

} // namespace farol::building
