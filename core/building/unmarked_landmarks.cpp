#include "core/building/unmarked_landmarks.h"

#include "core/base/geometry.h"

#include <algorithm>

namespace farol::building {

namespace {

constexpr double kSameDoorM = 1.0, kUsualWidthM = 0.9, kTallM = 2.0;
constexpr double kSameStairsM = 2.0, kUsualStairsWidthM = 1.5, kStairsTallM = 1.0;
constexpr double kLeastLineM = 0.2; ///< a shorter one does not tell how the door stands
constexpr double kIntoRegionM = 0.3;

bool isMarked(const Building& building, std::size_t region, Kind kind, Point2 at, double withinM) {
    return std::any_of(building.landmarksOf(region).begin(), building.landmarksOf(region).end(),
                       [&](std::size_t index) {
                           const Landmark& each = building.landmarks()[index];
                           return each.kind == kind && distance(each.position, at) <= withinM;
                       });
}

/// Across the access, into the region.
std::optional<Radians> facing(const Access& access, const Region& region) {
    if (access.line.size() < 2) return std::nullopt;
    Point2 along = access.line.back() - access.line.front();
    double size = length(along);
    if (size < kLeastLineM) return std::nullopt;
    Point2 across{-along.y / size, along.x / size};
    for (double side : {1.0, -1.0}) {
        Point2 inside = access.midpoint() + across * (side * kIntoRegionM);
        if (contains(region.polygon, inside)) return directionOf(across * side);
    }
    return std::nullopt;
}

bool isFlight(const Access& access) {
    return access.kind == AccessKind::Stairs || access.kind == AccessKind::Escalator;
}

Landmark markAt(const Access& access, const Region& region, Kind kind, double tallM, double usualWidthM) {
    Landmark mark;
    mark.id = LandmarkId(access.id.value + " from " + region.id.value);
    mark.kind = kind;
    mark.region = region.id;
    mark.level = region.level;
    mark.position = access.midpoint();
    mark.heightM = tallM / 2.0;
    mark.tallM = tallM;
    mark.widthM = access.widthM.value_or(usualWidthM);
    return mark;
}

} // namespace

std::vector<Landmark> unmarkedDoors(const Building& building) {
    std::vector<Landmark> doors;
    for (const Access& access : building.accesses()) {
        if (access.kind != AccessKind::Door || access.line.empty() || !access.passable()) continue;
        for (const RegionId& id : {access.regionA, access.regionB}) {
            auto index = building.regionIndex(id);
            if (!index || isMarked(building, *index, Kind::Door, access.midpoint(), kSameDoorM)) continue;
            const Region& region = building.regions()[*index];
            doors.push_back(markAt(access, region, Kind::Door, kTallM, kUsualWidthM));
            doors.back().heading = facing(access, region);
        }
    }
    return doors;
}

std::vector<Landmark> unmarkedStairs(const Building& building) {
    std::vector<Landmark> stairs;
    for (const Access& access : building.accesses()) {
        if (!isFlight(access) || access.line.empty() || !access.passable()) continue;
        for (const RegionId& id : {access.regionA, access.regionB}) {
            auto index = building.regionIndex(id);
            if (!index || isMarked(building, *index, Kind::Stairs, access.midpoint(), kSameStairsM)) continue;
            stairs.push_back(
                markAt(access, building.regions()[*index], Kind::Stairs, kStairsTallM, kUsualStairsWidthM));
        }
    }
    return stairs;
}

} // namespace farol::building
