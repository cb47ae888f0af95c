#include "core/building/access_regions.h"

#include "core/building/level_regions.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace farol::building {

namespace {

constexpr double kReachM = 0.3;

using Sides = std::pair<RegionId, RegionId>;

/// The regions of a map and where they lie.
struct Plan {
    const std::vector<Region>& regions;
    LevelRegions index;
};

RegionId regionAt(const Plan& plan, Point2 point, double level) {
    auto found = plan.index.at(level, point);
    return found ? plan.regions[*found].id : RegionId();
}

/// The direction of the line where its midpoint lies.
Point2 directionAtMiddle(const Polyline& line, Point2 middle) {
    Point2 direction = line.back() - line.front();
    double nearest = kReachM;
    for (std::size_t i = 1; i < line.size(); ++i) {
        double gap = distanceToSegment(middle, line[i - 1], line[i]);
        if (gap >= nearest || line[i] == line[i - 1]) continue;
        nearest = gap;
        direction = line[i] - line[i - 1];
    }
    return direction;
}

Sides besideLine(const Plan& plan, const Access& access) {
    Point2 middle = access.midpoint();
    Point2 along = directionAtMiddle(access.line, middle);
    Point2 left = Point2{-along.y, along.x} * (kReachM / length(along));
    return {regionAt(plan, middle + left, access.level), regionAt(plan, middle - left, access.level)};
}

Sides aroundPoint(const Plan& plan, const Access& access) {
    std::vector<std::pair<double, const Region*>> near;
    Box2 box = grown({access.midpoint(), access.midpoint()}, kReachM);
    for (std::size_t at : plan.index.meeting(access.level, box)) {
        const Region& region = plan.regions[at];
        if (region.polygon.outer.size() < 3) continue;
        double gap = distanceToPolygon(region.polygon, access.midpoint());
        if (gap <= kReachM) near.emplace_back(gap, &region);
    }
    std::stable_sort(near.begin(), near.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    // Where a third region is as near as the second, which two are meant is a guess.
    if (near.size() > 2 && near[2].first < near[1].first + 0.05) return {};
    return {near.empty() ? RegionId() : near[0].second->id,
            near.size() < 2 ? RegionId() : near[1].second->id};
}

} // namespace

void deriveAccessRegions(BuildingData& data) {
    Plan plan{data.regions, LevelRegions(data.regions)};
    for (Access& access : data.accesses) {
        if ((!access.regionA.empty() && !access.regionB.empty()) || access.line.empty()) continue;
        // Stairs and lifts that name one side lead to another level from there, and which one is not drawn.
        bool oneSide = !access.regionA.empty() || !access.regionB.empty();
        if (access.changesLevel() && oneSide) continue;
        bool isLine = access.line.size() > 1 && access.line.front() != access.line.back();
        auto [first, second] = isLine ? besideLine(plan, access) : aroundPoint(plan, access);
        if (first == second) second = RegionId();
        if (access.regionA.empty() && access.regionB.empty()) {
            access.regionA = first;
            access.regionB = second;
        } else {
            RegionId& known = access.regionA.empty() ? access.regionB : access.regionA;
            RegionId& open = access.regionA.empty() ? access.regionA : access.regionB;
            if (first != known && second == known)
                open = first;
            else if (first == known)
                open = second;
        }
    }
}

} // namespace farol::building
