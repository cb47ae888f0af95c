#include "core/building/feature_row.h"

#include "core/base/text.h"
#include "core/building/sentence.h"

#include <ogr_feature.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>

namespace farol::building {

namespace {

/// No building lies further from the origin of a metric CRS; beyond it squares and products lose their
/// meaning.
constexpr double kLargestCoordinate = 1e8;

std::optional<double> parsedNumber(const std::string& text) {
    std::size_t first = text.find_first_not_of(' ');
    if (first == std::string::npos) return std::nullopt;
    double value = 0.0;
    const char* end = text.data() + text.find_last_not_of(' ') + 1;
    auto [rest, failure] = std::from_chars(text.data() + first, end, value);
    if (failure != std::errc() || rest != end) return std::nullopt;
    return value;
}

/// The only part of a Multi… or collection of one; the geometry itself otherwise; nullptr for several parts.
const OGRGeometry* singlePart(const OGRGeometry& geometry) {
    const OGRGeometry* at = &geometry;
    while (OGR_GT_IsSubClassOf(wkbFlatten(at->getGeometryType()), wkbGeometryCollection)) {
        const OGRGeometryCollection* parts = at->toGeometryCollection();
        if (parts->getNumGeometries() != 1) return nullptr;
        at = parts->getGeometryRef(0);
    }
    return at;
}

} // namespace

AttributeValue attributeOf(const OGRFeature& feature, int field) {
    if (!feature.IsFieldSetAndNotNull(field)) return {};
    OGRFieldType type = feature.GetFieldDefnRef(field)->GetType();
    if (type == OFTInteger || type == OFTInteger64)
        return static_cast<std::int64_t>(feature.GetFieldAsInteger64(field));
    if (type == OFTReal) return feature.GetFieldAsDouble(field);
    if (type == OFTBinary) return {};
    return std::string(feature.GetFieldAsString(field));
}

FeatureRow::FeatureRow(const OGRFeature& feature, const LayerSpec& spec, const std::string& context)
    : m_feature(feature), m_spec(spec), m_context(context) {
    if (spec.key != nullptr) m_name = text(spec.key);
    if (!m_name.empty()) return;
    m_name = "number " + std::to_string(feature.GetFID());
    if (spec.key != nullptr) fail(english(Sentence::FieldEmpty, spec.key));
}

void FeatureRow::fail(const std::string& message) {
    if (!m_error)
        m_error = Error{ErrorCode::Corrupt, message, english(Sentence::FeatureOf, m_context, m_name)};
}

int FeatureRow::index(const char* field) const {
    int at = m_feature.GetFieldIndex(field);
    return at >= 0 && m_feature.IsFieldSetAndNotNull(at) ? at : -1;
}

std::string FeatureRow::text(const char* field) const {
    int at = index(field);
    return at < 0 ? std::string() : m_feature.GetFieldAsString(at);
}

std::optional<double> FeatureRow::number(const char* field) {
    int at = index(field);
    if (at < 0) return std::nullopt;
    OGRFieldType type = m_feature.GetFieldDefnRef(at)->GetType();
    std::optional<double> value;
    if (type == OFTInteger || type == OFTInteger64 || type == OFTReal) {
        value = m_feature.GetFieldAsDouble(at);
    } else {
        std::string written = m_feature.GetFieldAsString(at);
        if (written.empty()) return std::nullopt;
        value = parsedNumber(written);
    }
    if (value && std::isfinite(*value)) return value;
    fail(english(Sentence::FieldNoNumber, field));
    return std::nullopt;
}

std::optional<int> FeatureRow::whole(const char* field) {
    std::optional<double> value = number(field);
    if (!value) return std::nullopt;
    if (std::abs(*value) > 1e6 || *value != std::floor(*value)) {
        fail(english(Sentence::FieldNoWhole, field));
        return std::nullopt;
    }
    return static_cast<int>(*value);
}

double FeatureRow::level() {
    std::optional<double> written = number("level");
    // A layer without the field has one level (the reader warns); a gap in the field is a mistake.
    if (!written && m_feature.GetFieldIndex("level") >= 0) fail(english(Sentence::FieldEmpty, "level"));
    double level = written.value_or(0.0);
    if (std::abs(level) > 1000.0) fail(english(Sentence::LevelNoFloor, level));
    return level;
}

bool FeatureRow::flag(const char* field) {
    std::string written = text(field);
    std::transform(written.begin(), written.end(), written.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (written.empty() || written == "0" || written == "false" || written == "no") return false;
    if (written != "1" && written != "true" && written != "yes") fail(english(Sentence::FieldNoFlag, field));
    return true;
}

Attributes FeatureRow::extra() const {
    Attributes attributes;
    for (int i = 0; i < m_feature.GetFieldCount(); ++i) {
        const OGRFieldDefn& field = *m_feature.GetFieldDefnRef(i);
        if (m_spec.knows(field.GetNameRef())) continue;
        if (field.GetType() == OFTBinary && m_feature.IsFieldSetAndNotNull(i))
            continue; // stays in the file: see the writer
        attributes.emplace(field.GetNameRef(), attributeOf(m_feature, i));
    }
    return attributes;
}

const OGRGeometry* FeatureRow::geometry(const char* wanted) {
    const OGRGeometry* whole = m_feature.GetGeometryRef();
    if (whole == nullptr || whole->IsEmpty()) {
        fail(english(Sentence::NoGeometry, wanted));
        return nullptr;
    }
    const OGRGeometry* part = singlePart(*whole);
    if (part == nullptr)
        fail(english(Sentence::SeveralParts,
                     static_cast<double>(whole->toGeometryCollection()->getNumGeometries()), wanted));
    return part;
}

bool FeatureRow::checkPoints(const std::vector<Point2>& points) {
    for (Point2 p : points) {
        if (!isFinite(p))
            fail(english(Sentence::CornerNoNumber));
        else if (std::abs(p.x) > kLargestCoordinate || std::abs(p.y) > kLargestCoordinate)
            fail(english(Sentence::CornerTooFar));
    }
    return !m_error;
}

Ring FeatureRow::ring(const OGRLineString& line) {
    Ring points;
    for (int i = 0; i < line.getNumPoints(); ++i) points.push_back({line.getX(i), line.getY(i)});
    if (points.size() > 1 && points.front() == points.back()) points.pop_back();
    if (checkPoints(points) && (points.size() < 3 || signedArea(points) == 0.0))
        fail(english(Sentence::AreaNone));
    return points;
}

Polygon FeatureRow::polygon() {
    const OGRGeometry* part = geometry("Polygon");
    if (part == nullptr) return {};
    std::unique_ptr<OGRGeometry> straight;
    if (part->hasCurveGeometry() != 0) {
        straight.reset(part->getLinearGeometry());
        part = straight.get();
    }
    if (part == nullptr || wkbFlatten(part->getGeometryType()) != wkbPolygon) {
        fail(english(Sentence::OtherShape, part == nullptr ? "curve" : part->getGeometryName(), "Polygon"));
        return {};
    }
    const OGRPolygon* outline = part->toPolygon();
    if (outline->getExteriorRing() == nullptr) {
        fail(english(Sentence::NoOutline));
        return {};
    }
    Polygon polygon;
    polygon.outer = ring(*outline->getExteriorRing());
    for (int i = 0; i < outline->getNumInteriorRings(); ++i)
        polygon.holes.push_back(ring(*outline->getInteriorRing(i)));
    return polygon;
}

Polyline FeatureRow::polyline(const OGRGeometry& part, const char* wanted) {
    Polyline points;
    std::unique_ptr<OGRGeometry> straight(part.hasCurveGeometry() != 0 ? part.getLinearGeometry() : nullptr);
    const OGRGeometry& geometry = straight ? *straight : part;
    if (wkbFlatten(geometry.getGeometryType()) != wkbLineString) {
        fail(english(Sentence::OtherShape, geometry.getGeometryName(), wanted));
        return points;
    }
    const OGRLineString* line = geometry.toLineString();
    for (int i = 0; i < line->getNumPoints(); ++i) points.push_back({line->getX(i), line->getY(i)});
    checkPoints(points);
    return points;
}

Polyline FeatureRow::pointOrLine() {
    const OGRGeometry* part = geometry("Point or LineString");
    if (part == nullptr) return {};
    if (wkbFlatten(part->getGeometryType()) != wkbPoint) return polyline(*part, "Point or LineString");
    Polyline points{{part->toPoint()->getX(), part->toPoint()->getY()}};
    checkPoints(points);
    return points;
}

std::vector<Polyline> FeatureRow::lines() {
    const OGRGeometry* whole = m_feature.GetGeometryRef();
    if (whole == nullptr || whole->IsEmpty()) return {};
    if (!OGR_GT_IsSubClassOf(wkbFlatten(whole->getGeometryType()), wkbGeometryCollection))
        return {polyline(*whole, "LineString")};
    std::vector<Polyline> parts;
    const OGRGeometryCollection* collection = whole->toGeometryCollection();
    for (int i = 0; i < collection->getNumGeometries(); ++i)
        parts.push_back(polyline(*collection->getGeometryRef(i), "LineString"));
    return parts;
}

Point2 FeatureRow::point() {
    const OGRGeometry* part = geometry("Point");
    if (part == nullptr) return {};
    if (wkbFlatten(part->getGeometryType()) != wkbPoint) {
        fail(english(Sentence::OtherShape, part->getGeometryName(), "Point"));
        return {};
    }
    Point2 position{part->toPoint()->getX(), part->toPoint()->getY()};
    checkPoints({position});
    return position;
}

} // namespace farol::building
