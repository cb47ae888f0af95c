#include "core/building/import/indoorgml_geometry.h"

#include "core/base/ogr.h"
#include "core/building/import/local_plane.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace farol::building {

namespace {

constexpr double kFlatM = 0.05; ///< a face that differs by less in height is horizontal
constexpr double kOneFloorM = 0.4;
constexpr double kLeastAreaM2 = 0.01;

std::size_t dimensionOf(const XmlNode& node, std::size_t inherited) {
    std::string told = node.attribute("srsdimension");
    if (told == "2") return 2;
    if (told == "3") return 3;
    return inherited;
}

std::pair<double, double> heights(const Line3& ring) {
    double low = 0.0, high = 0.0;
    bool any = false;
    for (const Point3& point : ring) {
        double z = point.z.value_or(0.0);
        low = any ? std::min(low, z) : z;
        high = any ? std::max(high, z) : z;
        any = true;
    }
    return {low, high};
}

Ring flat(const Line3& line) {
    Ring ring;
    for (const Point3& point : line)
        if (ring.empty() || !(ring.back() == Point2{point.x, point.y})) ring.push_back({point.x, point.y});
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

Polygon flat(const std::vector<Line3>& rings) {
    Polygon polygon;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        Ring ring = flat(rings[i]);
        if (i == 0)
            polygon.outer = std::move(ring);
        else if (ring.size() >= 3)
            polygon.holes.push_back(std::move(ring));
    }
    return polygon;
}

} // namespace

void GmlGeometry::append(const std::string& text, std::size_t dimension, Line3& points) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* end = at + text.size();
    while (at != end) {
        if (*at == ' ' || *at == '\t' || *at == '\n' || *at == '\r' || *at == ',') {
            ++at;
            continue;
        }
        double value = 0.0;
        auto read = std::from_chars(*at == '+' ? at + 1 : at, end, value);
        if (read.ec != std::errc() || !std::isfinite(value) || std::abs(value) > 1e9) {
            m_good = false;
            return;
        }
        numbers.push_back(value);
        at = read.ptr;
    }
    if (dimension == 0) dimension = numbers.size() % 3 == 0 ? 3 : 2;
    if (numbers.size() % dimension != 0) m_good = false;
    for (std::size_t i = 0; i + dimension <= numbers.size() && m_good; i += dimension) {
        Point3 point{numbers[i], numbers[i + 1], {}};
        if (m_swapped) std::swap(point.x, point.y);
        if (dimension == 3) point.z = numbers[i + 2];
        points.push_back(point);
    }
}

Line3 GmlGeometry::coordinates(const XmlNode& node, std::size_t dimension) {
    Line3 points;
    for (const XmlNode& child : node.children) {
        std::size_t own = dimensionOf(child, dimensionOf(node, dimension));
        if (child.name == "pos" || child.name == "poslist" || child.name == "coordinates")
            append(child.text, own, points);
        else if (child.name == "pointproperty" || child.name == "point")
            for (Point3 point : coordinates(child, own)) points.push_back(point);
    }
    return points;
}

Line3 GmlGeometry::line(const XmlNode& geometry, std::size_t dimension) {
    m_good = true;
    std::size_t own = dimensionOf(geometry, dimension);
    Line3 points = coordinates(geometry, own);
    if (!m_good) return {};
    if (!points.empty()) return points;
    for (const XmlNode& child : geometry.children)
        if (Line3 found = line(child, own); !found.empty()) return found;
    return {};
}

void GmlGeometry::collectFaces(const XmlNode& node, std::size_t dimension, int hops,
                               std::vector<Face>& faces) {
    if (m_budget == 0) return;
    --m_budget;
    dimension = dimensionOf(node, dimension);
    std::string reference = node.attribute("href");
    if (reference.size() > 1 && reference[0] == '#' && hops < 2) {
        auto found = m_index.find(reference.substr(1));
        if (found != m_index.end()) collectFaces(*found->second, dimension, hops + 1, faces);
    }
    if (node.name != "polygon" && node.name != "polygonpatch" && node.name != "rectangle" &&
        node.name != "triangle") {
        for (const XmlNode& child : node.children) collectFaces(child, dimension, hops, faces);
        return;
    }
    Face face;
    for (const XmlNode& border : node.children) {
        if (border.name != "exterior" && border.name != "interior" && border.name != "outerboundaryis" &&
            border.name != "innerboundaryis")
            continue;
        Line3 ring = line(border, dimension);
        bool outer = border.name == "exterior" || border.name == "outerboundaryis";
        if (outer)
            face.rings.insert(face.rings.begin(), std::move(ring));
        else
            face.rings.push_back(std::move(ring));
    }
    if (!face.rings.empty() && face.rings.front().size() >= 3) faces.push_back(std::move(face));
}

std::optional<Footprint> GmlGeometry::footprint(const XmlNode& geometry) {
    std::vector<Face> faces;
    collectFaces(geometry, 0, 0, faces);
    auto isFlat = [](const Face& face) {
        auto [low, high] = heights(face.rings.front());
        return high - low < kFlatM;
    };
    bool anyFlat = std::any_of(faces.begin(), faces.end(), isFlat);
    std::optional<double> lowest;
    for (const Face& face : faces) {
        double low = heights(face.rings.front()).first;
        if (anyFlat && !isFlat(face)) continue;
        lowest = lowest ? std::min(*lowest, low) : low;
    }
    std::vector<GeometryPtr> parts;
    Footprint result;
    double largest = 0.0;
    for (const Face& face : faces) {
        double low = heights(face.rings.front()).first;
        if (anyFlat && (!isFlat(face) || low > *lowest + kOneFloorM)) continue;
        Polygon seen = flat(face.rings);
        double size = std::abs(signedArea(seen.outer));
        if (seen.outer.size() < 3 || size <= 0.0) continue; // a wall, seen from above
        if (size > largest && face.rings.front().front().z) result.z = low;
        largest = std::max(largest, size);
        if (auto part = ogrPolygon(seen)) parts.push_back(std::move(part));
    }
    GdalMessages quiet;
    GeometryPtr joined = unionOf(parts);
    std::vector<Polygon> polygons = polygonsOf(joined.get(), 0.0);
    if (polygons.empty()) return std::nullopt;
    auto bigger = [](const Polygon& a, const Polygon& b) { return area(a) < area(b); };
    result.polygon = *std::max_element(polygons.begin(), polygons.end(), bigger);
    auto& holes = result.polygon.holes; // slivers between faces that nearly meet
    holes.erase(std::remove_if(holes.begin(), holes.end(),
                               [](const Ring& hole) { return std::abs(signedArea(hole)) < kLeastAreaM2; }),
                holes.end());
    return result;
}

} // namespace farol::building
