#pragma once
// Brings one layer of a GeoPackage to what the building says. Features are found again by their key, not by
// their number, and only what Farol knows is changed in them: unknown fields of any type stay as they are.

#include "core/base/error.h"
#include "core/base/ogr.h"
#include "core/building/building.h"
#include "core/building/layer_schema.h"

#include <map>
#include <optional>
#include <string>

class GDALDataset;
class OGRFeature;
class OGRGeometry;
class OGRLayer;

namespace farol::building {

class LayerWriter {
public:
    enum class Missing { Remove, Keep }; ///< what becomes of features that are not written again

    LayerWriter(GDALDataset& dataset, const LayerSpec& spec, const std::string& crs, std::string context);

    /// Makes the layer and its fields ready; before anything else.
    Result<void> open();
    /// A field that Farol does not know, of the type of its value.
    Result<void> addField(const std::string& name, const AttributeValue& value);
    /// The feature with this key, or a new one; valid until the next call.
    OGRFeature& begin(const std::string& key);
    void set(const char* field, const std::string& text);
    void set(const char* field, std::optional<double> number);
    void set(const char* field, bool flag);
    void set(const Attributes& extra);
    void setPolygon(const Polygon& polygon);
    void setLine(const Polyline& line); ///< a single point becomes a Point
    Result<void> finish();              ///< a feature in which nothing changed is not written again
    Result<void> close(Missing missing);

private:
    Result<void> create();
    void readFeatures();
    Result<void> widenField(int index, int type);
    bool crsDiffers() const;
    void setGeometry(OGRGeometry* geometry);
    bool isNull(const char* field) const;
    Error failure(const std::string& action) const;

    GDALDataset& m_dataset;
    const LayerSpec& m_spec;
    std::string m_crs;
    std::string m_context;
    GdalMessages m_messages;
    OGRLayer* m_layer = nullptr;
    bool m_read = false;
    std::multimap<std::string, std::unique_ptr<OGRFeature>> m_old; ///< by key, of those not written again yet
    std::unique_ptr<OGRFeature> m_feature;
    std::unique_ptr<OGRFeature> m_before; ///< the feature as it stands in the file; nullptr for a new one
};

/// What finds a wall again in a layer without keys: its level and its line.
std::string wallKey(double level, const Polyline& line);

} // namespace farol::building
