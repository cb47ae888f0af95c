#include "core/building/import/imdf_categories.h"

#include <map>

namespace farol::building {

UnitRole imdfUnitRole(const std::string& category) {
    constexpr UnitRole kWall{RegionKind::Other, false, false, true};
    constexpr UnitRole kCorridor{RegionKind::Corridor}, kHall{RegionKind::Hall},
        kOutside{RegionKind::Outside}, kRoom{};
    static const std::map<std::string, UnitRole> roles{
        {"brick", kWall},
        {"column", kWall},
        {"concrete", kWall},
        {"drywall", kWall},
        {"glass", kWall},
        {"structure", kWall},
        {"wood", kWall},
        {"opentobelow", kWall},
        {"walkway", kCorridor},
        {"walkway.island", kCorridor},
        {"footbridge", kCorridor},
        {"movingwalkway", kCorridor},
        {"ramp", kCorridor},
        {"stairs", {RegionKind::Stairwell}},
        {"steps", {RegionKind::Stairwell}},
        {"escalator", {RegionKind::Stairwell}},
        {"elevator", {RegionKind::Elevator}},
        {"lobby", kHall},
        {"lounge", kHall},
        {"waitingroom", kHall},
        {"platform", kHall},
        {"unenclosedarea", kHall},
        {"privatelounge", kHall},
        {"recreation", kHall},
        {"foodservice", kHall},
        {"auditorium", kHall},
        {"road", kOutside},
        {"terrace", kOutside},
        {"vegetation", kOutside},
        {"smokingarea", kOutside},
        {"fieldofplay", kOutside},
        {"parking", kOutside},
        {"nonpublic", {RegionKind::Room, true, true, true}},
        {"classroom", kRoom},
        {"conferenceroom", kRoom},
        {"firstaid", kRoom},
        {"fitnessroom", kRoom},
        {"huddleroom", kRoom},
        {"kitchen", kRoom},
        {"laboratory", kRoom},
        {"library", kRoom},
        {"mailroom", kRoom},
        {"mothersroom", kRoom},
        {"movietheater", kRoom},
        {"office", kRoom},
        {"phoneroom", kRoom},
        {"room", kRoom},
        {"serverroom", kRoom},
        {"shower", kRoom},
        {"storage", kRoom},
        {"theater", kRoom},
        {"unspecified", kRoom},
    };
    auto found = roles.find(category);
    if (found != roles.end()) return found->second;
    if (category.rfind("restroom", 0) == 0) return {RegionKind::Toilet};
    return {RegionKind::Room, true, false, false};
}

Kind imdfAmenityKind(const std::string& category) {
    static const std::map<std::string, Kind> kinds{
        {"fireextinguisher", Kind::Extinguisher},
        {"drinkingfountain", Kind::Fountain},
        {"elevator", Kind::Elevator},
        {"stairs", Kind::Stairs},
        {"vendingmachine", Kind::VendingMachine},
        {"coinlocker", Kind::Locker},
        {"seat", Kind::Furniture},
        {"seating", Kind::Furniture},
        {"exhibit", Kind::Picture},
        {"information", Kind::Sign},
    };
    auto found = kinds.find(category);
    return found == kinds.end() ? Kind::Other : found->second;
}

std::optional<AccessKind> imdfLevelChange(const std::string& category) {
    if (category == "elevator") return AccessKind::Elevator;
    if (category == "escalator") return AccessKind::Escalator;
    if (category == "stairs") return AccessKind::Stairs;
    if (category == "ramp") return AccessKind::Ramp;
    return std::nullopt;
}

} // namespace farol::building
