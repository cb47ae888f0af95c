#include "core/routing/walking_space.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace farol::routing {
namespace {

constexpr Point2 kUtm{592000.0, 4098000.0}; // maps lie far from their origin

Polygon shifted(Polygon polygon) {
    for (Point2& p : polygon.outer) p = p + kUtm;
    for (Ring& hole : polygon.holes)
        for (Point2& p : hole) p = p + kUtm;
    return polygon;
}

double walked(const Polygon& polygon, Point2 a, Point2 b) {
    WalkingSpace space(shifted(polygon));
    auto tree = space.from(a + kUtm);
    double told = space.lengthTo(tree, b + kUtm);
    EXPECT_NEAR(length(space.pathTo(tree, b + kUtm)), told, 1e-6);
    return told;
}

const Polygon kSquare{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}};
const Polygon kEll{{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}}, {}};
const Polygon kColumn{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {6, 4}, {6, 6}, {4, 6}}}};

TEST(WalkingSpace, straightWhereNothingIsInTheWay) {
    EXPECT_NEAR(walked(kSquare, {1, 1}, {4, 5}), 5.0, 1e-9);
    EXPECT_NEAR(walked(kSquare, {0, 5}, {10, 5}), 10.0, 1e-9) << "from wall to wall";
    EXPECT_NEAR(walked(kSquare, {0, 0}, {0, 10}), 10.0, 1e-9) << "along a wall";
    EXPECT_EQ(walked(kSquare, {3, 3}, {3, 3}), 0.0);
}

TEST(WalkingSpace, roundTheInnerCornerOfAnL) {
    EXPECT_NEAR(walked(kEll, {1, 9}, {9, 1}), std::hypot(3, 5) * 2.0, 1e-9);
    Polygon clockwise = kEll;
    std::reverse(clockwise.outer.begin(), clockwise.outer.end());
    EXPECT_NEAR(walked(clockwise, {1, 9}, {9, 1}), std::hypot(3, 5) * 2.0, 1e-9);
    EXPECT_NEAR(walked(kEll, {4, 10}, {10, 4}), 12.0, 1e-9) << "along both walls, touching the corner";
}

TEST(WalkingSpace, roundAColumn) {
    double round = std::hypot(3, 1) + 2.0 + std::hypot(3, 1);
    EXPECT_NEAR(walked(kColumn, {1, 5}, {9, 5}), round, 1e-9);
    EXPECT_NEAR(walked(kColumn, {1, 4}, {9, 4}), 8.0, 1e-9) << "along its side";
    EXPECT_NEAR(walked(kColumn, {1, 1}, {4, 4}), std::hypot(3, 3), 1e-9);
}

TEST(WalkingSpace, aDoorInAThickWallIsReachedFromTheBorder) {
    EXPECT_NEAR(walked(kSquare, {-0.1, 5}, {5, 5}), 5.1, 1e-9);
    EXPECT_NEAR(walked(kSquare, {-0.1, 5}, {10.1, 5}), 10.2, 1e-9);
}

TEST(WalkingSpace, neverThroughAThinWall) {
    // A wall 5 cm thick that stands into the room.
    Polygon split{{{0, 0}, {5, 0}, {5, 8}, {5.05, 8}, {5.05, 0}, {10, 0}, {10, 10}, {0, 10}}, {}};
    double over = std::hypot(1, 7) + 0.05 + std::hypot(0.95, 7);
    EXPECT_NEAR(walked(split, {4, 1}, {6, 1}), over, 1e-9);
}

TEST(WalkingSpace, brokenPolygonsGiveStraightLines) {
    EXPECT_NEAR(walked({}, {0, 0}, {3, 4}), 5.0, 1e-9);
    EXPECT_NEAR(walked({{{1, 1}}, {}}, {0, 0}, {3, 4}), std::sqrt(2.0) + std::hypot(2, 3), 1e-6);
    Polygon bow{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {}};
    EXPECT_GT(walked(bow, {1, 5}, {9, 5}), 7.9);
}

TEST(WalkingSpace, atLeastTheStraightLineAndTheSameBothWays) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(0.0, 10.0);
    Polygon comb{{{0, 0},
                  {10, 0},
                  {10, 10},
                  {8, 10},
                  {8, 2},
                  {6, 2},
                  {6, 10},
                  {4, 10},
                  {4, 2},
                  {2, 2},
                  {2, 10},
                  {0, 10}},
                 {{{4.5, 0.5}, {5.5, 0.5}, {5.5, 1.5}, {4.5, 1.5}}}};
    for (int i = 0; i < 200; ++i) {
        Point2 a{anywhere(random), anywhere(random)};
        Point2 b{anywhere(random), anywhere(random)};
        if (!contains(comb, a) || !contains(comb, b)) continue;
        double there = walked(comb, a, b);
        EXPECT_GE(there, distance(a, b) - 1e-9);
        EXPECT_NEAR(there, walked(comb, b, a), 1e-6);
        WalkingSpace space(comb);
        Polyline path = space.pathTo(space.from(a), b);
        for (std::size_t k = 1; k < path.size(); ++k)
            for (int s = 1; s < 20; ++s)
                EXPECT_LT(distanceToPolygon(comb, path[k - 1] + (path[k] - path[k - 1]) * (s / 20.0)), 1e-6);
    }
}

} // namespace
} // namespace farol::routing
