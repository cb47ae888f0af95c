#include "core/recognition/flow_model.h"

#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace farol::recognition {

namespace {

constexpr double kHeadingRangeX = 0.6, kHeadingRangeY = 0.24;
/// Nearer to the focus of expansion a point hardly moves by walking and tells nothing of it.
constexpr double kMinRadius = 0.08;
/// Who walks obliquely sees the far end of a corridor beside the way: most points may be far beyond the walls
/// that the measure of a step assumes, few are nearer.
constexpr double kNearShare = 0.7;

/// What a small rotation does to a point: flow = rows * rotation vector.
struct RotationRows {
    cv::Vec3d x, y;
};

RotationRows rotationRows(const cv::Point2d& p) {
    return {{p.x * p.y, -(1.0 + p.x * p.x), p.y}, {1.0 + p.y * p.y, -p.x * p.y, -p.x}};
}

/// A hypothesis: the camera moves towards `heading`. Flow across the ray from there is rotation alone,
/// whatever the distances are, so the rotation is a linear fit.
struct Hypothesis {
    cv::Point2d heading;
    cv::Vec3d rotation;
    double cost = std::numeric_limits<double>::infinity();
};

/// Unit vector across the ray from the focus of expansion; the ray itself for points too near to it, which
/// then count in both directions.
struct Ray {
    cv::Point2d along, across;
    double radius = 0.0;
    double side = 0.0; ///< the larger coordinate
};

Ray rayFrom(const cv::Point2d& heading, const cv::Point2d& point) {
    cv::Point2d d = point - heading;
    double radius = std::hypot(d.x, d.y);
    if (radius < 1e-9) return {{1.0, 0.0}, {0.0, 1.0}, 0.0, 0.0};
    double side = std::max(std::abs(d.x), std::abs(d.y));
    return {{d.x / radius, d.y / radius}, {-d.y / radius, d.x / radius}, radius, side};
}

/// What is left of a point's flow without the rotation, along and across its ray.
struct Residual {
    double along = 0.0, across = 0.0;
};

Residual residualOf(const PointFlow& point, const Ray& ray, const cv::Vec3d& rotation) {
    RotationRows rows = rotationRows(point.before);
    cv::Point2d left = point.after - point.before;
    left -= cv::Point2d(rows.x.dot(rotation), rows.y.dot(rotation));
    return {left.dot(ray.along), left.dot(ray.across)};
}

/// How far a point is from the model. `advance` as in FlowFit, of the points in common: people walk forwards,
/// so what comes together instead of spreading, or spreads several times faster than the rest, moves on its
/// own.
double distanceOf(const Residual& left, const Ray& ray, double advance) {
    constexpr double kNearest = 3.0; ///< times nearer than the points in common
    if (ray.radius < kMinRadius) return std::hypot(left.across, left.along);
    double most = kNearest * advance * ray.radius * ray.side;
    double beyond = left.along < 0.0 ? left.along : std::max(0.0, left.along - most);
    return std::hypot(left.across, beyond);
}

double medianOf(std::vector<double>& values) {
    if (values.empty()) return 0.0;
    auto mid = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), mid, values.end());
    return *mid;
}

/// Along a corridor whose walls, floor and ceiling are `d` from the line of walking, a step of length s moves
/// a point by radius * side * s/d, with `side` the larger of both coordinates seen from the focus of
/// expansion: the ratio does not depend on how far away the point is.
double commonAdvance(std::span<const Residual> left, std::span<const Ray> rays) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < left.size(); ++i)
        if (rays[i].radius >= 2.0 * kMinRadius)
            ratios.push_back(left[i].along / (rays[i].radius * rays[i].side));
    return std::max(0.0, medianOf(ratios));
}

/// Weighted normal equations of one re-weighting round; false when the points leave the rotation open.
bool solveRotation(std::span<const PointFlow> points, std::span<const Ray> rays,
                   std::span<const double> weights, cv::Vec3d& rotation) {
    cv::Matx33d normal = cv::Matx33d::eye() * 1e-9;
    cv::Vec3d right(0.0, 0.0, 0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        RotationRows rows = rotationRows(points[i].before);
        cv::Point2d flow = points[i].after - points[i].before;
        cv::Vec3d row = rows.x * rays[i].across.x + rows.y * rays[i].across.y;
        double value = flow.dot(rays[i].across);
        normal += weights[i] * (row * row.t());
        right += weights[i] * value * row;
    }
    bool solved = false;
    cv::Matx33d inverse = normal.inv(cv::DECOMP_CHOLESKY, &solved);
    if (solved) rotation = inverse * right;
    return solved;
}

Hypothesis tryHeading(std::span<const PointFlow> points, const cv::Point2d& heading, const cv::Vec3d& start,
                      const FlowModelOptions& options) {
    constexpr int kRounds = 5;
    std::vector<Ray> rays;
    rays.reserve(points.size());
    for (const PointFlow& point : points) rays.push_back(rayFrom(heading, point.before));
    std::vector<double> weights(points.size());
    std::vector<Residual> left(points.size());
    Hypothesis tried{heading, start};
    auto measure = [&] {
        for (std::size_t i = 0; i < points.size(); ++i)
            left[i] = residualOf(points[i], rays[i], tried.rotation);
        return commonAdvance(left, rays);
    };
    for (int round = 0; round < kRounds; ++round) {
        // Cauchy weights, wide at first: a few people crossing do not pull the fit.
        double scale = options.inlierDistance * (round < 2 ? 4.0 : 1.0), advance = measure();
        for (std::size_t i = 0; i < points.size(); ++i) {
            double r = distanceOf(left[i], rays[i], advance) / scale;
            weights[i] = 1.0 / (1.0 + r * r);
        }
        if (!solveRotation(points, rays, weights, tried.rotation)) return tried;
    }
    tried.cost = 0.0;
    double advance = measure();
    for (std::size_t i = 0; i < points.size(); ++i) {
        double r = distanceOf(left[i], rays[i], advance) / options.inlierDistance;
        tried.cost += std::min(r * r, 9.0);
    }
    // Points on one object err together: a hundred of them are no more than a few witnesses.
    constexpr double kWitnesses = 24.0;
    tried.cost *= std::min(1.0, kWitnesses / static_cast<double>(points.size()));
    double x = heading.x / options.headingSpreadX, y = heading.y / options.headingSpreadY;
    tried.cost += x * x + y * y;
    return tried;
}

/// Where most points went, so that a quick turn does not start the fit among the outliers.
cv::Vec3d roughRotation(std::span<const PointFlow> points) {
    std::vector<double> dx, dy;
    for (const PointFlow& point : points) {
        dx.push_back(point.after.x - point.before.x);
        dy.push_back(point.after.y - point.before.y);
    }
    return {medianOf(dy), -medianOf(dx), 0.0};
}

/// All directions of walking of a grid with `columns` by `rows` steps to either side, best first.
std::vector<Hypothesis> tryHeadings(std::span<const PointFlow> points, const cv::Vec3d& start, int columns,
                                    int rows, const FlowModelOptions& options) {
    std::vector<Hypothesis> all;
    for (int iy = -rows; iy <= rows; ++iy)
        for (int ix = -columns; ix <= columns; ++ix) {
            cv::Point2d heading(kHeadingRangeX * ix / std::max(columns, 1),
                                kHeadingRangeY * iy / std::max(rows, 1));
            all.push_back(tryHeading(points, heading, start, options));
        }
    std::stable_sort(all.begin(), all.end(),
                     [](const Hypothesis& a, const Hypothesis& b) { return a.cost < b.cost; });
    return all;
}

/// The later points as they would be had the camera not turned: exact, so that quick turns are no worse.
std::vector<PointFlow> derotated(std::span<const PointFlow> points, const cv::Vec3d& rotation) {
    cv::Matx33d turn;
    cv::Rodrigues(rotation, turn);
    std::vector<PointFlow> result;
    result.reserve(points.size());
    for (const PointFlow& point : points) {
        cv::Vec3d ray = turn * cv::Vec3d(point.after.x, point.after.y, 1.0);
        double z = std::max(ray[2], 0.1);
        result.push_back({point.before, {ray[0] / z, ray[1] / z}});
    }
    return result;
}

/// The advance of the points in common, for what is to be refused; the fit gets the one of the near points.
double measureAdvance(std::span<const PointFlow> points, const FlowModelOptions& options, FlowFit& fit) {
    std::vector<Ray> rays;
    std::vector<Residual> left;
    for (const PointFlow& point : points) {
        rays.push_back(rayFrom(fit.heading, point.before));
        left.push_back(residualOf(point, rays.back(), {0.0, 0.0, 0.0}));
    }
    double rough = commonAdvance(left, rays), spread = 0.0;
    std::vector<double> ratios;
    std::size_t inliers = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (distanceOf(left[i], rays[i], rough) > options.inlierDistance * 2.0) continue;
        ++inliers;
        if (rays[i].radius < 2.0 * kMinRadius) continue;
        double lever = rays[i].radius * rays[i].side;
        ratios.push_back(left[i].along / lever);
        spread += 1.0 / lever;
    }
    fit.inlierShare = static_cast<double>(inliers) / static_cast<double>(points.size());
    if (ratios.empty()) return 0.0;
    auto count = static_cast<double>(ratios.size());
    auto near = ratios.begin() + static_cast<std::ptrdiff_t>(kNearShare * (count - 1.0));
    std::nth_element(ratios.begin(), near, ratios.end());
    fit.advance = *near;
    fit.advanceNoise = 0.4 * options.inlierDistance * (spread / count) / std::sqrt(count);
    return medianOf(ratios);
}

} // namespace

std::optional<FlowFit> fitFlow(const std::vector<PointFlow>& points, const FlowModelOptions& options) {
    if (static_cast<int>(points.size()) < options.minPoints) return std::nullopt;
    cv::Vec3d start = roughRotation(points);
    Hypothesis first = tryHeadings(points, start, 1, 0, options).front();
    if (!std::isfinite(first.cost)) return std::nullopt;
    // The linear model holds for small turns: take out what was found, exactly, and fit what is left.
    std::vector<PointFlow> still = derotated(points, first.rotation);
    std::vector<Hypothesis> ranked = tryHeadings(still, {0.0, 0.0, 0.0}, 6, 2, options);
    const Hypothesis& best = ranked.front();
    if (!std::isfinite(best.cost)) return std::nullopt;
    for (const Hypothesis& other : ranked) {
        if (other.cost > best.cost + 4.0) break;
        if (std::abs(other.rotation[1] - best.rotation[1]) > options.maxTurnDoubtRad) return std::nullopt;
    }
    FlowFit fit;
    fit.heading = best.heading;
    fit.rotation = first.rotation + best.rotation;
    double common = measureAdvance(derotated(still, best.rotation), options, fit);
    if (fit.inlierShare < options.minInlierShare) return std::nullopt;
    // Nobody walks that far beside where the camera looks, or backwards: something else moves in the view.
    if (std::abs(fit.heading.x) > options.maxHeadingX && common > 3.0 * fit.advanceNoise) return std::nullopt;
    if (common < -std::max(3.0 * fit.advanceNoise, options.inlierDistance)) return std::nullopt;
    return fit;
}

} // namespace farol::recognition
