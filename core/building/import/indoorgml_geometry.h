#pragma once
// Footprints and lines of IndoorGML: GML surfaces in space, seen from above.

#include "core/base/geometry.h"
#include "core/building/import/indoorgml_xml.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace farol::building {

struct Point3 {
    double x = 0.0, y = 0.0;
    std::optional<double> z;
};
using Line3 = std::vector<Point3>;

struct Footprint {
    Polygon polygon;
    std::optional<double> z; ///< of the floor
};

/// Elements by gml:id, for references inside the document.
using XmlIndex = std::map<std::string, const XmlNode*>;

/// Reads coordinates with a budget for the whole document, so that references cannot multiply it.
class GmlGeometry {
public:
    GmlGeometry(const XmlIndex& index, bool swapped) : m_index(index), m_swapped(swapped) {}

    /// Of a solid: its lowest horizontal faces (steps up to 0.4 m are one floor); of surfaces: all, from
    /// above.
    std::optional<Footprint> footprint(const XmlNode& geometry);
    /// The coordinates of the first point or line under the element; empty when there are none or one is no
    /// number.
    Line3 line(const XmlNode& geometry, std::size_t dimension = 0);

private:
    struct Face {
        std::vector<Line3> rings;
    };

    void collectFaces(const XmlNode& node, std::size_t dimension, int hops, std::vector<Face>& faces);
    Line3 coordinates(const XmlNode& node, std::size_t dimension);
    void append(const std::string& text, std::size_t dimension, Line3& points);

    const XmlIndex& m_index;
    bool m_swapped; ///< the CRS has latitude or northing first
    std::size_t m_budget = 200000;
    bool m_good = true;
};

} // namespace farol::building
