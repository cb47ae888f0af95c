#pragma once
// A feature as OpenStreetMap, HULOP and WRLD files have it: tags and shapes in degrees. And GeoJSON read into
// such.

#include "core/base/error.h"
#include "core/base/geometry.h"
#include "core/building/building.h"
#include "core/building/import/importer.h"

#include <map>
#include <string>
#include <vector>

class OGRGeometry;

namespace farol::building {

using Tags = std::map<std::string, std::string>;

struct TaggedFeature {
    std::string id; ///< "way/42", or as the file has it; may be empty
    Tags tags;
    std::vector<Point2> points;
    std::vector<Polyline> lines;
    std::vector<Polygon> polygons;

    const std::string& tag(const std::string& key) const; ///< empty when absent
    bool has(const std::string& key) const { return tags.count(key) != 0; }
    bool is(const std::string& key, const std::string& value) const { return tag(key) == value; }
};

/// The features of a FeatureCollection with the top level's other plain members. Properties become text; the
/// members of an object property "tags" stand among the others. Shapes that cannot be are left out and told
/// in `findings`.
struct TaggedCollection {
    Tags members;
    std::vector<TaggedFeature> features;
};

Result<TaggedCollection> readTaggedGeoJson(const std::string& text, const std::string& context,
                                           std::vector<Finding>& findings);

/// Longitude and latitude in degrees?
bool isGeographic(Point2 point);
/// Adds the shapes of an OGR geometry, whatever its nesting. False when a vertex is no place on Earth.
bool addShapes(const OGRGeometry& geometry, TaggedFeature& feature);
/// `name:<language>` when there is one, else `name`.
std::string nameOf(const TaggedFeature& feature, const std::string& language);
/// All tags as attributes, for what Farol has no field for.
Attributes attributesOf(const Tags& tags);
/// "24", "24.5"; empty for what is no plain finite number (units are not read).
std::optional<double> plainNumber(const std::string& text);

} // namespace farol::building
