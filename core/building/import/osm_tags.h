#pragma once
// What OpenStreetMap tags mean for a building: Simple Indoor Tagging, read as KOSMIndoorMap's rules read it.

#include "core/building/import/tagged_feature.h"

#include <optional>
#include <string>

namespace farol::building {

struct RegionRole {
    RegionKind kind = RegionKind::Other;
    std::string kindText;
    bool walled = false; ///< its outline is a wall, but for doors
};

/// Of a polygon that can be walked; empty for walls, furniture, outlines of levels and what is outdoors.
std::optional<RegionRole> osmRegionRole(const TaggedFeature& feature);
/// Of a line that is walked along and has no area of its own.
std::optional<RegionRole> osmWalkRole(const TaggedFeature& feature);
/// A flight of steps or an escalator drawn as a line.
bool isOsmSteps(const TaggedFeature& feature);
/// A way that carries one along its level.
bool isOsmMovingWalkway(const TaggedFeature& feature);
/// The direction in which stairs or a way move: AToB along the way's own direction.
OneWay osmConveying(const TaggedFeature& feature);
bool isOsmLift(const TaggedFeature& feature);
bool isOsmDoor(const TaggedFeature& feature);
bool isOsmEmergencyDoor(const TaggedFeature& feature);
bool isOsmWall(const TaggedFeature& feature);
bool isOsmRestricted(const TaggedFeature& feature);

struct LandmarkRole {
    Kind kind = Kind::Other;
    std::string kindText;
};
std::optional<LandmarkRole> osmLandmarkRole(const TaggedFeature& feature);

} // namespace farol::building
