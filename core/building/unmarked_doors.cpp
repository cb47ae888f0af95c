#include "core/building/unmarked_doors.h"

#include "core/base/geometry.h"

#include <algorithm>

namespace farol::building {

namespace {

constexpr double kSameDoorM = 1.0, kUsualWidthM = 0.9, kTallM = 2.0;
constexpr double kLeastLineM = 0.2; ///< a shorter one does not tell how the door stands
constexpr double kIntoRegionM = 0.3;

bool isMarked(const Building& building, std::size_t region, Point2 at) {
    return std::any_of(building.landmarksOf(region).begin(), building.landmarksOf(region).end(),
                       [&](std::size_t index) {
                           const Landmark& each = building.landmarks()[index];
                           return each.kind == Kind::Door && distance(each.position, at) <= kSameDoorM;
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

} // namespace

std::vector<Landmark> unmarkedDoors(const Building& building) {
    std::vector<Landmark> doors;
    for (const Access& access : building.accesses()) {
        if (access.kind != AccessKind::Door || access.line.empty() || access.changesLevel() ||
            !access.passable())
            continue;
        for (const RegionId& id : {access.regionA, access.regionB}) {
            auto index = building.regionIndex(id);
            if (!index || isMarked(building, *index, access.midpoint())) continue;
            const Region& region = building.regions()[*index];
            Landmark door;
            door.id = LandmarkId(access.id.value + " from " + id.value);
            door.kind = Kind::Door;
            door.region = id;
            door.level = region.level;
            door.heading = facing(access, region);
            door.position = access.midpoint();
            door.heightM = kTallM / 2.0;
            door.tallM = kTallM;
            door.widthM = access.widthM.value_or(kUsualWidthM);
            doors.push_back(std::move(door));
        }
    }
    return doors;
}

} // namespace farol::building
