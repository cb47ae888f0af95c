#pragma once
// The layers of the building file (design, section 4), once for reading and writing.

#include <ogr_core.h>

#include <string>
#include <vector>

namespace farol::building {

inline constexpr int kSchemaVersion = 1;

struct FieldSpec {
    const char* name;
    OGRFieldType type;
    OGRFieldSubType subtype = OFSTNone;
};

struct LayerSpec {
    const char* name;
    OGRwkbGeometryType geometry;
    const char* key; ///< the field without which a feature means nothing; nullptr when there is none
    std::vector<FieldSpec> fields;

    bool knows(const std::string& field) const;
};

const LayerSpec& levelsLayer();
const LayerSpec& regionsLayer();
const LayerSpec& accessesLayer();
const LayerSpec& landmarksLayer();
const LayerSpec& wallsLayer();
const LayerSpec& farolLayer();

} // namespace farol::building
