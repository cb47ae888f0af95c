#include "core/building/layer_schema.h"

#include <cpl_port.h>

#include <algorithm>

namespace farol::building {

bool LayerSpec::knows(const std::string& field) const {
    // OGR finds fields whatever their case.
    return std::any_of(fields.begin(), fields.end(),
                       [&](const FieldSpec& each) { return EQUAL(field.c_str(), each.name) != 0; });
}

const LayerSpec& levelsLayer() {
    static const LayerSpec spec{"levels",
                                wkbNone,
                                "level",
                                {{"level", OFTReal},
                                 {"name", OFTString},
                                 {"ref", OFTString},
                                 {"elevation_m", OFTReal},
                                 {"height_m", OFTReal}}};
    return spec;
}

const LayerSpec& regionsLayer() {
    static const LayerSpec spec{"regions",
                                wkbPolygon,
                                "region_id",
                                {{"region_id", OFTString},
                                 {"level", OFTReal},
                                 {"name", OFTString},
                                 {"ref", OFTString},
                                 {"kind", OFTString},
                                 {"restricted", OFTInteger, OFSTBoolean}}};
    return spec;
}

const LayerSpec& accessesLayer() {
    // Doors with a width are lines, others points: the layer takes any geometry.
    static const LayerSpec spec{"accesses",
                                wkbUnknown,
                                "access_id",
                                {{"access_id", OFTString},
                                 {"kind", OFTString},
                                 {"level", OFTReal},
                                 {"region_a", OFTString},
                                 {"region_b", OFTString},
                                 {"shaft", OFTString},
                                 {"oneway", OFTString},
                                 {"door_type", OFTString},
                                 {"automatic", OFTInteger, OFSTBoolean},
                                 {"width_m", OFTReal},
                                 {"steps", OFTInteger},
                                 {"closed", OFTInteger, OFSTBoolean}}};
    return spec;
}

const LayerSpec& landmarksLayer() {
    static const LayerSpec spec{"landmarks",
                                wkbPoint,
                                "landmark_id",
                                {{"landmark_id", OFTString},
                                 {"kind", OFTString},
                                 {"template", OFTString},
                                 {"text", OFTString},
                                 {"region_id", OFTString},
                                 {"level", OFTReal},
                                 {"heading_deg", OFTReal},
                                 {"height_m", OFTReal},
                                 {"width_m", OFTReal},
                                 {"tall_m", OFTReal}}};
    return spec;
}

const LayerSpec& wallsLayer() {
    static const LayerSpec spec{"walls", wkbLineString, nullptr, {{"level", OFTReal}}};
    return spec;
}

const LayerSpec& farolLayer() {
    static const LayerSpec spec{"farol", wkbNone, "key", {{"key", OFTString}, {"value", OFTString}}};
    return spec;
}

} // namespace farol::building
