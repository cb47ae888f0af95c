#include "core/building/import/strips.h"

#include "core/base/ogr.h"
#include "core/building/import/local_plane.h"

#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

namespace farol::building {

Point2 unitVector(Point2 v) {
    double size = length(v);
    return size > 0.0 ? v * (1.0 / size) : Point2{};
}

std::pair<Polyline, Point2> firstHalf(const Polyline& line) {
    double rest = length(line) / 2;
    Polyline half{line.front()};
    for (std::size_t i = 1; i < line.size(); ++i) {
        double step = distance(line[i - 1], line[i]);
        Point2 along = unitVector(line[i] - line[i - 1]);
        if (step >= rest) {
            half.push_back(line[i - 1] + along * rest);
            return {half, along};
        }
        rest -= step;
        half.push_back(line[i]);
    }
    return {half, unitVector(line.back() - line.front())};
}

Polygon octagon(Point2 at, double radius) {
    Polygon polygon;
    for (int k = 0; k < 8; ++k) {
        double angle = (k + 0.5) * 3.14159265358979323846 / 4;
        polygon.outer.push_back(at + Point2{std::cos(angle), std::sin(angle)} * radius);
    }
    return polygon;
}

void appendStrip(const Polyline& line, double halfWidth, std::vector<Polygon>& strips) {
    for (std::size_t i = 1; i < line.size(); ++i) {
        Point2 along = unitVector(line[i] - line[i - 1]);
        Point2 side = Point2{-along.y, along.x} * halfWidth;
        if (length(along) <= 0.0) continue;
        strips.push_back({{line[i - 1] - side, line[i] - side, line[i] + side, line[i - 1] + side}, {}});
        if (i > 1) strips.push_back(octagon(line[i - 1], halfWidth));
    }
}

std::optional<Polygon> joinedStrips(const std::vector<Polygon>& strips) {
    GdalMessages quiet;
    std::vector<GeometryPtr> parts;
    for (const Polygon& strip : strips)
        if (auto part = ogrPolygon(strip)) parts.push_back(std::move(part));
    GeometryPtr joined = unionOf(parts);
    std::vector<Polygon> polygons = polygonsOf(joined.get(), 0.0);
    if (polygons.empty()) return std::nullopt;
    auto smaller = [](const Polygon& a, const Polygon& b) { return area(a) < area(b); };
    return *std::max_element(polygons.begin(), polygons.end(), smaller);
}

} // namespace farol::building
