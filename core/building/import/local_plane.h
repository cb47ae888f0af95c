#pragma once
// Metres around a place, for importers that must measure while they still read degrees; and GEOS, through
// OGR, on plain polygons.

#include "core/base/geometry.h"
#include "core/building/building.h"

#include <memory>
#include <vector>

class OGRGeometry;

namespace farol::building {

/// An equirectangular plane. True to a centimetre over a building, which is all that widths and gaps need.
class LocalPlane {
public:
    explicit LocalPlane(Point2 centreDegrees);
    Point2 toMetres(Point2 degrees) const;
    Point2 toDegrees(Point2 metres) const;
    /// Every coordinate of the building, in place.
    void toDegrees(BuildingData& data) const;

private:
    Point2 m_centre;
    double m_metresPerDegreeX, m_metresPerDegreeY;
};

struct GeometryDeleter {
    void operator()(OGRGeometry* geometry) const;
};
using GeometryPtr = std::unique_ptr<OGRGeometry, GeometryDeleter>;

/// A valid geometry of the polygon (mended when it crosses itself); null when nothing is left of it.
GeometryPtr ogrPolygon(const Polygon& polygon);
GeometryPtr ogrLine(const Polyline& line);
GeometryPtr unionOf(const std::vector<GeometryPtr>& parts); ///< null for none
/// The polygons of any geometry, those under `leastArea` left out.
std::vector<Polygon> polygonsOf(const OGRGeometry* geometry, double leastArea);

} // namespace farol::building
