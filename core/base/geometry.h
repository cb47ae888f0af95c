#pragma once
// Plane geometry of the map (x east, y north, metres) and of the picture (x right, y down, pixels, pixel
// centres at +0.5). The two never mix: map functions take Point2, picture functions ImagePoint.

#include "core/base/angle.h"

#include <array>
#include <optional>
#include <vector>

namespace farol {

struct Point2 {
    double x = 0.0;
    double y = 0.0;

    friend constexpr Point2 operator+(Point2 a, Point2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Point2 operator-(Point2 a, Point2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Point2 operator*(Point2 a, double s) { return {a.x * s, a.y * s}; }
    friend constexpr bool operator==(Point2, Point2) = default;
};

double dot(Point2 a, Point2 b);
double cross(Point2 a, Point2 b); ///< z of a x b: positive when b is counter-clockwise of a
double length(Point2 v);
double distance(Point2 a, Point2 b);
Radians directionOf(Point2 v); ///< counter-clockwise from east; 0 for the null vector
bool isFinite(Point2 p);

using Polyline = std::vector<Point2>;
/// Vertices without the closing repeat.
using Ring = std::vector<Point2>;

struct Polygon {
    Ring outer;
    std::vector<Ring> holes;
};

struct Box2 {
    Point2 low;
    Point2 high;

    double width() const { return high.x - low.x; }
    double height() const { return high.y - low.y; }
};

double length(const Polyline& line);
double signedArea(const Ring& ring);     ///< positive when counter-clockwise
double area(const Polygon& polygon);     ///< holes taken off
Point2 centroid(const Polygon& polygon); ///< may lie outside a bent polygon: see pointInside
/// A point that is surely inside: the centroid when it is, else the middle of the widest horizontal chord
/// near it.
Point2 pointInside(const Polygon& polygon);
bool contains(const Polygon& polygon, Point2 p); ///< the border counts as inside
double distanceToSegment(Point2 p, Point2 a, Point2 b);
Point2 nearestOnSegment(Point2 p, Point2 a, Point2 b);
double distanceToPolygon(const Polygon& polygon, Point2 p); ///< 0 inside
std::optional<Box2> boundingBox(const Ring& points);        ///< empty for no points
/// Do the open segments cross at one inner point of both? Touching ends and overlaps are no crossing.
bool segmentsCross(Point2 a, Point2 b, Point2 c, Point2 d);

struct ImagePoint {
    double x = 0.0;
    double y = 0.0;

    friend constexpr bool operator==(ImagePoint, ImagePoint) = default;
};

struct ImageSize {
    int width = 0;
    int height = 0;

    friend constexpr bool operator==(ImageSize, ImageSize) = default;
};

struct ImageBox {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;

    ImagePoint centre() const { return {x + width / 2, y + height / 2}; }
    double area() const { return width * height; }
};

/// Corners clockwise in the picture from the object's own top left.
using Quad = std::array<ImagePoint, 4>;

ImageBox boundingBox(const Quad& quad);
Quad quadOf(const ImageBox& box);
/// Intersection over union of the boxes, 0 when they do not meet.
double overlap(const ImageBox& a, const ImageBox& b);

} // namespace farol
