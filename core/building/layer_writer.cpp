#include "core/building/layer_writer.h"

#include "core/base/text.h"
#include "core/building/feature_row.h"
#include "core/building/sentence.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <cstring>
#include <utility>

namespace farol::building {

namespace {

std::string wallKeyOf(const OGRFeature& feature, const LayerSpec& spec) {
    FeatureRow row(feature, spec, "");
    std::vector<Polyline> lines = row.lines();
    double level = row.level();
    return row.error() || lines.size() != 1 ? std::string() : wallKey(level, lines.front());
}

std::string keyOf(const OGRFeature& feature, const LayerSpec& spec) {
    if (spec.key == nullptr) return wallKeyOf(feature, spec);
    int index = feature.GetFieldIndex(spec.key);
    if (index < 0 || !feature.IsFieldSetAndNotNull(index)) return {};
    bool real = feature.GetFieldDefnRef(index)->GetType() == OFTReal;
    return real ? formatNumber(feature.GetFieldAsDouble(index)) : feature.GetFieldAsString(index);
}

/// nullptr for no CRS: GeoPackage then notes it as undefined.
std::unique_ptr<OGRSpatialReference> referenceOf(const std::string& crs) {
    if (crs.empty()) return nullptr;
    auto reference = std::make_unique<OGRSpatialReference>();
    if (reference->SetFromUserInput(
            crs.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE)
        return nullptr;
    reference->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return reference;
}

void addRing(OGRPolygon& polygon, const Ring& points) {
    auto* ring = new OGRLinearRing; // the polygon takes it
    for (Point2 p : points) ring->addPoint(p.x, p.y);
    ring->closeRings();
    polygon.addRingDirectly(ring);
}

} // namespace

LayerWriter::LayerWriter(GDALDataset& dataset, const LayerSpec& spec, const std::string& crs,
                         std::string context)
    : m_dataset(dataset), m_spec(spec), m_crs(crs), m_context(std::move(context) + ", layer " + spec.name) {}

Error LayerWriter::failure(const std::string& action) const {
    return m_messages.error(ErrorCode::Io, action, m_context);
}

bool LayerWriter::crsDiffers() const {
    if (m_spec.geometry == wkbNone) return false;
    const OGRSpatialReference* present = m_layer->GetSpatialRef();
    if (present != nullptr &&
        std::string(present->GetName() ? present->GetName() : "").rfind("Undefined", 0) == 0)
        present = nullptr;
    auto wanted = referenceOf(m_crs);
    if (present == nullptr || wanted == nullptr) return (present == nullptr) != (wanted == nullptr);
    const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", nullptr};
    return present->IsSame(wanted.get(), options) == 0;
}

Result<void> LayerWriter::create() {
    auto reference = referenceOf(m_crs);
    if (reference == nullptr && !m_crs.empty() && m_spec.geometry != wkbNone)
        return Error{ErrorCode::InvalidArgument, "the map's coordinate reference system cannot be understood",
                     m_context};
    const char* const options[] = {"GEOMETRY_NAME=geom", "FID=fid", "LAUNDER=NO", nullptr};
    m_layer =
        m_dataset.CreateLayer(m_spec.name, reference.get(), m_spec.geometry, const_cast<char**>(options));
    if (m_layer == nullptr) return failure("cannot create the layer");
    return {};
}

Result<void> LayerWriter::open() {
    m_layer = m_dataset.GetLayerByName(m_spec.name);
    if (m_layer != nullptr && crsDiffers()) {
        // Coordinates of two systems must not stand in one layer; what is unknown in it travels in `extra`.
        for (int i = 0; i < m_dataset.GetLayerCount(); ++i)
            if (m_dataset.GetLayer(i) == m_layer) {
                if (m_dataset.DeleteLayer(i) != OGRERR_NONE) return failure("cannot replace the layer");
                break;
            }
        m_layer = nullptr;
    }
    if (m_layer == nullptr)
        if (auto created = create(); !created) return created;
    for (const FieldSpec& field : m_spec.fields) {
        if (m_layer->GetLayerDefn()->GetFieldIndex(field.name) >= 0) continue;
        OGRFieldDefn definition(field.name, field.type);
        definition.SetSubType(field.subtype);
        if (m_layer->CreateField(&definition) != OGRERR_NONE)
            return failure(std::string("cannot add the field ") + field.name);
    }
    return {};
}

/// Once all fields are there. Kept whole: asking a database for each again would take long.
void LayerWriter::readFeatures() {
    if (std::exchange(m_read, true)) return;
    m_layer->ResetReading();
    while (OGRFeatureUniquePtr feature{m_layer->GetNextFeature()}) {
        std::string key = keyOf(*feature, m_spec);
        m_old.emplace(std::move(key), feature.release());
    }
}

Result<void> LayerWriter::addField(const std::string& name, const AttributeValue& value) {
    OGRFieldType type = std::holds_alternative<std::int64_t>(value) ? OFTInteger64
                        : std::holds_alternative<double>(value)     ? OFTReal
                                                                    : OFTString;
    int present = m_layer->GetLayerDefn()->GetFieldIndex(name.c_str());
    bool known = !std::holds_alternative<std::monostate>(value);
    if (present >= 0) return known ? widenField(present, type) : Result<void>();
    // Columns that the GeoPackage itself keeps.
    if (EQUAL(name.c_str(), m_layer->GetFIDColumn()) || EQUAL(name.c_str(), m_layer->GetGeometryColumn()))
        return {};
    OGRFieldDefn definition(name.c_str(), type);
    if (m_layer->CreateField(&definition) != OGRERR_NONE) return failure("cannot add the field " + name);
    return {};
}

/// A number into a column of whole ones, or words into one of numbers, would be cut down without a word.
Result<void> LayerWriter::widenField(int index, int type) {
    OGRFieldDefn& present = *m_layer->GetLayerDefn()->GetFieldDefn(index);
    OGRFieldType now = present.GetType();
    bool whole = now == OFTInteger || now == OFTInteger64;
    bool narrow = (type == OFTReal && whole) || (type == OFTInteger64 && now == OFTInteger) ||
                  (type == OFTString && (whole || now == OFTReal));
    if (!narrow) return {};
    OGRFieldDefn wider(present.GetNameRef(), static_cast<OGRFieldType>(type));
    if (m_layer->AlterFieldDefn(index, &wider, ALTER_TYPE_FLAG) != OGRERR_NONE)
        return failure(std::string("cannot widen the field ") + present.GetNameRef());
    return {};
}

OGRFeature& LayerWriter::begin(const std::string& key) {
    m_feature.reset();
    m_before.reset();
    readFeatures();
    auto old = m_old.find(key);
    if (old != m_old.end()) {
        m_before = std::move(old->second);
        m_old.erase(old);
    }
    m_feature = m_before != nullptr ? std::unique_ptr<OGRFeature>(m_before->Clone())
                                    : std::make_unique<OGRFeature>(m_layer->GetLayerDefn());
    return *m_feature;
}

bool LayerWriter::isNull(const char* field) const {
    return !m_feature->IsFieldSetAndNotNull(m_feature->GetFieldIndex(field));
}

void LayerWriter::set(const char* field, const std::string& text) {
    if (text.empty() && m_before != nullptr &&
        (isNull(field) || *m_feature->GetFieldAsString(m_feature->GetFieldIndex(field)) == 0))
        return; // an empty text stays the empty text that it was
    if (text.empty())
        m_feature->SetFieldNull(m_feature->GetFieldIndex(field));
    else
        m_feature->SetField(field, text.c_str());
}

void LayerWriter::set(const char* field, std::optional<double> number) {
    if (m_before != nullptr) {
        FeatureRow row(*m_before, m_spec, "");
        if (row.number(field) == number && !row.error()) return;
    }
    if (number)
        m_feature->SetField(field, *number);
    else
        m_feature->SetFieldNull(m_feature->GetFieldIndex(field));
}

void LayerWriter::set(const char* field, bool flag) {
    if (m_before != nullptr) {
        FeatureRow row(*m_before, m_spec, "");
        if (row.flag(field) == flag && !row.error()) return; // also where nobody filled it in
    }
    m_feature->SetField(field, flag ? 1 : 0);
}

void LayerWriter::set(const Attributes& extra) {
    for (const auto& [name, value] : extra) {
        int index = m_feature->GetFieldIndex(name.c_str());
        // What is as it was stays to the byte: a date, a list or a raw string is more than its text.
        if (index < 0 || (m_before != nullptr && attributeOf(*m_before, index) == value)) continue;
        if (const auto* whole = std::get_if<std::int64_t>(&value))
            m_feature->SetField(index, static_cast<GIntBig>(*whole));
        else if (const auto* real = std::get_if<double>(&value))
            m_feature->SetField(index, *real);
        else if (const auto* text = std::get_if<std::string>(&value))
            m_feature->SetField(index, text->c_str());
        else
            m_feature->SetFieldNull(index);
    }
}

void LayerWriter::setGeometry(OGRGeometry* geometry) {
    // QGIS likes to make Multi… layers: their features stay so.
    OGRwkbGeometryType type = wkbFlatten(m_layer->GetGeomType());
    if (type == wkbMultiPolygon || type == wkbMultiPoint || type == wkbMultiLineString)
        geometry = OGRGeometryFactory::forceTo(geometry, type);
    m_feature->SetGeometryDirectly(geometry);
}

void LayerWriter::setPolygon(const Polygon& polygon) {
    if (m_before != nullptr) { // heights and curves that Farol does not read stay where nothing moved
        FeatureRow row(*m_before, m_spec, "");
        Polygon before = row.polygon();
        if (!row.error() && before.outer == polygon.outer && before.holes == polygon.holes) return;
    }
    auto shape = std::make_unique<OGRPolygon>();
    addRing(*shape, polygon.outer);
    for (const Ring& hole : polygon.holes) addRing(*shape, hole);
    setGeometry(shape.release());
}

void LayerWriter::setLine(const Polyline& line) {
    if (m_before != nullptr) {
        FeatureRow row(*m_before, m_spec, "");
        if (row.pointOrLine() == line && !row.error()) return;
    }
    if (line.size() == 1) {
        setGeometry(new OGRPoint(line.front().x, line.front().y));
        return;
    }
    auto shape = std::make_unique<OGRLineString>();
    for (Point2 p : line) shape->addPoint(p.x, p.y);
    setGeometry(shape.release());
}

Result<void> LayerWriter::finish() {
    if (m_messages.failed()) return failure(english(Sentence::NotReadToItsEnd));
    if (m_before != nullptr && m_feature->Equal(m_before.get()) != FALSE) return {};
    OGRErr code =
        m_before == nullptr ? m_layer->CreateFeature(m_feature.get()) : m_layer->SetFeature(m_feature.get());
    if (code != OGRERR_NONE || m_messages.failed())
        return failure("cannot write the feature " + keyOf(*m_feature, m_spec));
    return {};
}

Result<void> LayerWriter::close(Missing missing) {
    if (missing == Missing::Keep) return {};
    readFeatures();
    if (m_messages.failed()) return failure(english(Sentence::NotReadToItsEnd));
    for (const auto& [key, feature] : m_old)
        if (m_layer->DeleteFeature(feature->GetFID()) != OGRERR_NONE)
            return failure("cannot remove the feature " + key);
    return {};
}

std::string wallKey(double level, const Polyline& line) {
    std::string key = formatNumber(level);
    if (!line.empty()) {
        std::size_t start = key.size(), bytes = line.size() * sizeof(Point2);
        key.resize(start + bytes);
        std::memcpy(key.data() + start, line.data(), bytes);
    }
    return key;
}

} // namespace farol::building
