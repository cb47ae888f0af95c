#include "core/building/import/tagged_feature.h"

#include "core/base/text.h"
#include "core/building/sentence.h"

#include <nlohmann/json.hpp>
#include <ogr_geometry.h>

#include <charconv>
#include <cmath>
#include <exception>

namespace farol::building {

namespace {

using Json = nlohmann::json;

constexpr int kMaxNesting = 40;
constexpr std::size_t kMaxFeatures = 500000;

/// Stops at the first value nested deeper than any map is, before memory goes into it.
bool tooDeep(const std::string& text) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (quoted && c == '\\')
            ++i;
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && (c == '{' || c == '[') && ++depth > kMaxNesting)
            return true;
        else if (!quoted && (c == '}' || c == ']'))
            --depth;
    }
    return false;
}

std::string plainText(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return formatNumber(value.get<double>());
    return value.is_null() ? std::string() : value.dump();
}

void addTags(const Json& object, Tags& tags) {
    for (const auto& [key, value] : object.items())
        if (key == "tags" && value.is_object())
            addTags(value, tags);
        else if (!value.is_null())
            tags[key] = plainText(value);
}

/// Reads coordinates of one geometry; `good` falls when something is no coordinate.
class ShapeReader {
public:
    explicit ShapeReader(TaggedFeature& feature) : m_feature(feature) {}

    bool read(const Json& geometry) {
        if (!geometry.is_object()) return geometry.is_null();
        auto named = geometry.find("type");
        const std::string type =
            named != geometry.end() && named->is_string() ? named->get<std::string>() : "";
        if (type == "GeometryCollection") {
            for (const Json& part : member(geometry, "geometries")) read(part);
            return m_good;
        }
        const Json& at = member(geometry, "coordinates");
        if (type == "Point")
            m_feature.points.push_back(point(at));
        else if (type == "MultiPoint")
            for (const Json& one : at) m_feature.points.push_back(point(one));
        else if (type == "LineString")
            m_feature.lines.push_back(line(at));
        else if (type == "MultiLineString")
            for (const Json& one : at) m_feature.lines.push_back(line(one));
        else if (type == "Polygon")
            polygon(at);
        else if (type == "MultiPolygon")
            for (const Json& one : at) polygon(one);
        else
            m_good = false;
        return m_good;
    }

private:
    const Json& member(const Json& object, const char* key) {
        static const Json none = Json::array();
        auto found = object.find(key);
        if (found != object.end() && found->is_array()) return *found;
        m_good = false;
        return none;
    }
    Point2 point(const Json& at) {
        Point2 p;
        bool numbers = at.is_array() && at.size() >= 2 && at[0].is_number() && at[1].is_number();
        if (numbers) p = {at[0].get<double>(), at[1].get<double>()};
        m_good = m_good && numbers && isGeographic(p);
        return p;
    }
    Polyline line(const Json& at) {
        Polyline points;
        m_good = m_good && at.is_array();
        if (at.is_array())
            for (const Json& one : at) points.push_back(point(one));
        m_good = m_good && points.size() >= 2;
        return points;
    }
    void polygon(const Json& rings) {
        Polygon polygon;
        m_good = m_good && rings.is_array() && !rings.empty();
        if (!m_good) return;
        for (std::size_t i = 0; i < rings.size(); ++i) {
            Ring ring = line(rings[i]);
            if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
            m_good = m_good && ring.size() >= 3;
            if (i == 0)
                polygon.outer = std::move(ring);
            else
                polygon.holes.push_back(std::move(ring));
        }
        m_feature.polygons.push_back(std::move(polygon));
    }

    TaggedFeature& m_feature;
    bool m_good = true;
};

TaggedFeature featureOf(const Json& json, bool& good) {
    TaggedFeature feature;
    if (auto properties = json.find("properties"); properties != json.end() && properties->is_object())
        addTags(*properties, feature.tags);
    if (feature.has("@id"))
        feature.id = feature.tag("@id");
    else if (auto id = json.find("id"); id != json.end())
        feature.id = plainText(*id);
    if (feature.id.empty()) feature.id = feature.tag("id");
    auto geometry = json.find("geometry");
    good = geometry != json.end() && ShapeReader(feature).read(*geometry);
    return feature;
}

Result<TaggedCollection> collectionOf(const Json& json, const std::string& context,
                                      std::vector<Finding>& findings) {
    auto features = json.is_object() ? json.find("features") : json.end();
    if (features == json.end() || !features->is_array())
        return Error{ErrorCode::UnsupportedFormat, english(Sentence::NoFeatureCollection), context};
    if (features->size() > kMaxFeatures)
        return Error{ErrorCode::Corrupt, english(Sentence::TooManyShapes), context};
    TaggedCollection collection;
    for (const auto& [key, value] : json.items())
        if (value.is_primitive() && !value.is_null()) collection.members[key] = plainText(value);
    Finding broken{Severity::Warning, "source-geometry", Sentence::ShapesNotOnEarth, context, {}};
    for (const Json& one : *features) {
        bool good = false;
        TaggedFeature feature = one.is_object() ? featureOf(one, good) : TaggedFeature();
        if (feature.id.empty()) feature.id = "feature " + std::to_string(&one - &(*features)[0]);
        if (good)
            collection.features.push_back(std::move(feature));
        else
            broken.ids.push_back(feature.id);
    }
    if (!broken.ids.empty()) findings.push_back(std::move(broken));
    return collection;
}

Polyline pointsOf(const OGRSimpleCurve& curve, bool& good) {
    Polyline points;
    for (int i = 0; i < curve.getNumPoints(); ++i) {
        points.push_back({curve.getX(i), curve.getY(i)});
        good = good && isGeographic(points.back());
    }
    return points;
}

} // namespace

const std::string& TaggedFeature::tag(const std::string& key) const {
    static const std::string none;
    auto found = tags.find(key);
    return found == tags.end() ? none : found->second;
}

Result<TaggedCollection> readTaggedGeoJson(const std::string& text, const std::string& context,
                                           std::vector<Finding>& findings) {
    if (tooDeep(text)) return Error{ErrorCode::Corrupt, english(Sentence::JsonTooDeep), context};
    try {
        Json json = Json::parse(text);
        return collectionOf(json, context, findings);
    } catch (const std::exception& failure) {
        return Error{ErrorCode::Corrupt, english(Sentence::JsonDamaged, failure.what()), context};
    }
}

bool isGeographic(Point2 point) {
    return isFinite(point) && std::abs(point.x) <= 180.0 && std::abs(point.y) <= 90.0;
}

bool addShapes(const OGRGeometry& geometry, TaggedFeature& feature) {
    bool good = true;
    switch (wkbFlatten(geometry.getGeometryType())) {
    case wkbPoint: {
        const OGRPoint& point = *geometry.toPoint();
        good = point.IsEmpty() == FALSE && isGeographic({point.getX(), point.getY()});
        feature.points.push_back({point.getX(), point.getY()});
        break;
    }
    case wkbLineString:
        feature.lines.push_back(pointsOf(*geometry.toLineString(), good));
        good = good && feature.lines.back().size() >= 2;
        break;
    case wkbPolygon: {
        Polygon polygon;
        for (const OGRLinearRing* part : *geometry.toPolygon()) {
            Ring ring = pointsOf(*part, good);
            if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
            good = good && ring.size() >= 3;
            if (part == geometry.toPolygon()->getExteriorRing())
                polygon.outer = std::move(ring);
            else
                polygon.holes.push_back(std::move(ring));
        }
        good = good && !polygon.outer.empty();
        feature.polygons.push_back(std::move(polygon));
        break;
    }
    case wkbMultiPoint:
    case wkbMultiLineString:
    case wkbMultiPolygon:
    case wkbGeometryCollection:
        for (const OGRGeometry* part : *geometry.toGeometryCollection())
            good = addShapes(*part, feature) && good;
        break;
    default:
        good = false;
    }
    return good;
}

std::string nameOf(const TaggedFeature& feature, const std::string& language) {
    const std::string& own = language.empty() ? std::string() : feature.tag("name:" + language);
    return own.empty() ? feature.tag("name") : own;
}

Attributes attributesOf(const Tags& tags) {
    Attributes attributes;
    for (const auto& [key, value] : tags) attributes[key] = value;
    return attributes;
}

std::optional<double> plainNumber(const std::string& text) {
    double value = 0.0;
    auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size() ||
        !std::isfinite(value))
        return std::nullopt;
    return value;
}

} // namespace farol::building
