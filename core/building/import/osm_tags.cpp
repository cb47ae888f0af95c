#include "core/building/import/osm_tags.h"

#include <algorithm>
#include <initializer_list>

namespace farol::building {

namespace {

bool isOne(const TaggedFeature& feature, const char* key, std::initializer_list<const char*> values) {
    const std::string& value = feature.tag(key);
    return std::any_of(values.begin(), values.end(), [&value](const char* one) { return value == one; });
}

bool isStairwell(const TaggedFeature& feature) {
    return feature.is("stairs", "yes") || isOne(feature, "room", {"stairs", "steps", "staircase"}) ||
           isOsmSteps(feature);
}

bool isFurniture(const TaggedFeature& feature) {
    return isOne(feature, "amenity",
                 {"vending_machine", "bench", "atm", "waste_basket", "clock", "ticket_validator"});
}

std::optional<RegionRole> roomRole(const TaggedFeature& feature) {
    bool toilet =
        isOne(feature, "room", {"toilet", "toilets", "bathroom"}) || feature.is("amenity", "toilets");
    if (toilet) return RegionRole{RegionKind::Toilet, "", true};
    if (isOne(feature, "room", {"hall", "entrance", "lobby", "auditorium"}))
        return RegionRole{RegionKind::Hall, "", true};
    if (feature.is("room", "corridor")) return RegionRole{RegionKind::Corridor, "", true};
    return RegionRole{RegionKind::Room, "", true};
}

} // namespace

std::optional<RegionRole> osmRegionRole(const TaggedFeature& feature) {
    const std::string& indoor = feature.tag("indoor");
    if (isOne(feature, "indoor", {"wall", "level", "column", "door", "no"}) || isFurniture(feature))
        return std::nullopt;
    if (isOsmLift(feature) || feature.is("room", "elevator"))
        return RegionRole{RegionKind::Elevator, "", true};
    bool inside = !indoor.empty() || feature.has("room");
    if (isStairwell(feature) && (inside || feature.has("level")))
        return RegionRole{RegionKind::Stairwell, "", indoor == "room"};
    if (indoor == "room" || feature.has("room")) return roomRole(feature);
    if (indoor == "corridor") return RegionRole{RegionKind::Corridor, "", false};
    if (indoor == "area") return RegionRole{RegionKind::Hall, "", false};
    bool walked = isOne(feature, "highway", {"footway", "pedestrian", "corridor", "path"});
    if (walked && !feature.is("area", "yes")) return std::nullopt; // a ring that one walks round
    if (indoor == "yes") return RegionRole{RegionKind::Hall, "", false};
    if (!feature.has("level")) return std::nullopt;
    if (feature.is("railway", "platform") || feature.is("public_transport", "platform"))
        return RegionRole{RegionKind::Other, "platform", false};
    bool area = walked || isOne(feature, "area:highway", {"footway", "pedestrian"});
    return area ? std::optional(RegionRole{RegionKind::Hall, "", false}) : std::nullopt;
}

std::optional<RegionRole> osmWalkRole(const TaggedFeature& feature) {
    bool inside = feature.has("level") || (feature.has("indoor") && !feature.is("indoor", "no"));
    bool corridor = feature.is("highway", "corridor") || feature.is("indoor", "corridor");
    bool walked = isOne(feature, "highway", {"footway", "pedestrian", "path"});
    if (!corridor && !(walked && inside)) return std::nullopt;
    return RegionRole{RegionKind::Corridor, "", false};
}

bool isOsmMovingWalkway(const TaggedFeature& feature) {
    return osmWalkRole(feature) && feature.has("conveying") && !feature.is("conveying", "no");
}

OneWay osmConveying(const TaggedFeature& feature) {
    bool moving = feature.has("conveying") && !feature.is("conveying", "no");
    if (feature.is("conveying", "forward") || (moving && isOne(feature, "oneway", {"yes", "1"})))
        return OneWay::AToB;
    if (feature.is("conveying", "backward") || (moving && feature.is("oneway", "-1"))) return OneWay::BToA;
    return OneWay::No;
}

bool isOsmSteps(const TaggedFeature& feature) {
    return feature.is("highway", "steps");
}

bool isOsmLift(const TaggedFeature& feature) {
    return feature.is("highway", "elevator") || feature.is("building:part", "elevator");
}

bool isOsmEmergencyDoor(const TaggedFeature& feature) {
    return feature.is("entrance", "emergency") || feature.is("exit", "emergency");
}

bool isOsmDoor(const TaggedFeature& feature) {
    auto told = [&feature](const char* key) { return feature.has(key) && !feature.is(key, "no"); };
    return told("door") || told("entrance") || feature.is("indoor", "door") || feature.is("door", "no") ||
           isOsmEmergencyDoor(feature);
}

bool isOsmWall(const TaggedFeature& feature) {
    return isOne(feature, "indoor", {"wall", "column"}) ||
           ((feature.has("level") || feature.has("indoor")) &&
            isOne(feature, "barrier",
                  {"wall", "fence", "handrail", "guard_rail", "retaining_wall", "hedge"}));
}

bool isOsmRestricted(const TaggedFeature& feature) {
    return isOne(feature, "access", {"no", "private", "employees", "staff", "permit"}) ||
           isOne(feature, "foot", {"no", "private"});
}

std::optional<LandmarkRole> osmLandmarkRole(const TaggedFeature& feature) {
    if (feature.is("emergency", "fire_extinguisher")) return LandmarkRole{Kind::Extinguisher, ""};
    if (isOne(feature, "emergency", {"fire_hydrant", "fire_hose"})) return LandmarkRole{Kind::Hydrant, ""};
    if (isOne(feature, "emergency", {"defibrillator", "phone", "first_aid_kit"}))
        return LandmarkRole{Kind::Other, feature.tag("emergency")};
    const std::string& amenity = feature.tag("amenity");
    if (amenity == "vending_machine") return LandmarkRole{Kind::VendingMachine, ""};
    if (amenity == "bench" || amenity == "lounger") return LandmarkRole{Kind::Furniture, ""};
    if (isOne(feature, "amenity", {"waste_basket", "recycling", "waste_disposal"}))
        return LandmarkRole{Kind::Bin, ""};
    if (amenity == "drinking_water" || amenity == "fountain") return LandmarkRole{Kind::Fountain, ""};
    if (amenity == "locker" || amenity == "luggage_locker") return LandmarkRole{Kind::Locker, ""};
    if (feature.is("tourism", "artwork")) return LandmarkRole{Kind::Picture, ""};
    if (feature.has("information") || feature.is("tourism", "information"))
        return LandmarkRole{Kind::Sign, ""};
    if (feature.is("advertising", "poster_box")) return LandmarkRole{Kind::Poster, ""};
    for (const char* key : {"amenity", "shop", "office", "healthcare"})
        if (feature.has(key)) return LandmarkRole{Kind::Other, feature.tag(key)};
    return std::nullopt;
}

} // namespace farol::building
