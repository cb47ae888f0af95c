#pragma once
// The layers of a building in a database (PostgreSQL with PostGIS), which several workstations share: read
// from one moment, written all or nothing, and never over what somebody else changed in between.

#include "core/base/error.h"
#include "core/building/building.h"

#include <string>

class GDALDataset;

namespace farol::building {

/// Writes all layers in one transaction. Where the building names the revision it was read at
/// (BuildingData::revision) and the map was changed since, whether by Farol or by hand, nothing is written:
/// Conflict. A building without a revision (an import) takes the place of what is there. Answers the new
/// revision, for the next save.
Result<std::string> saveToDatabase(const Building& building, const std::string& source);

/// From here on the dataset shows one moment of the map, whatever others write.
Result<void> holdMoment(GDALDataset& dataset, const std::string& context);

/// What tells one content of the layers from any other.
Result<std::string> mapRevision(GDALDataset& dataset, const std::string& context);

} // namespace farol::building
