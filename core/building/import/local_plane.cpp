#include "core/building/import/local_plane.h"

#include "core/base/ogr.h"

#include <ogrsf_frmts.h>

#include <cmath>

namespace farol::building {

namespace {

constexpr double kMetresPerDegree = 111319.490793; // of the equator of WGS 84
constexpr double kPi = 3.14159265358979323846;

Ring ringOf(const OGRLinearRing& ring) {
    Ring points;
    for (int i = 0; i + 1 < ring.getNumPoints(); ++i) points.push_back({ring.getX(i), ring.getY(i)});
    return points;
}

void addRing(OGRPolygon& polygon, const Ring& points) {
    OGRLinearRing ring;
    for (Point2 point : points) ring.addPoint(point.x, point.y);
    ring.closeRings();
    polygon.addRing(&ring);
}

} // namespace

LocalPlane::LocalPlane(Point2 centreDegrees)
    : m_centre(centreDegrees),
      m_metresPerDegreeX(kMetresPerDegree * std::max(0.001, std::cos(centreDegrees.y * kPi / 180.0))),
      m_metresPerDegreeY(kMetresPerDegree) {}

Point2 LocalPlane::toMetres(Point2 degrees) const {
    return {(degrees.x - m_centre.x) * m_metresPerDegreeX, (degrees.y - m_centre.y) * m_metresPerDegreeY};
}

Point2 LocalPlane::toDegrees(Point2 metres) const {
    return {metres.x / m_metresPerDegreeX + m_centre.x, metres.y / m_metresPerDegreeY + m_centre.y};
}

void LocalPlane::toDegrees(BuildingData& data) const {
    auto each = [this](std::vector<Point2>& points) {
        for (Point2& point : points) point = toDegrees(point);
    };
    for (Region& region : data.regions) {
        each(region.polygon.outer);
        for (Ring& hole : region.polygon.holes) each(hole);
    }
    for (Access& access : data.accesses) each(access.line);
    for (Wall& wall : data.walls) each(wall.line);
    for (Landmark& landmark : data.landmarks) landmark.position = toDegrees(landmark.position);
}

void GeometryDeleter::operator()(OGRGeometry* geometry) const {
    OGRGeometryFactory::destroyGeometry(geometry);
}

GeometryPtr ogrPolygon(const Polygon& polygon) {
    if (polygon.outer.size() < 3) return nullptr;
    GdalMessages messages;
    auto made = std::make_unique<OGRPolygon>();
    addRing(*made, polygon.outer);
    for (const Ring& hole : polygon.holes)
        if (hole.size() >= 3) addRing(*made, hole);
    GeometryPtr geometry(made.release());
    if (geometry->IsValid() == FALSE) geometry.reset(geometry->MakeValid());
    return geometry;
}

GeometryPtr ogrLine(const Polyline& line) {
    auto made = std::make_unique<OGRLineString>();
    for (Point2 point : line) made->addPoint(point.x, point.y);
    return GeometryPtr(made.release());
}

GeometryPtr unionOf(const std::vector<GeometryPtr>& parts) {
    GdalMessages messages;
    OGRMultiPolygon all;
    for (const GeometryPtr& part : parts)
        for (const Polygon& polygon : polygonsOf(part.get(), 0.0)) {
            GeometryPtr one = ogrPolygon(polygon);
            if (one != nullptr && wkbFlatten(one->getGeometryType()) == wkbPolygon)
                all.addGeometry(one.get());
        }
    return all.IsEmpty() ? nullptr : GeometryPtr(all.UnionCascaded());
}

std::vector<Polygon> polygonsOf(const OGRGeometry* geometry, double leastArea) {
    std::vector<Polygon> polygons;
    if (geometry == nullptr) return polygons;
    OGRwkbGeometryType type = wkbFlatten(geometry->getGeometryType());
    if (type == wkbPolygon) {
        const OGRPolygon& source = *geometry->toPolygon();
        if (source.IsEmpty() == FALSE && source.get_Area() >= leastArea) {
            Polygon polygon{ringOf(*source.getExteriorRing()), {}};
            for (int i = 0; i < source.getNumInteriorRings(); ++i)
                polygon.holes.push_back(ringOf(*source.getInteriorRing(i)));
            polygons.push_back(std::move(polygon));
        }
    } else if (type == wkbMultiPolygon || type == wkbGeometryCollection) {
        for (const OGRGeometry* part : *geometry->toGeometryCollection())
            for (Polygon& polygon : polygonsOf(part, leastArea)) polygons.push_back(std::move(polygon));
    }
    return polygons;
}

} // namespace farol::building
