#pragma once
// One feature of a layer, read with its faults remembered: readers ask for values and check error() once.

#include "core/base/error.h"
#include "core/building/building.h"
#include "core/building/layer_schema.h"

#include <optional>
#include <string>
#include <vector>

class OGRFeature;
class OGRGeometry;
class OGRLineString;

namespace farol::building {

/// The value of one field, whatever its type; nothing for null. Bytes are no attribute: they stay in the
/// file.
AttributeValue attributeOf(const OGRFeature& feature, int field);

class FeatureRow {
public:
    /// `context` names file and layer.
    FeatureRow(const OGRFeature& feature, const LayerSpec& spec, const std::string& context);

    /// The key, or the feature's number where there is none: for messages.
    const std::string& name() const { return m_name; }
    std::string text(const char* field) const; ///< empty when null
    std::optional<double> number(const char* field);
    std::optional<int> whole(const char* field);
    bool has(const char* field) const { return index(field) >= 0; }
    double level();
    bool flag(const char* field);
    Attributes extra() const; ///< what the schema does not know

    Polygon polygon();
    Polyline pointOrLine();
    std::vector<Polyline> lines();
    Point2 point();

    void fail(const std::string& message);
    const std::optional<Error>& error() const { return m_error; }

private:
    int index(const char* field) const; ///< -1 when missing or null
    const OGRGeometry* geometry(const char* wanted);
    Ring ring(const OGRLineString& line);
    Polyline polyline(const OGRGeometry& part, const char* wanted);
    bool checkPoints(const std::vector<Point2>& points);

    const OGRFeature& m_feature;
    const LayerSpec& m_spec;
    std::string m_context;
    std::string m_name;
    std::optional<Error> m_error;
};

} // namespace farol::building
