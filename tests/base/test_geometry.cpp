#include "core/base/geometry.h"
#include "core/base/zone.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace farol {
namespace {

// Real map coordinates: UTM values in millions must not cost precision.
constexpr Point2 kFar{592000.0, 4098000.0};

Polygon shifted(Ring ring, Point2 by) {
    for (Point2& p : ring) p = p + by;
    return {std::move(ring), {}};
}

const Ring kL{{0, 0}, {10, 0}, {10, 2}, {2, 2}, {2, 10}, {0, 10}};

TEST(Polygon, AreaAndCentroidFarFromTheOrigin) {
    Polygon square = shifted({{0, 0}, {4, 0}, {4, 2}, {0, 2}}, kFar);
    EXPECT_NEAR(area(square), 8.0, 1e-9);
    EXPECT_NEAR(distance(centroid(square), kFar + Point2{2, 1}), 0.0, 1e-9);
}

TEST(Polygon, HolesAreTakenOff) {
    Polygon ring{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}}};
    EXPECT_DOUBLE_EQ(area(ring), 12.0);
    EXPECT_FALSE(contains(ring, {2, 2}));
    EXPECT_TRUE(contains(ring, {0.5, 2}));
    EXPECT_TRUE(contains(ring, {1, 2})) << "the border of a hole belongs to the polygon";
    EXPECT_DOUBLE_EQ(distanceToPolygon(ring, {2, 2}), 1.0);
}

TEST(Polygon, APointInsideABentRegionIsInside) {
    Polygon bent = shifted(kL, kFar);
    EXPECT_FALSE(contains(bent, centroid(bent)));
    EXPECT_TRUE(contains(bent, pointInside(bent)));
}

TEST(Polygon, PointInsideARingAroundAHole) {
    Polygon ring{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}}};
    EXPECT_TRUE(contains(ring, pointInside(ring)));
}

TEST(Polygon, DegenerateRingsAnswerSomethingFinite) {
    EXPECT_DOUBLE_EQ(area(Polygon{}), 0.0);
    EXPECT_FALSE(boundingBox(Ring{}).has_value());
    Polygon line{{{0, 0}, {2, 0}, {4, 0}}, {}};
    EXPECT_DOUBLE_EQ(area(line), 0.0);
    EXPECT_TRUE(isFinite(centroid(line)));
    EXPECT_TRUE(isFinite(pointInside(line)));
}

TEST(Segments, CrossOnlyAtInnerPoints) {
    EXPECT_TRUE(segmentsCross({0, 0}, {2, 2}, {0, 2}, {2, 0}));
    EXPECT_FALSE(segmentsCross({0, 0}, {2, 2}, {2, 2}, {3, 0})) << "they only touch";
    EXPECT_FALSE(segmentsCross({0, 0}, {2, 0}, {1, 0}, {3, 0})) << "they overlap";
    EXPECT_DOUBLE_EQ(distanceToSegment({1, 1}, {0, 0}, {0, 0}), std::sqrt(2.0)) << "a segment of no length";
}

TEST(Angles, WrapToHalfOpenTurn) {
    EXPECT_NEAR(toDegrees(wrapped(fromDegrees(270))), -90.0, 1e-9);
    EXPECT_NEAR(toDegrees(wrapped(fromDegrees(-180))), 180.0, 1e-9);
    EXPECT_NEAR(toDegrees(wrapped(fromDegrees(725))), 5.0, 1e-9);
    EXPECT_TRUE(std::isnan(wrapped({std::numeric_limits<double>::quiet_NaN()}).value));
    EXPECT_NEAR(toDegrees(directionOf({0, 3})), 90.0, 1e-9)
        << "north is 90 degrees counter-clockwise from east";
}

TEST(Boxes, OverlapIsIntersectionOverUnion) {
    EXPECT_DOUBLE_EQ(overlap({0, 0, 2, 2}, {1, 0, 2, 2}), 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(overlap({0, 0, 2, 2}, {2, 0, 2, 2}), 0.0);
    EXPECT_DOUBLE_EQ(overlap({0, 0, 0, 0}, {0, 0, 0, 0}), 0.0);
}

TEST(Zones, ThirdsOfThePicture) {
    ImageSize size{640, 480};
    EXPECT_EQ(zoneName(zoneOf({10, 470}, size)), "left-down");
    EXPECT_EQ(zoneName(zoneOf({320, 240}, size)), "centre");
    EXPECT_EQ(zoneName(zoneOf({640.0 * 2 / 3, 0}, size)), "right-up")
        << "a border belongs to the right and lower zone";
    EXPECT_EQ(zoneName(zoneOf({-50, 900}, size)), "left-down") << "outside counts to the nearest";
}

} // namespace
} // namespace farol
